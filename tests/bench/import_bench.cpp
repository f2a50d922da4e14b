// SPDX-License-Identifier: MIT
// The time from a GLB's bytes to an Animal, against the time that tinygltf itself takes to parse the same
// bytes, in one run and turn by turn.
//
//   posepack_import_bench [--rounds N] [--limit RATIO] FILE.glb...
//
// Prints a row a file with the best of N rounds (default 40) and the ratio of the two; the last line holds
// their sums. With --limit the exit code is 1 when the sums' ratio is larger. tinygltf is the one compiled
// into posepack, with its RapidJSON backend and without images, which is the fastest there is: it takes a
// third of the time of Debian's library.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "animal/read_animal.hpp"
#include "animal/tinygltf.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Options {
    int rounds = 40;
    double limit = 0.0;  // 0: none
    std::vector<std::string> files;
};

struct Times {
    double tinygltf_ms = 1e30, posepack_ms = 1e30;
    bool is_good = true;
};

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--rounds" && i + 1 < argc)
            options.rounds = std::max(1, std::atoi(argv[++i]));
        else if (word == "--limit" && i + 1 < argc)
            options.limit = std::atof(argv[++i]);
        else
            options.files.emplace_back(word);
    }
    return options;
}

Bytes read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

bool skip_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                void*) {
    return true;
}

bool parse_with_tinygltf(const Bytes& bytes) {
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(skip_image, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    return parser.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(),
                                       static_cast<unsigned>(bytes.size()));
}

template <class Work>
double elapsed_ms(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Times measure(const Bytes& bytes, int rounds) {
    Times times;
    for (int round = 0; round < rounds; ++round) {
        times.tinygltf_ms =
            std::min(times.tinygltf_ms,
                     elapsed_ms([&] { times.is_good = parse_with_tinygltf(bytes) && times.is_good; }));
        times.posepack_ms = std::min(
            times.posepack_ms, elapsed_ms([&] {
                times.is_good = static_cast<bool>(posepack::animal::read_animal(bytes)) && times.is_good;
            }));
    }
    return times;
}

void print(const std::string& name, const Times& times) {
    fmt::print("{:<28}{:>12.3f}{:>12.3f}{:>8.2f}\n", name, times.tinygltf_ms, times.posepack_ms,
               times.posepack_ms / times.tinygltf_ms);
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    if (options.files.empty()) {
        fmt::print(stderr, "usage: posepack_import_bench [--rounds N] [--limit RATIO] FILE.glb...\n");
        return 1;
    }
    fmt::print("{:<28}{:>12}{:>12}{:>8}\n", fmt::format("best of {} rounds", options.rounds), "tinygltf ms",
               "posepack ms", "ratio");
    Times sum{0.0, 0.0, true};
    for (const std::string& file : options.files) {
        const Times times = measure(read_file(file), options.rounds);
        if (!times.is_good) {
            fmt::print(stderr, "{}: expected a GLB that both read\n", file);
            return 1;
        }
        print(file.substr(file.find_last_of('/') + 1), times);
        sum.tinygltf_ms += times.tinygltf_ms;
        sum.posepack_ms += times.posepack_ms;
    }
    print("sum", sum);
    if (options.limit <= 0.0 || sum.posepack_ms <= options.limit * sum.tinygltf_ms) return 0;
    fmt::print("expected a ratio of at most {}, found {:.2f}\n", options.limit,
               sum.posepack_ms / sum.tinygltf_ms);
    return 1;
}

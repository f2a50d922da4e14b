// SPDX-License-Identifier: MIT
// Replays inputs through a fuzz target without libFuzzer, in the ordinary test run.
//
//     replay [--explain] FILE-OR-FOLDER...
//
// --explain prints what became of each file. Fails when it finds no file; a crash ends it, after the name of
// the input was printed.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz/target.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const char* argument) {
    std::vector<fs::path> files;
    if (!fs::is_directory(argument)) return {argument};
    for (const auto& entry : fs::recursive_directory_iterator(argument))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// The input lies in a block of exactly its size, so that a read past its end is a report.
bool replay(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return false;
    const std::vector<char> text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    return true;
}

}  // namespace

int main(int argument_count, char** arguments) {
    std::size_t count = 0;
    bool explain = false;
    for (int a = 1; a < argument_count; ++a) {
        if (std::strcmp(arguments[a], "--explain") == 0) {
            explain = true;
            continue;
        }
        for (const fs::path& path : files_below(arguments[a])) {
            if (explain)
                posepack::fuzz::outcome_sink = [&](const std::string& outcome) {
                    std::printf("%s\t%s\n", path.c_str(), outcome.c_str());
                };
            std::fprintf(stderr, "\r%s ", path.c_str());  // the last name printed is that of a crash
            if (!replay(path)) {
                std::fprintf(stderr, "\nexpected a file that can be read, found %s\n", path.c_str());
                return 1;
            }
            ++count;
        }
    }
    std::fprintf(stderr, "\nreplayed %zu inputs\n", count);
    return count == 0 ? 1 : 0;
}

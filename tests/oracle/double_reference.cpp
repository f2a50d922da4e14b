// SPDX-License-Identifier: MIT
// Bakes a catalog in RGBA32F and compares every bone matrix with a second, plain reading of glTF in double
// precision that shares no code with the compiler.
//
//   double_reference --posepack EXE --project DIR --catalog FILE [--assets NAME]
//                    [--encoding NAME] [--space NAME] [--texel-order NAME] [--rate HZ] [--only IDS]
//
// Models come from a folder of the assets ("animals"); where none is named they are generated first. Assets
// lie in POSEPACK_ASSETS, else in shared/assets beside the project; without them the test is skipped (exit
// code 77), but fails where CI=true. It fails when nothing was compared.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "compare_palette.hpp"
#include "posepack/loader.h"
#include "reference_animal.hpp"

extern char** environ;

namespace posepack::oracle {
namespace {

namespace fs = std::filesystem;
using Options = std::map<std::string, std::string>;

constexpr int kSkipped = 77;

// Bounds of a difference. Only the rounding of twelve numbers to single precision is left between the two
// sides: with S the sum of the lengths that make up a coordinate, 2^-24 S each. S is a few R, more for a
// joint whose bind-space numbers are large beside the body. Found: at most 2.6e-7 R (robot_expressive, a
// finger), and at most 1.15 roundings. What exceeds one rounding is time: a key step of an open loop is known
// to 1e-9 s only, in which a joint at 54 rad/s turns by 5e-8 (cyber_character, Roll).
constexpr double kLargestError = 1e-6;  // of R
constexpr double kMostRoundings = 2.0;

std::string option(const Options& options, const std::string& name) {
    const auto found = options.find(name);
    return found == options.end() ? "" : found->second;
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// Runs the compiler without its results and warnings.
void run_posepack(const std::string& exe, std::vector<std::string> args) {
    args.insert(args.begin(), {exe, "--quiet"});
    std::vector<char*> argv;
    argv.reserve(args.size() + 1);
    for (std::string& arg : args) argv.push_back(arg.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    int status = -1;
    const bool started = posix_spawn(&child, exe.c_str(), &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    if (!started || waitpid(child, &status, 0) != child || status != 0)
        throw std::runtime_error(
            fmt::format("{} {}: expected wait status 0, found {}", exe, args[2], status));
}

// Bakes the catalog, without measuring.
void bake(const Options& options, const fs::path& models, const fs::path& folder) {
    std::vector<std::string> args{"bake", options.at("catalog"), "--models", models.string(),
                                  "-o",   folder.string()};
    args.insert(args.end(), {"--texel-format", "rgba32f", "--caps", "desktop", "--no-measure", "--no-fsync"});
    for (const char* name : {"encoding", "space", "texel-order", "rate", "only"})
        if (options.contains(name)) args.insert(args.end(), {std::string("--") + name, options.at(name)});
    run_posepack(options.at("posepack"), args);
}

// A folder that goes with the object.
class ScratchFolder {
 public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "posepack-oracle-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make the folder " + name);
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

// Ids and models of the catalog, all or those of the comma-separated list `only`.
std::map<std::string, std::string> animals_of(const std::string& catalog, const std::string& only) {
    std::ifstream file(catalog);
    const nlohmann::json parsed = nlohmann::json::parse(file);
    std::map<std::string, std::string> animals;
    for (const auto& [id, animal] : parsed.at("animals").items())
        if (only.empty() || fmt::format(",{},", only).find(fmt::format(",{},", id)) != std::string::npos)
            animals[id] = animal.at("model");
    return animals;
}

Comparison compare_files(const fs::path& model, const fs::path& container) {
    std::ifstream file(container, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    posepack_view view;
    if (const posepack_result result = posepack_open(&view, bytes.data(), bytes.size());
        result != POSEPACK_OK)
        throw std::runtime_error(fmt::format("{}: {}", container.string(), posepack_result_name(result)));
    if (view.header.texel_format != POSEPACK_TEXEL_RGBA32F)
        throw std::runtime_error(container.string() + ": expected RGBA32F");
    return compare_palette(ReferenceAnimal(model), view);
}

// Prints one animal, adds it to the total and judges it.
void account(const std::string& id, const Comparison& one, Comparison& total) {
    fmt::print("{:<22}{:>9}{:>9}{:>9}  {:.2e}{:>11.2f}  {}\n", id, one.clips, one.rows, one.matrices,
               one.error, one.roundings, one.place);
    total.clips += one.clips;
    total.rows += one.rows;
    total.rows_left_out += one.rows_left_out;
    total.matrices += one.matrices;
    if (!(one.error <= total.error)) {
        total.error = one.error;
        total.place = fmt::format("{}: {}", id, one.place);
    }
    for (const std::string& fault : one.faults) total.faults.push_back(fmt::format("{}: {}", id, fault));
    if (one.matrices == 0) total.faults.push_back(id + ": expected matrices to compare, found none");
    if (!(one.error <= kLargestError && one.roundings <= kMostRoundings))
        total.faults.push_back(fmt::format("{}: expected at most {} R and {} roundings, found {} R and {}",
                                           id, kLargestError, kMostRoundings, one.error, one.roundings));
}

// Bakes, compares, prints, and returns the exit code.
int compare_catalog(const Options& options, const fs::path& models, const fs::path& folder) {
    bake(options, models, folder);
    const auto animals = animals_of(options.at("catalog"), option(options, "only"));
    Comparison total;
    fmt::print("{:<22}{:>9}{:>9}{:>9}  {:<8}  {}  worst place\n", "animal", "clips", "rows", "matrices",
               "max / R", "roundings");
    for (const auto& [id, model] : animals)
        account(id, compare_files(models / model, folder / (id + ".posepack")), total);
    if (total.matrices == 0) total.faults.emplace_back("expected matrices to compare, found none");
    fmt::print(
        "compared {} files, {} clips, {} rows, {} matrices ({}, RGBA32F); largest difference {:.2e} R ({})\n",
        animals.size(), total.clips, total.rows, total.matrices, options.at("encoding"), total.error,
        total.place);
    if (total.rows_left_out > 0)
        fmt::print("{} rows behind the last key of an open loop left out\n", total.rows_left_out);
    for (const std::string& fault : total.faults) fmt::print("{}\n", fault);
    return total.faults.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

int run(const Options& options) {
    const ScratchFolder scratch;
    const fs::path palettes = scratch.path() / "palettes";
    if (!options.contains("assets")) {
        const fs::path models = scratch.path() / "models";
        run_posepack(options.at("posepack"), {"menagerie", models.string()});
        return compare_catalog(options, models, palettes);
    }
    fs::path assets = variable("POSEPACK_ASSETS");
    if (assets.empty()) assets = fs::path(options.at("project")) / ".." / "shared" / "assets";
    const fs::path models = assets / options.at("assets");
    if (fs::exists(models)) return compare_catalog(options, models, palettes);
    fmt::print("skipped: no folder {}; POSEPACK_ASSETS names its parent\n", models.string());
    return variable("CI") == "true" ? EXIT_FAILURE : kSkipped;
}

}  // namespace
}  // namespace posepack::oracle

int main(int argc, char** argv) {
    try {
        posepack::oracle::Options options{{"encoding", "affine"}, {"texel-order", "bone-major"}};
        for (int i = 1; i + 1 < argc; i += 2) options[std::string(argv[i]).substr(2)] = argv[i + 1];
        return posepack::oracle::run(options);
    } catch (const std::exception& exception) {
        fmt::print(stderr, "double_reference: {}\n", exception.what());
        return EXIT_FAILURE;
    }
}

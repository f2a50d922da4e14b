// SPDX-License-Identifier: MIT
// Bakes a catalog in RGBA32F and compares every bone matrix with a second reading of glTF in double
// precision.
//
//   double_reference --posepack EXE --project DIR --catalog FILE [--assets NAME]
//                    [--encoding NAME] [--texel-order NAME] [--rate HZ] [--only IDS]
//
// Models come from a folder of the assets ("animals"), or are generated first where none is named. Assets lie
// in POSEPACK_ASSETS, else in shared/assets beside the project; without them the test is skipped (exit code
// 77), but fails where CI=true. It fails when nothing was compared.
//
// The difference of two matrices is what it does to the body: the largest distance between M_reference p and
// M_palette p over the corners and the centre of the box of the vertices that the joint moves, as a fraction
// of the radius R. A difference is affine in p, so no vertex in the box is further off.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "posepack/loader.h"
#include "reference_animal.hpp"

extern char** environ;

namespace posepack::oracle {
namespace {

namespace fs = std::filesystem;
using Options = std::map<std::string, std::string>;

constexpr int kSkipped = 77;
constexpr double kLargestError = 1e-6;  // of R

struct Worst {
    double error = 0.0;  // of R
    std::string clip, bone;
    std::uint32_t row = 0;
};

struct Counts {
    std::size_t clips = 0, rows = 0, rows_left_out = 0, matrices = 0;
};

struct Outcome {
    Counts counts;
    Worst worst;
    double worst_roundings = 0.0;
    std::vector<std::string> faults;
};

std::string text_of(const posepack_string& string) {
    return {string.data, string.size_bytes};
}

void require_ok(posepack_result result) {
    if (result != POSEPACK_OK)
        throw std::runtime_error(fmt::format("the loader answers {}", posepack_result_name(result)));
}

Affine affine_of(const float matrix[12]) {
    Affine out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(matrix[i]);
    return out;
}

// Runs the compiler; its remarks pass, its results do not.
void run_posepack(const std::string& exe, std::vector<std::string> args) {
    args.insert(args.begin(), exe);
    std::vector<char*> argv;
    for (std::string& arg : args) argv.push_back(arg.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    int status = -1;
    const bool started = posix_spawn(&child, exe.c_str(), &quiet, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&quiet);
    if (!started || waitpid(child, &status, 0) != child || status != 0)
        throw std::runtime_error(
            fmt::format("{} {}: expected exit code 0, found status {}", exe, args[1], status));
}

class ScratchFolder {
 public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "posepack-oracle-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("expected to make a folder " + name);
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

// Compares one container with its GLB.
class Comparison {
 public:
    Comparison(const ReferenceAnimal& animal, const posepack_view& view);

    Outcome run();

 private:
    // A skin as one or more meshes of the palette use it.
    struct Use {
        std::uint32_t mesh, skin;
        Affine palette_from_mesh;
    };

    void compare_clip(const posepack_clip& clip, const ReferenceClip& source);
    void compare_row(const posepack_clip& clip, std::uint32_t row, const std::vector<Affine>& globals);
    void compare_joint(const posepack_clip& clip, std::uint32_t row, const Use& use, std::uint32_t joint,
                       const Affine& expected);

    const ReferenceAnimal& animal_;
    const posepack_view& view_;
    std::vector<Use> uses_;
    Affine model_from_palette_{};
    double radius_ = 0.0;  // in units of the model
    std::set<std::uint32_t> bones_seen_;
    Outcome outcome_;
};

Comparison::Comparison(const ReferenceAnimal& animal, const posepack_view& view)
    : animal_(animal), view_(view) {
    posepack_space space;
    require_ok(posepack_get_space(&view, &space));
    model_from_palette_ = affine_of(space.model_from_palette);
    radius_ = static_cast<double>(view.header.radius_m) / static_cast<double>(space.metres_per_unit);
    for (std::uint32_t m = 0; m < space.mesh_count; ++m) {
        posepack_mesh mesh;
        require_ok(posepack_get_mesh(&view, m, &mesh));
        const Use use{m, mesh.skin, affine_of(mesh.palette_from_mesh)};
        const auto is_same = [&](const Use& other) {
            return other.skin == use.skin && other.palette_from_mesh == use.palette_from_mesh;
        };
        if (std::none_of(uses_.begin(), uses_.end(), is_same)) uses_.push_back(use);
    }
}

Outcome Comparison::run() {
    std::set<const ReferenceClip*> taken;
    for (std::uint32_t c = 0; c < view_.header.clip_count; ++c) {
        posepack_clip clip;
        require_ok(posepack_get_clip(&view_, c, &clip));
        const auto source =
            std::find_if(animal_.clips.begin(), animal_.clips.end(), [&](const auto& candidate) {
                return candidate.name == text_of(clip.source_name) && !taken.contains(&candidate);
            });
        if (source == animal_.clips.end())
            throw std::runtime_error(fmt::format("clip {}: no such animation is left", text_of(clip.name)));
        taken.insert(&*source);
        compare_clip(clip, *source);
    }
    if (bones_seen_.size() != view_.header.bone_count)
        outcome_.faults.push_back(
            fmt::format("compared {} of {} bones", bones_seen_.size(), view_.header.bone_count));
    return outcome_;
}

// The period of a clip in double precision; the container has it rounded. An open loop adds a key step to the
// duration: that of a usual rate, in whole or NTSC frames a second, where one gives the stored number.
double period_s(const posepack_clip& clip, double duration_s) {
    if (clip.wrap != POSEPACK_WRAP_LOOP || clip.seam != POSEPACK_SEAM_OPEN) return duration_s;
    for (int frames = 24; frames <= 240; ++frames)
        for (const double rate_hz : {1.0 * frames, frames * 1000.0 / 1001.0})
            if (static_cast<float>(duration_s + 1.0 / rate_hz) == clip.period_s)
                return duration_s + 1.0 / rate_hz;
    return static_cast<double>(clip.period_s);
}

void Comparison::compare_clip(const posepack_clip& clip, const ReferenceClip& source) {
    ++outcome_.counts.clips;
    const double period = period_s(clip, source.end_s - source.start_s);
    if (static_cast<float>(source.start_s) != clip.start_s || static_cast<float>(period) != clip.period_s)
        outcome_.faults.push_back(fmt::format("clip {}: expected {} s from {} s on, found {} s from {} s on",
                                              text_of(clip.name), period, source.start_s, clip.period_s,
                                              clip.start_s));
    const std::uint32_t intervals = clip.wrap == POSEPACK_WRAP_LOOP ? clip.row_count : clip.row_count - 1;
    for (std::uint32_t row = 0; row < clip.row_count; ++row) {
        const double time_s = source.start_s + (clip.row_count > 1 ? row * period / intervals : 0.0);
        // glTF says nothing about the time between the last key of an open loop and its first row.
        if (clip.seam == POSEPACK_SEAM_OPEN && time_s > source.end_s + 1e-9) {
            ++outcome_.counts.rows_left_out;
            continue;
        }
        ++outcome_.counts.rows;
        compare_row(clip, row, animal_.globals(source, time_s));
    }
}

void Comparison::compare_row(const posepack_clip& clip, std::uint32_t row,
                             const std::vector<Affine>& globals) {
    for (const Use& use : uses_) {
        const ReferenceSkin& skin = animal_.skins.at(use.skin);
        for (std::uint32_t joint = 0; joint < skin.nodes.size(); ++joint)
            compare_joint(clip, row, use, joint, globals.at(skin.nodes[joint]) * skin.inverse_binds[joint]);
    }
}

void Comparison::compare_joint(const posepack_clip& clip, std::uint32_t row, const Use& use,
                               std::uint32_t joint, const Affine& expected) {
    std::uint32_t bone = 0;
    float stored[12];
    require_ok(posepack_map_joint(&view_, use.mesh, joint, &bone));
    require_ok(posepack_decode_bone(&view_, clip.first_row + row, bone, stored));
    const Affine found = model_from_palette_ * affine_of(stored) * use.palette_from_mesh;
    const Box& box = animal_.skins[use.skin].boxes[joint];
    double largest = 0.0, roundings = 0.0;
    for (int corner = 0; corner <= 8; ++corner) {  // the last is the centre
        double square = 0.0, bound = 0.0;
        for (std::size_t r = 0; r < 12; r += 4) {
            double along = expected[r + 3] - found[r + 3];
            double b = std::abs(expected[r + 3]);
            for (std::size_t c = 0; c < 3; ++c) {
                const double p = corner == 8 ? (box.low[c] + box.high[c]) / 2
                                             : ((corner >> c & 1) != 0 ? box.high[c] : box.low[c]);
                along += (expected[r + c] - found[r + c]) * p;
                b += std::abs(expected[r + c] * p);
            }
            square += along * along;
            bound += b * b;
        }
        if (!(square <= largest)) largest = square;  // NaN is largest of all
        roundings = std::max(roundings, std::sqrt(square) / (std::sqrt(bound) * 0x1p-24));
    }
    const double error = std::sqrt(largest) / radius_;
    ++outcome_.counts.matrices;
    bones_seen_.insert(bone);
    outcome_.worst_roundings = std::max(roundings, outcome_.worst_roundings);
    if (error <= outcome_.worst.error) return;
    posepack_bone record;
    require_ok(posepack_get_bone(&view_, bone, &record));
    outcome_.worst = {error, text_of(clip.name), text_of(record.name), row};
}

Outcome compare_files(const fs::path& glb, const fs::path& container) {
    std::ifstream file(container, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    posepack_view view;
    require_ok(posepack_open(&view, bytes.data(), bytes.size()));
    const ReferenceAnimal animal(glb);
    return Comparison(animal, view).run();
}

// Ids and models of the catalog, all or those of the comma-separated list `only`.
std::map<std::string, std::string> animals_of(const std::string& catalog, const std::string& only) {
    std::ifstream file(catalog);
    std::map<std::string, std::string> out;
    const nlohmann::json parsed = nlohmann::json::parse(file);
    for (const auto& [id, animal] : parsed.at("animals").items())
        if (only.empty() || ("," + only + ",").find("," + id + ",") != std::string::npos)
            out[id] = animal.at("model");
    return out;
}

void bake(const Options& options, const fs::path& models, const fs::path& folder) {
    std::vector<std::string> args{"bake",         options.at("catalog"), "--models",       models.string(),
                                  "-o",           folder.string(),       "--caps",         "desktop",
                                  "--no-measure", "--no-fsync",          "--texel-format", "rgba32f"};
    for (const char* name : {"encoding", "texel-order", "rate", "only"})
        if (options.contains(name)) args.insert(args.end(), {std::string("--") + name, options.at(name)});
    run_posepack(options.at("posepack"), args);
}

// Bakes, compares, prints, and returns the exit code.
int compare_catalog(const Options& options, const fs::path& models, const fs::path& folder) {
    bake(options, models, folder);
    Counts total;
    std::size_t files = 0;
    double largest = 0.0;
    std::string place;
    std::vector<std::string> faults;
    fmt::print("{:<22}{:>9}{:>9}{:>9}  max / R   worst place\n", "animal", "clips", "rows", "matrices");
    for (const auto& [id, model] :
         animals_of(options.at("catalog"), options.contains("only") ? options.at("only") : "")) {
        const Outcome outcome = compare_files(models / model, folder / (id + ".posepack"));
        const auto& [counts, worst, wr, animal_faults] = outcome;
        const std::string where = fmt::format("{} row {} bone {}", worst.clip, worst.row, worst.bone);
        fmt::print("{:<22}{:>9}{:>9}{:>9}  {:.2e}  {:.4f} {}\n", id, counts.clips, counts.rows,
                   counts.matrices, worst.error, wr, where);
        ++files;
        total.clips += counts.clips;
        total.rows += counts.rows;
        total.rows_left_out += counts.rows_left_out;
        total.matrices += counts.matrices;
        if (!(worst.error <= largest)) {
            largest = worst.error;
            place = id + ": " + where;
        }
        for (const std::string& fault : animal_faults) faults.push_back(id + ": " + fault);
        if (!(worst.error <= kLargestError))
            faults.push_back(
                fmt::format("{}: expected at most {} R, found {}", id, kLargestError, worst.error));
        if (counts.matrices == 0) faults.push_back(id + ": expected matrices to compare, found none");
    }
    if (total.matrices == 0) faults.push_back("expected matrices to compare, found none");
    fmt::print(
        "compared {} files, {} clips, {} rows, {} matrices ({}); largest difference {:.2e} R ({}); {} left "
        "out\n",
        files, total.clips, total.rows, total.matrices, "", largest, place, total.rows_left_out);
    for (const std::string& fault : faults) fmt::print("{}\n", fault);
    return faults.empty() ? 0 : 1;
}

int run(const Options& options) {
    const ScratchFolder scratch;
    if (!options.contains("assets")) {
        run_posepack(options.at("posepack"), {"menagerie", (scratch.path() / "models").string()});
        return compare_catalog(options, scratch.path() / "models", scratch.path() / "palettes");
    }
    const char* assets = std::getenv("POSEPACK_ASSETS");
    const fs::path folder = (assets != nullptr && *assets != '\0'
                                 ? fs::path(assets)
                                 : fs::path(options.at("project")) / ".." / "shared" / "assets") /
                            options.at("assets");
    if (fs::exists(folder)) return compare_catalog(options, folder, scratch.path() / "palettes");
    const char* ci = std::getenv("CI");
    fmt::print("skipped: no folder {}; POSEPACK_ASSETS names its parent\n", folder.string());
    return ci != nullptr && std::string(ci) == "true" ? 1 : kSkipped;
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
        return 1;
    }
}

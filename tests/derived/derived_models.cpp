// SPDX-License-Identifier: MIT
// Metamorphic tests: each model der_*.glb was derived from one real animal by a change whose effect on the
// palette is known; that effect is what must be found, and nothing else.
//
//   derived_models PROJECT_FOLDER
//
// Models lie in POSEPACK_ASSETS, else in shared/assets beside the project; without them the test is skipped
// (exit code 77), but fails where CI=true. It fails when a file of the folder has no row in the table, or a
// row no file.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <set>
#include <stdexcept>

#include "base/text.hpp"
#include "motion/clip_sampler.hpp"
#include "motion/skin_set.hpp"
#include "relations.hpp"

namespace posepack::derived {
namespace {

namespace fs = std::filesystem;

constexpr int kSkipped = 77;
constexpr const char* kBase = "animals/snake.glb";

// Rounding of two palettes to single precision: found at most 4.3e-7 R.
constexpr double kRounding = 1e-6;
// Key times that were shifted are rounded anew, by up to 6e-8 s, in which a tail at 20 R/s moves 1.2e-6 R.
constexpr double kTimeRounding = 3e-6;
// The README of the models states 1e-4 for 16 bits. Eight bits turn a joint by up to 1/127, and joints in a
// chain add up: found 0.019 R. Weights in steps of 1/255: found 0.0021 R.
constexpr double kSixteenBits = 1e-4;
constexpr double kEightBits = 0.03;
constexpr double kWeightSteps = 0.004;

using Faults = std::vector<std::string>;

struct Row {
    const char* file;  // der_<file>.glb
    const char* relation;
    Relation change;
    double bound;  // largest distance of a vertex, of R
    void (*more)(const PosedModel& base, const PosedModel& derived, Faults& faults);
};

void expect(bool is_right, const std::string& fault, Faults& faults) {
    if (!is_right) faults.push_back(fault);
}

void expect_late_start(const PosedModel& base, const PosedModel& derived, Faults& faults) {
    for (std::size_t c = 0; c < base.record.clips.size(); ++c)
        expect(std::abs(derived.record.clips[c].start_s - base.record.clips[c].start_s - 1.25f) < 1e-6f,
               fmt::format("clip {}: expected a start 1.25 s later, found {}", c,
                           derived.record.clips[c].start_s),
               faults);
}

// The rotations were stored in eight bits and are off unit length by a hundredth: made unit, they keep the
// volume of every bone.
void expect_unit_rotations(const PosedModel& base, const PosedModel& derived, Faults& faults) {
    for (std::uint32_t row = 0; row < base.record.row_count; ++row) {
        const std::vector<float> a = decoded_row(base, row);
        const std::vector<float> b = decoded_row(derived, row);
        for (std::size_t bone = 0; bone * 12 < a.size(); ++bone) {
            const auto volume = [&](const std::vector<float>& m) {
                const float* p = &m[bone * 12];
                return glm::determinant(glm::dmat3(p[0], p[4], p[8], p[1], p[5], p[9], p[2], p[6], p[10]));
            };
            if (std::abs(volume(b) / volume(a) - 1.0) > 1e-5) {
                faults.push_back(fmt::format("row {}, bone {}: expected the base's volume, found {} times it",
                                             row, bone, volume(b) / volume(a)));
                return;
            }
        }
    }
}

void expect_clip_names(const PosedModel&, const PosedModel& derived, Faults& faults) {
    std::set<std::string> names;
    for (const recipe::ClipRecord& clip : derived.record.clips) {
        expect(!clip.name.empty(), "a clip has no name", faults);
        expect(names.insert(base::lowered(clip.name)).second, "two clips are named " + clip.name, faults);
    }
    expect(derived.record.clips[0].source_name == "../../etc/x", "source names must stay", faults);
}

void expect_made_up_names(const PosedModel&, const PosedModel& derived, Faults& faults) {
    for (std::size_t c = 0; c < derived.record.clips.size(); ++c)
        expect(derived.record.clips[c].name == fmt::format("clip_{}", c), "expected clip_<index>", faults);
    for (const animal::Bone& bone : derived.animal.bones)
        expect(bone.name == fmt::format("node_{}", bone.node), "expected node_<index>", faults);
}

// At times that no row has: splines whose tangents are the slopes of their segments are straight lines.
void expect_equal_between_keys(const PosedModel& base, const PosedModel& derived, Faults& faults) {
    const motion::SkinSet points = motion::unique_points(base.animal);
    std::vector<glm::dvec3> a(points.size());
    std::vector<glm::dvec3> b(points.size());
    std::vector<motion::Affine> bones(base.animal.bones.size());
    double largest = 0.0;
    for (std::size_t c = 0; c < base.animal.clips.size(); ++c) {
        motion::ClipSampler straight(base.animal, base.animal.clips[c]);
        motion::ClipSampler curved(derived.animal, derived.animal.clips[c]);
        for (double time_s = 0.013; time_s < base.animal.clips[c].duration_s; time_s += 0.017) {
            straight.sample(time_s, bones);
            motion::skin(points, bones, a);
            curved.sample(time_s, bones);
            motion::skin(points, bones, b);
            for (std::size_t v = 0; v < a.size(); ++v) {
                const double distance = glm::length(a[v] - b[v]) / static_cast<double>(base.record.radius_m);
                if (!(distance <= largest)) largest = distance;
            }
        }
    }
    fmt::print("{:<22}between keys: {:.2e} R\n", "cubicspline", largest);
    expect(largest <= kRounding,
           fmt::format("between keys: expected at most {} R, found {}", kRounding, largest), faults);
}

// Between two keys a stepped clip shows the earlier one, to the bit.
void expect_held_poses(const PosedModel& base, const PosedModel& derived, Faults& faults) {
    std::size_t compared = 0;
    std::size_t changes = 0;
    for (std::size_t c = 0; c < derived.record.clips.size(); ++c) {
        const recipe::ClipRecord& clip = derived.record.clips[c];
        expect(clip.interpolation == "step", clip.name + ": expected stepped rows", faults);
        expect(base.record.clips[c].interpolation == "linear", "the base must be smooth", faults);
        motion::ClipSampler sampler(derived.animal, derived.animal.clips[c]);
        std::vector<motion::Affine> at(derived.animal.bones.size());
        std::vector<motion::Affine> between(at.size());
        for (std::uint32_t row = 0; row + 1 < clip.row_count; ++row) {
            const double time_s = row / static_cast<double>(clip.rate_hz);
            sampler.sample(time_s, at);
            for (const double part : {0.25, 0.5, 0.99}) {
                sampler.sample(time_s + part / static_cast<double>(clip.rate_hz), between);
                for (std::size_t b = 0; b < at.size(); ++b, ++compared)
                    if (at[b].linear != between[b].linear || at[b].translation != between[b].translation)
                        ++changes;
            }
        }
    }
    expect(compared > 0 && changes == 0, fmt::format("{} of {} poses change between keys", changes, compared),
           faults);
}

// The first half must differ, or the file is not what it says.
void expect_changed_start(const PosedModel& base, const PosedModel& derived, Faults& faults) {
    expect(decoded_row(base, 0) != decoded_row(derived, 0), "expected another first pose", faults);
}

glm::dmat4 scaled(double x, double y, double z) {
    return glm::scale(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

glm::dmat4 sheared() {
    return {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0.25, 1, 0, 3, -2, 1, 1};
}

// Of the quaternion (0, 0.3826834, 0, 0.9238795), made unit, then 1, 2, 0.5 along the axes.
glm::dmat4 turned_and_stretched() {
    return glm::mat4_cast(glm::normalize(glm::dquat(0.9238795, 0, 0.3826834, 0))) * scaled(1, 2, 0.5);
}

Relation same() {
    Relation relation;
    relation.bits_equal = true;
    return relation;
}

Relation same_by_name() {
    Relation relation = same();
    relation.pairs_bones_by_name = true;
    return relation;
}

Relation rounded(const glm::dmat4& transform = glm::dmat4(1.0)) {
    Relation relation;
    relation.transform = transform;
    return relation;
}

Relation copied(std::uint32_t copies) {
    Relation relation = same();
    relation.clip_copies = copies;
    return relation;
}

Relation without_bind() {
    Relation relation;
    relation.undoes_bind = true;
    return relation;
}

Relation second_half() {
    Relation relation;
    relation.second_half_only = true;
    return relation;
}

std::vector<Row> table() {
    return {
        {"cubicspline", "splines with straight tangents are the straight lines", rounded(), kRounding,
         expect_equal_between_keys},
        {"huge_units", "1e5 x base", rounded(scaled(1e5, 1e5, 1e5)), kRounding, nullptr},
        {"interleaved_u8", "equal matrices; weights in steps of 1/255", same(), kWeightSteps, nullptr},
        {"joints_1_weights_1", "equal matrices, equal vertices", same(), 0.0, nullptr},
        {"joints_shuffled", "equal matrices under the bones' names, equal vertices", same_by_name(), 1e-12,
         nullptr},
        {"late_start", "the same rows from 1.25 s on", rounded(), kTimeRounding, expect_late_start},
        {"mirror_root", "mirrored base", rounded(scaled(-1, 1, 1)), 0.0, nullptr},
        {"no_ibm", "matrix x the base's inverse bind = base", without_bind(), kRounding, nullptr},
        {"no_scene", "equal matrices, equal vertices", same(), 0.0, nullptr},
        {"nodes_reversed", "equal matrices, equal vertices", same(), 0.0, nullptr},
        {"nonuniform_root", "turned and stretched base", rounded(turned_and_stretched()), kRounding, nullptr},
        {"odd_clip_names", "the base's clips twice, with names of their own", copied(2), 0.0,
         expect_clip_names},
        {"ragged_channels", "the second half of every clip", second_half(), kRounding, expect_changed_start},
        {"rotation_i16n", "base, rotations in 16 bits", rounded(), kSixteenBits, nullptr},
        {"rotation_i8n", "base, rotations in 8 bits, of unit length", rounded(), kEightBits,
         expect_unit_rotations},
        {"sheared_root", "sheared and moved base", rounded(sheared()), kRounding, nullptr},
        {"sparse", "equal matrices, equal vertices", same(), 0.0, nullptr},
        {"step", "base at the keys, held between them", rounded(), kRounding, expect_held_poses},
        {"tiny_units", "1e-5 x base", rounded(scaled(1e-5, 1e-5, 1e-5)), kRounding, nullptr},
        {"unnamed", "equal matrices, equal vertices, names by index", same(), 0.0, expect_made_up_names},
    };
}

// Files of the folder without a row.
Faults untabled(const fs::path& folder, const std::vector<Row>& rows) {
    std::set<std::string> known;
    for (const Row& row : rows) known.insert(fmt::format("der_{}.glb", row.file));
    Faults faults;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("der_") && !known.contains(name))
            faults.push_back(name + ": expected a row of the table, found none");
    }
    return faults;
}

int run(const fs::path& assets) {
    const std::vector<Row> rows = table();
    Faults faults = untabled(assets / "features", rows);
    const PosedModel base = pose_model(assets / kBase);
    std::size_t vertices = 0;
    fmt::print("{:<22}{:>6}{:>6}{:>10}  {:<10}{:<10}relation to {}\n", "derived model", "clips", "rows",
               "vertices", "found / R", "bound / R", kBase);
    for (const Row& row : rows) {
        const PosedModel derived = pose_model(assets / "features" / fmt::format("der_{}.glb", row.file));
        Found found = compare(base, derived, row.change);
        if (row.more != nullptr) row.more(base, derived, found.faults);
        fmt::print("{:<22}{:>6}{:>6}{:>10}  {:<10.2e}{:<10.2g}{}\n", row.file, found.clips, found.rows,
                   found.vertices, found.largest, row.bound, row.relation);
        expect(found.vertices > 0, "expected vertices to compare, found none", found.faults);
        expect(found.largest <= row.bound,
               fmt::format("expected at most {} R, found {}", row.bound, found.largest), found.faults);
        for (const std::string& fault : found.faults)
            faults.push_back(fmt::format("{}: {}", row.file, fault));
        vertices += found.vertices;
    }
    fmt::print("{} derived models, {} vertices compared, {} faults\n", rows.size(), vertices, faults.size());
    for (const std::string& fault : faults) fmt::print("{}\n", fault);
    return faults.empty() && vertices > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace posepack::derived

int main(int argc, char** argv) {
    namespace fs = std::filesystem;
    try {
        const char* variable = std::getenv("POSEPACK_ASSETS");
        const fs::path assets = variable != nullptr
                                    ? fs::path(variable)
                                    : fs::path(argc > 1 ? argv[1] : ".") / ".." / "shared" / "assets";
        if (fs::exists(assets / posepack::derived::kBase)) return posepack::derived::run(assets);
        fmt::print("SKIPPED: no {} in {}; POSEPACK_ASSETS names the folder\n", posepack::derived::kBase,
                   assets.string());
        const char* ci = std::getenv("CI");
        return ci != nullptr && std::string(ci) == "true" ? EXIT_FAILURE : posepack::derived::kSkipped;
    } catch (const std::exception& exception) {
        fmt::print(stderr, "derived_models: {}\n", exception.what());
        return EXIT_FAILURE;
    }
}

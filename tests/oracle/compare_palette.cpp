// SPDX-License-Identifier: MIT
#include "compare_palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace posepack::oracle {
namespace {

// A row meant for the last key may lie this far behind it: key times are single precision.
constexpr double kLastKeySlackS = 1e-8;

// Fraction of R that never counts as a rounding: what double precision itself costs.
constexpr double kDoubleRounding = 1e-12;

constexpr Affine kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

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

// A corner of a box (0 to 7), or its centre (8).
std::array<double, 3> point_of(const Box& box, int corner) {
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = corner == 8              ? (box.low[c] + box.high[c]) / 2
                 : (corner >> c & 1) != 0 ? box.high[c]
                                          : box.low[c];
    return out;
}

// What two matrices do to a point: how far apart they put it, and how far apart rounding each number of the
// first to single precision can put it: half a unit in the last place, 2^-24 of each product in a sum.
struct Difference {
    double distance, rounding;
};

Difference difference_at(const Affine& expected, const Affine& found, const std::array<double, 3>& point) {
    double square = 0.0, rounding_square = 0.0;
    for (std::size_t r = 0; r < 12; r += 4) {
        double along = expected[r + 3] - found[r + 3];
        double rounding = std::abs(expected[r + 3]);
        for (std::size_t c = 0; c < 3; ++c) {
            along += (expected[r + c] - found[r + c]) * point[c];
            rounding += std::abs(expected[r + c] * point[c]);
        }
        square += along * along;
        rounding_square += rounding * rounding;
    }
    return {std::sqrt(square), 0x1p-24 * std::sqrt(rounding_square)};
}

// The period of a clip in double precision; the container has it rounded. An open loop adds a key step to the
// time of its keys: that of a usual rate, in whole or NTSC frames a second, where one gives the stored
// number.
double period_s(const posepack_clip& clip, double duration_s) {
    if (clip.wrap != POSEPACK_WRAP_LOOP || clip.seam != POSEPACK_SEAM_OPEN) return duration_s;
    for (int frames = 24; frames <= 240; ++frames)
        for (const double rate_hz : {1.0 * frames, frames * 1000.0 / 1001.0})
            if (static_cast<float>(duration_s + 1.0 / rate_hz) == clip.period_s)
                return duration_s + 1.0 / rate_hz;
    return static_cast<double>(clip.period_s);
}

class Comparer {
 public:
    Comparer(const ReferenceAnimal& animal, const posepack_view& view);

    Comparison run();

 private:
    // A skin, as one or several meshes of the palette use it, or a rigid mesh: a skin of one joint that
    // nobody wrote down.
    struct Use {
        std::uint32_t mesh;
        ReferenceSkin skin;
        Affine palette_from_mesh;
    };

    ReferenceSkin skin_of(const posepack_mesh& mesh) const;

    const ReferenceClip& source_of(const posepack_clip& clip);
    void compare_clip(const posepack_clip& clip, const ReferenceClip& source);
    void compare_row(const posepack_clip& clip, std::uint32_t row, const std::vector<Affine>& globals);
    void compare_joint(const posepack_clip& clip, std::uint32_t row, const Use& use, std::uint32_t joint,
                       const Affine& expected);
    void note_error(double error, const posepack_clip& clip, std::uint32_t row, std::uint32_t bone);

    const ReferenceAnimal& animal_;
    const posepack_view& view_;
    std::vector<Use> uses_;
    Affine model_from_palette_{};
    double radius_ = 0.0;  // R in units of the model
    std::set<const ReferenceClip*> taken_;
    std::set<std::uint32_t> bones_seen_;
    Comparison result_;
};

Comparer::Comparer(const ReferenceAnimal& animal, const posepack_view& view) : animal_(animal), view_(view) {
    posepack_space space;
    require_ok(posepack_get_space(&view, &space));
    model_from_palette_ = affine_of(space.model_from_palette);
    radius_ = static_cast<double>(view.header.radius_m) / static_cast<double>(space.metres_per_unit);
    std::set<std::pair<std::uint32_t, Affine>> seen;
    for (std::uint32_t m = 0; m < space.mesh_count; ++m) {
        posepack_mesh mesh;
        require_ok(posepack_get_mesh(&view, m, &mesh));
        const Affine palette_from_mesh = affine_of(mesh.palette_from_mesh);
        // Meshes of one skin are alike; each rigid mesh is one of its own.
        if (mesh.skin != POSEPACK_NONE && !seen.insert({mesh.skin, palette_from_mesh}).second) continue;
        uses_.push_back({m, skin_of(mesh), palette_from_mesh});
        if (mesh.joint_count != uses_.back().skin.nodes.size())
            throw std::runtime_error(fmt::format("expected {} joints of skin {}, found {}",
                                                 uses_.back().skin.nodes.size(), mesh.skin,
                                                 mesh.joint_count));
    }
}

ReferenceSkin Comparer::skin_of(const posepack_mesh& mesh) const {
    if (mesh.skin != POSEPACK_NONE) return animal_.skins.at(mesh.skin);
    for (const ReferenceRigidMesh& rigid : animal_.rigid_meshes)
        if (rigid.node == mesh.node) return {{rigid.node}, {kIdentity}, {rigid.box}};
    throw std::runtime_error(fmt::format("expected a rigid mesh at node {}, found none", mesh.node));
}

Comparison Comparer::run() {
    for (std::uint32_t c = 0; c < view_.header.clip_count; ++c) {
        posepack_clip clip;
        require_ok(posepack_get_clip(&view_, c, &clip));
        compare_clip(clip, source_of(clip));
    }
    if (bones_seen_.size() != view_.header.bone_count)
        result_.faults.push_back(
            fmt::format("expected to compare {} bones, did {}", view_.header.bone_count, bones_seen_.size()));
    return result_;
}

// The name says which animation it is, and of equal names the order.
const ReferenceClip& Comparer::source_of(const posepack_clip& clip) {
    for (const ReferenceClip& source : animal_.clips)
        if (source.name == text_of(clip.source_name) && taken_.insert(&source).second) return source;
    throw std::runtime_error(fmt::format("clip {}: the GLB has no animation '{}' left for it",
                                         text_of(clip.name), text_of(clip.source_name)));
}

void Comparer::compare_clip(const posepack_clip& clip, const ReferenceClip& source) {
    ++result_.clips;
    const double period = period_s(clip, source.end_s - source.start_s);
    if (static_cast<float>(source.start_s) != clip.start_s || static_cast<float>(period) != clip.period_s)
        result_.faults.push_back(fmt::format("clip {}: expected {} s from {} s on, found {} s from {} s on",
                                             text_of(clip.name), period, source.start_s, clip.period_s,
                                             clip.start_s));
    const std::uint32_t intervals = clip.wrap == POSEPACK_WRAP_LOOP ? clip.row_count : clip.row_count - 1;
    for (std::uint32_t row = 0; row < clip.row_count; ++row) {
        const double time_s = source.start_s + (clip.row_count > 1 ? row * period / intervals : 0.0);
        if (clip.seam == POSEPACK_SEAM_OPEN && time_s > source.end_s + kLastKeySlackS) {
            ++result_.rows_left_out;
            continue;
        }
        ++result_.rows;
        compare_row(clip, row, animal_.globals(source, time_s));
    }
}

void Comparer::compare_row(const posepack_clip& clip, std::uint32_t row, const std::vector<Affine>& globals) {
    for (const Use& use : uses_) {
        const ReferenceSkin& skin = use.skin;
        for (std::uint32_t joint = 0; joint < skin.nodes.size(); ++joint)
            compare_joint(clip, row, use, joint, globals.at(skin.nodes[joint]) * skin.inverse_binds[joint]);
    }
}

void Comparer::compare_joint(const posepack_clip& clip, std::uint32_t row, const Use& use,
                             std::uint32_t joint, const Affine& expected) {
    std::uint32_t bone = 0;
    float stored[12];
    require_ok(posepack_map_joint(&view_, use.mesh, joint, &bone));
    require_ok(posepack_decode_bone(&view_, clip.first_row + row, bone, stored));
    const Affine found = model_from_palette_ * affine_of(stored) * use.palette_from_mesh;
    for (int corner = 0; corner <= 8; ++corner) {
        const Difference difference = difference_at(expected, found, point_of(use.skin.boxes[joint], corner));
        const double roundings = difference.distance / (difference.rounding + kDoubleRounding * radius_);
        // What was rounded are the numbers that are stored; only where they are the whole matrix (no
        // normalised space, no folded skin) is it known what that may cost.
        const bool is_whole =
            (view_.header.space_flags & POSEPACK_SPACE_NORMALISED) == 0 && use.palette_from_mesh == kIdentity;
        if (is_whole && !(roundings <= result_.roundings))
            result_.roundings = roundings;  // NaN is largest of all
        note_error(difference.distance / radius_, clip, row, bone);
    }
    ++result_.matrices;
    bones_seen_.insert(bone);
}

void Comparer::note_error(double error, const posepack_clip& clip, std::uint32_t row, std::uint32_t bone) {
    if (error <= result_.error || std::isnan(result_.error)) return;
    posepack_bone record;
    require_ok(posepack_get_bone(&view_, bone, &record));
    result_.error = error;
    result_.place = fmt::format("{} row {} bone {}", text_of(clip.name), row, text_of(record.name));
}

}  // namespace

Comparison compare_palette(const ReferenceAnimal& animal, const posepack_view& view) {
    return Comparer(animal, view).run();
}

}  // namespace posepack::oracle

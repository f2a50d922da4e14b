// SPDX-License-Identifier: MIT
#include "relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace posepack::derived {
namespace {

// The bone of `base` for every bone of `derived`.
std::vector<std::size_t> pair_bones(const PosedModel& base, const PosedModel& derived, bool by_name) {
    std::vector<std::size_t> pairs;
    for (std::size_t b = 0; b < derived.animal.bones.size(); ++b) {
        std::size_t found = b;
        if (by_name)
            for (std::size_t other = 0; other < base.animal.bones.size(); ++other)
                if (base.animal.bones[other].name == derived.animal.bones[b].name) found = other;
        pairs.push_back(found);
    }
    return pairs;
}

bool equal_bones(const std::vector<float>& base, const std::vector<float>& derived,
                 const std::vector<std::size_t>& pairs) {
    for (std::size_t b = 0; b < pairs.size(); ++b)
        for (std::size_t i = 0; i < 12; ++i)
            if (base[pairs[b] * 12 + i] != derived[b * 12 + i]) return false;
    return true;
}

class Comparison {
 public:
    Comparison(const PosedModel& base, const PosedModel& derived, const Relation& relation)
        : base_(base),
          derived_(derived),
          relation_(relation),
          pairs_(pair_bones(base, derived, relation.pairs_bones_by_name)),
          radius_(static_cast<double>((relation.undoes_bind ? base : derived).record.radius_m)) {
        if (relation.undoes_bind)
            for (const animal::Bone& bone : base.animal.bones) binds_.push_back(bone.inverse_bind);
    }

    Found run() {
        const std::size_t clips = base_.record.clips.size();
        if (derived_.record.clips.size() != clips * relation_.clip_copies || clips == 0 ||
            derived_.animal.bones.size() != base_.animal.bones.size() ||
            derived_.animal.vertices.positions.size() != base_.animal.vertices.positions.size()) {
            fault("expected the clips, bones and vertices of the base");
            return found_;
        }
        for (std::size_t c = 0; c < derived_.record.clips.size(); ++c)
            compare_clip(base_.record.clips[c % clips], derived_.record.clips[c]);
        return found_;
    }

 private:
    void fault(std::string text) {
        if (found_.faults.size() < 5) found_.faults.push_back(std::move(text));
    }

    void compare_clip(const recipe::ClipRecord& base, const recipe::ClipRecord& derived) {
        if (base.row_count != derived.row_count || std::abs(base.rate_hz - derived.rate_hz) > 1e-3f) {
            fault(fmt::format("{}: expected {} rows at {} Hz, found {} at {} Hz", derived.name,
                              base.row_count, base.rate_hz, derived.row_count, derived.rate_hz));
            return;
        }
        ++found_.clips;
        const std::uint32_t first = relation_.second_half_only ? base.row_count / 2 + 1 : 0;
        for (std::uint32_t row = first; row < base.row_count; ++row)
            compare_row(base.first_row + row, derived.first_row + row, derived.name, row);
    }

    void compare_row(std::uint32_t base_row, std::uint32_t derived_row, const std::string& clip,
                     std::uint32_t row) {
        const std::vector<float> a = decoded_row(base_, base_row);
        const std::vector<float> b = decoded_row(derived_, derived_row);
        if (relation_.bits_equal && !equal_bones(a, b, pairs_))
            fault(fmt::format("{}, row {}: expected equal bits of every matrix", clip, row));
        const std::vector<glm::dvec3> from = posed_vertices(base_, a);
        const std::vector<glm::dvec3> to = posed_vertices(derived_, b, binds_);
        for (std::size_t v = 0; v < from.size(); ++v) {
            const glm::dvec3 expected(relation_.transform * glm::dvec4(from[v], 1.0));
            const double distance = glm::length(to[v] - expected) / radius_;
            // A NaN must not pass as small.
            if (!(distance <= found_.largest)) found_.largest = distance;
        }
        ++found_.rows;
        found_.vertices += from.size();
    }

    const PosedModel& base_;
    const PosedModel& derived_;
    const Relation& relation_;
    std::vector<std::size_t> pairs_;
    std::vector<glm::dmat4> binds_;
    double radius_;
    Found found_;
};

}  // namespace

Found compare(const PosedModel& base, const PosedModel& derived, const Relation& relation) {
    return Comparison(base, derived, relation).run();
}

}  // namespace posepack::derived

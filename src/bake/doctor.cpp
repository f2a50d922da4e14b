// SPDX-License-Identifier: MIT
#include "bake/doctor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "animal/names.hpp"
#include "animal/read_animal.hpp"
#include "bake/bake_animal.hpp"
#include "motion/clip_sampler.hpp"
#include "motion/key_grid.hpp"
#include "motion/skin_set.hpp"
#include "vat/vram.hpp"

namespace posepack::bake {
namespace {

using animal::Animal;
using base::Issue;
using base::IssueCode;
using output::Diagnosis;

constexpr double kShearTolerance = 1e-4;  // cosine between two axes

output::Treatment treatment_of(IssueCode code) {
    switch (code) {
        case IssueCode::warn_weights:
        case IssueCode::warn_times:
        case IssueCode::warn_quat:
        case IssueCode::warn_channel:
        case IssueCode::warn_influences:
            return output::Treatment::repair;
        case IssueCode::warn_left_out:
            return output::Treatment::left_out;
        default:
            return output::Treatment::remark;
    }
}

// The rest pose of everything above a node, composed.
motion::Affine above(const Animal& animal, std::uint32_t node) {
    motion::Affine out;
    for (std::uint32_t n = animal.nodes[node].parent; n != animal::kNone; n = animal.nodes[n].parent) {
        const animal::Node& source = animal.nodes[n];
        out = (source.has_matrix ? motion::affine_of(source.matrix) : motion::affine_of(source.rest)) * out;
    }
    return out;
}

// Notes the root whose axes differ most from length 1, whether some root is mirrored or sheared.
void measure_armature(const Animal& animal, output::DiagnosedSkeleton& skeleton) {
    double most = 0.0;
    for (const animal::Bone& bone : animal.bones) {
        if (bone.parent != animal::kNone) continue;
        const glm::dmat3 axes = above(animal, bone.node).linear;
        std::array<double, 3> lengths{};
        double change = 0.0;
        for (int i = 0; i < 3; ++i) {
            const double length = glm::length(axes[i]);
            lengths[static_cast<std::size_t>(i)] = length;
            change = std::max(change, length > 0.0 ? std::abs(std::log(length)) : HUGE_VAL);
            const double along = std::abs(glm::dot(axes[i], axes[(i + 1) % 3]));
            if (along > kShearTolerance * length * glm::length(axes[(i + 1) % 3])) skeleton.is_sheared = true;
        }
        if (glm::determinant(axes) < 0.0) skeleton.is_mirrored = true;
        if (change > most) {
            most = change;
            skeleton.armature_scale = lengths;
        }
    }
}

output::DiagnosedSkeleton skeleton_of(const Animal& animal) {
    output::DiagnosedSkeleton skeleton;
    skeleton.bone_count = static_cast<std::uint32_t>(animal.bones.size());
    for (const animal::Bone& bone : animal.bones) {
        if (!bone.weighted) skeleton.unused_bones.push_back(bone.name);
        std::uint32_t length = 1;
        for (std::uint32_t b = bone.parent; b != animal::kNone; b = animal.bones[b].parent) ++length;
        skeleton.longest_chain = std::max(skeleton.longest_chain, length);
    }
    measure_armature(animal, skeleton);
    return skeleton;
}

void measure_rest_pose(const Animal& animal, Diagnosis& diagnosis) {
    const motion::SkinSet points = motion::unique_points(animal);
    std::vector<glm::dvec3> posed(points.size());
    motion::skin(points, motion::rest_pose(animal), posed);
    glm::dvec3 low(HUGE_VAL);
    glm::dvec3 high(-HUGE_VAL);
    for (const glm::dvec3& p : posed) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    for (int i = 0; i < 3; ++i) diagnosis.extent_m[static_cast<std::size_t>(i)] = high[i] - low[i];
    diagnosis.radius_m = motion::sphere_around(posed).radius;
}

output::DiagnosedClip clip_of(const Animal& animal, const animal::Clip& clip) {
    output::DiagnosedClip out;
    out.name = clip.name;
    out.source_name = clip.source_name;
    out.start_s = clip.start_s;
    out.duration_s = clip.duration_s;
    for (const animal::Channel& channel : clip.channels) {
        out.linear_channels += channel.interpolation == animal::Interpolation::linear ? 1 : 0;
        out.step_channels += channel.interpolation == animal::Interpolation::step ? 1 : 0;
        out.cubic_channels += channel.interpolation == animal::Interpolation::cubic_spline ? 1 : 0;
        if (channel.key_count > 1 && animal.key_times[channel.first_time] > clip.start_s + 1e-6)
            out.has_late_channel = true;
    }
    const motion::ClipSampler sampler(animal, clip);
    const std::vector<double> times_s = sampler.key_times_s();
    out.key_count = static_cast<std::uint32_t>(times_s.size());
    out.moves = sampler.moves();
    if (const auto step_s = motion::key_step_s(times_s)) out.key_rate_hz = 1.0 / *step_s;
    return out;
}

// Clips keep the file's order; an animation that moves no node is no clip.
void count_morph_channels(Diagnosis& diagnosis) {
    std::size_t clip = 0;
    const auto& animations = diagnosis.facts->animations;
    for (std::size_t a = 0; a < animations.size() && clip < diagnosis.clips.size(); ++a) {
        const auto name = animal::usable_name(animations[a].name, fmt::format("clip_{}", a));
        const bool may_move = animations[a].node_channels + animations[a].pointer_channels > 0;
        if (may_move && name && name.value() == diagnosis.clips[clip].source_name)
            diagnosis.clips[clip++].morph_channels = animations[a].morph_channels;
    }
}

void add_findings(const std::vector<Issue>& issues, Diagnosis& diagnosis) {
    for (const Issue& issue : issues) diagnosis.findings.push_back({treatment_of(issue.code), issue});
}

void examine_animal(const Animal& animal, Diagnosis& diagnosis) {
    diagnosis.skeleton = skeleton_of(animal);
    diagnosis.vertex_count = static_cast<std::uint32_t>(animal.vertices.positions.size());
    measure_rest_pose(animal, diagnosis);
    for (const animal::Clip& clip : animal.clips) diagnosis.clips.push_back(clip_of(animal, clip));
    if (diagnosis.facts) count_morph_channels(diagnosis);
    find_oddities(animal, diagnosis);
}

void add_plan(const recipe::ClipRecord& record, output::DiagnosedClip& clip) {
    clip.is_planned = true;
    clip.row_count = record.row_count;
    clip.rate_hz = static_cast<double>(record.rate_hz);
    clip.period_s = static_cast<double>(record.period_s);
    clip.wrap = record.wrap;
    clip.seam = record.seam;
    clip.seam_gap = static_cast<double>(record.seam_gap);
    clip.error_max_m = static_cast<double>(record.error.max_m);
}

output::DiagnosedBake bake_of(const recipe::BakeRecord& record) {
    output::DiagnosedBake bake;
    bake.encoding = record.encoding;
    bake.texel_format = record.texel_format;
    bake.row_count = record.row_count;
    bake.bone_count = record.bone_count;
    bake.vertex_count = record.vertex_count;
    bake.texture_width = record.texture_width;
    bake.texture_height = record.texture_height;
    bake.texel_bytes = record.texel_bytes;
    for (const vat::Form& form : vat::kForms)
        if (form.is_palette)
            bake.forms.push_back(
                {std::string(form.name),
                 texture_bytes(form, record.row_count, record.bone_count, record.vertex_count)});
    bake.is_measured = record.error.measured;
    bake.error_max = static_cast<double>(record.error.max);
    bake.error_max_m = static_cast<double>(record.error.max_m);
    bake.worst_clip = record.error.clip;
    if (record.reduction.measured) {
        bake.reduced_vertex_count = record.reduction.vertex_count;
        bake.influences_most = record.reduction.influences_most;
        bake.reduction_max_m = static_cast<double>(record.reduction.max_m);
        bake.reduction_max = static_cast<double>(record.reduction.max);
        bake.reduction_rms_m = static_cast<double>(record.reduction.rms_m);
        bake.reduction_rms = static_cast<double>(record.reduction.rms);
        bake.reduction_clip = record.reduction.clip;
    }
    return bake;
}

recipe::AnimalEntry plain_entry(const std::string& file_name) {
    recipe::AnimalEntry entry;
    entry.id = file_name;
    entry.model = file_name;
    entry.keywords = recipe::default_keywords();
    entry.canonical_json = "{}";
    return entry;
}

}  // namespace

output::Diagnosis diagnose(const std::string& file_name, std::span<const std::uint8_t> bytes,
                           const DoctorOptions& options) {
    Diagnosis diagnosis;
    diagnosis.file_name = file_name;
    diagnosis.is_strict = options.strict;
    diagnosis.file_bytes = bytes.size();
    if (auto facts = animal::read_file_facts(bytes)) diagnosis.facts = std::move(facts).value();
    std::vector<Issue> findings;
    if (const auto animal = animal::read_animal(bytes)) {
        examine_animal(animal.value(), diagnosis);
        findings = animal.value().findings;
    }
    AnimalOptions bake_options;
    bake_options.strict = options.strict;
    bake_options.measure = options.measure;
    auto baked = bake_animal(plain_entry(file_name), bytes, bake_options);
    if (!baked) {
        diagnosis.refusal = baked.issue();
        add_findings(findings, diagnosis);
        return diagnosis;
    }
    add_findings(baked.value().findings, diagnosis);
    const recipe::BakeRecord& record = baked.value().record;
    for (std::size_t c = 0; c < std::min(record.clips.size(), diagnosis.clips.size()); ++c)
        add_plan(record.clips[c], diagnosis.clips[c]);
    diagnosis.bake = bake_of(record);
    if (auto strict = animal::read_animal(bytes, {true}); !strict)
        diagnosis.strict_refusal = base::at(file_name, strict.issue());
    return diagnosis;
}

}  // namespace posepack::bake

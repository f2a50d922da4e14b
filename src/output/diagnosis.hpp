// SPDX-License-Identifier: MIT
// Diagnosis: what a GLB holds, what is odd in it, what would be repaired, and what a bake of it would give.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "animal/file_facts.hpp"
#include "base/issue.hpp"

namespace posepack::output {

struct DiagnosedSkeleton {
    std::uint32_t bone_count = 0;
    std::vector<std::string> unused_bones;  // no vertex has a weight on them
    std::uint32_t longest_chain = 0;        // bones from a root to the deepest bone
    // What the nodes above the root bones do at rest, for the root that they change most.
    std::array<double, 3> armature_scale{1.0, 1.0, 1.0};  // lengths of the axes
    bool is_mirrored = false, is_sheared = false;
};

struct DiagnosedClip {
    std::string name, source_name;
    double start_s = 0.0, duration_s = 0.0;
    std::uint32_t key_count = 0;  // different key times of channels that move a bone
    double key_rate_hz = 0.0;     // of the uniform grid that the keys lie on; 0: none
    std::uint32_t linear_channels = 0, step_channels = 0, cubic_channels = 0;
    std::uint32_t morph_channels = 0;  // not in the palette
    bool has_late_channel = false;     // some channel starts after the clip does
    bool moves = false;                // some bone moves

    bool is_planned = false;  // the rest is what a bake would choose and measure
    std::uint32_t row_count = 0;
    double rate_hz = 0.0, period_s = 0.0;
    std::string wrap, seam;    // as in manifests
    double seam_gap = 0.0;     // of R
    double error_max_m = 0.0;  // metres; meaningless when the bake was not measured
};

struct Oddity {
    std::string id;      // stable: "armature-scale"
    std::string detail;  // a sentence for people
};

enum class Treatment { repair, left_out, remark };

struct DiagnosedFinding {
    Treatment treatment = Treatment::remark;
    base::Issue issue;
};

struct FormBytes {
    std::string form;  // "affine RGBA16F"
    std::uint64_t bytes = 0;
};

struct DiagnosedBake {
    std::string encoding, texel_format;
    std::uint32_t row_count = 0, bone_count = 0, vertex_count = 0;
    std::uint32_t texture_width = 0, texture_height = 0;
    std::uint64_t texel_bytes = 0;
    std::vector<FormBytes> forms;  // mat4 and affine in both texel formats, at the same rows
    bool is_measured = false;
    double error_max_m = 0.0, error_max = 0.0;  // metres; of R
    std::string worst_clip;
    // What it costs that vertices keep four influences; vertex count 0: none has more.
    std::uint32_t reduced_vertex_count = 0, influences_most = 0;
    double reduction_max_m = 0.0, reduction_max = 0.0, reduction_rms_m = 0.0, reduction_rms = 0.0;
    std::string reduction_clip;
};

struct Diagnosis {
    std::string file_name;
    bool is_strict = false;
    std::uint64_t file_bytes = 0;
    std::optional<animal::FileFacts> facts;     // none: not even the glTF could be read
    std::optional<DiagnosedSkeleton> skeleton;  // from here on: none where the reader refuses the file
    std::array<double, 3> extent_m{};           // of the rest pose, one unit taken as a metre
    double radius_m = 0.0;                      // R
    std::uint32_t vertex_count = 0;
    std::vector<DiagnosedClip> clips;
    std::vector<Oddity> oddities;
    std::vector<DiagnosedFinding> findings;
    std::optional<DiagnosedBake> bake;          // none: refused
    std::optional<base::Issue> refusal;         // what bake would answer
    std::optional<base::Issue> strict_refusal;  // what bake --strict would answer where bake goes on
};

}  // namespace posepack::output

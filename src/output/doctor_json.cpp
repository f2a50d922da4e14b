// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "output/doctor_report.hpp"

namespace posepack::output {
namespace {

using nlohmann::json;

json issue_json(const std::optional<base::Issue>& issue) {
    return issue ? json::parse(format_issue_json(*issue)) : json(nullptr);
}

json skin_json(const animal::SkinFacts& skin) {
    return {{"name", skin.name},
            {"joints", skin.joint_count},
            {"meshes", skin.user_count},
            {"has_inverse_binds", skin.has_inverse_binds}};
}

json animation_json(const animal::AnimationFacts& animation) {
    return {{"name", animation.name},
            {"node_channels", animation.node_channels},
            {"morph_channels", animation.morph_channels},
            {"pointer_channels", animation.pointer_channels},
            {"unknown_channels", animation.unknown_channels}};
}

json contents_json(const animal::FileFacts& facts) {
    json skins = json::array();
    for (const animal::SkinFacts& skin : facts.skins) skins.push_back(skin_json(skin));
    json animations = json::array();
    for (const animal::AnimationFacts& a : facts.animations) animations.push_back(animation_json(a));
    return {{"generator", facts.generator},
            {"gltf_version", facts.gltf_version},
            {"extensions_used", facts.extensions_used},
            {"extensions_required", facts.extensions_required},
            {"scenes", facts.scene_count},
            {"nodes", facts.node_count},
            {"meshes", facts.mesh_count},
            {"primitives", facts.primitive_count},
            {"triangles", facts.triangle_count},
            {"images", facts.image_count},
            {"outside_images", facts.outside_image_count},
            {"compressed_primitives", facts.compressed_primitive_count},
            {"quantised_primitives", facts.quantised_primitive_count},
            {"sparse_accessors", facts.sparse_accessor_count},
            {"influence_sets", facts.influence_set_count},
            {"skinned_nodes", facts.skinned_node_count},
            {"rigid_nodes", facts.rigid_nodes},
            {"morph_targets", facts.morph_target_count},
            {"morphed_meshes", facts.morphed_meshes},
            {"skins", skins},
            {"animations", animations}};
}

json skeleton_json(const DiagnosedSkeleton& skeleton) {
    return {{"bones", skeleton.bone_count},
            {"unused_bones", skeleton.unused_bones},
            {"longest_chain", skeleton.longest_chain},
            {"armature_scale", skeleton.armature_scale},
            {"mirrored", skeleton.is_mirrored},
            {"sheared", skeleton.is_sheared}};
}

json plan_json(const DiagnosedClip& clip, bool is_measured) {
    if (!clip.is_planned) return nullptr;
    return {{"rows", clip.row_count},
            {"rate_hz", clip.rate_hz},
            {"period_s", clip.period_s},
            {"wrap", clip.wrap},
            {"seam", clip.seam},
            {"seam_gap", clip.seam_gap},
            {"error_max_m", is_measured ? json(clip.error_max_m) : json(nullptr)}};
}

json clip_json(const DiagnosedClip& clip, bool is_measured) {
    return {{"name", clip.name},
            {"source_name", clip.source_name},
            {"start_s", clip.start_s},
            {"duration_s", clip.duration_s},
            {"keys", clip.key_count},
            {"key_rate_hz", clip.key_rate_hz > 0 ? json(clip.key_rate_hz) : json(nullptr)},
            {"channels",
             {{"linear", clip.linear_channels},
              {"step", clip.step_channels},
              {"cubic_spline", clip.cubic_channels},
              {"morph", clip.morph_channels}}},
            {"moves", clip.moves},
            {"plan", plan_json(clip, is_measured)}};
}

json bake_json(const DiagnosedBake& bake) {
    json forms = json::array();
    for (const FormBytes& form : bake.forms) forms.push_back({{"form", form.form}, {"bytes", form.bytes}});
    json error = nullptr;
    if (bake.is_measured)
        error = {{"max_m", bake.error_max_m}, {"max", bake.error_max}, {"clip", bake.worst_clip}};
    json reduction = nullptr;
    if (bake.reduced_vertex_count > 0)
        reduction = {{"vertices", bake.reduced_vertex_count},
                     {"influences_most", bake.influences_most},
                     {"max_m", bake.reduction_max_m},
                     {"max", bake.reduction_max},
                     {"rms_m", bake.reduction_rms_m},
                     {"rms", bake.reduction_rms},
                     {"clip", bake.reduction_clip}};
    return {{"encoding", bake.encoding},
            {"texel_format", bake.texel_format},
            {"rows", bake.row_count},
            {"bones", bake.bone_count},
            {"vertices", bake.vertex_count},
            {"texture_width", bake.texture_width},
            {"texture_height", bake.texture_height},
            {"texel_bytes", bake.texel_bytes},
            {"forms", forms},
            {"error", error},
            {"reduction", reduction}};
}

const char* name_of(Treatment treatment) {
    return treatment == Treatment::repair     ? "repair"
           : treatment == Treatment::left_out ? "left-out"
                                              : "remark";
}

}  // namespace

std::string doctor_json(const Diagnosis& diagnosis, int indent) {
    const bool is_read = diagnosis.skeleton.has_value();
    const bool is_measured = diagnosis.bake && diagnosis.bake->is_measured;
    json clips = json::array();
    for (const DiagnosedClip& clip : diagnosis.clips) clips.push_back(clip_json(clip, is_measured));
    json oddities = json::array();
    for (const Oddity& oddity : diagnosis.oddities)
        oddities.push_back({{"id", oddity.id}, {"detail", oddity.detail}});
    json findings = json::array();
    for (const DiagnosedFinding& finding : diagnosis.findings) {
        json out = json::parse(format_issue_json(finding.issue));
        out["treatment"] = name_of(finding.treatment);
        findings.push_back(std::move(out));
    }
    const int exit_code =
        diagnosis.refusal ? static_cast<int>(issue_kind(diagnosis.refusal->code).exit_code) : 0;
    const json out{{"schema", "posepack-doctor-1"},
                   {"file", base::printable(diagnosis.file_name)},
                   {"bytes", diagnosis.file_bytes},
                   {"strict", diagnosis.is_strict},
                   {"ok", !diagnosis.refusal},
                   {"exit_code", exit_code},
                   {"refusal", issue_json(diagnosis.refusal)},
                   {"strict_refusal", issue_json(diagnosis.strict_refusal)},
                   {"contents", diagnosis.facts ? contents_json(*diagnosis.facts) : json(nullptr)},
                   {"skeleton", is_read ? skeleton_json(*diagnosis.skeleton) : json(nullptr)},
                   {"size", is_read ? json{{"extent_m", diagnosis.extent_m}, {"radius_m", diagnosis.radius_m}}
                                    : json(nullptr)},
                   {"vertices", is_read ? json(diagnosis.vertex_count) : json(nullptr)},
                   {"clips", clips},
                   {"odd", oddities},
                   {"findings", findings},
                   {"bake", diagnosis.bake ? bake_json(*diagnosis.bake) : json(nullptr)}};
    return out.dump(indent);
}

}  // namespace posepack::output

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "output/doctor_report.hpp"
#include "output/text_table.hpp"

namespace posepack::output {
namespace {

constexpr std::size_t kNameBytes = 40;   // of a name in the text
constexpr std::size_t kMostNames = 8;    // of a list
constexpr std::size_t kMostClips = 200;  // rows of the table of clips

std::string shown(const std::string& name) {
    return name.empty() ? "(no name)" : base::shortened(base::printable(name), kNameBytes);
}

// "a, b, c and 12 more".
std::string listed(const std::vector<std::string>& names) {
    std::string out;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i)
        out += (i == 0 ? "" : ", ") + shown(names[i]);
    if (names.size() > kMostNames) out += fmt::format(" and {} more", names.size() - kMostNames);
    return out;
}

void line(std::string& out, const char* label, const std::string& text) {
    out += fmt::format("  {:<11}{}\n", label, text);
}

std::size_t count_of(const Diagnosis& diagnosis, Treatment treatment) {
    return static_cast<std::size_t>(
        std::count_if(diagnosis.findings.begin(), diagnosis.findings.end(),
                      [&](const DiagnosedFinding& finding) { return finding.treatment == treatment; }));
}

// "1 repair", "2 repairs".
std::string counted(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

void write_verdict(std::string& out, const Diagnosis& diagnosis) {
    const std::string strict = diagnosis.is_strict ? " under --strict" : "";
    if (!diagnosis.refusal) {
        out += fmt::format("{}: can be baked{}.\n", base::printable(diagnosis.file_name), strict);
        out += fmt::format("{}, {} left out, {} to know of.\n",
                           counted(count_of(diagnosis, Treatment::repair), "repair", "repairs"),
                           counted(count_of(diagnosis, Treatment::left_out), "part", "parts"),
                           counted(diagnosis.oddities.size(), "oddity", "oddities"));
        return;
    }
    const base::IssueKind& kind = issue_kind(diagnosis.refusal->code);
    out += fmt::format("{}: cannot be baked{}. {}\n", base::printable(diagnosis.file_name), strict,
                       kind.meaning);
    out += fmt::format("  {}\n  (exit code {})\n", format_issue(*diagnosis.refusal),
                       static_cast<int>(kind.exit_code));
}

void write_storage(std::string& out, const animal::FileFacts& facts) {
    if (!facts.extensions_used.empty()) line(out, "extensions", listed(facts.extensions_used));
    std::string how;
    const auto add = [&](std::uint32_t count, const char* what) {
        if (count > 0) how += fmt::format("{}{} {}", how.empty() ? "" : ", ", count, what);
    };
    add(facts.compressed_primitive_count, "mesh parts compressed with Draco");
    add(facts.quantised_primitive_count, "mesh parts with positions as whole numbers (quantised)");
    add(facts.sparse_accessor_count, "lists of numbers stored as differences (sparse)");
    if (!how.empty()) line(out, "stored as", how);
}

void write_contents(std::string& out, const Diagnosis& diagnosis) {
    out += "\nWhat is in the file\n";
    const animal::FileFacts& facts = *diagnosis.facts;
    line(out, "file",
         fmt::format("{} bytes, written by {}", base::grouped(diagnosis.file_bytes),
                     facts.generator.empty() ? "a program that left no name"
                                             : base::shortened(base::printable(facts.generator), 80)));
    line(out, "nodes",
         fmt::format("{} (places of the model, each relative to its parent)", facts.node_count));
    line(out, "meshes",
         fmt::format(
             "{} drawn with a skin (bent by joints), {} rigid; {} triangles, room for {} joints a vertex",
             facts.skinned_node_count, facts.rigid_nodes.size(), base::grouped(facts.triangle_count),
             facts.influence_set_count * 4));
    std::uint64_t joints = 0;
    for (const animal::SkinFacts& skin : facts.skins) joints += skin.joint_count;
    line(out, "skins", fmt::format("{} with {} joints together", facts.skins.size(), joints));
    line(out, "animations", std::to_string(facts.animations.size()));
    write_storage(out, facts);
}

void write_skeleton(std::string& out, const Diagnosis& diagnosis) {
    const DiagnosedSkeleton& skeleton = *diagnosis.skeleton;
    line(out, "palette",
         fmt::format("{} bones (the joints as the palette counts them: one column each), up to {} "
                     "in a chain; {} vertices",
                     skeleton.bone_count, skeleton.longest_chain, base::grouped(diagnosis.vertex_count)));
    if (!skeleton.unused_bones.empty())
        line(
            out, "unused",
            fmt::format("{} {} no vertex: {}", base::counted(skeleton.unused_bones.size(), "bone"),
                        skeleton.unused_bones.size() == 1 ? "moves" : "move", listed(skeleton.unused_bones)));
    line(out, "size",
         fmt::format("{:.4g} x {:.4g} x {:.4g} m as it rests, if a unit is a metre", diagnosis.extent_m[0],
                     diagnosis.extent_m[1], diagnosis.extent_m[2]));
}

std::string keys_of(const DiagnosedClip& clip) {
    if (clip.step_channels == 0 && clip.cubic_channels == 0) return "straight";
    if (clip.linear_channels == 0 && clip.cubic_channels == 0) return "stepped";
    if (clip.linear_channels == 0 && clip.step_channels == 0) return "curved";
    return "mixed";
}

std::string end_of(const DiagnosedClip& clip) {
    if (!clip.is_planned) return "-";
    if (clip.wrap != "loop") return clip.wrap == "once" ? "plays once" : clip.wrap;
    return clip.seam == "closed" ? "loops (ends on its first pose)"
                                 : "loops (one more step to its first pose)";
}

std::string error_of(const Diagnosis& diagnosis, const DiagnosedClip& clip) {
    const bool is_measured = clip.is_planned && diagnosis.bake && diagnosis.bake->is_measured;
    return is_measured ? fmt::format("{:.3g}", clip.error_max_m * 1e3) : "-";
}

void write_clips(std::string& out, const Diagnosis& diagnosis) {
    if (diagnosis.clips.empty()) return;
    out += fmt::format("\nClips ({})\n", diagnosis.clips.size());
    TextTable table;
    table.columns = {{"clip", Align::left},
                     {"seconds"},
                     {"starts at"},
                     {"keys"},
                     {"keys/s"},
                     {"between keys", Align::left},
                     {"rows"},
                     {"error mm"},
                     {"at its end", Align::left}};
    for (std::size_t c = 0; c < std::min(diagnosis.clips.size(), kMostClips); ++c) {
        const DiagnosedClip& clip = diagnosis.clips[c];
        table.rows.push_back({shown(clip.name), fmt::format("{:.3f}", clip.duration_s),
                              fmt::format("{:.3f}", clip.start_s), std::to_string(clip.key_count),
                              clip.key_rate_hz > 0 ? fmt::format("{:.4g}", clip.key_rate_hz) : "-",
                              keys_of(clip), clip.is_planned ? std::to_string(clip.row_count) : "-",
                              error_of(diagnosis, clip), end_of(clip)});
    }
    out += format_text(table);
    if (diagnosis.clips.size() > kMostClips)
        out += fmt::format("and {} more\n", diagnosis.clips.size() - kMostClips);
    out +=
        "keys: different times at which something is set. keys/s: the even grid they lie on; - for none.\n"
        "rows: poses that a bake stores. error: largest distance of a vertex from the source, if a unit is a "
        "metre.\n";
}

void write_oddities(std::string& out, const Diagnosis& diagnosis) {
    if (diagnosis.oddities.empty()) return;
    out += "\nWhat is odd (nothing needs to be done)\n";
    for (const Oddity& oddity : diagnosis.oddities)
        out += fmt::format("  - {}\n", base::printable(oddity.detail));
}

// The place without the name of the file, which heads the report.
std::string place_of(const Diagnosis& diagnosis, const base::Issue& issue) {
    const std::string prefix = diagnosis.file_name + ": ";
    const bool has_prefix = issue.where.starts_with(prefix);
    return base::printable(has_prefix ? issue.where.substr(prefix.size()) : issue.where);
}

// One item a kind of finding, its places below it.
void write_findings(std::string& out, const Diagnosis& diagnosis, Treatment treatment, const char* title) {
    if (count_of(diagnosis, treatment) == 0) return;
    out += fmt::format("\n{}\n", title);
    std::vector<base::IssueCode> written;
    for (const DiagnosedFinding& first : diagnosis.findings) {
        const base::IssueCode code = first.issue.code;
        if (first.treatment != treatment || std::find(written.begin(), written.end(), code) != written.end())
            continue;
        written.push_back(code);
        const base::IssueKind& kind = issue_kind(code);
        out += fmt::format("  - {}", kind.meaning);
        out += kind.advice.empty() ? "\n" : fmt::format(" To mend it: {}.\n", kind.advice);
        for (const DiagnosedFinding& finding : diagnosis.findings)
            if (finding.issue.code == code)
                out += fmt::format("    {}: {}\n", place_of(diagnosis, finding.issue),
                                   base::printable(finding.issue.detail));
    }
}

void write_left_out_names(std::string& out, const Diagnosis& diagnosis) {
    if (!diagnosis.facts || !diagnosis.skeleton) return;
    const animal::FileFacts& facts = *diagnosis.facts;
    if (!facts.morphed_meshes.empty())
        out += fmt::format("    shapes that blend (morph targets): {} in {}\n", facts.morph_target_count,
                           listed(facts.morphed_meshes));
    std::vector<std::string> clips;
    for (const DiagnosedClip& clip : diagnosis.clips)
        if (clip.morph_channels > 0) clips.push_back(clip.name);
    if (!clips.empty()) out += fmt::format("    clips that would blend them: {}\n", listed(clips));
}

void write_bake(std::string& out, const DiagnosedBake& bake) {
    out += fmt::format("\nWhat a bake would give\n  {} rows (poses) of {} bones for {} vertices\n",
                       base::grouped(bake.row_count), bake.bone_count, base::grouped(bake.vertex_count));
    for (const FormBytes& form : bake.forms)
        out += fmt::format("  {:<16}{:>12} bytes ({})\n", form.form, base::grouped(form.bytes),
                           readable_bytes(form.bytes));
    out += fmt::format("  as baked without options: {} {}, a texture of {} x {}\n", bake.encoding,
                       bake.texel_format, bake.texture_width, bake.texture_height);
    if (bake.is_measured)
        out += fmt::format(
            "  largest distance of a vertex from the source: {:.3g} mm ({} of the size R), in {}\n",
            bake.error_max_m * 1e3, readable_error(bake.error_max), shown(bake.worst_clip));
    if (bake.reduced_vertex_count > 0)
        out += fmt::format(
            "  {} of {} vertices keep the four strongest of up to {} joints: that moves them by up to {:.3g} "
            "mm\n"
            "  ({} of the size R), in {}, and by {:.3g} mm as a mean square; --influences 8 keeps eight\n",
            base::grouped(bake.reduced_vertex_count), base::grouped(bake.vertex_count), bake.influences_most,
            bake.reduction_max_m * 1e3, readable_error(bake.reduction_max), shown(bake.reduction_clip),
            bake.reduction_rms_m * 1e3);
}

}  // namespace

std::string doctor_text(const Diagnosis& diagnosis) {
    std::string out;
    write_verdict(out, diagnosis);
    if (diagnosis.facts) write_contents(out, diagnosis);
    if (diagnosis.skeleton) write_skeleton(out, diagnosis);
    write_clips(out, diagnosis);
    write_oddities(out, diagnosis);
    write_findings(out, diagnosis, Treatment::repair, "What is repaired");
    write_findings(out, diagnosis, Treatment::left_out, "What is left out of the palette");
    if (count_of(diagnosis, Treatment::left_out) > 0) write_left_out_names(out, diagnosis);
    write_findings(out, diagnosis, Treatment::remark, "What else a bake remarks");
    if (diagnosis.bake) write_bake(out, *diagnosis.bake);
    if (diagnosis.strict_refusal)
        out += fmt::format("\nWith --strict it would be refused:\n  {}\n",
                           format_issue(*diagnosis.strict_refusal));
    return out;
}

}  // namespace posepack::output

// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "output/choice_text.hpp"
#include "output/report_totals.hpp"
#include "output/report_writers.hpp"

namespace posepack::output {
namespace {

using base::widened;
using nlohmann::json;

json error_json(const recipe::ErrorRecord& e) {
    return {{"max", widened(e.max)},
            {"p999", widened(e.p999)},
            {"rms", widened(e.rms)},
            {"max_m", widened(e.max_m)},
            {"p999_m", widened(e.p999_m)},
            {"rms_m", widened(e.rms_m)},
            {"normal_max_deg", widened(e.normal_max_deg)},
            {"normal_p999_deg", widened(e.normal_p999_deg)},
            {"normal_rms_deg", widened(e.normal_rms_deg)},
            {"worst",
             {{"clip", base::printable(e.clip)},
              {"time_s", widened(e.time_s)},
              {"mesh", base::printable(e.mesh)},
              {"vertex", e.vertex},
              {"bone", base::printable(e.bone)}}}};
}

json row_json(const ReportRow& row) {
    return {{"form", row.form},
            {"encoding", row.encoding},
            {"texel_format", row.texel_format},
            {"rows", row.rows},
            {"chosen", row.is_chosen},
            {"bytes", row.bytes},
            {"error", error_json(row.error)},
            {"decode_ns_per_vertex", row.decode_ns_per_vertex},
            {"fetches", row.fetches},
            {"alu_operations", row.alu_operations},
            {"bake_ms", row.bake_ms}};
}

json clip_json(const recipe::ClipRecord& clip) {
    json error = error_json(clip.error);
    error["worst"].erase("clip");
    json tried = json::array();
    for (const recipe::TryRecord& one : clip.tried)
        tried.push_back({{"encoding", one.encoding},
                         {"row_scheme", one.row_scheme},
                         {"bytes", one.bytes},
                         {"max", widened(one.max)},
                         {"p999", widened(one.p999)},
                         {"rms", widened(one.rms)},
                         {"keeps_bound", one.keeps_bound}});
    return {{"name", base::printable(clip.name)},
            {"encoding", clip.encoding},
            {"row_scheme", clip.row_scheme},
            {"rows", clip.row_count},
            {"why", choice_sentence(clip)},
            {"tried", tried},
            {"rate_hz", widened(clip.rate_hz)},
            {"period_s", widened(clip.period_s)},
            {"error", error}};
}

json heat_json(const HeatMap& heat) {
    json bones = json::array(), clips = json::array();
    for (const std::string& bone : heat.bones) bones.push_back(base::printable(bone));
    for (const HeatClip& clip : heat.clips) {
        json errors = json::array();
        for (std::size_t first = 0; first < clip.errors.size(); first += heat.bones.size()) {
            json bin = json::array();
            for (std::size_t bone = 0; bone < heat.bones.size(); ++bone)
                bin.push_back(widened(clip.errors[first + bone]));
            errors.push_back(std::move(bin));
        }
        clips.push_back(
            {{"name", base::printable(clip.name)}, {"edges_s", clip.edges_s}, {"errors", errors}});
    }
    return {{"bones", bones}, {"clips", clips}};
}

json animal_json(const AnimalReport& animal) {
    json rows = json::array(), refused = json::array(), clips = json::array();
    for (const ReportRow& row : animal.rows) rows.push_back(row_json(row));
    for (const RefusedForm& form : animal.refused)
        refused.push_back({{"form", form.form},
                           {"rows", form.rows},
                           {"issue", json::parse(format_issue_json(form.issue))}});
    for (const recipe::ClipRecord& clip : animal.clips) clips.push_back(clip_json(clip));
    return {{"id", animal.id},
            {"radius_m", widened(animal.radius_m)},
            {"bones", animal.bone_count},
            {"vertices", animal.vertex_count},
            {"rows", rows},
            {"refused", refused},
            {"clips", clips},
            {"heat_map", animal.heat ? heat_json(*animal.heat) : json(nullptr)}};
}

json spread_json(const Spread& spread) {
    return {{"median", spread.median}, {"worst", spread.worst}, {"worst_animal", spread.worst_animal}};
}

json total_json(const ReportTotal& total) {
    return {{"form", total.form},
            {"rows", total.rows},
            {"chosen", total.is_chosen},
            {"animals", total.animal_count},
            {"bytes", total.bytes},
            {"max", spread_json(total.max)},
            {"p999", spread_json(total.p999)},
            {"rms", spread_json(total.rms)},
            {"max_m", spread_json(total.max_m)},
            {"normal_max_deg", spread_json(total.normal_max_deg)},
            {"decode_ns_per_vertex", total.decode_ns_per_vertex},
            {"fetches", total.fetches},
            {"alu_operations", total.alu_operations},
            {"bake_ms", total.bake_ms}};
}

}  // namespace

std::string report_json(const Report& report, int indent) {
    json animals = json::array(), totals = json::array();
    for (const AnimalReport& animal : report.animals) animals.push_back(animal_json(animal));
    for (const ReportTotal& total : report_totals(report)) totals.push_back(total_json(total));
    const json out{{"schema", "posepack-report-1"},
                   {"catalog", base::printable(report.catalog)},
                   {"animals", animals},
                   {"totals", totals}};
    return out.dump(indent);
}

}  // namespace posepack::output

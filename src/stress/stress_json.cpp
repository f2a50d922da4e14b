// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <algorithm>

#include "base/text.hpp"
#include "stress/stress_report.hpp"

namespace posepack::stress {
namespace {

using Json = nlohmann::ordered_json;

// Six digits are more than any of these figures mean.
Json number(double value) {
    return base::widened(static_cast<float>(value));
}

Json amounts_json(const Amounts& amounts) {
    return {{"max", number(amounts.max)}, {"p999", number(amounts.p999)}, {"rms", number(amounts.rms)}};
}

Json form_json(const Form& form) {
    return {{"encoding", name_of(form.encoding)},
            {"texel_format", name_of(form.texel_format)},
            {"space", name_of(form.space)}};
}

Json result_json(const FormResult& result) {
    Json out = form_json(result.form);
    out["refused"] = nullptr;
    out["measured"] = nullptr;
    if (result.refusal) {
        out["refused"] = {{"code", issue_kind(result.refusal->code).id},
                          {"message", format_issue(*result.refusal)}};
        return out;
    }
    out["measured"] = {{"rows", result.row_count},
                       {"bytes", result.texel_bytes},
                       {"at_rows", amounts_json(result.drawn.rows)},
                       {"drawn", amounts_json(result.drawn.all)},
                       {"printed", amounts_json(result.printed)},
                       {"normal_max_deg", number(result.normal_max_deg)}};
    return out;
}

Json action_json(const Action& action) {
    return {{"text", text_of(action)},
            {"switches_form", action.switches_form},
            {"adds_rows", action.adds_rows},
            {"slots", action.has_slots},
            {"cuts", action.cuts},
            {"misses", action.misses},
            {"refuses", action.refuses ? Json(issue_kind(*action.refuses).id) : Json(nullptr)}};
}

Json chosen_json(const Chosen& chosen) {
    Json out = form_json(chosen.form);
    out["row_scheme"] = chosen.has_slots ? "slots" : "runs";
    out["bone_rows"] = chosen.bone_row_count;
    out["bone_rows_at_start"] = chosen.start_bone_row_count;
    out["cuts"] = chosen.cut_count;
    out["bytes"] = chosen.texel_bytes;
    out["drawn"] = amounts_json(chosen.drawn.all);
    return out;
}

Json case_json(const CaseResult& result) {
    const StressCase& stress_case = *result.stress_case;
    Json forms = Json::array();
    for (const FormResult& form : result.forms) forms.push_back(result_json(form));
    Json warnings = Json::array();
    for (const base::IssueCode code : result.found.warnings) warnings.push_back(issue_kind(code).id);
    return {{"name", stress_case.name},
            {"group", result.group},
            {"trouble", stress_case.trouble},
            {"reader",
             {{"running_s", stress_case.reader.running_s},
              {"raw_clock", stress_case.reader.has_raw_clock},
              {"half_phase", stress_case.reader.has_half_phase}}},
            {"bound", {{"max", number(result.bound.max)}, {"p999", number(result.bound.p999)}}},
            {"forms", std::move(forms)},
            {"expected", action_json(stress_case.expected.action)},
            {"found", action_json(result.found.action)},
            {"chosen", result.chosen ? chosen_json(*result.chosen) : Json(nullptr)},
            {"refusal", result.found.refusal.empty() ? Json(nullptr) : Json(result.found.refusal)},
            {"warnings", std::move(warnings)},
            {"difference", result.difference.empty() ? Json(nullptr) : Json(result.difference)}};
}

}  // namespace

std::string stress_json(std::span<const CaseResult> results, double bound_factor) {
    Json cases = Json::array();
    for (const CaseResult& result : results) cases.push_back(case_json(result));
    const bool ok = std::all_of(results.begin(), results.end(),
                                [](const CaseResult& result) { return result.difference.empty(); });
    const Json out{{"schema", "posepack-stress-1"},
                   {"ok", ok},
                   {"bound_factor", bound_factor},
                   {"cases", std::move(cases)}};
    return out.dump(1);
}

}  // namespace posepack::stress

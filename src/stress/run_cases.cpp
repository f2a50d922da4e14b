// SPDX-License-Identifier: MIT
#include "stress/run_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "animal/read_animal.hpp"
#include "animal/unused_bones.hpp"
#include "bake/bake_animal.hpp"
#include "bake/workers.hpp"
#include "base/interrupt.hpp"
#include "base/text.hpp"
#include "posepack/loader.h"

namespace posepack::stress {
namespace {

using base::Issue;
using base::IssueCode;

// A bake is judged by what it prints. What it draws may be found worse by as much as docs/error_metric.md
// allows: times that it did not look at, and the rounding of the shader.
constexpr double kSeenShare = 0.97;
constexpr double kUnseen = 5e-4;  // R

bool is_held(const Amounts& amounts, const Bound& bound) {
    return amounts.max <= bound.max / kSeenShare + kUnseen &&
           amounts.p999 <= bound.p999 / kSeenShare + kUnseen;
}

void note_warnings(std::span<const Issue> findings, Found& found) {
    for (const Issue& finding : findings)
        if (std::find(found.warnings.begin(), found.warnings.end(), finding.code) == found.warnings.end())
            found.warnings.push_back(finding.code);
}

// One case at work.
class CaseRun {
 public:
    CaseRun(const StressCase& stress_case, std::string_view group, double bound_factor)
        : case_(stress_case), entry_(entry_of(stress_case)), glb_(write_glb(stress_case.build())) {
        result_.stress_case = &stress_case;
        result_.group = group;
        result_.bound = {stress_case.bound.max * bound_factor, stress_case.bound.p999 * bound_factor};
    }

    base::Result<CaseResult> run() {
        auto animal = animal::read_animal(glb_);
        if (animal) animal_ = std::move(animal).value();
        for (const Form& form : all_forms())
            if (auto status = measure_form(form); !status) return status.issue();
        if (auto status = choose(); !status) return status.issue();
        result_.difference = difference(case_.expected, result_.found);
        return std::move(result_);
    }

 private:
    // Errors: E-INTERNAL. What a form refuses is a result.
    base::Status measure_form(const Form& form) {
        FormResult& out = result_.forms.emplace_back();
        out.form = form;
        const auto baked = bake::bake_animal(in_form(entry_, form), glb_, {});
        if (!baked) {
            out.refusal = baked.issue();
            return {};
        }
        note_warnings(baked.value().findings, result_.found);
        const recipe::BakeRecord& record = baked.value().record;
        out.row_count = record.row_count;
        out.texel_bytes = record.texel_bytes;
        out.printed = {static_cast<double>(record.error.max), static_cast<double>(record.error.p999),
                       static_cast<double>(record.error.rms)};
        out.normal_max_deg = static_cast<double>(record.error.normal_max_deg);
        const auto drawn = measure_drawn(*animal_, baked.value().container, case_.reader);
        if (!drawn) return drawn.issue();
        out.drawn = drawn.value();
        return {};
    }

    base::Status choose() {
        const auto baked = bake::bake_animal(under_bound(entry_, result_.bound), glb_, {});
        if (!baked) {
            result_.found.action = refuses(baked.issue().code);
            result_.found.refusal = format_issue(baked.issue());
            return {};
        }
        auto chosen = describe(baked.value().container);
        if (!chosen) return chosen.issue();
        result_.chosen = chosen.value();
        Action& action = result_.found.action;
        action.switches_form = chosen.value().form != Form{};
        action.adds_rows = chosen.value().bone_row_count > chosen.value().start_bone_row_count;
        action.has_slots = chosen.value().has_slots;
        action.cuts = chosen.value().cut_count > 0;
        action.misses = !is_held(chosen.value().drawn.all, result_.bound);
        return {};
    }

    // What the loader says of the chosen container, and how far it is off.
    base::Result<Chosen> describe(const base::Bytes& container) const {
        animal::Animal baked = *animal_;  // bones as the container numbers them
        animal::drop_unused_bones(baked);
        const auto drawn = measure_drawn(baked, container, case_.reader);
        if (!drawn) return drawn.issue();
        Chosen chosen;
        chosen.drawn = drawn.value();
        posepack_view view;
        posepack_open(&view, container.data(), container.size());
        chosen.start_bone_row_count = std::uint64_t{rows_at_start()} * animal_->bones.size();
        std::set<std::uint32_t> bone_rows;  // by their first texels
        for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
            posepack_clip clip;
            posepack_get_clip(&view, c, &clip);
            if (c == 0) chosen.form = form_of(view, clip);
            if (c == 0) chosen.has_slots = clip.row_scheme == POSEPACK_ROWS_SLOTS;
            chosen.cut_count += cuts_of(view, c, clip.slot_count);
            for (std::uint32_t bone = 0; bone < view.header.bone_count; ++bone) {
                posepack_run run;
                posepack_get_run(&view, c, bone, &run);
                for (std::uint32_t row = 0; row <= run.interval_count; ++row)
                    bone_rows.insert(run.texel + row * run.texel_step);
            }
        }
        chosen.bone_row_count = bone_rows.size();
        posepack_texels texels;
        posepack_get_texels(&view, &texels);
        chosen.texel_bytes = texels.size_bytes;
        return chosen;
    }

    // Jumps that a row ends in front of: there a slot begins at a later row than the one before ends at.
    static std::uint32_t cuts_of(const posepack_view& view, std::uint32_t clip, std::uint32_t slot_count) {
        std::uint32_t count = 0;
        std::uint32_t end = 0;
        for (std::uint32_t k = 0; k < slot_count; ++k) {
            posepack_slot slot;
            posepack_get_slot(&view, clip, k, &slot);
            count += slot.row > end;
            end = slot.row + (slot.span == 0 ? slot.offset : (slot.offset + 1) / slot.span);
        }
        return count;
    }

    static Form form_of(const posepack_view& view, const posepack_clip& clip) {
        Form form;
        form.encoding = clip.encoding == POSEPACK_ENCODING_MAT4     ? recipe::Encoding::mat4
                        : clip.encoding == POSEPACK_ENCODING_AFFINE ? recipe::Encoding::affine
                                                                    : recipe::Encoding::dualquat;
        form.texel_format = view.header.texel_format == POSEPACK_TEXEL_RGBA16F ? recipe::TexelFormat::rgba16f
                                                                               : recipe::TexelFormat::rgba32f;
        form.space = (view.header.space_flags & POSEPACK_SPACE_NORMALISED) != 0 ? recipe::Space::normalised
                                                                                : recipe::Space::model;
        return form;
    }

    // Rows of the first form that could be baked; the plan is the same for all, but for closing rows.
    std::uint32_t rows_at_start() const {
        for (const FormResult& form : result_.forms)
            if (!form.refusal && form.form.encoding != recipe::Encoding::dualquat) return form.row_count;
        return 0;
    }

    const StressCase& case_;
    recipe::AnimalEntry entry_;
    std::vector<std::uint8_t> glb_;
    std::optional<animal::Animal> animal_;
    CaseResult result_;
};

struct Listed {
    const StressCase* stress_case;
    std::string_view group;
};

std::vector<Listed> listed_cases() {
    std::vector<Listed> all;
    for (const CaseGroup& group : case_groups())
        for (const StressCase& stress_case : group.cases) all.push_back({&stress_case, group.title});
    return all;
}

base::Result<std::vector<Listed>> cases_named(const std::vector<std::string>& names) {
    std::vector<Listed> all = listed_cases();
    if (names.empty()) return all;
    std::vector<std::string> known;
    known.reserve(all.size());
    for (const Listed& listed : all) known.emplace_back(listed.stress_case->name);
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string near = base::nearest(name, known);
        return Issue{IssueCode::usage, "--only",
                     fmt::format("expected names of stress cases, found '{}'{}", name,
                                 near.empty() ? "" : fmt::format("; did you mean '{}'?", near))};
    }
    std::erase_if(all, [&names](const Listed& listed) {
        return std::find(names.begin(), names.end(), listed.stress_case->name) == names.end();
    });
    return all;
}

}  // namespace

base::Result<CaseResult> run_case(const StressCase& stress_case, std::string_view group,
                                  double bound_factor) {
    return CaseRun(stress_case, group, bound_factor).run();
}

base::Result<std::vector<CaseResult>> run_cases(const RunOptions& options) {
    const auto listed = cases_named(options.only);
    if (!listed) return listed.issue();
    std::vector<std::optional<base::Result<CaseResult>>> results(listed.value().size());
    bake::run_jobs(results.size(), options.jobs, [&](std::size_t index) {
        const Listed& one = listed.value()[index];
        results[index] = run_case(*one.stress_case, one.group, options.bound_factor);
        return static_cast<bool>(*results[index]);
    });
    if (auto status = base::check_interrupt(); !status) return status.issue();
    std::vector<CaseResult> out;
    for (auto& result : results) {
        if (!result) break;
        if (!*result) return result->issue();
        out.push_back(std::move(*result).value());
    }
    return out;
}

}  // namespace posepack::stress

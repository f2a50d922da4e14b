// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/sha256.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/container_file.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "output/container_json.hpp"
#include "output/text_table.hpp"

namespace posepack::cli {
namespace {

using base::Issue;
using base::IssueCode;
using output::Align;

struct Options {
    std::string container;
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
    std::string clip, bone;
    std::optional<std::uint32_t> row;
    std::optional<double> phase;
    bool bones = false;
};

std::string text_of(const posepack_string& string) {
    return {string.data, string.size_bytes};
}

output::TextTable clips_table(const posepack_view& view) {
    output::TextTable table;
    table.columns = {{"clip", Align::left},
                     {"rows"},
                     {"first"},
                     {"rate Hz"},
                     {"period s"},
                     {"form", Align::left},
                     {"wrap", Align::left},
                     {"speed m/s"},
                     {"max / R"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"max mm"},
                     {"p99.9 mm"},
                     {"rms mm"},
                     {"normal deg"},
                     {"worst place", Align::left}};
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        if (posepack_get_clip(&view, c, &clip) != POSEPACK_OK) continue;
        posepack_bone bone;
        const bool placed =
            clip.measured != 0 && posepack_get_bone(&view, clip.error.bone, &bone) == POSEPACK_OK;
        const std::string wrap = output::wrap_name(clip.wrap) +
                                 (clip.wrap == POSEPACK_WRAP_LOOP ? ", " + output::seam_name(clip.seam) : "");
        const auto figure = [&](float value) {
            return clip.measured != 0 ? output::readable_error(value) : "-";
        };
        const auto millimetres = [&](float value) {
            return clip.measured != 0
                       ? fmt::format("{:.3g}", static_cast<double>(value) *
                                                   static_cast<double>(view.header.radius_m) * 1e3)
                       : "-";
        };
        table.rows.push_back(
            {text_of(clip.name), std::to_string(clip.row_count), std::to_string(clip.first_row),
             fmt::format("{:.6g}", clip.rate_hz), fmt::format("{:.4f}", clip.period_s),
             output::encoding_name(clip.encoding) + ", " + output::row_scheme_name(clip.row_scheme), wrap,
             clip.speed_mps > 0 ? fmt::format("{:.3g}", clip.speed_mps) : "-", figure(clip.error.max),
             figure(clip.error.p999), figure(clip.error.rms), millimetres(clip.error.max),
             millimetres(clip.error.p999), millimetres(clip.error.rms),
             clip.measured != 0 ? fmt::format("{:.3g}", clip.error.normal_max_deg) : "-",
             placed ? fmt::format("{:.3f} s, vertex {}, {}", clip.error.time_s, clip.error.vertex,
                                  text_of(bone.name))
                    : "not measured"});
    }
    return table;
}

output::TextTable bones_table(const posepack_view& view) {
    output::TextTable table;
    table.columns = {{"bone"}, {"name", Align::left}, {"parent"}, {"node"}, {"weighted", Align::left}};
    for (std::uint32_t b = 0; b < view.header.bone_count; ++b) {
        posepack_bone bone;
        if (posepack_get_bone(&view, b, &bone) != POSEPACK_OK) continue;
        table.rows.push_back({std::to_string(b), text_of(bone.name),
                              bone.parent == POSEPACK_NONE ? "-" : std::to_string(bone.parent),
                              std::to_string(bone.node),
                              (bone.flags & POSEPACK_BONE_FLAG_WEIGHTED) != 0 ? "yes" : "no"});
    }
    return table;
}

// The bones that move no vertex, and how many joints have none: what --unused-bones keeps or drops.
void print_unused(const posepack_view& view) {
    constexpr std::uint32_t kMostNames = 16;
    std::uint32_t unused = 0;
    std::string names;
    for (std::uint32_t b = 0; b < view.header.bone_count; ++b) {
        posepack_bone bone;
        if (posepack_get_bone(&view, b, &bone) != POSEPACK_OK) continue;
        if ((bone.flags & POSEPACK_BONE_FLAG_WEIGHTED) != 0) continue;
        if (unused++ < kMostNames)
            names += (unused > 1 ? ", " : "") + base::shortened(text_of(bone.name), 40);
    }
    if (unused > kMostNames) names += fmt::format(" and {} more", unused - kMostNames);
    if (unused > 0) fmt::print("unused    {} without a vertex: {}\n", base::counted(unused, "bone"), names);
    if (const std::uint64_t left_out = output::joints_without_bone(view); left_out > 0)
        fmt::print("unused    {} without a bone: left out, no vertex moves by them\n",
                   base::counted(left_out, "joint"));
}

void print_summary(const posepack_view& view, const Options& options) {
    const posepack_header& h = view.header;
    fmt::print("{}: format {}.{} (draft), {} bytes, bake ABI {}\n", options.container, h.major, h.minor,
               base::grouped(h.file_bytes), h.bake_abi);
    fmt::print("palette   {} {}, {}, {} bones x {} rows, texture {} x {}, pitch {} bytes\n",
               output::encoding_name(h.encoding), output::texel_format_name(h.texel_format),
               output::texel_order_name(h.texel_order), h.bone_count, h.row_count, h.texture_width_texels,
               h.texture_height_texels, h.row_pitch_bytes);
    print_unused(view);
    fmt::print("radius R  {:.4g} m\nrecipe    {}\nsections ", h.radius_m, base::hexadecimal(h.recipe_sha256));
    for (std::uint32_t s = 0; s < h.section_count; ++s) {
        std::string type;
        for (int i = 0; i < 4; ++i) type += static_cast<char>(view.sections[s].type >> (8 * i) & 0xFF);
        fmt::print(" {} {}", type, view.sections[s].stored_bytes);
    }
    fmt::print("\n\n{}", format_text(clips_table(view)));
    std::uint32_t count = 0, default_state = POSEPACK_NONE;
    if (posepack_count_states(&view, &count, &default_state) == POSEPACK_OK && count > 0)
        fmt::print("\nstates   ");
    for (std::uint32_t s = 0; s < count; ++s) {
        posepack_state state;
        posepack_clip clip;
        if (posepack_get_state(&view, s, &state) == POSEPACK_OK &&
            posepack_get_clip(&view, state.clip, &clip) == POSEPACK_OK)
            fmt::print(" {}{} -> {}{}", text_of(state.name), s == default_state ? " (default)" : "",
                       text_of(clip.name), s + 1 < count ? "," : "\n");
    }
    if (options.bones) fmt::print("\n{}", format_text(bones_table(view)));
}

// A bone by number or name; a row of the container, or of a clip when one is named.
struct BoneRow {
    std::uint32_t row = 0, bone = 0;
};

base::Result<std::uint32_t> find_bone(const posepack_view& view, const Options& options) {
    std::uint32_t bone = 0;
    if (options.bone.empty() || posepack_find_bone(&view, options.bone.c_str(), &bone) == POSEPACK_OK)
        return bone;
    const bool number =
        options.bone.find_first_not_of("0123456789") == std::string::npos && options.bone.size() < 6;
    if (number) bone = static_cast<std::uint32_t>(std::stoul(options.bone));
    if (!number || bone >= view.header.bone_count)
        return Issue{
            IssueCode::usage, "--bone",
            fmt::format("expected a name or 0 to {}, found '{}'", view.header.bone_count - 1, options.bone)};
    return bone;
}

base::Result<std::uint32_t> find_clip(const posepack_view& view, const Options& options) {
    std::uint32_t index = 0;
    if (posepack_find_clip(&view, options.clip.c_str(), &index) == POSEPACK_OK) return index;
    return Issue{IssueCode::usage, "--clip",
                 fmt::format("expected one of the container's {} clips, found '{}'", view.header.clip_count,
                             options.clip)};
}

base::Result<BoneRow> find_bone_row(const posepack_view& view, const Options& options) {
    BoneRow place;
    if (view.header.row_scheme != POSEPACK_ROWS_UNIFORM)
        return Issue{
            IssueCode::usage, "--row",
            "expected --phase and --clip, because the bones of this palette share no rows, found --row"};
    std::uint32_t row_limit = view.header.row_count;
    std::uint32_t first_row = 0;
    if (!options.clip.empty()) {
        const auto index = find_clip(view, options);
        if (!index) return index.issue();
        posepack_clip clip;
        posepack_get_clip(&view, index.value(), &clip);
        first_row = clip.first_row;
        row_limit = clip.row_count;
    }
    if (*options.row >= row_limit)
        return Issue{IssueCode::usage, "--row",
                     fmt::format("expected 0 to {}, found {}", row_limit - 1, *options.row)};
    place.row = first_row + *options.row;
    const auto bone = find_bone(view, options);
    if (!bone) return bone.issue();
    place.bone = bone.value();
    return place;
}

// What is shown: a row or a phase, the bone and its matrix.
struct Matrix {
    nlohmann::json where;  // "row", or "clip" and "phase"
    std::string title;
    std::uint32_t bone = 0;
    float m[12] = {};
};

base::Result<Matrix> matrix_at_row(const posepack_view& view, const Options& options) {
    const auto place = find_bone_row(view, options);
    if (!place) return place.issue();
    Matrix out{
        {{"row", place.value().row}}, fmt::format("row {}", place.value().row), place.value().bone, {}};
    posepack_decode_bone(&view, place.value().row, out.bone, out.m);
    return out;
}

base::Result<Matrix> matrix_at_phase(const posepack_view& view, const Options& options) {
    if (options.clip.empty())
        return Issue{IssueCode::usage, "--phase", "expected --clip with it, found none"};
    const auto clip = find_clip(view, options);
    if (!clip) return clip.issue();
    const auto bone = find_bone(view, options);
    if (!bone) return bone.issue();
    Matrix out{{{"clip", options.clip}, {"phase", *options.phase}},
               fmt::format("{} at phase {:g}", options.clip, *options.phase),
               bone.value(),
               {}};
    posepack_sample_bone(&view, clip.value(), static_cast<float>(*options.phase), out.bone, out.m);
    return out;
}

int print_matrix(const posepack_view& view, const Options& options) {
    const auto found = options.phase ? matrix_at_phase(view, options) : matrix_at_row(view, options);
    if (!found) return fail(found.issue());
    const float* m = found.value().m;
    posepack_bone bone;
    posepack_get_bone(&view, found.value().bone, &bone);
    if (*options.format == Format::json) {
        nlohmann::json rows = nlohmann::json::array();
        for (int r = 0; r < 3; ++r) {
            nlohmann::json row = nlohmann::json::array();
            for (int c = 0; c < 4; ++c) row.push_back(base::widened(m[r * 4 + c]));
            rows.push_back(row);
        }
        nlohmann::json json{{"schema", "posepack-matrix-1"},
                            {"bone", found.value().bone},
                            {"name", text_of(bone.name)},
                            {"matrix", rows}};
        json.update(found.value().where);
        fmt::print("{}\n", json.dump(1));
        return 0;
    }
    fmt::print("{}, bone {} ({}):\n", found.value().title, found.value().bone, text_of(bone.name));
    for (int r = 0; r < 3; ++r)
        fmt::print("{:>14} {:>14} {:>14} {:>14}\n", base::shortest(m[r * 4]), base::shortest(m[r * 4 + 1]),
                   base::shortest(m[r * 4 + 2]), base::shortest(m[r * 4 + 3]));
    return 0;
}

int run(const Options& options) {
    if (options.row && options.phase)
        return fail({IssueCode::usage, "--phase", "expected --row or --phase, found both"});
    if (!options.row && !options.phase && (!options.clip.empty() || !options.bone.empty()))
        return fail({IssueCode::usage, options.clip.empty() ? "--bone" : "--clip",
                     "expected --row or --phase with it, for one bone as a matrix, found none"});
    const auto file = open_container(options.container);
    if (!file) return fail(file.issue());
    const posepack_view& view = file.value().view;
    if (options.row || options.phase) return print_matrix(view, options);
    if (*options.format == Format::json)
        fmt::print("{}\n", output::container_json(view, 1));
    else
        print_summary(view, options);
    return 0;
}

}  // namespace

Runner add_inspect(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("container", options->container, "Container to show")->required()->type_name("FILE");
    app.add_flag("--bones", options->bones, "List the bones too");
    app.add_option("--row", options->row, "Show one bone-row as a matrix: row of the container, or of --clip")
        ->check(whole_between(0, POSEPACK_MAX_ROWS - 1))
        ->group("Matrix")
        ->type_name("N");
    app.add_option("--phase", options->phase, "Show one bone at a phase of --clip as a matrix, 0 to 1")
        ->check(number_between(0.0, 1.0))
        ->group("Matrix")
        ->type_name("P");
    app.add_option("--clip", options->clip, "Clip that --row counts from, or --phase means")
        ->group("Matrix")
        ->type_name("NAME");
    app.add_option("--bone", options->bone, "Bone by name or number (default: 0)")
        ->group("Matrix")
        ->type_name("BONE");
    add_format_option(app, options->format, false);
    return [options] { return run(*options); };
}

}  // namespace posepack::cli

// SPDX-License-Identifier: MIT
#include "cli/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>

namespace posepack::cli {
namespace {

using recipe::Caps;
using recipe::Encoding;
using recipe::RowPitch;
using recipe::Space;
using recipe::TexelFormat;
using recipe::TexelOrder;
using recipe::UnusedBones;

// An option that takes one of the values' names and sets an optional of the overrides.
template <class Enum>
void add_choice(CLI::App& app, const std::string& flag, const std::string& help,
                const std::shared_ptr<bake::CatalogSource>& source,
                std::optional<Enum> recipe::OutputOverrides::*field, std::initializer_list<Enum> values) {
    std::map<std::string, Enum> by_name;
    std::string names;
    for (const Enum value : values) {
        by_name.emplace(name_of(value), value);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(value));
    }
    app.add_option_function<std::string>(
           flag,
           [by_name, names, flag, source, field](const std::string& text) {
               const auto found = by_name.find(text);
               if (found == by_name.end())
                   throw CLI::ValidationError(flag,
                                              fmt::format("expected one of {}, found '{}'", names, text));
               source->overrides.*field = found->second;
           },
           fmt::format("{}: {}", help, names))
        ->group("Output")
        ->type_name("NAME");
}

// A limit beside --max-error, which CLI11 makes sure comes too; their order on the command line is free.
void add_limit(CLI::App& app, const std::string& flag, const std::string& what,
               const std::shared_ptr<bake::CatalogSource>& source,
               std::optional<recipe::ErrorLimit> recipe::ErrorBound::*field) {
    app.add_option_function<std::string>(
           flag,
           [flag, source, field](const std::string& text) {
               const auto limit = recipe::parse_error_limit(text);
               if (!limit)
                   throw CLI::ValidationError(
                       flag, fmt::format("expected a fraction of the radius (0.02), millimetres (5mm) or "
                                         "pixels (1px@20m,1080,60), found '{}'",
                                         text));
               if (!source->overrides.bound) source->overrides.bound.emplace();
               (*source->overrides.bound).*field = limit;
           },
           fmt::format("Bound {}; with --max-error", what))
        ->needs("--max-error")
        ->group("Output")
        ->type_name("LIMIT");
}

// A validator that takes a text when all of it reads as a Number from `least` to `most`. NaN compares with
// nothing, so it is refused; infinity lies outside of any range.
template <class Number>
CLI::Validator between(std::string_view what, Number least, Number most) {
    const auto check = [what, least, most](const std::string& text) {
        Number value{};
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc{} && stop == end && value >= least && value <= most) return std::string();
        return fmt::format("expected {} from {} to {}, found '{}'", what, least, most, text);
    };
    return {check, fmt::format("{} to {}", least, most)};
}

}  // namespace

CLI::Validator number_between(double least, double most) {
    return between("a number", least, most);
}

CLI::Validator whole_between(std::uint64_t least, std::uint64_t most) {
    return between("a whole number", least, most);
}

void add_catalog_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source) {
    app.add_option("catalog", source->catalog, "Catalog of animals (JSON)")->required()->type_name("CATALOG");
    app.add_option("--models", source->models,
                   "Folder that the model paths start from (default: the catalog's)")
        ->type_name("DIR");
    app.add_option("--only", source->only, "Only these animals (ids, comma-separated)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("ID");
}

void add_output_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source) {
    add_choice(app, "--encoding", "Form of a bone", source, &recipe::OutputOverrides::encoding,
               {Encoding::mat4, Encoding::affine, Encoding::dualquat});
    add_choice(app, "--space", "Coordinates of the rows", source, &recipe::OutputOverrides::space,
               {Space::automatic, Space::model, Space::normalised});
    add_choice(app, "--texel-format", "Numbers of a texel", source, &recipe::OutputOverrides::texel_format,
               {TexelFormat::rgba16f, TexelFormat::rgba32f});
    add_choice(app, "--texel-order", "Order of a row's texels", source, &recipe::OutputOverrides::texel_order,
               {TexelOrder::bone_major, TexelOrder::planar});
    add_choice(app, "--row-pitch", "Bytes from line to line", source, &recipe::OutputOverrides::row_pitch,
               {RowPitch::tight, RowPitch::align256});
    add_choice(app, "--caps", "Largest texture: 4096 or 16384 texels a side", source,
               &recipe::OutputOverrides::caps, {Caps::webgl2, Caps::desktop});
    app.add_option_function<std::string>(
           "--influences",
           [source](const std::string& text) {
               if (text != "4" && text != "8")
                   throw CLI::ValidationError("--influences",
                                              fmt::format("expected 4 or 8, found '{}'", text));
               source->overrides.influences = text == "4" ? 4u : 8u;
           },
           "Joints a vertex keeps, the largest weights: 4, 8 (default: 4)")
        ->group("Output")
        ->type_name("N");
    add_choice(app, "--unused-bones", "Bones that move no vertex (auto: drop under a bound)", source,
               &recipe::OutputOverrides::unused_bones,
               {UnusedBones::automatic, UnusedBones::keep, UnusedBones::drop});
    app.add_option("--rate", source->rate_hz,
                   "Rows a second for every clip (default: each clip's own key grid)")
        ->check(number_between(1.0, 1000.0))
        ->group("Output")
        ->type_name("HZ");
}

void add_bound_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source) {
    app.add_option_function<std::string>(
           "--max-error",
           [source](const std::string& text) {
               const auto bound = recipe::parse_error_bound(text);
               if (!bound)
                   throw CLI::ValidationError("--max-error", fmt::format("expected one of {}, found '{}'",
                                                                         recipe::kErrorLimitForms, text));
               const auto given = source->overrides.bound;
               source->overrides.bound = bound;
               if (given && given->p999) source->overrides.bound->p999 = given->p999;
               if (given && given->rms) source->overrides.bound->rms = given->rms;
           },
           fmt::format("Smallest form and rows whose largest error stays within: {}; p99.9 within a quarter",
                       recipe::kErrorLimitForms))
        ->group("Output")
        ->type_name("BOUND");
    add_limit(app, "--p999-error", "of 99.9 % of the errors, instead of a quarter", source,
              &recipe::ErrorBound::p999);
    add_limit(app, "--rms-error", "of their root mean square", source, &recipe::ErrorBound::rms);
}

void add_format_option(CLI::App& app, const std::shared_ptr<Format>& format, bool with_csv) {
    const std::string names = with_csv ? "text, csv, json" : "text, json";
    app.add_option_function<std::string>(
           "--format",
           [format, with_csv, names](const std::string& text) {
               if (text == "text")
                   *format = Format::text;
               else if (text == "json")
                   *format = Format::json;
               else if (text == "csv" && with_csv)
                   *format = Format::csv;
               else
                   throw CLI::ValidationError("--format",
                                              fmt::format("expected one of {}, found '{}'", names, text));
           },
           fmt::format("Output on stdout: {} (default: text)", names))
        ->type_name("NAME");
}

}  // namespace posepack::cli

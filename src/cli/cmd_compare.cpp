// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "bake/compare.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "output/text_table.hpp"
#include "vat/vram.hpp"

namespace posepack::cli {
namespace {

struct Options {
    std::shared_ptr<bake::CatalogSource> source = std::make_shared<bake::CatalogSource>();
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
    std::uint32_t copies = 1;
};

constexpr std::uint32_t kInfluences = 4;

std::array<std::uint64_t, vat::kFormCount> in_order(const recipe::VramRecord& vram) {
    return {vram.mat4_rgba32f,     vram.mat4_rgba16f,        vram.affine_rgba32f, vram.affine_rgba16f,
            vram.dualquat_rgba16f, vram.vat_position_rgb32f, vram.vat_rgba32f,    vram.vat_rgba16f};
}

std::vector<std::string> cells_of(const bake::CompareRow& row) {
    std::vector<std::string> cells{row.id, std::to_string(row.bone_count), std::to_string(row.row_count),
                                   std::to_string(row.vertex_count)};
    for (const std::uint64_t bytes : in_order(row.vram)) cells.push_back(std::to_string(bytes));
    return cells;
}

output::TextTable bytes_table(const bake::Comparison& comparison) {
    output::TextTable table;
    table.columns = {{"animal", output::Align::left}, {"bones"}, {"rows"}, {"vertices"}};
    for (const vat::Form& form : vat::kForms) table.columns.push_back({std::string(form.name)});
    for (const bake::CompareRow& row : comparison.rows) table.rows.push_back(cells_of(row));
    table.total = cells_of(comparison.total);
    return table;
}

output::TextTable reads_table() {
    output::TextTable table;
    table.columns = {{"form", output::Align::left}, {"texel reads a vertex"}, {"bytes an element and row"}};
    for (const vat::Form& form : vat::kForms)
        table.rows.push_back(
            {std::string(form.name), std::to_string(texel_reads(form, kInfluences)),
             fmt::format("{} a {}", form.bytes_per_element, form.is_palette ? "bone" : "vertex")});
    return table;
}

nlohmann::json row_json(const bake::CompareRow& row) {
    nlohmann::json bytes = nlohmann::json::object();
    const auto values = in_order(row.vram);
    for (std::size_t f = 0; f < vat::kFormCount; ++f) bytes[std::string(vat::kForms[f].name)] = values[f];
    return {{"id", row.id},
            {"bones", row.bone_count},
            {"rows", row.row_count},
            {"vertices", row.vertex_count},
            {"bytes", bytes}};
}

void print_json(const bake::Comparison& comparison) {
    nlohmann::json animals = nlohmann::json::array();
    for (const bake::CompareRow& row : comparison.rows) animals.push_back(row_json(row));
    nlohmann::json reads = nlohmann::json::object();
    for (const vat::Form& form : vat::kForms) reads[std::string(form.name)] = texel_reads(form, kInfluences);
    const nlohmann::json out{{"schema", "posepack-compare-1"},
                             {"animals", animals},
                             {"total", row_json(comparison.total)},
                             {"texel_reads_per_vertex", reads}};
    fmt::print("{}\n", out.dump(1));
}

int run(const Options& options) {
    const auto comparison = bake::compare_catalog(*options.source, options.copies);
    if (!comparison) return fail(comparison.issue());
    if (*options.format == Format::json) {
        print_json(comparison.value());
    } else if (*options.format == Format::csv) {
        fmt::print("{}", format_csv(bytes_table(comparison.value())));
    } else {
        fmt::print("Texture memory in bytes at the same rows{}:\n\n{}\n",
                   options.copies > 1 ? fmt::format(", {} of each animal", options.copies) : "",
                   format_text(bytes_table(comparison.value())));
        fmt::print("Texel reads of a vertex with {} influences that blends two rows:\n\n{}", kInfluences,
                   format_text(reads_table()));
    }
    return 0;
}

}  // namespace

Runner add_compare(CLI::App& app) {
    auto options = std::make_shared<Options>();
    add_catalog_options(app, options->source);
    app.add_option("--rate", options->source->rate_hz,
                   "Rows a second for every clip (default: each clip's own key grid)")
        ->check(number_between(1.0, 1000.0))
        ->type_name("HZ");
    app.add_option("--copies", options->copies, "Count each animal this many times, as kinds of their own")
        ->check(whole_between(1, 100'000))
        ->type_name("N");
    add_format_option(app, options->format, true);
    return [options] { return run(*options); };
}

}  // namespace posepack::cli

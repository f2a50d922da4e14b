// SPDX-License-Identifier: MIT
// Groups of options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "bake/bake_catalog.hpp"

namespace posepack::cli {

// CATALOG, --models, --only.
void add_catalog_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source);

// --encoding, --space, --texel-format, --texel-order, --row-pitch, --caps, --influences, --unused-bones,
// --rate: they beat the catalog.
void add_output_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source);

// --max-error, --p999-error, --rms-error: form and rows are chosen by a bound.
void add_bound_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source);

// Checks of an option's text, shared by every option that takes a number: finite, in decimal, in the range,
// and nothing behind it. What is refused reads "expected a number from 1 to 1000, found 'nan'".
CLI::Validator number_between(double least, double most);
CLI::Validator whole_between(std::uint64_t least, std::uint64_t most);

enum class Format { text, csv, json };

// --format with the formats given: "text,json" or "text,csv,json".
void add_format_option(CLI::App& app, const std::shared_ptr<Format>& format, bool with_csv);

}  // namespace posepack::cli

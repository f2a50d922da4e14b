// SPDX-License-Identifier: MIT
// Groups of options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "bake/bake_catalog.hpp"

namespace posepack::cli {

// CATALOG, --models, --only.
void add_catalog_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source);

// --encoding, --texel-format, --texel-order, --row-pitch, --caps, --rate: they beat the catalog.
void add_output_options(CLI::App& app, const std::shared_ptr<bake::CatalogSource>& source);

enum class Format { text, csv, json };

// --format with the formats given: "text,json" or "text,csv,json".
void add_format_option(CLI::App& app, const std::shared_ptr<Format>& format, bool with_csv);

}  // namespace posepack::cli

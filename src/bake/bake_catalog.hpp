// SPDX-License-Identifier: MIT
// A whole catalog: every animal baked, containers and manifest published together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bake/bake_animal.hpp"
#include "base/result.hpp"
#include "recipe/catalog.hpp"
#include "recipe/manifest.hpp"

namespace posepack::bake {

// A catalog read from disk, with the folder that its models lie in.
struct CatalogFile {
    recipe::Catalog catalog;
    std::filesystem::path models;
    std::string sha256;
};

struct CatalogSource {
    std::filesystem::path catalog;
    std::filesystem::path models;  // empty: the catalog's folder
    recipe::OutputOverrides overrides;
    std::optional<double> rate_hz;
    std::vector<std::string> only;  // ids; empty: all
};

// Errors: E-IO-*, E-CAT-*, E-LIM-*.
base::Result<CatalogFile> open_catalog(const CatalogSource& source);

// The bytes of the model of `entry`. Errors: E-CAT-PATH, E-IO-*, E-LIM-FILE.
base::Result<base::Bytes> read_model(const CatalogFile& file, const recipe::AnimalEntry& entry);

struct BakeOptions {
    std::filesystem::path output;
    AnimalOptions animal;
    unsigned jobs = 0;        // threads; 0: one a core
    bool keep_going = false;  // bake the rest when an animal fails; not when the output folder does
    bool sync_to_disk = true;
    double lock_timeout_s = 10.0;
};

struct BakedSummary {
    std::string id;
    double bake_s = 0.0, measure_s = 0.0;
};

struct BakeOutcome {
    recipe::Manifest manifest;          // what was published; without records nothing was
    std::vector<BakedSummary> times;    // in the order of manifest.records
    std::vector<base::Issue> findings;  // warnings, animal by animal
    std::vector<base::Issue> failures;  // animals left out under keep_going
    double elapsed_s = 0.0;
};

// Bakes every animal of the catalog into options.output. Without keep_going the first failing animal (by id)
// is the error and nothing is published; the old content of the folder stays whole. So it stays where, with
// keep_going, every animal fails: the outcome then has failures alone.
// An interrupt ends it between two animals, or before anything is renamed.
// Errors: those of open_catalog, read_model, bake_animal and OutputFolder, E-INTERRUPTED.
base::Result<BakeOutcome> bake_catalog(const CatalogSource& source, const BakeOptions& options);

}  // namespace posepack::bake

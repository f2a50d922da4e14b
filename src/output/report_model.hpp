// SPDX-License-Identifier: MIT
// What `posepack report` found: every form and row scheme of every animal, measured and timed. Plain data
// that the writers of report_writers.hpp read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/issue.hpp"
#include "recipe/manifest.hpp"

namespace posepack::output {

// One form and row scheme of one animal.
struct ReportRow {
    std::string form;      // what a bone is stored as, in short: "dualquat rgba16f"
    std::string encoding;  // names as in catalogs
    std::string texel_format;
    std::string rows;           // the row scheme: "keys", "30 Hz"
    bool is_chosen = false;     // what a bake of the catalog writes; at most one row of an animal
    std::uint64_t bytes = 0;    // texels of all stored rows, closing rows too; no header, no alignment fill
    recipe::ErrorRecord error;  // of the whole animal, with its worst place
    double decode_ns_per_vertex = 0.0;  // two rows decoded and blended, every vertex skinned, one thread
    std::uint32_t fetches = 0;          // texels that a vertex of four influences reads for two rows
    std::uint32_t alu_operations = 0;   // scalar multiply-adds of that vertex, position and normal, about
    double bake_ms = 0.0;               // read, sample, encode; without the measurement
};

// The largest errors of the chosen row over (time, bone): measure::ErrorHeat with names.
struct HeatClip {
    std::string name;
    std::vector<double> edges_s;  // of the time bins: one more than there are bins
    std::vector<float> errors;    // [bin * bones.size() + bone], fractions of R
};
struct HeatMap {
    std::vector<std::string> bones;  // those that move vertices, in the palette's order
    std::vector<HeatClip> clips;
};

// A form that the animal cannot have.
struct RefusedForm {
    std::string form, rows;
    base::Issue issue;
};

struct AnimalReport {
    std::string id;
    float radius_m = 0;
    std::uint32_t bone_count = 0, vertex_count = 0;
    std::vector<ReportRow> rows;
    std::vector<RefusedForm> refused;       // they have no row
    std::vector<recipe::ClipRecord> clips;  // of the chosen row; empty where it was refused
    std::optional<HeatMap> heat;            // where it was asked for and there is a chosen row
};

struct Report {
    std::string catalog;                // its file name
    std::vector<AnimalReport> animals;  // sorted by id
};

// The chosen row of an animal; null where there is none.
const ReportRow* chosen_row(const AnimalReport& animal);

}  // namespace posepack::output

// SPDX-License-Identifier: MIT
// Manifest: what a bake wrote, from what, with what error. Canonical JSON: keys sorted, no clock, no host,
// no absolute path, so equal inputs give equal bytes (schemas/manifest-1.schema.json).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace posepack::recipe {

inline constexpr int kManifestSchema = 1;
inline constexpr std::string_view kManifestName = "manifest.json";
inline constexpr std::size_t kMaxManifestBytes = 64u << 20;

// Error of the written bytes against the source curve; lengths as fractions of R, angles in degrees.
struct ErrorRecord {
    bool measured = false;
    float max = 0, p999 = 0, rms = 0;
    float max_m = 0, p999_m = 0, rms_m = 0;  // the same in metres: times radius_m
    float normal_max_deg = 0, normal_p999_deg = 0, normal_rms_deg = 0;
    std::string clip;          // the worst place: clip (empty inside a clip's own record),
    float time_s = 0;          //   time within it,
    std::string mesh;          //   mesh,
    std::uint32_t vertex = 0;  //   vertex within that mesh,
    std::string bone;          //   and the bone that contributes most
};

// What it costs that vertices keep the largest of their influences only, at the rows; lengths as fractions of
// R.
struct ReductionRecord {
    bool measured = false;              // false: no vertex lost any, or nothing was measured
    std::uint32_t vertex_count = 0;     // vertices that lost influences
    std::uint32_t influences_most = 0;  // the largest number that one of them had
    float max = 0, rms = 0;
    float max_m = 0, rms_m = 0;  // the same in metres: times radius_m
    std::string clip;            // the worst place: clip,
    float time_s = 0;            //   time within it,
    std::string mesh;            //   mesh,
    std::uint32_t vertex = 0;    //   and vertex within that mesh
};

// One try to find the smallest rows within a bound: what it would have stored, and its measured error.
struct TryRecord {
    std::string encoding;
    std::string row_scheme;   // "runs", "slots"
    std::uint64_t bytes = 0;  // of bone-rows and the tables of rows
    float max = 0, p999 = 0, rms = 0;
    bool keeps_bound = false;
};

struct ClipRecord {
    std::string name, source_name;
    std::uint32_t first_row = 0, row_count = 0;
    float rate_hz = 0, period_s = 0, start_s = 0;
    std::string wrap;           // "loop", "once", "ping-pong"
    std::string seam;           // "closed", "open"
    std::string interpolation;  // "linear", "step"
    float seam_gap = 0;         // fraction of R
    float speed_mps = 0;
    std::string encoding;
    std::string row_scheme;  // "uniform", "runs", "slots"
    std::vector<TryRecord>
        tried;  // in their order, where a bound chose: the smallest that keeps it was taken
    ErrorRecord error;
};

struct StateRecord {
    std::string name, clip;
};

struct VramRecord {  // bytes of texels at the same rows, without padding
    std::uint64_t mat4_rgba32f = 0, mat4_rgba16f = 0, affine_rgba32f = 0, affine_rgba16f = 0;
    std::uint64_t dualquat_rgba16f = 0;
    std::uint64_t vat_position_rgb32f = 0, vat_rgba32f = 0, vat_rgba16f = 0;
};

struct BakeRecord {
    std::string id;
    std::string container;  // file name inside the output folder
    std::uint64_t container_bytes = 0;
    std::string container_sha256;  // 64 lower-case hex digits
    std::string model;             // path as in the catalog
    std::uint64_t model_bytes = 0;
    std::string model_sha256;
    std::string recipe_sha256;
    std::string encoding;    // "mixed" where clips differ
    std::string row_scheme;  // "uniform", "runs"
    std::string texel_format, texel_order;
    std::uint32_t bone_count = 0, row_count = 0, vertex_count = 0;
    std::uint32_t texture_width = 0, texture_height = 0;
    std::uint64_t texel_bytes = 0;
    std::uint64_t row_table_bytes = 0;  // of RUNS and SLOT
    float radius_m = 0;
    std::vector<ClipRecord> clips;
    std::vector<StateRecord> states;
    std::string default_state;
    ErrorRecord error;  // the worst over all clips; rms and p999 pooled
    ReductionRecord reduction;
    bool has_vram = false;  // bake --compare-vat
    VramRecord vram;
    std::vector<std::string> remarks;  // warnings, as printed
};

struct Manifest {
    std::uint32_t bake_abi = 0;
    std::string tool_version;
    std::string catalog_sha256;
    std::string options_json;         // canonical JSON object of the options given on the command line
    std::vector<BakeRecord> records;  // sorted by id
};

// Canonical JSON with a final newline. Numbers must be finite; `options_json` must be a JSON object or empty.
std::string write_manifest(const Manifest& manifest);

// Reads a manifest that write_manifest() wrote: every key must be there, records sorted by id, and each
// container named "<id>.posepack". Errors: E-MAN-JSON, E-MAN-VERSION, E-LIM-JSON-DEPTH, E-LIM-FILE.
base::Result<Manifest> read_manifest(std::string_view text);

}  // namespace posepack::recipe

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "recipe/file_rules.hpp"
#include "recipe/manifest.hpp"
#include "recipe/parse.hpp"
#include "recipe/value.hpp"

namespace posepack::recipe {
namespace {

using base::IssueCode;
using Json = nlohmann::json;

constexpr FaultCodes kManifestCodes{IssueCode::man_json, IssueCode::man_json, IssueCode::man_json,
                                    IssueCode::man_json};
constexpr JsonFaultCodes kManifestJsonCodes{IssueCode::man_json, IssueCode::man_json, IssueCode::man_json};

std::uint32_t whole_u32(const Value& object, std::string_view key) {
    return static_cast<std::uint32_t>(object.need(key).whole(std::numeric_limits<std::uint32_t>::max()));
}

std::uint64_t whole_u64(const Value& object, std::string_view key) {
    return object.need(key).whole(std::numeric_limits<std::uint64_t>::max());
}

float number(const Value& object, std::string_view key) {
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(object.need(key).number(-kMost, kMost));
}

std::string text(const Value& object, std::string_view key) {
    return object.need(key).text();
}

std::string digest(const Value& object, std::string_view key) {
    const Value value = object.need(key);
    std::string hex = value.text();
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    if (hex.size() != 64 || !std::all_of(hex.begin(), hex.end(), is_digit)) {
        value.fail(IssueCode::man_json, "expected 64 lower-case hexadecimal digits, found another text");
    }
    return hex;
}

// `key` as one of an enumeration's names; kept as text.
template <class Choice>
std::string choice(const Value& object, std::string_view key) {
    return std::string(name_of(object.need(key).choice<Choice>()));
}

ErrorRecord read_error(const Value& error, bool names_clip) {
    ErrorRecord record;
    if (error.json().is_null()) return record;
    error.expect_object({"bone", "clip", "max", "max_m", "mesh", "normal_max_deg", "normal_p999_deg",
                         "normal_rms_deg", "p999", "p999_m", "rms", "rms_m", "time_s", "vertex"});
    record.measured = true;
    record.max = number(error, "max");
    record.p999 = number(error, "p999");
    record.rms = number(error, "rms");
    record.max_m = number(error, "max_m");
    record.p999_m = number(error, "p999_m");
    record.rms_m = number(error, "rms_m");
    record.normal_max_deg = number(error, "normal_max_deg");
    record.normal_p999_deg = number(error, "normal_p999_deg");
    record.normal_rms_deg = number(error, "normal_rms_deg");
    if (names_clip) record.clip = text(error, "clip");
    record.time_s = number(error, "time_s");
    record.mesh = text(error, "mesh");
    record.vertex = whole_u32(error, "vertex");
    record.bone = text(error, "bone");
    return record;
}

ReductionRecord read_reduction(const Value& reduction) {
    ReductionRecord record;
    if (reduction.json().is_null()) return record;
    reduction.expect_object({"clip", "influences_most", "max", "max_m", "mesh", "rms", "rms_m", "time_s",
                             "vertex", "vertex_count"});
    record.measured = true;
    record.vertex_count = whole_u32(reduction, "vertex_count");
    record.influences_most = whole_u32(reduction, "influences_most");
    record.max = number(reduction, "max");
    record.rms = number(reduction, "rms");
    record.max_m = number(reduction, "max_m");
    record.rms_m = number(reduction, "rms_m");
    record.clip = text(reduction, "clip");
    record.time_s = number(reduction, "time_s");
    record.mesh = text(reduction, "mesh");
    record.vertex = whole_u32(reduction, "vertex");
    return record;
}

void check_flag(const Value& options, std::string_view key) {
    const std::optional<Value> flag = options.find(key);
    if (flag && !flag->json().is_boolean())
        flag->fail(IssueCode::man_json,
                   fmt::format("expected true or false, found {}", flag->json().type_name()));
}

TryRecord read_try(const Value& value) {
    value.expect_object({"bytes", "encoding", "keeps_bound", "max", "p999", "rms", "row_scheme"});
    TryRecord one;
    one.encoding = choice<Encoding>(value, "encoding");
    one.row_scheme = value.need("row_scheme").one_of({"runs", "slots"});
    one.bytes = whole_u64(value, "bytes");
    one.max = number(value, "max");
    one.p999 = number(value, "p999");
    one.rms = number(value, "rms");
    check_flag(value, "keeps_bound");
    const Value keeps = value.need("keeps_bound");
    one.keeps_bound = keeps.json().is_boolean() && keeps.json().get<bool>();
    return one;
}

ClipRecord read_clip(const Value& clip) {
    clip.expect_object({"encoding", "error", "first_row", "interpolation", "name", "period_s", "rate_hz",
                        "row_count", "row_scheme", "seam", "seam_gap", "source_name", "speed_mps", "start_s",
                        "tried", "wrap"});
    ClipRecord record;
    record.name = text(clip, "name");
    record.source_name = text(clip, "source_name");
    record.first_row = whole_u32(clip, "first_row");
    record.row_count = whole_u32(clip, "row_count");
    record.rate_hz = number(clip, "rate_hz");
    record.period_s = number(clip, "period_s");
    record.start_s = number(clip, "start_s");
    record.wrap = clip.need("wrap").one_of({"loop", "once", "ping-pong"});
    record.seam = clip.need("seam").one_of({"closed", "open"});
    record.interpolation = clip.need("interpolation").one_of({"linear", "step"});
    record.seam_gap = number(clip, "seam_gap");
    record.speed_mps = number(clip, "speed_mps");
    record.encoding = choice<Encoding>(clip, "encoding");
    record.row_scheme = clip.need("row_scheme").one_of({"runs", "slots", "uniform"});
    for (const Value& one : clip.need("tried").elements()) record.tried.push_back(read_try(one));
    record.error = read_error(clip.need("error"), false);
    return record;
}

StateRecord read_state(const Value& state) {
    state.expect_object({"clip", "name"});
    return {text(state, "name"), text(state, "clip")};
}

VramRecord read_vram(const Value& vram) {
    vram.expect_object({"affine_rgba16f", "affine_rgba32f", "dualquat_rgba16f", "mat4_rgba16f",
                        "mat4_rgba32f", "vat_position_rgb32f", "vat_rgba16f", "vat_rgba32f"});
    VramRecord record;
    record.mat4_rgba32f = whole_u64(vram, "mat4_rgba32f");
    record.mat4_rgba16f = whole_u64(vram, "mat4_rgba16f");
    record.affine_rgba32f = whole_u64(vram, "affine_rgba32f");
    record.affine_rgba16f = whole_u64(vram, "affine_rgba16f");
    record.dualquat_rgba16f = whole_u64(vram, "dualquat_rgba16f");
    record.vat_position_rgb32f = whole_u64(vram, "vat_position_rgb32f");
    record.vat_rgba32f = whole_u64(vram, "vat_rgba32f");
    record.vat_rgba16f = whole_u64(vram, "vat_rgba16f");
    return record;
}

// Names of files: what a hostile manifest could use to point elsewhere.
void read_files(const Value& value, BakeRecord* record) {
    record->id = text(value, "id");
    if (std::string fault = id_fault(record->id); !fault.empty()) {
        value.need("id").fail(IssueCode::man_json, std::move(fault));
    }
    record->container = text(value, "container");
    if (record->container != record->id + ".posepack") {
        value.need("container")
            .fail(IssueCode::man_json,
                  fmt::format("expected '{}.posepack', found '{}'", base::printable(record->id),
                              base::printable(record->container)));
    }
    record->model = text(value, "model");
    if (std::string fault = path_fault(record->model); !fault.empty()) {
        value.need("model").fail(IssueCode::man_json, std::move(fault));
    }
    record->container_bytes = whole_u64(value, "container_bytes");
    record->container_sha256 = digest(value, "container_sha256");
    record->model_bytes = whole_u64(value, "model_bytes");
    record->model_sha256 = digest(value, "model_sha256");
    record->recipe_sha256 = digest(value, "recipe_sha256");
}

void read_palette(const Value& value, BakeRecord* record) {
    record->encoding = value.need("encoding").one_of({"affine", "dualquat", "mat4", "mixed"});
    record->row_scheme = value.need("row_scheme").one_of({"runs", "uniform"});
    record->texel_format = choice<TexelFormat>(value, "texel_format");
    record->texel_order = choice<TexelOrder>(value, "texel_order");
    record->bone_count = whole_u32(value, "bone_count");
    record->row_count = whole_u32(value, "row_count");
    record->vertex_count = whole_u32(value, "vertex_count");
    record->texture_width = whole_u32(value, "texture_width");
    record->texture_height = whole_u32(value, "texture_height");
    record->texel_bytes = whole_u64(value, "texel_bytes");
    record->row_table_bytes = whole_u64(value, "row_table_bytes");
    record->radius_m = number(value, "radius_m");
}

BakeRecord read_record(const Value& value) {
    value.expect_object({"bone_count",
                         "clips",
                         "container",
                         "container_bytes",
                         "container_sha256",
                         "default_state",
                         "encoding",
                         "error",
                         "id",
                         "model",
                         "model_bytes",
                         "model_sha256",
                         "radius_m",
                         "recipe_sha256",
                         "reduction",
                         "remarks",
                         "row_count",
                         "row_scheme",
                         "row_table_bytes",
                         "states",
                         "texel_bytes",
                         "texel_format",
                         "texel_order",
                         "texture_height",
                         "texture_width",
                         "vertex_count",
                         "vram"});
    BakeRecord record;
    read_files(value, &record);
    read_palette(value, &record);
    for (const Value& clip : value.need("clips").elements()) record.clips.push_back(read_clip(clip));
    for (const Value& state : value.need("states").elements()) record.states.push_back(read_state(state));
    record.default_state = text(value, "default_state");
    record.error = read_error(value.need("error"), true);
    record.reduction = read_reduction(value.need("reduction"));
    const Value vram = value.need("vram");
    record.has_vram = !vram.json().is_null();
    if (record.has_vram) record.vram = read_vram(vram);
    for (const Value& remark : value.need("remarks").elements()) record.remarks.push_back(remark.text());
    return record;
}

template <class Choice>
void check_choice(const Value& options, std::string_view key) {
    if (const std::optional<Value> value = options.find(key)) static_cast<void>(value->choice<Choice>());
}

// Limits as fractions of R or in metres; null where there is none.
void check_bound(const Value& bound) {
    bound.expect_object({"max", "p999", "rms"});
    for (const std::string_view key : {"max", "p999", "rms"}) {
        const Value limit = bound.need(key);
        if (limit.json().is_null()) continue;
        limit.expect_object({"unit", "value"});
        limit.need("unit").one_of({"R", "m"});
        static_cast<void>(limit.need("value").number(0.0, std::numeric_limits<double>::max()));
    }
}

// What the command line set: only what it set is there.
void check_options(const Value& options) {
    options.expect_object({"allow_data_uris", "bound", "caps", "compare_vat", "encoding", "influences",
                           "measure", "only", "rate_hz", "row_pitch", "space", "strict", "texel_format",
                           "texel_order", "unused_bones"});
    if (const std::optional<Value> bound = options.find("bound")) check_bound(*bound);
    check_choice<Caps>(options, "caps");
    check_choice<Encoding>(options, "encoding");
    check_choice<RowPitch>(options, "row_pitch");
    check_choice<Space>(options, "space");
    check_choice<TexelFormat>(options, "texel_format");
    check_choice<TexelOrder>(options, "texel_order");
    check_choice<UnusedBones>(options, "unused_bones");
    if (const std::optional<Value> influences = options.find("influences"))
        if (const std::uint64_t number = influences->whole(8); number != 4 && number != 8)
            influences->fail(IssueCode::man_json, fmt::format("expected 4 or 8, found {}", number));
    for (const std::string_view flag : {"allow_data_uris", "compare_vat", "measure", "strict"})
        check_flag(options, flag);
    if (const std::optional<Value> rate = options.find("rate_hz"))
        static_cast<void>(rate->number(1.0, 1000.0));
    if (const std::optional<Value> only = options.find("only"))
        for (const Value& id : only->elements())
            if (std::string fault = id_fault(id.text()); !fault.empty())
                id.fail(IssueCode::man_json, std::move(fault));
}

void check_schema(const Value& root) {
    const Value schema = root.need("schema");
    const std::uint64_t number = schema.whole(std::numeric_limits<std::uint64_t>::max());
    if (number == kManifestSchema) return;
    schema.fail(number > kManifestSchema ? IssueCode::man_version : IssueCode::man_json,
                fmt::format("expected schema {}, found {}", kManifestSchema, number));
}

void read_records(const Value& list, std::vector<BakeRecord>* records) {
    for (const Value& value : list.elements()) {
        records->push_back(read_record(value));
        const std::size_t last = records->size() - 1;
        if (last == 0 || (*records)[last - 1].id < (*records)[last].id) continue;
        value.fail(IssueCode::man_json, fmt::format("expected records sorted by id, found '{}' after '{}'",
                                                    base::printable((*records)[last].id),
                                                    base::printable((*records)[last - 1].id)));
    }
}

}  // namespace

base::Result<Manifest> read_manifest(std::string_view text_bytes) {
    const base::Result<Json> parsed = parse_json(text_bytes, kMaxManifestBytes, kManifestJsonCodes);
    if (!parsed) return parsed.issue();
    Faults faults{kManifestCodes, std::nullopt};
    const Value root(parsed.value(), "", faults);
    check_schema(root);
    root.expect_object({"bake_abi", "catalog_sha256", "options", "records", "schema", "tool_version"});
    Manifest manifest;
    manifest.bake_abi = whole_u32(root, "bake_abi");
    manifest.tool_version = text(root, "tool_version");
    manifest.catalog_sha256 = digest(root, "catalog_sha256");
    const Value options = root.need("options");
    check_options(options);
    manifest.options_json = options.json().dump();
    read_records(root.need("records"), &manifest.records);
    if (faults.first) return *faults.first;
    return manifest;
}

}  // namespace posepack::recipe

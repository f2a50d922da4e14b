// SPDX-License-Identifier: MIT
#include "recipe/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/json.hpp"
#include "base/text.hpp"
#include "recipe/file_rules.hpp"
#include "recipe/parse.hpp"
#include "recipe/value.hpp"

namespace posepack::recipe {
namespace {

using base::IssueCode;
using Json = nlohmann::json;

constexpr double kMinRateHz = 1.0;
constexpr double kMaxRateHz = 1000.0;
constexpr double kMinMetresPerUnit = 1e-6;
constexpr double kMaxMetresPerUnit = 1e6;
constexpr double kMaxSpeedMps = 1000.0;

constexpr FaultCodes kCatalogCodes{IssueCode::cat_type, IssueCode::cat_key, IssueCode::cat_value,
                                   IssueCode::cat_range};
constexpr JsonFaultCodes kCatalogJsonCodes{IssueCode::cat_json, IssueCode::cat_json_dup,
                                           IssueCode::cat_range};

// A rate as written: absent, "keys" (the clip's own grid), or a number.
struct Rate {
    bool is_set = false;
    std::optional<double> rate_hz;
};

// What an animal takes where it says nothing itself.
struct Defaults {
    Rate rate;
    double metres_per_unit = 1.0;
    ForwardAxis forward = ForwardAxis::plus_z;
    OutputOptions output;
    KeywordMap keywords;
};

// What the command line says; it beats the catalog.
struct CommandLine {
    OutputOverrides output;
    std::optional<double> rate_hz;
};

Rate read_rate(const Value& object, Rate inherited) {
    const std::optional<Value> value = object.find("rate_hz");
    if (!value) return inherited;
    if (!value->is_text()) return {true, value->number(kMinRateHz, kMaxRateHz)};
    if (value->text() != "keys") {
        value->fail(IssueCode::cat_value,
                    fmt::format("expected \"keys\" or a number from {} to {}, found '{}'", kMinRateHz,
                                kMaxRateHz, base::printable(value->text())));
    }
    return {true, std::nullopt};
}

template <class Choice>
void read_choice(const Value& object, std::string_view key, Choice* choice) {
    if (const std::optional<Value> value = object.find(key)) *choice = value->choice<Choice>();
}

// Influences are as many as one or two vectors of four hold.
void read_influences(const Value& object, std::uint32_t* influences) {
    const std::optional<Value> value = object.find("influences");
    if (!value) return;
    const std::uint64_t number = value->whole(8);
    *influences = static_cast<std::uint32_t>(number);
    if (number != 4 && number != 8)
        value->fail(IssueCode::cat_value, fmt::format("expected 4 or 8, found {}", number));
}

std::optional<ErrorLimit> read_limit(const Value& object, std::string_view key) {
    const std::optional<Value> value = object.find(key);
    if (!value) return std::nullopt;
    if (!value->is_text()) return ErrorLimit{value->number(1e-9, 1.0)};
    const auto limit = parse_error_limit(value->text());
    if (!limit)
        value->fail(
            IssueCode::cat_value,
            fmt::format("expected a fraction of the radius, \"5mm\" or \"1px@20m,1080,60\", found '{}'",
                        base::printable(value->text())));
    return limit;
}

// "max_error", with "p999_error" and "rms_error" beside it.
void read_bound(const Value& object, std::optional<ErrorBound>* bound) {
    if (const std::optional<Value> value = object.find("max_error")) {
        if (!value->is_text()) {
            const ErrorLimit max{value->number(1e-9, 1.0)};
            *bound = ErrorBound{max, ErrorLimit{0.25 * max.value}, {}};
        } else if (const auto parsed = parse_error_bound(value->text())) {
            *bound = parsed;
        } else {
            value->fail(IssueCode::cat_value, fmt::format("expected one of {}, found '{}'", kErrorLimitForms,
                                                          base::printable(value->text())));
        }
    }
    for (const auto& [key, field] :
         {std::pair{"p999_error", &ErrorBound::p999}, {"rms_error", &ErrorBound::rms}}) {
        const std::optional<ErrorLimit> limit = read_limit(object, key);
        if (!limit) continue;
        if (*bound)
            (**bound).*field = limit;
        else
            object.fail(IssueCode::cat_value,
                        fmt::format("expected \"max_error\" beside \"{}\", found none", key));
    }
}

// Overlays `options` with what the object's "output" says.
void read_output(const Value& object, OutputOptions* options) {
    const std::optional<Value> output = object.find("output");
    if (!output) return;
    output->expect_object({"caps", "encoding", "influences", "max_error", "p999_error", "rms_error",
                           "row_pitch", "space", "texel_format", "texel_order", "unused_bones"});
    if (output->find("encoding")) options->bound.reset();
    read_choice(*output, "encoding", &options->encoding);
    read_bound(*output, &options->bound);
    for (const std::string_view key : {"encoding", "row_pitch", "texel_order"})
        if (output->find("max_error") && output->find(key))
            output->fail(
                IssueCode::cat_value,
                fmt::format("expected \"max_error\", which chooses the form, or \"{}\", found both", key));
    read_choice(*output, "texel_format", &options->texel_format);
    read_choice(*output, "texel_order", &options->texel_order);
    read_choice(*output, "row_pitch", &options->row_pitch);
    read_choice(*output, "caps", &options->caps);
    read_choice(*output, "space", &options->space);
    read_influences(*output, &options->influences);
    read_choice(*output, "unused_bones", &options->unused_bones);
}

void apply(const OutputOverrides& overrides, OutputOptions* options) {
    options->encoding = overrides.encoding.value_or(options->encoding);
    options->texel_format = overrides.texel_format.value_or(options->texel_format);
    options->texel_order = overrides.texel_order.value_or(options->texel_order);
    options->row_pitch = overrides.row_pitch.value_or(options->row_pitch);
    options->caps = overrides.caps.value_or(options->caps);
    options->space = overrides.space.value_or(options->space);
    options->influences = overrides.influences.value_or(options->influences);
    options->unused_bones = overrides.unused_bones.value_or(options->unused_bones);
    if (overrides.encoding) options->bound.reset();
    if (overrides.bound) options->bound = overrides.bound;
}

void read_units(const Value& object, double* metres_per_unit, ForwardAxis* forward) {
    if (const std::optional<Value> value = object.find("metres_per_unit")) {
        *metres_per_unit = value->number(kMinMetresPerUnit, kMaxMetresPerUnit);
    }
    read_choice(object, "forward", forward);
}

// Replaces the keywords of the states that the object's "keywords" names; an empty list drops the state.
void read_keywords(const Value& keywords, KeywordMap* map) {
    for (const auto& [state, list] : keywords.members()) {
        list.check_name(state);
        std::vector<std::string> words;
        for (const Value& word : list.elements()) words.push_back(word.name());
        if (words.empty()) {
            map->erase(state);
        } else {
            (*map)[state] = std::move(words);
        }
    }
}

void read_speed(const Value& clip, ClipWish* wish) {
    if (const std::optional<Value> speed = clip.find("speed_mps")) {
        wish->speed_mps = speed->number(0.0, kMaxSpeedMps);
    }
    if (const std::optional<Value> phase = clip.find("stride_phase")) {
        wish->stride_phase = phase->number(0.0, 1.0);
        if (wish->stride_phase == 1.0) {
            phase->fail(IssueCode::cat_range, "expected a number from 0 to below 1, found 1");
        }
    }
}

ClipWish read_clip(const Value& clip, const Rate& inherited) {
    ClipWish wish;
    wish.rate_hz = inherited.rate_hz;
    if (clip.is_text()) {
        wish.name = clip.name();
        return wish;
    }
    clip.expect_object({"max_error", "name", "p999_error", "rate_hz", "rms_error", "seam", "speed_mps",
                        "states", "stride_phase", "wrap"});
    read_bound(clip, &wish.bound);
    wish.name = clip.need("name").name();
    if (const std::optional<Value> states = clip.find("states")) {
        for (const Value& state : states->elements()) wish.states.push_back(state.name());
    }
    wish.rate_hz = read_rate(clip, inherited).rate_hz;
    read_choice(clip, "wrap", &wish.wrap);
    read_choice(clip, "seam", &wish.seam);
    read_speed(clip, &wish);
    return wish;
}

void read_clips(const Value& clips, const Rate& inherited, AnimalEntry* animal) {
    std::set<std::string> states;
    for (const Value& clip : clips.elements()) {
        animal->clips.push_back(read_clip(clip, inherited));
        for (const std::string& state : animal->clips.back().states) {
            if (states.insert(state).second) continue;
            clip.fail(IssueCode::cat_value,
                      fmt::format("expected each state once in an animal, found '{}' twice",
                                  base::printable(state)));
        }
    }
    if (animal->clips.empty()) {
        clips.fail(IssueCode::cat_value,
                   "expected at least one clip (no \"clips\" at all means every clip), "
                   "found an empty array");
    }
}

Json rate_json(const std::optional<double>& rate_hz) {
    return rate_hz ? Json(*rate_hz) : Json("keys");
}

Json bound_of(const std::optional<ErrorBound>& bound) {
    return bound ? Json::parse(bound_json(*bound)) : Json();
}

Json clip_json(const ClipWish& wish) {
    return {{"bound", bound_of(wish.bound)},      {"name", wish.name},
            {"rate_hz", rate_json(wish.rate_hz)}, {"seam", name_of(wish.seam)},
            {"speed_mps", wish.speed_mps},        {"states", wish.states},
            {"stride_phase", wish.stride_phase},  {"wrap", name_of(wish.wrap)}};
}

std::string canonical(const AnimalEntry& animal) {
    Json clips = Json::array();
    for (const ClipWish& wish : animal.clips) clips.push_back(clip_json(wish));
    const Json output{{"bound", bound_of(animal.output.bound)},
                      {"caps", name_of(animal.output.caps)},
                      {"encoding", name_of(animal.output.encoding)},
                      {"influences", animal.output.influences},
                      {"row_pitch", name_of(animal.output.row_pitch)},
                      {"space", animal.output.is_normalised() ? "normalised" : "model"},
                      {"texel_format", name_of(animal.output.texel_format)},
                      {"texel_order", name_of(animal.output.texel_order)},
                      {"unused_bones", animal.output.drops_unused_bones() ? "drop" : "keep"}};
    const Json entry{{"clips", std::move(clips)},
                     {"default_state", animal.default_state},
                     {"forward", name_of(animal.forward)},
                     {"keywords", animal.keywords},
                     {"metres_per_unit", animal.metres_per_unit},
                     {"output", output},
                     {"rate_hz", rate_json(animal.rate_hz)}};
    return entry.dump();
}

// Every rate ends in the clip wishes; the animal keeps one only where it has none, and bakes every clip.
void settle_rates(const std::optional<double>& command_line_hz, const Rate& rate, AnimalEntry* animal) {
    if (animal->clips.empty()) animal->rate_hz = command_line_hz ? command_line_hz : rate.rate_hz;
    if (!command_line_hz) return;
    for (ClipWish& wish : animal->clips) wish.rate_hz = command_line_hz;
}

// The clips of a palette are stored in one way: where the animal's form is fixed, a clip's bound could not
// hold.
void refuse_lone_bounds(const Value& value, const AnimalEntry& animal) {
    for (const ClipWish& wish : animal.clips)
        if (wish.bound)
            return value.fail(
                IssueCode::cat_value,
                fmt::format("expected \"max_error\" in \"output\" beside that of clip '{}', found none",
                            base::printable(wish.name)));
}

AnimalEntry read_animal(const std::string& id, const Value& value, const Defaults& defaults,
                        const CommandLine& command_line) {
    AnimalEntry animal;
    animal.id = id;
    if (std::string fault = id_fault(id); !fault.empty()) value.fail(IssueCode::cat_id, std::move(fault));
    value.expect_object(
        {"clips", "default_state", "forward", "keywords", "metres_per_unit", "model", "output", "rate_hz"});
    const Value model = value.need("model");
    animal.model = model.text();
    if (std::string fault = path_fault(animal.model); !fault.empty()) {
        model.fail(IssueCode::cat_path, std::move(fault));
    }
    const Rate rate = read_rate(value, defaults.rate);
    if (const std::optional<Value> clips = value.find("clips")) read_clips(*clips, rate, &animal);
    if (const std::optional<Value> state = value.find("default_state")) animal.default_state = state->name();
    animal.keywords = defaults.keywords;
    if (const std::optional<Value> words = value.find("keywords")) read_keywords(*words, &animal.keywords);
    animal.metres_per_unit = defaults.metres_per_unit;
    animal.forward = defaults.forward;
    read_units(value, &animal.metres_per_unit, &animal.forward);
    animal.output = defaults.output;
    read_output(value, &animal.output);
    apply(command_line.output, &animal.output);
    settle_rates(command_line.rate_hz, rate, &animal);
    if (command_line.rate_hz && !command_line.output.bound) animal.output.bound.reset();
    if (!animal.output.bound && !command_line.output.encoding && !command_line.rate_hz)
        refuse_lone_bounds(value, animal);
    animal.canonical_json = canonical(animal);
    return animal;
}

Defaults read_defaults(const Value& catalog) {
    Defaults defaults;
    if (const std::optional<Value> value = catalog.find("defaults")) {
        value->expect_object({"forward", "metres_per_unit", "output", "rate_hz"});
        defaults.rate = read_rate(*value, {});
        read_units(*value, &defaults.metres_per_unit, &defaults.forward);
        read_output(*value, &defaults.output);
    }
    if (const std::optional<Value> keywords = catalog.find("keywords")) {
        read_keywords(*keywords, &defaults.keywords);
    } else {
        defaults.keywords = default_keywords();
    }
    return defaults;
}

// The schema number comes first: a newer catalog may have keys and types that are unknown here.
void check_schema(const Value& catalog) {
    const Value schema = catalog.need("schema");
    const double number = schema.json().is_number() ? schema.json().get<double>() : schema.number(0.0, 0.0);
    if (number > kCatalogSchema) {
        schema.fail(IssueCode::cat_version,
                    fmt::format("expected schema {}, found {}", kCatalogSchema, schema.json().dump()));
    } else if (number != kCatalogSchema) {
        schema.fail(IssueCode::cat_value,
                    fmt::format("expected schema {}, found {}", kCatalogSchema, schema.json().dump()));
    }
}

std::vector<AnimalEntry> read_animals(const Value& catalog, const CommandLine& command_line) {
    std::vector<AnimalEntry> animals;
    const Value value = catalog.need("animals");
    const std::size_t count = value.json().size();
    if (count > kMaxAnimals) {
        value.fail(IssueCode::lim_entries, fmt::format("expected at most {} animals, found {}",
                                                       base::grouped(kMaxAnimals), base::grouped(count)));
        return animals;
    }
    const Defaults defaults = read_defaults(catalog);
    std::map<std::string, std::string> ids;  // lowered -> as written
    for (const auto& [id, entry] : value.members()) {
        animals.push_back(read_animal(id, entry, defaults, command_line));
        const auto [earlier, is_new] = ids.emplace(base::lowered(id), id);
        if (is_new) continue;
        entry.fail(IssueCode::cat_id,
                   fmt::format("expected ids that differ by more than case, found '{}' and '{}'",
                               earlier->second, id));
    }
    if (animals.empty()) value.fail(IssueCode::cat_value, "expected at least one animal, found none");
    return animals;
}

}  // namespace

const KeywordMap& default_keywords() {
    static const KeywordMap kKeywords{{"attack", {"attack", "bite"}},
                                      {"flee", {"run", "gallop"}},
                                      {"idle", {"idle"}},
                                      {"wander", {"walk"}}};
    return kKeywords;
}

base::Result<Catalog> read_catalog(std::string_view text, const OutputOverrides& overrides,
                                   std::optional<double> rate_hz) {
    const base::Result<Json> parsed = parse_json(text, kMaxCatalogBytes, kCatalogJsonCodes);
    if (!parsed) return parsed.issue();
    Faults faults{kCatalogCodes, std::nullopt};
    const Value root(parsed.value(), "", faults);
    check_schema(root);
    root.expect_object({"$schema", "animals", "defaults", "keywords", "schema"});
    if (const std::optional<Value> schema = root.find("$schema")) schema->text();
    Catalog catalog{read_animals(root, {overrides, rate_hz})};
    if (faults.first) return *faults.first;
    return catalog;
}

}  // namespace posepack::recipe

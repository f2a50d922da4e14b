// SPDX-License-Identifier: MIT
#include "recipe/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/text.hpp"

namespace posepack::recipe {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDetailBytes = 64;
constexpr std::size_t kMaxNameBytes = 255;

const Json kNull;

// The value as JSON, cut so that it fits a message.
std::string shown(const Json& json) {
    if (json.is_structured()) return fmt::format("an {}", json.type_name());
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return base::printable(base::shortened(text, kDetailBytes));
}

// RFC 6901 section 3.
std::string escaped(std::string_view key) {
    std::string text;
    for (const char c : key) {
        if (c == '~') {
            text += "~0";
        } else if (c == '/') {
            text += "~1";
        } else {
            text += c;
        }
    }
    return text;
}

std::string unknown_key_detail(std::string_view key, std::initializer_list<std::string_view> known) {
    const std::vector<std::string> candidates(known.begin(), known.end());
    const std::string found = base::printable(base::shortened(key, kDetailBytes));
    const std::string near = base::nearest(key, candidates);
    if (!near.empty()) {
        return fmt::format("expected a known key, found '{}'; did you mean '{}'?", found, near);
    }
    return fmt::format("expected one of {}, found '{}'", fmt::join(candidates, ", "), found);
}

}  // namespace

void Value::fail(base::IssueCode code, std::string detail) const {
    if (!faults_->first) faults_->first = base::Issue{code, place_, std::move(detail)};
}

void Value::fail_type(std::string_view expected) const {
    fail(faults_->codes.type, fmt::format("expected {}, found {}", expected, shown(*json_)));
}

Value Value::child(const Json& json, std::string_view key) const {
    return {json, fmt::format("{}/{}", place_, escaped(key)), *faults_};
}

void Value::expect_object(std::initializer_list<std::string_view> known) const {
    if (!json_->is_object()) return fail_type("an object");
    for (const auto& [key, json] : json_->items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            return fail(faults_->codes.key, unknown_key_detail(key, known));
        }
    }
}

std::optional<Value> Value::find(std::string_view key) const {
    if (!json_->is_object()) return std::nullopt;
    const auto member = json_->find(key);
    if (member == json_->end()) return std::nullopt;
    return child(*member, key);
}

Value Value::need(std::string_view key) const {
    if (const std::optional<Value> member = find(key)) return *member;
    if (json_->is_object()) {
        fail(faults_->codes.key, fmt::format("expected the key '{}', found none", key));
    } else {
        fail_type("an object");
    }
    return child(kNull, key);
}

std::vector<std::pair<std::string, Value>> Value::members() const {
    std::vector<std::pair<std::string, Value>> members;
    if (!json_->is_object()) {
        fail_type("an object");
        return members;
    }
    for (const auto& [key, json] : json_->items()) members.emplace_back(key, child(json, key));
    return members;
}

std::vector<Value> Value::elements() const {
    std::vector<Value> elements;
    if (!json_->is_array()) {
        fail_type("an array");
        return elements;
    }
    for (const Json& json : *json_) elements.push_back(child(json, std::to_string(elements.size())));
    return elements;
}

double Value::number(double least, double most) const {
    if (!json_->is_number()) {
        fail_type("a number");
        return least;
    }
    const double value = json_->get<double>();
    if (value >= least && value <= most) return value == 0.0 ? 0.0 : value;  // never minus zero
    fail(faults_->codes.range,
         fmt::format("expected a number from {} to {}, found {}", least, most, shown(*json_)));
    return least;
}

std::uint64_t Value::whole(std::uint64_t most) const {
    if (!json_->is_number_integer()) {
        fail_type("a whole number");
        return 0;
    }
    const bool is_negative = !json_->is_number_unsigned() && json_->get<std::int64_t>() < 0;
    const std::uint64_t value = is_negative ? 0 : json_->get<std::uint64_t>();
    if (!is_negative && value <= most) return value;
    fail(faults_->codes.range,
         fmt::format("expected a whole number from 0 to {}, found {}", most, shown(*json_)));
    return 0;
}

bool Value::is_text() const {
    return json_->is_string();
}

std::string Value::text() const {
    if (json_->is_string()) return json_->get<std::string>();
    fail_type("a string");
    return {};
}

std::string Value::name() const {
    std::string text = this->text();
    check_name(text);
    return text;
}

void Value::check_name(std::string_view text) const {
    if (text.size() > kMaxNameBytes) {
        fail(base::IssueCode::lim_string,
             fmt::format("expected at most {} bytes, found {}", kMaxNameBytes, text.size()));
    }
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (text.empty() || std::any_of(text.begin(), text.end(), is_control)) {
        fail(faults_->codes.value, fmt::format("expected a name without control characters, found '{}'",
                                               base::printable(base::shortened(text, kDetailBytes))));
    }
}

std::string Value::one_of(std::initializer_list<std::string_view> allowed) const {
    return std::string(allowed.begin()[choice_index({allowed.begin(), allowed.size()})]);
}

std::size_t Value::choice_index(std::span<const std::string_view> names) const {
    const std::string text = this->text();
    const auto name = std::find(names.begin(), names.end(), text);
    if (name != names.end()) return static_cast<std::size_t>(name - names.begin());
    fail(faults_->codes.value,
         fmt::format("expected one of {}, found {}", fmt::join(names, ", "), shown(*json_)));
    return 0;
}

}  // namespace posepack::recipe

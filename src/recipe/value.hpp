// SPDX-License-Identifier: MIT
// Value: a strict cursor over parsed JSON, for the readers of this room. The first fault is kept and names
// its place by JSON pointer (RFC 6901); after it every read yields a harmless default, so that a reader is
// straight-line code with one test at its end.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/issue.hpp"
#include "recipe/names.hpp"

namespace posepack::recipe {

// The codes that faults of one kind of file are reported by.
struct FaultCodes {
    base::IssueCode type;   // another type than expected
    base::IssueCode key;    // an unknown or missing key
    base::IssueCode value;  // none of the listed values
    base::IssueCode range;  // a number out of range
};

// Where the first fault goes. Must outlive every Value that uses it.
struct Faults {
    FaultCodes codes;
    std::optional<base::Issue> first;
};

class Value {
 public:
    Value(const nlohmann::json& json, std::string place, Faults& faults)
        : json_(&json), place_(std::move(place)), faults_(&faults) {}

    const std::string& place() const { return place_; }
    const nlohmann::json& json() const { return *json_; }

    // Records a fault at this place, unless there is one already.
    void fail(base::IssueCode code, std::string detail) const;

    // Tests that this is an object with no other keys than `known`; a near miss is suggested.
    void expect_object(std::initializer_list<std::string_view> known) const;

    // The member `key`, where this is an object that has it.
    std::optional<Value> find(std::string_view key) const;

    // The member `key`; its absence is a fault, and gives a null that no read objects to a second time.
    Value need(std::string_view key) const;

    // Members of an object, sorted by key; elements of an array. Another type is a fault and gives none.
    std::vector<std::pair<std::string, Value>> members() const;
    std::vector<Value> elements() const;

    // A number in [least, most], never minus zero; integers only for whole().
    double number(double least, double most) const;
    std::uint64_t whole(std::uint64_t most) const;
    bool is_text() const;
    std::string text() const;

    // A string of 1 to 255 bytes without control characters. Errors: the value code, E-LIM-STRING.
    std::string name() const;

    // Tests the same of a text that stands here, such as this member's key.
    void check_name(std::string_view text) const;

    // One of the given texts.
    std::string one_of(std::initializer_list<std::string_view> allowed) const;

    // One of the names of an enumeration.
    template <class Choice>
    Choice choice() const {
        return static_cast<Choice>(choice_index(all_names<Choice>()));
    }

 private:
    void fail_type(std::string_view expected) const;
    std::size_t choice_index(std::span<const std::string_view> names) const;
    Value child(const nlohmann::json& json, std::string_view key) const;

    const nlohmann::json* json_;
    std::string place_;
    Faults* faults_;
};

}  // namespace posepack::recipe

// SPDX-License-Identifier: MIT
// Result<T>: a value, or the one Issue that prevented it.
#pragma once

#include <utility>
#include <variant>

#include "base/issue.hpp"

namespace posepack::base {

// Holds either a T or an Issue. Test with `if (!result)`, then take value() or issue().
template <class T>
class [[nodiscard]] Result {
 public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Issue issue) : state_(std::in_place_index<1>, std::move(issue)) {}

    explicit operator bool() const { return state_.index() == 0; }
    T& value() & { return std::get<0>(state_); }
    const T& value() const& { return std::get<0>(state_); }
    T&& value() && { return std::get<0>(std::move(state_)); }
    const Issue& issue() const { return std::get<1>(state_); }

 private:
    std::variant<T, Issue> state_;
};

// The result of an action that makes nothing: success, or an Issue.
class [[nodiscard]] Status {
 public:
    Status() = default;
    Status(Issue issue) : issue_(std::move(issue)), failed_(true) {}

    explicit operator bool() const { return !failed_; }
    const Issue& issue() const { return issue_; }

 private:
    Issue issue_;
    bool failed_ = false;
};

}  // namespace posepack::base

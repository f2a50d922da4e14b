// SPDX-License-Identifier: MIT
// The one exception of the drawing tools: a line for people, caught by main.
#pragma once

#include <stdexcept>
#include <string>

namespace posepack::render {

struct RenderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline void require(bool holds, const std::string& what) {
    if (!holds) throw RenderError(what);
}

}  // namespace posepack::render

// SPDX-License-Identifier: MIT
// How this room compiles RapidJSON, the same in every file: a JSON value of the wrong type throws instead of
// aborting. Include before any RapidJSON header.
#pragma once

#include <stdexcept>

#define RAPIDJSON_ASSERT(condition)     \
    ((condition) ? static_cast<void>(0) \
                 : throw std::runtime_error("JSON value of another type than expected"))
#define RAPIDJSON_NOEXCEPT_ASSERT(condition) static_cast<void>(condition)

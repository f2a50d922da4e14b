// SPDX-License-Identifier: MIT
// Every rule about runs and slots, broken once and kept once at its edge: one list for the C loader and for
// the reader written from the specification. Checksums are right, and no other rule is broken but where it
// cannot be helped. Rule numbers are those of docs/format/posepack-1.md.
#pragma once

#include <functional>
#include <vector>

#include "posepack/loader.h"
#include "runs_builder.hpp"

namespace posepack::test {

struct RunCase {
    const char* rule;
    const char* what;
    std::function<void(Parts&)> change;
    posepack_result expected = POSEPACK_ERROR_SEMANTIC;
    RunOptions options = tiny_runs();
};

std::vector<RunCase> run_cases();

}  // namespace posepack::test

// SPDX-License-Identifier: MIT
// What the tests of the format's rules share: one change of a good container, and the answer it must get.
// Every container has right checksums. Rule numbers are those of docs/format/posepack-1.md; P and two digits
// number the list of bad containers that every release answers alike.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "changes.hpp"
#include "posepack/loader.h"

namespace posepack::test {

struct Case {
    const char* rule;
    const char* what;
    std::function<void(Parts&)> change;
    posepack_result expected = POSEPACK_ERROR_SEMANTIC;
};

inline std::string open_name(const Bytes& bytes) {
    posepack_view view;
    return posepack_result_name(posepack_open(&view, bytes.data(), bytes.size()));
}

inline void run(const std::vector<Case>& cases, const TinyOptions& options = {}) {
    ASSERT_EQ(open_name(make_container(options)), "OK");
    for (const Case& test : cases) {
        Parts parts = make_parts(options);
        test.change(parts);
        EXPECT_EQ(open_name(assemble(parts)), posepack_result_name(test.expected))
            << test.rule << ": " << test.what;
    }
}

}  // namespace posepack::test

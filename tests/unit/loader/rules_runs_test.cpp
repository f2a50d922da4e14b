// SPDX-License-Identifier: MIT
// The rules about runs: those of RUNS (R) and SLOT (L), and what the others ask of a container with runs.
#include <set>

#include "rules.hpp"
#include "run_cases.hpp"

namespace posepack::test {
namespace {

TEST(RunRules, EachIsBrokenOnce) {
    std::set<std::string> rules;
    int refused = 0, opened = 0;
    for (const RunCase& test : run_cases()) {
        Parts parts = make_run_parts(test.options);
        if (test.change != nullptr) {
            ASSERT_EQ(open_name(assemble(parts)), "OK") << test.rule << ": before " << test.what;
            test.change(parts);
        }
        EXPECT_EQ(open_name(assemble(parts)), posepack_result_name(test.expected))
            << test.rule << ": " << test.what;
        if (test.expected != POSEPACK_OK) rules.insert(test.rule);
        ++(test.expected == POSEPACK_OK ? opened : refused);
    }
    for (const char* rule :
         {"T9", "H5", "H9", "H10", "C3", "C5", "C6", "C7", "R1", "R2", "R3", "R4", "R5", "L1", "L2", "L3",
          "L4", "L5", "L6", "G1",  "G2", "G3", "G4", "G5", "G6", "X1", "X2", "X3", "X5", "X6", "X8"})
        EXPECT_EQ(rules.count(rule), 1u) << rule;
    EXPECT_GT(refused, 80);
    EXPECT_GT(opened, 5);
}

TEST(RunRules, EveryVariantIsGood) {
    int opened = 0;
    for (unsigned i = 0; i < 3 * 3 * 3 * 2 * 2 * 2 * 2; ++i) {
        RunOptions options = tiny_runs(static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + i % 3),
                                       static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + i / 3 % 3));
        options.clips[0].wrap = static_cast<std::uint8_t>(i / 9 % 3);
        options.clips[0].interpolation = i / 27 % 2;
        options.texel_format = i / 54 % 2 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        options.measured = i / 108 % 2 == 0;
        options.clips[1].turned = options.clips[1].encoding == POSEPACK_ENCODING_DUALQUAT ? i / 216 * 3 : 0;
        // A run within another closes too.
        if (options.clips[0].wrap == POSEPACK_WRAP_LOOP) options.clips[0].runs[2] = run_word(0, 2);
        EXPECT_EQ(open_name(make_run_container(options)), "OK") << i;
        ++opened;
    }
    EXPECT_EQ(opened, 432);
}

TEST(RunRules, TheTextureGetsWiderWhereItWouldBeTooHigh) {
    // 8 x 4,096 x 9 = 294,912 texels are more than 64 x 4,096.
    const Bytes wide = make_run_container(many_runs(8, 4095));
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, wide.data(), wide.size()), POSEPACK_OK);
    EXPECT_EQ(view.header.texture_width_texels, 128u);
    EXPECT_EQ(view.header.texture_height_texels, 2305u);
    // 262,143 texels and one bone-row need 4,097 lines of 64; three texels less, and 4,096 are enough.
    RunOptions options = many_runs(7, 4095);  // 258,048
    options.clips.push_back(many_runs(1, 454).clips[0]);
    const Bytes next = make_run_container(options);  // 262,143
    ASSERT_EQ(posepack_open(&view, next.data(), next.size()), POSEPACK_OK);
    EXPECT_EQ(view.header.texture_width_texels, 128u);
    options.clips.back().runs[2] = run_word(910, 453);
    const Bytes high = make_run_container(options);  // 262,140
    ASSERT_EQ(posepack_open(&view, high.data(), high.size()), POSEPACK_OK);
    EXPECT_EQ(view.header.texture_width_texels, 64u);
    EXPECT_EQ(view.header.texture_height_texels, 4096u);
}

}  // namespace
}  // namespace posepack::test

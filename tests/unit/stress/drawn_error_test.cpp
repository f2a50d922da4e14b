// SPDX-License-Identifier: MIT
// Errors of drawn palettes that can be told in advance.
#include "stress/drawn_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "bake/bake_animal.hpp"
#include "stress/form.hpp"
#include "support/sample_models.hpp"

namespace posepack::stress {
namespace {

using support::ModelSpec;
using support::turn;
using support::turns;

constexpr double kPi = 3.14159265358979323846;

recipe::AnimalEntry entry_for(const Form& form, double rate_hz) {
    recipe::AnimalEntry entry;
    entry.id = "one";
    entry.model = "one.glb";
    entry.canonical_json = "{}";
    recipe::ClipWish every;
    every.name = "*";
    every.rate_hz = rate_hz;
    every.wrap = recipe::Wrap::once;
    entry.clips = {every};
    return in_form(std::move(entry), form);
}

struct Drawn {
    DrawnError error;
    recipe::BakeRecord record;
};

Drawn drawn(const ModelSpec& spec, const Form& form, double rate_hz, const Reader& reader = {}) {
    auto baked = bake::bake_animal(entry_for(form, rate_hz), support::glb_of(spec), {});
    if (!baked) throw std::runtime_error(base::format_issue(baked.issue()));
    const auto error = measure_drawn(support::animal_of(spec), baked.value().container, reader);
    if (!error) throw std::runtime_error(base::format_issue(error.issue()));
    return {error.value(), baked.value().record};
}

constexpr Form kMat4Floats{recipe::Encoding::mat4, recipe::TexelFormat::rgba32f, recipe::Space::model};
constexpr Form kMat4Halves{recipe::Encoding::mat4, recipe::TexelFormat::rgba16f, recipe::Space::model};

// Vertices 3 units from the axis; 60 degrees from row to row.
ModelSpec turning() {
    ModelSpec spec = support::one_bone({3, 0, 0, -3, 0, 0});
    std::vector<std::array<float, 4>> rotations;
    for (int k = 0; k < 9; ++k) rotations.push_back(turn(60.0 * k, 0, 0, 1));
    spec.clips = {{"Turn", {{0, "rotation", support::grid(9, 10), turns(rotations)}}}};
    return spec;
}

TEST(DrawnError, OfMatricesIsTheChordOfTheArc) {
    const Drawn found = drawn(turning(), kMat4Floats, 10.0);
    EXPECT_NEAR(found.error.all.max, 1 - std::cos(kPi / 6), 1e-4) << "half way, of R = 3";
    EXPECT_LT(found.error.rows.max, 1e-6);
    EXPECT_LT(found.error.all.rms, found.error.all.max);
    EXPECT_GT(found.error.all.p999, 0.9 * found.error.all.max);
}

TEST(DrawnError, OfDualQuaternionsIsTheirUnevenPace) {
    const Drawn found = drawn(turning(), {recipe::Encoding::dualquat, recipe::TexelFormat::rgba32f}, 10.0);
    double largest = 0.0;
    for (double u = 0.0; u < 0.5; u += 0.001)
        largest = std::max(
            largest, 2 * (u * kPi / 6 - std::atan2(u * std::sin(kPi / 6), 1 - u + u * std::cos(kPi / 6))));
    EXPECT_NEAR(found.error.all.max, largest, largest * 0.02);
    EXPECT_NEAR(found.record.error.max, largest, largest * 0.03) << "as printed";
}

TEST(DrawnError, CountsSubnormalHalvesAsZero) {
    ModelSpec spec = support::one_bone({1e-5f, 0, 0, 0, 1e-5f, 0, 0, 0, 0});
    spec.clips = {{"Shift", {{0, "translation", {0, 1}, {3e-5f, 0, 0, 3e-5f, 0, 0}}}}};
    const Drawn found = drawn(spec, kMat4Halves, 10.0);
    EXPECT_NEAR(found.error.all.max * static_cast<double>(found.record.radius_m), 3e-5, 1e-8)
        << "the whole translation is lost";
    EXPECT_LT(drawn(spec, kMat4Floats, 10.0).error.all.max, 1e-5) << "of floats nothing is";
}

TEST(DrawnError, SeesPhasesInHalves) {
    ModelSpec spec = support::one_bone();
    std::vector<float> places;
    for (int k = 0; k < 2101; ++k) places.insert(places.end(), {k % 2 == 0 ? 0.0f : 1.0f, 0, 0});
    spec.clips = {{"Shake", {{0, "translation", support::grid(2101, 30), places}}}};
    EXPECT_LT(drawn(spec, kMat4Floats, 30.0).error.all.max, 5e-3) << "rows lie at the keys";
    const Drawn halves = drawn(spec, kMat4Floats, 30.0, {.has_half_phase = true});
    EXPECT_NEAR(halves.error.all.max * static_cast<double>(halves.record.radius_m), 0.5, 0.05)
        << "phases behind the middle step by a row: half a row is lost";
}

// A body that shakes for five keys of 64.
ModelSpec shaking() {
    ModelSpec spec = support::one_bone({1, 0, 0, 0, 1, 0, 0, 0, 1});
    std::vector<std::array<float, 4>> rotations;
    for (int k = 0; k < 65; ++k)
        rotations.push_back(turn(k >= 30 && k < 36 ? (k % 2 == 0 ? 50.0 : -50.0) : 0.2 * k, 0, 0, 1));
    spec.clips = {{"Shake", {{0, "rotation", support::grid(65, 30), turns(rotations)}}}};
    return spec;
}

TEST(DrawnError, OfRunsAndSlotsIsWhatTheBoundAllows) {
    for (const bool has_slots : {false, true}) {
        const ModelSpec spec = has_slots ? shaking() : turning();
        recipe::AnimalEntry entry = entry_for({}, 30.0);
        entry.clips.front().rate_hz.reset();
        entry.output.bound = recipe::ErrorBound{{2e-2}, {}, {}};
        const auto baked = bake::bake_animal(entry, support::glb_of(spec), {});
        ASSERT_TRUE(baked) << base::format_issue(baked.issue());
        const recipe::ClipRecord& clip = baked.value().record.clips.front();
        EXPECT_EQ(clip.row_scheme, has_slots ? "slots" : "runs");
        const auto error = measure_drawn(support::animal_of(spec), baked.value().container, {});
        ASSERT_TRUE(error);
        EXPECT_NEAR(error.value().all.max, static_cast<double>(clip.error.max), 1e-3) << clip.row_scheme;
        EXPECT_GT(error.value().all.max, 5e-3) << clip.row_scheme;
        EXPECT_EQ(error.value().rows.max, 0.0) << "bones share no rows";
    }
}

TEST(DrawnError, OfBytesThatAreNoContainerIsRefused) {
    const auto error = measure_drawn(support::animal_of(turning()), std::vector<std::uint8_t>(200), {});
    ASSERT_FALSE(error);
    EXPECT_EQ(error.issue().code, base::IssueCode::internal);
}

}  // namespace
}  // namespace posepack::stress

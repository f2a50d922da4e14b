// SPDX-License-Identifier: MIT
// What a reader can spoil while it runs, whatever the palette: clocks and halves.
#include <array>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

RawModel run() {
    const RawModel model = reed();
    return with_clip(model, swaying(model, grid(22, kKeyHz), kSwayDegrees, 0.7));
}

// 2,101 keys of a clip that sways all the time.
RawModel keys_2101() {
    const RawModel model = reed({.joints = 2, .rings = 5});
    return with_clip(model, swaying(model, grid(2'101, kKeyHz), kSwayDegrees, 1.0));
}

constexpr double kHourS = 3'600.0;
constexpr double kDayS = 86'400.0;
constexpr double kElevenDaysS = 1e6;
constexpr Start kLoop{.wrap = recipe::Wrap::loop};

constexpr std::array kCases = {
    StressCase{"phase_after_eleven_days",
               "1e6 s of running; the phase is wrapped in double precision",
               run,
               {kMeets},
               kLoop,
               kUsual,
               {.running_s = kElevenDaysS}},
    StressCase{"raw_clock_after_a_minute",
               "60 s in one float, divided by the period in the shader",
               run,
               {kMeets},
               kLoop,
               kUsual,
               {.running_s = 60.0, .has_raw_clock = true}},
    StressCase{"raw_clock_after_an_hour",
               "the same after an hour: floats step by 0.24 ms",
               run,
               {kMeets},
               kLoop,
               kUsual,
               {.running_s = kHourS, .has_raw_clock = true}},
    StressCase{"raw_clock_after_a_day",
               "the same after a day: by 7.8 ms, a quarter of a row",
               run,
               {kMisses},
               kLoop,
               kUsual,
               {.running_s = kDayS, .has_raw_clock = true}},
    StressCase{"raw_clock_after_eleven_days",
               "the same after 1e6 s: by 62 ms, two rows",
               run,
               {kMisses},
               kLoop,
               kUsual,
               {.running_s = kElevenDaysS, .has_raw_clock = true}},
    StressCase{"phase_of_2101_keys", "a clip of 2,101 keys, its phase in one float", keys_2101, {kMeets}},
    StressCase{"phase_in_a_half",
               "the same with the phase in a half, which steps by a whole row",
               keys_2101,
               {kMisses},
               {},
               kUsual,
               {.has_half_phase = true}},
};

}  // namespace

CaseGroup reader_cases() {
    return {"Readers",
            "A palette is only as good as the phase that a program hands its shader. No palette mends a lost "
            "one: wrap it in double precision, and hand it on in 32 bits.",
            kCases};
}

}  // namespace posepack::stress

// SPDX-License-Identifier: MIT
// What a reader can spoil while it runs, whatever the palette: clocks and row numbers.
#include <array>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

RawModel run() {
    const RawModel model = reed();
    return with_clip(model, swaying(model, grid(22, kKeyHz), kSwayDegrees, 0.7));
}

// 2,101 rows of a clip that sways all the time.
RawModel rows_2101() {
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
    StressCase{"rows_2101", "2,101 rows, their numbers as integers", rows_2101, {kMeets}},
    StressCase{"rows_2101_in_halves",
               "the same with row numbers in halves: 2,049 is read as 2,048",
               rows_2101,
               {kMisses},
               {},
               kUsual,
               {.has_half_rows = true}},
};

}  // namespace

CaseGroup reader_cases() {
    return {"Readers",
            "A palette is only as good as the time and the row number that a program hands its shader. No "
            "palette "
            "mends these: wrap the phase in double precision, keep row numbers in 32 bits.",
            kCases};
}

}  // namespace posepack::stress

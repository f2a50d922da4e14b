// SPDX-License-Identifier: MIT
#include "bake/workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

#include "base/interrupt.hpp"

namespace posepack::bake {
namespace {

TEST(Workers, EveryJobRunsOnce) {
    for (const unsigned threads : {0u, 1u, 2u, 3u, 16u})
        for (const std::size_t count : {0u, 1u, 2u, 100u}) {
            std::vector<std::atomic<int>> runs(count);
            run_jobs(count, threads, [&](std::size_t i) {
                ++runs[i];
                return true;
            });
            for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(runs[i], 1) << threads << " threads, job " << i;
        }
}

// Whichever thread meets a failure first, the lowest index that fails has run: its failure can be told.
TEST(Workers, TheFirstFailingIndexDoesNotDependOnThreads) {
    const std::set<std::size_t> bad{13, 14, 40, 41, 42};
    for (const unsigned threads : {1u, 2u, 3u, 8u, 16u})
        for (int round = 0; round < 20; ++round) {
            std::vector<std::atomic<bool>> ran(60);
            run_jobs(60, threads, [&](std::size_t i) {
                // Early jobs take longer, so that later failures are met first.
                if (i == 13) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                ran[i] = true;
                return !bad.contains(i);
            });
            std::size_t first = 60;
            for (std::size_t i = 60; i-- > 0;)
                if (ran[i] && bad.contains(i)) first = i;
            ASSERT_EQ(first, 13u) << threads << " threads";
            for (std::size_t i = 0; i <= 13; ++i) ASSERT_TRUE(ran[i]) << "all before it ran";
        }
}

TEST(Workers, AFailureStopsTheStartOfLaterJobs) {
    std::atomic<int> runs{0};
    run_jobs(1000, 1, [&](std::size_t i) {
        ++runs;
        return i < 10;
    });
    EXPECT_EQ(runs, 11);
}

TEST(Workers, AnInterruptStopsTheStartOfLaterJobs) {
    for (const unsigned threads : {1u, 4u}) {
        std::atomic<int> runs{0};
        run_jobs(1000, threads, [&](std::size_t) {
            if (++runs == 10) base::request_interrupt();
            return true;
        });
        base::clear_interrupt();
        EXPECT_GE(runs, 10);
        EXPECT_LE(runs, 10 + static_cast<int>(threads)) << "those that had started";
    }
}

}  // namespace
}  // namespace posepack::bake

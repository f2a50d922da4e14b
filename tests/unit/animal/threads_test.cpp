// SPDX-License-Identifier: MIT
// Catalogs are baked on many threads: reading must not share anything that changes.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

TEST(Threads, ManyReadAtOnce) {
    const support::Bytes good = support::glb_of(support::tail());
    const support::Bytes bad(good.begin(), good.end() - 4);
    const Animal expected = support::read_good(good);
    std::atomic<int> ready{0}, wrong{0};
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 8; ++t)
            threads.emplace_back([&] {
                ++ready;
                while (ready < 8) std::this_thread::yield();  // all start together
                for (int round = 0; round < 50; ++round) {
                    const auto animal = read_animal(good);
                    if (!animal || animal.value().key_values != expected.key_values ||
                        animal.value().vertices.positions != expected.vertices.positions)
                        ++wrong;
                    if (read_animal(bad)) ++wrong;
                }
            });
    }
    EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace posepack::animal

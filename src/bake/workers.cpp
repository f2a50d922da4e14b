// SPDX-License-Identifier: MIT
#include "bake/workers.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace posepack::bake {

void run_jobs(std::size_t count, unsigned thread_count, const std::function<bool(std::size_t)>& job) {
    if (thread_count == 0) thread_count = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stop{false};
    const auto work = [&] {
        while (!stop) {
            const std::size_t index = next++;
            if (index >= count) return;
            if (!job(index)) stop = true;
        }
    };
    std::vector<std::jthread> threads;
    const std::size_t helpers = std::min<std::size_t>(thread_count, count);
    for (std::size_t t = 1; t < helpers; ++t) threads.emplace_back(work);
    work();
}

}  // namespace posepack::bake

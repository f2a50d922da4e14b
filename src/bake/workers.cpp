// SPDX-License-Identifier: MIT
#include "bake/workers.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/interrupt.hpp"

namespace posepack::bake {

void run_jobs(std::size_t count, unsigned thread_count, const std::function<bool(std::size_t)>& job) {
    if (thread_count == 0) thread_count = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stop{false};
    std::exception_ptr thrown;
    std::mutex thrown_mutex;
    const auto work = [&] {
        while (!stop && !base::interrupt_requested()) {
            const std::size_t index = next++;
            if (index >= count) return;
            try {
                if (!job(index)) stop = true;
            } catch (...) {  // no memory, most likely: the caller's thread reports it
                const std::lock_guard lock(thrown_mutex);
                if (!thrown) thrown = std::current_exception();
                stop = true;
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        const std::size_t helpers = std::min<std::size_t>(thread_count, count);
        for (std::size_t t = 1; t < helpers; ++t) threads.emplace_back(work);
        work();
    }
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace posepack::bake

// SPDX-License-Identifier: MIT
// A copy of some bytes that ends where readable memory ends: a read past it stops the test.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace posepack::test {

class GuardedBytes {
 public:
    /// Room for `capacity` bytes before the guard page.
    explicit GuardedBytes(std::size_t capacity) {
        const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        capacity_ = (capacity + page - 1) / page * page;
        mapped_ = capacity_ + page;
        void* memory = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) std::abort();
        memory_ = static_cast<std::uint8_t*>(memory);
        if (mprotect(memory_ + capacity_, page, PROT_NONE) != 0) std::abort();
    }
    ~GuardedBytes() { munmap(memory_, mapped_); }
    GuardedBytes(const GuardedBytes&) = delete;
    GuardedBytes& operator=(const GuardedBytes&) = delete;

    /// Copies `size` bytes so that the last one lies just before the guard; returns their start.
    std::uint8_t* place(const std::uint8_t* bytes, std::size_t size) {
        if (size > capacity_) std::abort();
        std::copy_n(bytes, size, memory_ + capacity_ - size);
        return memory_ + capacity_ - size;
    }

 private:
    std::size_t capacity_ = 0;
    std::size_t mapped_ = 0;
    std::uint8_t* memory_ = nullptr;
};

}  // namespace posepack::test

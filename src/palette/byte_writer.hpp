// SPDX-License-Identifier: MIT
// Little-endian numbers appended to a growing byte string.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace posepack::palette {

class ByteWriter {
 public:
    void u8(std::uint32_t value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
    void u16(std::uint32_t value);
    void u32(std::uint32_t value);
    void u64(std::uint64_t value);
    void f32(float value);
    void zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
    void append(std::span<const std::uint8_t> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    // Zero bytes up to a multiple of `alignment`.
    void align(std::size_t alignment);

    void reserve(std::size_t size) { bytes_.reserve(size); }
    std::size_t size() const { return bytes_.size(); }
    std::span<std::uint8_t> bytes() { return bytes_; }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace posepack::palette

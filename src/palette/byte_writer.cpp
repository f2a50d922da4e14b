// SPDX-License-Identifier: MIT
#include "palette/byte_writer.hpp"

#include "format/bytes.h"

namespace posepack::palette {

void ByteWriter::u16(std::uint32_t value) {
    bytes_.resize(bytes_.size() + 2);
    posepack_write_u16(&bytes_[bytes_.size() - 2], static_cast<std::uint16_t>(value));
}

void ByteWriter::u32(std::uint32_t value) {
    bytes_.resize(bytes_.size() + 4);
    posepack_write_u32(&bytes_[bytes_.size() - 4], value);
}

void ByteWriter::u64(std::uint64_t value) {
    bytes_.resize(bytes_.size() + 8);
    posepack_write_u64(&bytes_[bytes_.size() - 8], value);
}

void ByteWriter::f32(float value) {
    bytes_.resize(bytes_.size() + 4);
    posepack_write_f32(&bytes_[bytes_.size() - 4], value);
}

void ByteWriter::align(std::size_t alignment) {
    bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
}

}  // namespace posepack::palette

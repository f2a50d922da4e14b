// SPDX-License-Identifier: MIT
#include "recipe/names.hpp"

#include <array>

namespace posepack::recipe {
namespace {

constexpr std::array<std::string_view, 3> kEncodings{"mat4", "affine", "dualquat"};
constexpr std::array<std::string_view, 2> kTexelFormats{"rgba16f", "rgba32f"};
constexpr std::array<std::string_view, 2> kTexelOrders{"bone-major", "planar"};
constexpr std::array<std::string_view, 2> kRowPitches{"tight", "align256"};
constexpr std::array<std::string_view, 2> kCaps{"webgl2", "desktop"};
constexpr std::array<std::string_view, 3> kSpaces{"auto", "model", "normalised"};
constexpr std::array<std::string_view, 3> kUnusedBones{"auto", "keep", "drop"};
constexpr std::array<std::string_view, 4> kWraps{"auto", "loop", "once", "ping-pong"};
constexpr std::array<std::string_view, 3> kSeams{"auto", "closed", "open"};
constexpr std::array<std::string_view, 4> kForwardAxes{"+z", "-z", "+x", "-x"};

template <class Choice>
std::string_view name_in_table(Choice choice) {
    return all_names<Choice>()[static_cast<std::size_t>(choice)];
}

}  // namespace

template <>
std::span<const std::string_view> all_names<Encoding>() {
    return kEncodings;
}
template <>
std::span<const std::string_view> all_names<TexelFormat>() {
    return kTexelFormats;
}
template <>
std::span<const std::string_view> all_names<TexelOrder>() {
    return kTexelOrders;
}
template <>
std::span<const std::string_view> all_names<RowPitch>() {
    return kRowPitches;
}
template <>
std::span<const std::string_view> all_names<Caps>() {
    return kCaps;
}
template <>
std::span<const std::string_view> all_names<Space>() {
    return kSpaces;
}
template <>
std::span<const std::string_view> all_names<UnusedBones>() {
    return kUnusedBones;
}
template <>
std::span<const std::string_view> all_names<Wrap>() {
    return kWraps;
}
template <>
std::span<const std::string_view> all_names<Seam>() {
    return kSeams;
}
template <>
std::span<const std::string_view> all_names<ForwardAxis>() {
    return kForwardAxes;
}

std::string_view name_of(Encoding choice) {
    return name_in_table(choice);
}
std::string_view name_of(TexelFormat choice) {
    return name_in_table(choice);
}
std::string_view name_of(TexelOrder choice) {
    return name_in_table(choice);
}
std::string_view name_of(RowPitch choice) {
    return name_in_table(choice);
}
std::string_view name_of(Caps choice) {
    return name_in_table(choice);
}
std::string_view name_of(Space choice) {
    return name_in_table(choice);
}
std::string_view name_of(UnusedBones choice) {
    return name_in_table(choice);
}
std::string_view name_of(Wrap choice) {
    return name_in_table(choice);
}
std::string_view name_of(Seam choice) {
    return name_in_table(choice);
}
std::string_view name_of(ForwardAxis choice) {
    return name_in_table(choice);
}

}  // namespace posepack::recipe

// SPDX-License-Identifier: MIT
#include "render/png_file.hpp"

#include <fmt/format.h>
#include <png.h>

#include <cstdio>
#include <vector>

#include "render/colour_table.hpp"
#include "render/error.hpp"

namespace posepack::render {
namespace {

constexpr int kBestCompression = 9;
constexpr int kLargestWindow = 9;  // memory level of zlib

[[noreturn]] void on_error(png_structp, png_const_charp message) {
    throw RenderError(fmt::format("libpng: {}", message));
}

void append(png_structp png, png_bytep data, png_size_t size) {
    auto* bytes = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    bytes->insert(bytes->end(), data, data + size);
}

void no_flush(png_structp) {}

std::vector<std::uint8_t> encode_png(int width, int height, const IndexedPicture& picture) {
    std::vector<std::uint8_t> bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, no_flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_color> colours;
    for (const Rgb& c : picture.colours) colours.push_back({c[0], c[1], c[2]});
    png_set_PLTE(png, info, colours.data(), static_cast<int>(colours.size()));
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(png, kBestCompression);
    png_set_compression_mem_level(png, kLargestWindow);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_write_info(png, info);
    for (int line = height - 1; line >= 0; --line)
        png_write_row(png,
                      &picture.indices[static_cast<std::size_t>(line) * static_cast<std::size_t>(width)]);
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

}  // namespace

void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
    const std::vector<std::uint8_t> bytes = encode_png(width, height, reduce_colours(rgb, width));
    std::FILE* file = std::fopen(path.c_str(), "wb");
    require(file != nullptr, fmt::format("{} cannot be written", path));
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    require(std::fclose(file) == 0 && written, fmt::format("{} could not be written", path));
}

}  // namespace posepack::render

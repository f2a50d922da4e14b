// SPDX-License-Identifier: MIT
#include "output/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>

#include "output/container_json.hpp"

namespace posepack::output {
namespace {

// OpenEXR writes into memory, so that the file itself appears whole or not at all.
class MemoryStream : public Imf::OStream {
 public:
    MemoryStream() : Imf::OStream("memory") {}
    void write(const char data[], int size) override {
        const auto count = static_cast<std::size_t>(size);
        if (bytes.size() < position_ + count) bytes.resize(position_ + count);
        std::copy_n(data, count, bytes.begin() + static_cast<long>(position_));
        position_ += count;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }

    std::vector<std::uint8_t> bytes;

 private:
    std::size_t position_ = 0;
};

Imf::Header make_header(const posepack_view& view, const posepack_texels& texels, Imf::PixelType type) {
    Imf::Header header(static_cast<int>(texels.width_texels), static_cast<int>(texels.height_texels));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : {"R", "G", "B", "A"}) header.channels().insert(channel, Imf::Channel(type));
    const auto text = [&](const char* name, const std::string& value) {
        header.insert(name, Imf::StringAttribute(value));
    };
    const auto number = [&](const char* name, std::uint32_t value) {
        header.insert(name, Imf::IntAttribute(static_cast<int>(value)));
    };
    text("posepack:clips", clips_json(view));
    text("posepack:states", states_json(view));
    text("posepack:bones", bones_json(view));
    text("posepack:space", space_json(view));
    text("posepack:encoding", encoding_name(view.header.encoding));
    text("posepack:texelOrder", texel_order_name(view.header.texel_order));
    number("posepack:boneCount", view.header.bone_count);
    number("posepack:rowCount", view.header.row_count);
    number("posepack:texelsPerBone", view.header.texels_per_bone);
    number("posepack:rowsPerLine", view.header.rows_per_line);
    return header;
}

}  // namespace

base::Result<std::vector<std::uint8_t>> export_exr(const posepack_view& view) {
    posepack_texels texels;
    if (posepack_get_texels(&view, &texels) != POSEPACK_OK)
        return base::Issue{base::IssueCode::pack_invalid, "",
                           "expected texels, found a container that gives none"};
    if (view.header.row_scheme != POSEPACK_ROWS_UNIFORM)
        return base::Issue{base::IssueCode::usage, "",
                           "expected a container of uniform rows, one line a pose, found runs: bake it with "
                           "--encoding instead of a bound"};
    const bool half = texels.format == POSEPACK_TEXEL_RGBA16F;
    const Imf::PixelType type = half ? Imf::HALF : Imf::FLOAT;
    const std::size_t channel_bytes = half ? 2 : 4;
    // OpenEXR takes a pointer to non-const pixels, and reads them only.
    char* const pixels = const_cast<char*>(static_cast<const char*>(texels.data));
    MemoryStream stream;
    try {
        Imf::OutputFile file(stream, make_header(view, texels, type), 0);
        Imf::FrameBuffer frame;
        std::size_t offset = 0;
        for (const char* channel : {"R", "G", "B", "A"}) {
            frame.insert(channel,
                         Imf::Slice(type, pixels + offset, channel_bytes * 4, texels.row_pitch_bytes));
            offset += channel_bytes;
        }
        file.setFrameBuffer(frame);
        file.writePixels(static_cast<int>(texels.height_texels));
    } catch (const std::exception& exception) {
        return base::Issue{
            base::IssueCode::io_write, "",
            std::string("expected an image that OpenEXR can write, found: ") + exception.what()};
    }
    return std::move(stream.bytes);
}

}  // namespace posepack::output

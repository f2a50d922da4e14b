// SPDX-License-Identifier: MIT
// The export, read back with OpenEXR: the texels of the container bit for bit, its tables as attributes.
#include "output/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cstring>

#include "output/container_json.hpp"
#include "support/baked.hpp"
#include "support/sample_models.hpp"

namespace posepack::output {
namespace {

class MemoryInput : public Imf::IStream {
 public:
    explicit MemoryInput(const std::vector<std::uint8_t>& bytes) : Imf::IStream("memory"), bytes_(bytes) {}
    bool read(char out[], int size) override {
        if (position_ + static_cast<std::size_t>(size) > bytes_.size())
            throw std::out_of_range("end of file");
        std::memcpy(out, bytes_.data() + position_, static_cast<std::size_t>(size));
        position_ += static_cast<std::size_t>(size);
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override { position_ = position; }

 private:
    const std::vector<std::uint8_t>& bytes_;
    std::size_t position_ = 0;
};

// The pixels as they would lie in a texture without padding.
std::vector<std::uint8_t> pixels_of(Imf::InputFile& file, std::size_t channel_bytes, Imf::PixelType type) {
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x + 1);
    const auto height = static_cast<std::size_t>(window.max.y + 1);
    std::vector<std::uint8_t> pixels(width * height * 4 * channel_bytes);
    Imf::FrameBuffer frame;
    std::size_t offset = 0;
    for (const char* channel : {"R", "G", "B", "A"}) {
        frame.insert(channel, Imf::Slice(type, reinterpret_cast<char*>(pixels.data()) + offset,
                                         4 * channel_bytes, width * 4 * channel_bytes));
        offset += channel_bytes;
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, window.max.y);
    return pixels;
}

std::string text_of(const Imf::Header& header, const char* name) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    return attribute == nullptr ? std::string("(missing)") : attribute->value();
}

int number_of(const Imf::Header& header, const char* name) {
    const auto* attribute = header.findTypedAttribute<Imf::IntAttribute>(name);
    return attribute == nullptr ? -1 : attribute->value();
}

void expect_same_texels(const recipe::OutputOptions& output) {
    const support::Baked baked = support::bake_all(support::animal_of(support::tail()), output);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, baked.container.data(), baked.container.size()), POSEPACK_OK);
    const auto exr = export_exr(view);
    ASSERT_TRUE(exr);
    MemoryInput stream(exr.value());
    Imf::InputFile file(stream);
    const bool half = output.texel_format == recipe::TexelFormat::rgba16f;
    const Imf::PixelType type = half ? Imf::HALF : Imf::FLOAT;
    std::size_t channels = 0;
    for (auto it = file.header().channels().begin(); it != file.header().channels().end(); ++it, ++channels)
        EXPECT_EQ(it.channel().type, type) << it.name();
    EXPECT_EQ(channels, 4u);
    posepack_texels texels;
    ASSERT_EQ(posepack_get_texels(&view, &texels), POSEPACK_OK);
    const std::vector<std::uint8_t> pixels = pixels_of(file, half ? 2 : 4, type);
    const std::size_t line_bytes = std::size_t{texels.width_texels} * (half ? 8 : 16);
    ASSERT_EQ(pixels.size(), line_bytes * texels.height_texels);
    const auto* data = static_cast<const std::uint8_t*>(texels.data);
    for (std::uint32_t line = 0; line < texels.height_texels; ++line)
        ASSERT_EQ(std::memcmp(&pixels[line * line_bytes], data + std::size_t{line} * texels.row_pitch_bytes,
                              line_bytes),
                  0)
            << "line " << line;
    const Imf::Header& header = file.header();
    EXPECT_EQ(text_of(header, "posepack:clips"), clips_json(view));
    EXPECT_EQ(text_of(header, "posepack:states"), states_json(view));
    EXPECT_EQ(text_of(header, "posepack:bones"), bones_json(view));
    EXPECT_EQ(text_of(header, "posepack:space"), space_json(view));
    EXPECT_EQ(text_of(header, "posepack:encoding"), encoding_name(view.header.encoding));
    EXPECT_EQ(text_of(header, "posepack:texelOrder"), texel_order_name(view.header.texel_order));
    EXPECT_EQ(number_of(header, "posepack:boneCount"), 3);
    EXPECT_EQ(number_of(header, "posepack:rowCount"), static_cast<int>(view.header.row_count));
    EXPECT_EQ(number_of(header, "posepack:texelsPerBone"), view.header.texels_per_bone);
    EXPECT_EQ(number_of(header, "posepack:rowsPerLine"), static_cast<int>(view.header.rows_per_line));
}

TEST(Exr, HoldsTheTexelsOfEveryFormBitForBit) {
    using namespace recipe;
    for (const Encoding encoding : {Encoding::mat4, Encoding::affine})
        for (const TexelFormat format : {TexelFormat::rgba16f, TexelFormat::rgba32f})
            for (const TexelOrder order : {TexelOrder::bone_major, TexelOrder::planar})
                for (const RowPitch pitch : {RowPitch::tight, RowPitch::align256})
                    expect_same_texels({encoding, format, order, pitch, Caps::webgl2});
}

TEST(Exr, EqualContainersGiveEqualFiles) {
    const support::Baked baked = support::bake_all(support::animal_of(support::tail()));
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, baked.container.data(), baked.container.size()), POSEPACK_OK);
    EXPECT_EQ(export_exr(view).value(), export_exr(view).value());
}

TEST(Exr, AViewThatIsNotOpenIsRefused) {
    const posepack_view view{};
    const auto exr = export_exr(view);
    ASSERT_FALSE(exr);
    EXPECT_EQ(exr.issue().code, base::IssueCode::pack_invalid);
}

}  // namespace
}  // namespace posepack::output

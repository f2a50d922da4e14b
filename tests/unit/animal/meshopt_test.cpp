// SPDX-License-Identifier: MIT
// EXT_meshopt_compression: every mode and filter gives the numbers that were stored, and a stream that lies
// is refused by name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "animal/meshopt.hpp"
#include "animal/read_animal.hpp"
#include "support/compression.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using base::IssueCode;
using support::Bytes;
using support::GlbBuilder;
using support::Json;

Json& extension_of(GlbBuilder& glb, int view) {
    return glb
        .document["bufferViews"][static_cast<std::size_t>(view)]["extensions"]["EXT_meshopt_compression"];
}

// The tail with all its data in streams.
GlbBuilder compressed_tail() {
    GlbBuilder glb = support::builder_of(support::tail());
    const std::size_t count = glb.document["accessors"].size();
    for (std::size_t a = 0; a < count; ++a) support::compress_accessor(glb, a);
    glb.document["extensionsRequired"] = {"EXT_meshopt_compression"};
    return glb;
}

int view_of(const Json& accessor) {
    return accessor.at("bufferView").get<int>();
}

std::span<const std::uint8_t> bytes_of(const std::vector<float>& values) {
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(float)};
}

TEST(Meshopt, StreamsHoldWhatPlainDataHolds) {
    const Animal plain = support::animal_of(support::tail());
    const Animal animal = support::read_good(compressed_tail().build());
    EXPECT_EQ(animal.key_times, plain.key_times);
    EXPECT_EQ(animal.key_values, plain.key_values);
    EXPECT_EQ(animal.vertices.positions, plain.vertices.positions);
    EXPECT_EQ(animal.vertices.normals, plain.vertices.normals);
    EXPECT_EQ(animal.vertices.bones, plain.vertices.bones);
    EXPECT_EQ(animal.vertices.weights, plain.vertices.weights);
    ASSERT_EQ(animal.bones.size(), plain.bones.size());
    for (std::size_t b = 0; b < plain.bones.size(); ++b)
        EXPECT_EQ(animal.bones[b].inverse_bind, plain.bones[b].inverse_bind);
    EXPECT_TRUE(animal.findings.empty());
}

// The fallback buffer may name a file, and the extension may have its later name.
TEST(Meshopt, FallbackWithUriAndTheNameOfKhronos) {
    GlbBuilder glb = compressed_tail();
    glb.document["buffers"][1]["uri"] = "nobody/has/this.bin";
    glb.document["extensionsRequired"] = {"KHR_meshopt_compression"};
    for (Json& view : glb.document["bufferViews"]) {
        if (!view.contains("extensions")) continue;
        const Json extension = view["extensions"]["EXT_meshopt_compression"];
        view["extensions"] = {{"KHR_meshopt_compression", extension}};
    }
    EXPECT_EQ(support::read_good(glb.build()).key_values, support::animal_of(support::tail()).key_values);
}

// What nobody uses is not decoded, and so cannot be wrong.
TEST(Meshopt, UnusedStreamsAreLeftAlone) {
    GlbBuilder glb = compressed_tail();
    const Bytes junk(64, 0xFF);
    support::add_meshopt_view(glb, junk, 1'000, 16, "ATTRIBUTES");
    EXPECT_TRUE(read_animal(glb.build()));
}

TEST(Meshopt, QuaternionFilter) {
    const Animal plain = support::animal_of(support::tail());
    GlbBuilder glb = support::builder_of(support::tail());
    Json& accessor = glb.values(0, 0);
    const auto count = accessor["count"].get<std::size_t>();
    const auto* floats = reinterpret_cast<const float*>(support::view_data(glb, view_of(accessor)));
    const Bytes filtered = support::filter_quaternions(std::vector<float>(floats, floats + 4 * count), 16);
    const Bytes stream = support::meshopt_attributes(filtered, 8);
    const int view = support::add_meshopt_view(glb, stream, count, 8, "ATTRIBUTES", "QUATERNION");
    glb.values(0, 0).update({{"bufferView", view}, {"componentType", support::kI16}, {"normalized", true}});
    const Animal animal = support::read_good(glb.build());
    const Channel& channel = animal.clips[0].channels[0];
    const Channel& expected = plain.clips[0].channels[0];
    for (std::size_t k = 0; k < count; ++k) {
        double dot = 0.0;
        for (std::size_t c = 0; c < 4; ++c)
            dot += static_cast<double>(animal.key_values[channel.first_value + 4 * k + c]) *
                   plain.key_values[expected.first_value + 4 * k + c];
        EXPECT_NEAR(std::abs(dot), 1.0, 2e-4) << "16 bits; a filter may change the sign of a quaternion";
    }
}

TEST(Meshopt, ExponentialFilter) {
    GlbBuilder glb = support::builder_of(support::tail());
    const std::vector<float> keys{0.5f, 0.0f, -3.25f, 1000.0f, 0.25f, 1e-3f, 0.6f, -0.125f, 7.0f};
    const Bytes stream = support::meshopt_attributes(support::filter_exponential(keys, 20), 12);
    glb.values(2, 0)["bufferView"] =
        support::add_meshopt_view(glb, stream, 3, 12, "ATTRIBUTES", "EXPONENTIAL");
    const Animal animal = support::read_good(glb.build());
    const float* found = &animal.key_values[animal.clips[2].channels[0].first_value];
    for (std::size_t k = 0; k < 3; ++k) {
        // The numbers of an element share the exponent of the largest; 20 bits with their sign.
        const float* key = &keys[3 * k];
        const float largest = std::max({std::abs(key[0]), std::abs(key[1]), std::abs(key[2])});
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(found[3 * k + c], key[c], std::ldexp(largest, -18)) << k;
    }
}

TEST(Meshopt, OctahedralFilter) {
    const Animal plain = support::animal_of(support::tail());
    std::vector<float> padded;
    for (const auto& normal : plain.vertices.normals)
        padded.insert(padded.end(), {normal[0], normal[1], normal[2], 0.0f});
    GlbBuilder glb = support::builder_of(support::tail());
    const Bytes stream = support::meshopt_attributes(support::filter_normals(padded, 16), 8);
    const int view =
        support::add_meshopt_view(glb, stream, plain.vertices.normals.size(), 8, "ATTRIBUTES", "OCTAHEDRAL");
    glb.document["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 8;
    glb.attribute(0, "NORMAL")
        .update({{"bufferView", view}, {"componentType", support::kI16}, {"normalized", true}});
    const Animal animal = support::read_good(glb.build());
    for (std::size_t v = 0; v < plain.vertices.normals.size(); ++v)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(animal.vertices.normals[v][c], plain.vertices.normals[v][c], 1e-4f) << v;
}

// Two modes hold indices; sparse accessors are what an importer of animations reads them for.
GlbBuilder sparse_positions(const std::string& mode, const std::vector<std::uint32_t>& indices,
                            std::size_t index_bytes) {
    GlbBuilder glb = support::builder_of(support::tail());
    const Bytes stream =
        mode == "TRIANGLES" ? support::meshopt_triangles(indices) : support::meshopt_indices(indices);
    const int index_view = support::add_meshopt_view(glb, stream, indices.size(), index_bytes, mode);
    std::vector<float> values;
    for (const std::uint32_t i : indices) values.insert(values.end(), {100.0f + static_cast<float>(i), 0, 0});
    const int value_view = support::add_meshopt_view(glb, support::meshopt_attributes(bytes_of(values), 12),
                                                     indices.size(), 12, "ATTRIBUTES");
    glb.attribute(0, "POSITION")["sparse"] = {
        {"count", indices.size()},
        {"indices",
         {{"bufferView", index_view}, {"componentType", index_bytes == 2 ? support::kU16 : support::kU32}}},
        {"values", {{"bufferView", value_view}}}};
    return glb;
}

TEST(Meshopt, ModesOfIndices) {
    for (const char* mode : {"TRIANGLES", "INDICES"})
        for (const std::size_t index_bytes : {2, 4}) {
            const std::vector<std::uint32_t> indices{1, 3, 4, 7, 8, 11};
            const Animal animal = support::read_good(sparse_positions(mode, indices, index_bytes).build());
            for (const std::uint32_t i : indices)
                EXPECT_EQ(animal.vertices.positions[i][0], 100.0f + static_cast<float>(i)) << mode;
            EXPECT_EQ(animal.vertices.positions[0],
                      support::animal_of(support::tail()).vertices.positions[0]);
        }
}

// The decoded indices count, not the harmless bytes that lie where a reader without the extension looks.
TEST(Meshopt, DecodedSparseIndicesAreChecked) {
    GlbBuilder glb = sparse_positions("INDICES", {1, 3, 12}, 2);
    const int harmless = glb.add_view_of(std::vector<std::uint16_t>{1, 3, 4, 0});
    Json& positions = glb.attribute(0, "POSITION");
    const auto view = positions["sparse"]["indices"]["bufferView"].get<std::size_t>();
    Json& views = glb.document["bufferViews"];
    views[view]["buffer"] = 0;
    views[view]["byteOffset"] = views[static_cast<std::size_t>(harmless)]["byteOffset"];
    const auto animal = read_animal(glb.build());
    ASSERT_FALSE(animal);
    EXPECT_EQ(animal.issue().code, IssueCode::glb_sparse) << base::format_issue(animal.issue());
}

struct Lie {
    const char* what;
    IssueCode code;
    std::function<void(GlbBuilder&, Json& view, Json& extension)> tell;
};

std::uint8_t* stream_data(GlbBuilder& glb, const Json& extension) {
    return glb.bin.data() + extension["byteOffset"].get<std::size_t>();
}

TEST(Meshopt, LiesAreRefused) {
    const Lie lies[] = {
        {"no mode", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e.erase("mode"); }},
        {"unknown mode", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e["mode"] = "POINTS"; }},
        {"another mode", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e["mode"] = "TRIANGLES"; }},
        {"unknown filter", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e["filter"] = "SOFT"; }},
        {"a filter of KHR_meshopt_compression", IssueCode::glb_extension,
         [](auto&, auto&, Json& e) { e["filter"] = "COLOR"; }},
        {"quaternions of 12 bytes", IssueCode::glb_meshopt,
         [](auto&, auto&, Json& e) { e["filter"] = "QUATERNION"; }},
        {"normals of 12 bytes", IssueCode::glb_meshopt,
         [](auto&, auto&, Json& e) { e["filter"] = "OCTAHEDRAL"; }},
        {"a stream of version 1", IssueCode::glb_extension,
         [](GlbBuilder& g, auto&, Json& e) { *stream_data(g, e) = 0xA1; }},
        {"no header", IssueCode::glb_meshopt,
         [](GlbBuilder& g, auto&, Json& e) { *stream_data(g, e) = 0x00; }},
        {"a stream of no bytes", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e["byteLength"] = 0; }},
        {"one byte too few", IssueCode::glb_meshopt,
         [](auto&, auto&, Json& e) { e["byteLength"] = e["byteLength"].get<int>() - 1; }},
        {"count and view differ", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e["count"] = 13; }},
        {"no count", IssueCode::glb_meshopt, [](auto&, auto&, Json& e) { e.erase("count"); }},
        {"a stride of 6", IssueCode::glb_meshopt,
         [](auto&, Json& v, Json& e) {
             e["byteStride"] = 6;
             e["count"] = v["byteLength"].get<int>() / 6;
         }},
        {"more than any stream of this size holds", IssueCode::glb_meshopt,
         [](auto&, Json& v, Json& e) {
             e["count"] = 1'000'000'000;
             v["byteLength"] = 12'000'000'000;
         }},
        {"a product that wraps", IssueCode::glb_meshopt,
         [](auto&, Json& v, Json& e) {
             e["byteStride"] = 12;
             e["count"] = 1537228672809129302;  // times 12: 8 beyond 2^64
             v["byteLength"] = 8;
         }},
        {"a stream out of the buffer", IssueCode::glb_view_range,
         [](GlbBuilder& g, auto&, Json& e) { e["byteOffset"] = g.bin.size(); }},
        {"a stream in the fallback buffer", IssueCode::glb_uri,
         [](auto&, auto&, Json& e) { e["buffer"] = 1; }},
        {"a stream in no buffer", IssueCode::glb_reference, [](auto&, auto&, Json& e) { e["buffer"] = 7; }},
        {"a count of another type", IssueCode::glb_schema, [](auto&, auto&, Json& e) { e["count"] = "12"; }},
        {"no extension on a view of the fallback buffer", IssueCode::glb_uri,
         [](auto&, Json& v, auto&) { v.erase("extensions"); }},
    };
    for (const Lie& lie : lies) {
        GlbBuilder glb = compressed_tail();
        const int view = view_of(glb.attribute(0, "POSITION"));
        lie.tell(glb, glb.document["bufferViews"][static_cast<std::size_t>(view)], extension_of(glb, view));
        const auto animal = read_animal(glb.build());
        ASSERT_FALSE(animal) << lie.what;
        EXPECT_EQ(animal.issue().code, lie.code) << lie.what << ": " << base::format_issue(animal.issue());
    }
}

// No byte of a stream that is changed leads out of memory or time (run with AddressSanitizer).
TEST(Meshopt, AnyByteMayChange) {
    const GlbBuilder good = compressed_tail();
    GlbBuilder glb = good;
    const Json& extension = extension_of(glb, view_of(glb.attribute(0, "POSITION")));
    const auto begin = extension["byteOffset"].get<std::size_t>();
    const auto size = extension["byteLength"].get<std::size_t>();
    std::size_t refused = 0;
    for (std::size_t i = begin; i < begin + size; ++i) {
        glb.bin = good.bin;
        glb.bin[i] ^= 0xFF;
        if (!read_animal(glb.build())) ++refused;
    }
    EXPECT_GT(refused, 0u);
}

}  // namespace
}  // namespace posepack::animal

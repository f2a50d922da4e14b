// SPDX-License-Identifier: MIT
// Writes small inputs for the fuzz targets to begin with: FOLDER/glb_to_rows and FOLDER/open_container.
//
//     posepack_fuzz_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "container_builder.hpp"
#include "runs_builder.hpp"
#include "support/sample_models.hpp"

namespace {

using namespace posepack;
namespace fs = std::filesystem;

void write(const fs::path& path, const std::vector<std::uint8_t>& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// One joint that slides, in two keys of each interpolation.
support::ModelSpec slider(const std::string& interpolation) {
    support::ModelSpec spec = support::one_bone();
    support::ChannelSpec channel{0, "translation", {0.0f, 0.1f}, {0, 0, 0, 1, 0, 0}, interpolation};
    if (interpolation == "CUBICSPLINE")
        channel.values = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0};
    spec.clips.push_back({"Rig|Slide", {channel}});
    return spec;
}

void write_models(const fs::path& folder) {
    write(folder / "tail.glb", support::glb_of(support::tail()));
    for (const std::string interpolation : {"LINEAR", "STEP", "CUBICSPLINE"})
        write(folder / ("slider_" + interpolation + ".glb"), support::glb_of(slider(interpolation)));
    support::GlbBuilder rigid = support::builder_of(slider("LINEAR"));
    rigid.document.erase("skins");
    for (auto& node : rigid.document["nodes"]) node.erase("skin");
    rigid.document["nodes"][0]["mesh"] = 0;
    write(folder / "rigid.glb", rigid.build());
    support::GlbBuilder sparse = support::builder_of(slider("LINEAR"));
    const int indices = sparse.add_view_of(std::vector<std::uint16_t>{0, 1});
    const int values = sparse.add_view_of(std::vector<float>{0, 0, 0, 0, 1, 0});
    sparse.values(0, 0)["sparse"] = {{"count", 2},
                                     {"indices", {{"bufferView", indices}, {"componentType", support::kU16}}},
                                     {"values", {{"bufferView", values}}}};
    write(folder / "sparse.glb", sparse.build());
}

std::string file_name(unsigned encoding, unsigned format, unsigned order) {
    return std::to_string(encoding) + std::to_string(format) + std::to_string(order) + ".posepack";
}

void write_containers(const fs::path& folder) {
    for (const unsigned encoding : {POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_AFFINE})
        for (const unsigned format : {POSEPACK_TEXEL_RGBA16F, POSEPACK_TEXEL_RGBA32F})
            for (const unsigned order : {POSEPACK_ORDER_BONE_MAJOR, POSEPACK_ORDER_PLANAR}) {
                test::TinyOptions options;
                options.encoding = static_cast<std::uint8_t>(encoding);
                options.texel_format = static_cast<std::uint8_t>(format);
                options.texel_order = static_cast<std::uint8_t>(order);
                options.rows_per_line = 2;
                write(folder / file_name(encoding, format, order), test::make_container(options));
            }
    for (const std::uint8_t encoding :
         {POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT})
        write(folder / ("runs" + std::to_string(encoding) + ".posepack"),
              test::make_run_container(test::tiny_runs(encoding, POSEPACK_ENCODING_DUALQUAT)));
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: posepack_fuzz_seeds FOLDER\n");
        return 1;
    }
    const fs::path folder = arguments[1];
    fs::create_directories(folder / "glb_to_rows");
    fs::create_directories(folder / "open_container");
    write_models(folder / "glb_to_rows");
    write_containers(folder / "open_container");
    return 0;
}

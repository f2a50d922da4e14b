// SPDX-License-Identifier: MIT
// Every form that a palette can be written in.
#pragma once

#include <string>
#include <vector>

#include "recipe/catalog.hpp"

namespace posepack::palette {

inline std::vector<recipe::OutputOptions> all_forms() {
    using namespace recipe;
    std::vector<OutputOptions> forms;
    for (const Encoding encoding : {Encoding::mat4, Encoding::affine})
        for (const TexelFormat format : {TexelFormat::rgba16f, TexelFormat::rgba32f})
            for (const TexelOrder order : {TexelOrder::bone_major, TexelOrder::planar})
                for (const RowPitch pitch : {RowPitch::tight, RowPitch::align256})
                    forms.push_back({encoding, format, order, pitch, Caps::webgl2});
    return forms;
}

inline std::string name_of_form(const recipe::OutputOptions& form) {
    std::string name;
    for (const std::string_view part : {name_of(form.encoding), name_of(form.texel_format),
                                        name_of(form.texel_order), name_of(form.row_pitch)})
        name += std::string(part) + " ";
    return name;
}

}  // namespace posepack::palette

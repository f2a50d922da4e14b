// SPDX-License-Identifier: MIT
// The contact sheet: every animal in three of its clips, on a floor with a shadow that shows where it stands.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/mesh_buffers.hpp"
#include "render/palette_texture.hpp"

namespace posepack::render {

struct SheetOptions {
    int columns = 5;    // animals beside each other; each has three cells
    int cell_px = 128;  // width and height of a cell
    int samples_a_side = 3;
};

// An animal of the sheet: a palette, and its mesh with joints already turned into bones.
struct SheetAnimal {
    std::string id;
    PaletteTexture palette;
    SkinnedMesh mesh;
};

// Reads one animal. Throws RenderError where the files do not fit each other.
SheetAnimal read_sheet_animal(std::string id, const std::vector<std::uint8_t>& glb,
                              std::vector<std::uint8_t> container);

struct Sheet {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // lowest line first
};

// Draws the animals in rows from the upper left, in the clips of the states wander, flee and attack; each as
// large as its cell allows, at one scale for its three clips.
Sheet draw_sheet(const std::vector<SheetAnimal>& animals, const SheetOptions& options);

}  // namespace posepack::render

// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

namespace posepack::cli {
namespace {

constexpr Command kCommands[] = {
    {"bake", "Bake a catalog of GLB animals into palettes and a manifest", add_bake},
    {"report", "Error against run time: every encoding and rate, measured", add_report},
    {"compare", "Texture memory and texel reads: palettes against vertex animation textures", add_compare},
    {"doctor", "Say what a GLB holds, what is odd, what is repaired, and what a bake of it would give",
     add_doctor},
    {"inspect", "Show what a container holds; one bone-row as a matrix", add_inspect},
    {"verify", "Check containers against the format and the manifest", add_verify},
    {"export", "Write a container's texels as OpenEXR", add_export},
    {"stress", "Measure every form on stiff and extreme motion, and check what the compiler does about it",
     add_stress},
    {"menagerie", "Write the generated animals of the default catalog", add_menagerie},
};

}  // namespace

std::span<const Command> commands() {
    return kCommands;
}

}  // namespace posepack::cli

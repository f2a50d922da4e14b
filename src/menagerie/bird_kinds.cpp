// SPDX-License-Identifier: MIT
// The birds of the second catalog, as rows of data.
#include <array>

#include "menagerie/bird_shapes.hpp"
#include "menagerie/menagerie.hpp"

namespace posepack::menagerie {
namespace {

// A bird of the second catalog: the measures, and so the rig, of one of five, in its own colours and with its
// own thickness of neck and beak.
struct Plumage {
    const char* id;
    const char* name;
    BirdShape (*measures)();
    double neck, beak;  // times those of the measures
    Colour back, side, belly, cap, cheek, bib, wing, wing_bar, feather, tail, bill, leg;
};

constexpr std::array kPlumages = {
    // Crows.
    Plumage{"chough", "Chough", crow_shape, 0.92, 0.72, 0x17181C, 0x1B1C21, 0x1E1F24, 0x17181C, 0x17181C,
            0x17181C, 0x141519, 0x191A20, 0x101114, 0x121317, 0xD23A24, 0xC9382A},
    Plumage{"hooded_crow", "HoodedCrow", crow_shape, 1.0, 1.0, 0x8E8C88, 0x9A9894, 0xA3A19C, 0x1B1B1E,
            0x1B1B1E, 0x1E1E22, 0x1A1A1E, 0x222227, 0x131316, 0x151518, 0x1A1A1C, 0x222224},
    Plumage{"jackdaw", "Jackdaw", crow_shape, 1.06, 0.80, 0x26272C, 0x34353A, 0x3A3B40, 0x1A1B1F, 0x6E7076,
            0x2C2D32, 0x222328, 0x2A2B31, 0x18191D, 0x1B1C20, 0x1E1E20, 0x222224},
    Plumage{"magpie", "Magpie", crow_shape, 0.95, 0.85, 0x17181C, 0xF0EEE8, 0xF4F2EC, 0x141519, 0x16171B,
            0x141519, 0x1D2E4A, 0xF2F0EA, 0x15202E, 0x123830, 0x1A1A1C, 0x1F1F21},
    Plumage{"raven", "Raven", crow_shape, 1.15, 1.25, 0x131418, 0x16171B, 0x191A1F, 0x121317, 0x131418,
            0x111216, 0x101115, 0x15161B, 0x0D0E11, 0x0F1013, 0x141416, 0x1B1B1D},
    // Ducks.
    Plumage{"eider", "Eider", duck_shape, 1.05, 1.10, 0xF0EEE6, 0x202022, 0x242426, 0x1C1D20, 0xEFEDE4,
            0xEDE6D4, 0xF2F0E8, 0x2A2A2C, 0x222224, 0x1E1E20, 0xA8A878, 0x8A8460},
    Plumage{"goldeneye", "Goldeneye", duck_shape, 0.95, 0.90, 0x1E1F22, 0xF2F0EA, 0xF4F2EC, 0x1B3A30,
            0x1F4236, 0x1B3A30, 0x26262A, 0xF0EEE8, 0x1A1A1D, 0x2A2A2E, 0x2A2A2C, 0xD68A2C},
    Plumage{"pochard", "Pochard", duck_shape, 1.0, 1.0, 0x9C9A96, 0xA8A6A2, 0xB4B2AE, 0x8A3A1E, 0x92401F,
            0x2A2422, 0x94928E, 0xA6A4A0, 0x5E5C58, 0x2E2A28, 0x5A6470, 0x6A6A6A},
    Plumage{"shelduck", "Shelduck", duck_shape, 0.96, 1.05, 0xF2F0EA, 0xF0EEE6, 0xB0683A, 0x1A3A30, 0x1C3E34,
            0xF2F0EA, 0xF0EEE8, 0x2E6A4A, 0x1E1E20, 0xEDEBE4, 0xC8382C, 0xD89A92},
    Plumage{"teal", "Teal", duck_shape, 0.92, 0.85, 0x8A8680, 0x9E9A92, 0xD8D2C4, 0x7A3E20, 0x2A6A48,
            0x7A3E20, 0x807A72, 0x3A9A5E, 0x4E4A44, 0xD6C69A, 0x3A3A3C, 0x5E5A54},
    // Birds of prey.
    Plumage{"buzzard", "Buzzard", eagle_shape, 0.96, 0.78, 0x5A4028, 0x6E5236, 0xB49A72, 0x4E3824, 0x5C442C,
            0x7A5E40, 0x523A26, 0x8A6C48, 0x33251A, 0x7A6040, 0x3A3A3C, 0xE0B83A},
    Plumage{"golden_eagle", "GoldenEagle", eagle_shape, 1.08, 1.05, 0x3A2818, 0x443020, 0x4C3624, 0xA87838,
            0x8E6430, 0x402C1C, 0x3C2A1A, 0x5A4028, 0x281C12, 0x3E2C1E, 0x4A4A4A, 0xE2B63A},
    Plumage{"kestrel", "Kestrel", eagle_shape, 0.92, 0.66, 0xA86238, 0xB87648, 0xE6D2A8, 0x8A929C, 0xDCD2C0,
            0xE8DABC, 0xAA643A, 0xC08052, 0x2E2824, 0x8A929C, 0x5A5E64, 0xE6BE3C},
    Plumage{"osprey", "Osprey", eagle_shape, 0.94, 0.90, 0x4A3A2C, 0x5A4838, 0xF2EEE4, 0xF0ECE2, 0xEFEBE0,
            0xF0ECE2, 0x463628, 0x6A5642, 0x2C2218, 0x6E5A46, 0x2A2A2C, 0xB8BEC2},
    Plumage{"red_kite", "RedKite", eagle_shape, 0.94, 0.82, 0x7A4424, 0x8E5230, 0xA86238, 0xB8B2A6, 0xC4BEB2,
            0x9A5A34, 0x6A3C22, 0xE0D6C4, 0x26201C, 0xB2562A, 0xE0B034, 0xE6BE3C},
    // Owls.
    Plumage{"barn_owl", "BarnOwl", owl_shape, 0.92, 0.85, 0xC89A58, 0xE0BE86, 0xF6F2E8, 0xCC9E5C, 0xF8F5EE,
            0xF6F2E8, 0xC69856, 0xD8B27A, 0xA67C44, 0xD2AA6E, 0xE0D0B8, 0xD8CCB8},
    Plumage{"eagle_owl", "EagleOwl", owl_shape, 1.12, 1.20, 0x5A3E22, 0x8A6236, 0xB8884C, 0x4E361E, 0xA87C48,
            0xD8CCB4, 0x543A20, 0x8E683A, 0x322214, 0x5E4426, 0x2A2622, 0xB89C6E},
    Plumage{"little_owl", "LittleOwl", owl_shape, 1.04, 0.80, 0x6A5440, 0xA08A6E, 0xE2DACA, 0x5E4A38,
            0xDCD2C0, 0xE6DED0, 0x665040, 0xD0C4AE, 0x463628, 0x6E5A46, 0xC8B45A, 0xC6B48E},
    Plumage{"snowy_owl", "SnowyOwl", owl_shape, 1.10, 0.95, 0xF4F3EF, 0xF6F5F1, 0xF8F7F4, 0xF3F2EE, 0xF8F7F4,
            0xF8F7F4, 0xF2F1EC, 0xC8C6C0, 0xECEAE4, 0xF2F1EC, 0x2A2A2C, 0xEFEDE6},
    Plumage{"tawny_owl", "TawnyOwl", owl_shape, 1.06, 0.95, 0x7A4A28, 0xA87446, 0xDCC09A, 0x6E4224, 0xC89E70,
            0xD4B288, 0x744626, 0xD8BE98, 0x4A2E1A, 0x7E5230, 0xB8A87A, 0xC4A67A},
    // Songbirds.
    Plumage{"bullfinch", "Bullfinch", sparrow_shape, 1.08, 1.25, 0x7E8288, 0xC85A48, 0xD0604C, 0x17181B,
            0xCC5C4A, 0x1A1B1E, 0x5A5E64, 0xE6E4DE, 0x1C1D20, 0x1A1B1E, 0x1E1E20, 0x5A4438},
    Plumage{"goldfinch", "Goldfinch", sparrow_shape, 0.98, 0.92, 0xA87E52, 0xC8A680, 0xF2ECE0, 0x1A1A1C,
            0xF2EEE4, 0xC02A20, 0x1C1C1E, 0xE8C030, 0x161618, 0x1A1A1C, 0xDCC8AA, 0xC8A890},
    Plumage{"great_tit", "GreatTit", sparrow_shape, 1.0, 0.85, 0x6E8048, 0xD8C84A, 0xE2D24E, 0x17191C,
            0xF2F0EA, 0x17191C, 0x5E7088, 0xEDEBE4, 0x3A4656, 0x4E5E72, 0x222224, 0x5E6874},
    Plumage{"robin", "Robin", sparrow_shape, 1.06, 0.72, 0x6E5A42, 0xA09684, 0xE6E0D2, 0x665440, 0xD0602A,
            0xD4622A, 0x6A563E, 0x7A664C, 0x4E3E2C, 0x5E4C36, 0x2A241E, 0x7A5A44},
    Plumage{"wren", "Wren", sparrow_shape, 0.94, 0.62, 0x6A4426, 0x8E6640, 0xB4946A, 0x5E3C22, 0xC0A27A,
            0xC2A680, 0x66422A, 0x8A623C, 0x46301E, 0x5A3C24, 0x4A3828, 0xA88468},
};

BirdShape shape_of(const Plumage& kind) {
    BirdShape s = kind.measures();
    s.name = kind.name;
    s.neck_radius *= kind.neck;
    s.beak_radius *= kind.beak;
    s.back = kind.back;
    s.side = kind.side;
    s.belly = kind.belly;
    s.cap = s.nape = kind.cap;
    s.cheek = kind.cheek;
    s.bib = kind.bib;
    s.wing = kind.wing;
    s.wing_bar = kind.wing_bar;
    s.feather = kind.feather;
    s.tail = kind.tail;
    s.beak = kind.bill;
    s.leg = kind.leg;
    return s;
}

constexpr auto kBirds = [] {
    std::array<std::string_view, kPlumages.size()> ids{};
    for (std::size_t index = 0; index < kPlumages.size(); ++index) ids[index] = kPlumages[index].id;
    return ids;
}();

}  // namespace

std::span<const std::string_view> birds() {
    return kBirds;
}

std::optional<Model> build_bird(std::string_view id) {
    for (const Plumage& kind : kPlumages) {
        if (id == kind.id) return built_bird(shape_of(kind), {}, {"BirdArmature"}, 24);
    }
    return std::nullopt;
}

}  // namespace posepack::menagerie

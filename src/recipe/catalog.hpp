// SPDX-License-Identifier: MIT
// Catalog: what people write. Animals with their models, clips, states and output options, read from JSON
// and checked completely (schemas/catalog-1.schema.json says the same to editors).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "recipe/bound.hpp"

namespace posepack::recipe {

inline constexpr int kCatalogSchema = 1;
inline constexpr std::size_t kMaxCatalogBytes = 16u << 20;
inline constexpr std::size_t kMaxAnimals = 100'000;

enum class Encoding { mat4, affine, dualquat };
enum class Space { automatic, model, normalised };  // of the rows; automatic: model for mat4, else normalised
enum class TexelFormat { rgba16f, rgba32f };
enum class TexelOrder { bone_major, planar };
enum class RowPitch { tight, align256 };
enum class UnusedBones { automatic, keep, drop };  // bones that move no vertex; automatic: drop under a bound
enum class Caps { webgl2, desktop };               // largest texture side: 4096, 16384 texels
enum class Wrap { automatic, loop, once, ping_pong };
enum class Seam { automatic, closed, open };
enum class ForwardAxis { plus_z, minus_z, plus_x, minus_x };

// How a palette is laid out. Each field may come from the command line, the animal, the catalog's
// defaults, or this default, in that order.
struct OutputOptions {
    Encoding encoding = Encoding::affine;
    TexelFormat texel_format = TexelFormat::rgba16f;
    TexelOrder texel_order = TexelOrder::bone_major;
    RowPitch row_pitch = RowPitch::tight;
    Caps caps = Caps::webgl2;
    Space space = Space::automatic;
    std::uint32_t influences = 4;  // that a vertex keeps: 4 or 8
    UnusedBones unused_bones = UnusedBones::automatic;
    std::optional<ErrorBound> bound{};  // form and rows are chosen by it; `encoding` then says nothing

    bool is_normalised() const {
        return space == Space::normalised ||
               (space == Space::automatic && (bound || encoding != Encoding::mat4));
    }
    bool drops_unused_bones() const {
        return unused_bones == UnusedBones::drop || (unused_bones == UnusedBones::automatic && bound);
    }
};

// The fields of OutputOptions that somebody set.
struct OutputOverrides {
    std::optional<Encoding> encoding;
    std::optional<TexelFormat> texel_format;
    std::optional<TexelOrder> texel_order;
    std::optional<RowPitch> row_pitch;
    std::optional<Caps> caps;
    std::optional<Space> space;
    std::optional<std::uint32_t> influences{};
    std::optional<UnusedBones> unused_bones{};
    std::optional<ErrorBound> bound{};
};

// One wish for clips of an animal: a name, or a pattern with * and ?.
struct ClipWish {
    std::string name;                 // matched without case against the text after the last '|'
    std::vector<std::string> states;  // states that play this clip
    std::optional<double> rate_hz;    // settled; nothing: the clip's own key grid
    Wrap wrap = Wrap::automatic;
    Seam seam = Seam::automatic;
    double speed_mps = 0.0;             // ground speed at rate 1; 0: not stated
    double stride_phase = 0.0;          // phase of the first foot contact, 0..1
    std::optional<ErrorBound> bound{};  // of this clip alone; needs a bound of the animal
};

// State name -> keywords, in order of preference: the first clip whose name holds the keyword plays it.
using KeywordMap = std::map<std::string, std::vector<std::string>>;

struct AnimalEntry {
    std::string id;                 // a file name on every system
    std::string model;              // relative path with '/', inside the models folder
    std::vector<ClipWish> clips;    // empty: every clip of the model
    std::string default_state;      // empty: "idle" where there is one, else the first
    KeywordMap keywords;            // the catalog's, overlaid with the animal's
    std::optional<double> rate_hz;  // of every clip where `clips` is empty; nothing: the key grids
    double metres_per_unit = 1.0;
    ForwardAxis forward = ForwardAxis::plus_z;
    OutputOptions output;
    std::string canonical_json;  // the entry with defaults applied, without paths: part of the recipe
};

struct Catalog {
    std::vector<AnimalEntry> animals;  // sorted by id
};

// Reads a catalog from its JSON text. `overrides` (of the command line) beat everything in it; `rate_hz`
// likewise replaces every rate. Errors: E-CAT-*, E-LIM-JSON-DEPTH, E-LIM-ENTRIES, E-LIM-FILE.
// `where` in an issue is the JSON pointer of the place.
base::Result<Catalog> read_catalog(std::string_view text, const OutputOverrides& overrides = {},
                                   std::optional<double> rate_hz = std::nullopt);

// The states every animal has where the catalog gives no keywords: attack, flee, wander, idle.
const KeywordMap& default_keywords();

// Names as written in catalogs, manifests and on the command line ("affine", "rgba16f", "+z").
std::string_view name_of(Encoding);
std::string_view name_of(TexelFormat);
std::string_view name_of(TexelOrder);
std::string_view name_of(RowPitch);
std::string_view name_of(Caps);
std::string_view name_of(Space);
std::string_view name_of(UnusedBones);
std::string_view name_of(Wrap);
std::string_view name_of(Seam);
std::string_view name_of(ForwardAxis);

}  // namespace posepack::recipe

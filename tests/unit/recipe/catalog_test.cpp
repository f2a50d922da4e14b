// SPDX-License-Identifier: MIT
#include "recipe/catalog.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <clocale>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "base/json.hpp"

namespace posepack::recipe {
namespace {

Catalog read(std::string_view text, const OutputOverrides& overrides = {},
             std::optional<double> rate_hz = std::nullopt) {
    const base::Result<Catalog> catalog = read_catalog(text, overrides, rate_hz);
    if (!catalog) throw std::runtime_error(base::format_issue(catalog.issue()));
    return catalog.value();
}

constexpr std::string_view kSmall = R"({"schema": 1, "animals": {"deer": {"model": "deer.glb"}}})";

constexpr std::string_view kFull = R"({
    "$schema": "../schemas/catalog-1.schema.json",
    "schema": 1,
    "defaults": {"rate_hz": 24, "metres_per_unit": 0.01, "forward": "-z",
                 "output": {"encoding": "mat4", "texel_format": "rgba32f", "texel_order": "planar",
                            "row_pitch": "align256", "caps": "desktop", "influences": 8,
                            "unused_bones": "drop"}},
    "keywords": {"wander": ["walk", "trot"], "rest": ["sleep"]},
    "animals": {
        "wolf": {"model": "dogs/wolf.glb",
                 "clips": ["Run*", {"name": "Walk", "states": ["wander", "stroll"], "rate_hz": 30, "wrap": "loop",
                                    "seam": "closed", "speed_mps": 1.5, "stride_phase": 0.25},
                           {"name": "Eat", "rate_hz": "keys", "wrap": "ping-pong"}],
                 "default_state": "stroll",
                 "keywords": {"rest": [], "hunt": ["bite"]},
                 "metres_per_unit": 1, "forward": "+x",
                 "output": {"encoding": "affine", "caps": "webgl2", "influences": 4,
                            "unused_bones": "keep"}},
        "Bear": {"model": "bear.glb", "rate_hz": "keys"},
        "cat": {"model": "cat.glb"}
    }
})";

TEST(ReadCatalog, FillsInTheDefaults) {
    const Catalog catalog = read(kSmall);
    ASSERT_EQ(catalog.animals.size(), 1u);
    const AnimalEntry& deer = catalog.animals[0];
    EXPECT_EQ(deer.id, "deer");
    EXPECT_EQ(deer.model, "deer.glb");
    EXPECT_TRUE(deer.clips.empty());
    EXPECT_EQ(deer.default_state, "");
    EXPECT_EQ(deer.keywords, default_keywords());
    EXPECT_FALSE(deer.rate_hz);
    EXPECT_EQ(deer.metres_per_unit, 1.0);
    EXPECT_EQ(deer.forward, ForwardAxis::plus_z);
    EXPECT_EQ(deer.output.encoding, Encoding::affine);
    EXPECT_EQ(deer.output.texel_format, TexelFormat::rgba16f);
}

TEST(ReadCatalog, SortsAnimalsById) {
    const Catalog catalog = read(kFull);
    ASSERT_EQ(catalog.animals.size(), 3u);
    EXPECT_EQ(catalog.animals[0].id, "Bear");
    EXPECT_EQ(catalog.animals[1].id, "cat");
    EXPECT_EQ(catalog.animals[2].id, "wolf");
}

TEST(ReadCatalog, ReadsEveryKeyOfAClip) {
    const AnimalEntry wolf = read(kFull).animals[2];
    ASSERT_EQ(wolf.clips.size(), 3u);
    EXPECT_EQ(wolf.clips[0].name, "Run*");
    EXPECT_EQ(wolf.clips[0].wrap, Wrap::automatic);
    EXPECT_EQ(wolf.clips[0].seam, Seam::automatic);
    const ClipWish& walk = wolf.clips[1];
    EXPECT_EQ(walk.name, "Walk");
    EXPECT_EQ(walk.states, (std::vector<std::string>{"wander", "stroll"}));
    EXPECT_EQ(walk.wrap, Wrap::loop);
    EXPECT_EQ(walk.seam, Seam::closed);
    EXPECT_EQ(walk.speed_mps, 1.5);
    EXPECT_EQ(walk.stride_phase, 0.25);
    EXPECT_EQ(wolf.clips[2].wrap, Wrap::ping_pong);
    EXPECT_EQ(wolf.default_state, "stroll");
}

TEST(ReadCatalog, SettlesRatesClipByClip) {
    const Catalog catalog = read(kFull);
    EXPECT_FALSE(catalog.animals[0].rate_hz) << "\"keys\" beats the defaults";
    EXPECT_EQ(catalog.animals[1].rate_hz, 24.0);
    const AnimalEntry& wolf = catalog.animals[2];
    EXPECT_EQ(wolf.clips[0].rate_hz, 24.0);
    EXPECT_EQ(wolf.clips[1].rate_hz, 30.0);
    EXPECT_FALSE(wolf.clips[2].rate_hz) << "\"keys\" beats the defaults";
    const Catalog forced = read(kFull, {}, 15.0);
    EXPECT_EQ(forced.animals[0].rate_hz, 15.0);
    for (const ClipWish& wish : forced.animals[2].clips) EXPECT_EQ(wish.rate_hz, 15.0);
}

TEST(ReadCatalog, OverlaysKeywordsStateByState) {
    const Catalog catalog = read(kFull);
    EXPECT_EQ(catalog.animals[1].keywords, (KeywordMap{{"wander", {"walk", "trot"}}, {"rest", {"sleep"}}}));
    EXPECT_EQ(catalog.animals[2].keywords, (KeywordMap{{"wander", {"walk", "trot"}}, {"hunt", {"bite"}}}));
}

TEST(ReadCatalog, OverlaysUnitsAndOutputOptions) {
    const Catalog catalog = read(kFull);
    const AnimalEntry& cat = catalog.animals[1];
    EXPECT_EQ(cat.metres_per_unit, 0.01);
    EXPECT_EQ(cat.forward, ForwardAxis::minus_z);
    EXPECT_EQ(cat.output.encoding, Encoding::mat4);
    EXPECT_EQ(cat.output.texel_format, TexelFormat::rgba32f);
    EXPECT_EQ(cat.output.texel_order, TexelOrder::planar);
    EXPECT_EQ(cat.output.row_pitch, RowPitch::align256);
    EXPECT_EQ(cat.output.caps, Caps::desktop);
    EXPECT_EQ(cat.output.influences, 8u);
    EXPECT_EQ(cat.output.unused_bones, UnusedBones::drop);
    const AnimalEntry& wolf = catalog.animals[2];
    EXPECT_EQ(wolf.metres_per_unit, 1.0);
    EXPECT_EQ(wolf.forward, ForwardAxis::plus_x);
    EXPECT_EQ(wolf.output.encoding, Encoding::affine);
    EXPECT_EQ(wolf.output.texel_format, TexelFormat::rgba32f);
    EXPECT_EQ(wolf.output.caps, Caps::webgl2);
    EXPECT_EQ(wolf.output.influences, 4u);
    EXPECT_EQ(wolf.output.unused_bones, UnusedBones::keep);
}

TEST(ReadCatalog, LetsTheCommandLineWin) {
    OutputOverrides overrides;
    overrides.encoding = Encoding::affine;
    overrides.texel_format = TexelFormat::rgba16f;
    overrides.texel_order = TexelOrder::bone_major;
    overrides.row_pitch = RowPitch::tight;
    overrides.caps = Caps::webgl2;
    overrides.influences = 4;
    overrides.unused_bones = UnusedBones::keep;
    for (const AnimalEntry& animal : read(kFull, overrides).animals) {
        EXPECT_EQ(animal.output.encoding, Encoding::affine);
        EXPECT_EQ(animal.output.texel_format, TexelFormat::rgba16f);
        EXPECT_EQ(animal.output.texel_order, TexelOrder::bone_major);
        EXPECT_EQ(animal.output.row_pitch, RowPitch::tight);
        EXPECT_EQ(animal.output.caps, Caps::webgl2);
        EXPECT_EQ(animal.output.influences, 4u);
        EXPECT_EQ(animal.output.unused_bones, UnusedBones::keep);
    }
}

// A bound chooses the form, and leaves out what moves nothing; whoever says otherwise wins.
TEST(ReadCatalog, ABoundLeavesUnusedBonesOutUnlessTold) {
    struct Case {
        const char* output;
        std::optional<UnusedBones> asked;  // on the command line
        bool drops;
    };
    const Case cases[] = {
        {R"({})", {}, false},
        {R"({"max_error":0.02})", {}, true},
        {R"({"max_error":0.02,"unused_bones":"auto"})", {}, true},
        {R"({"max_error":0.02,"unused_bones":"keep"})", {}, false},
        {R"({"max_error":0.02})", UnusedBones::keep, false},
        {R"({"max_error":0.02,"unused_bones":"keep"})", UnusedBones::automatic, true},
        {R"({"max_error":0.02,"unused_bones":"keep"})", UnusedBones::drop, true},
        {R"({"unused_bones":"drop"})", {}, true},
        {R"({"unused_bones":"drop"})", UnusedBones::automatic, false},
    };
    for (const Case& c : cases) {
        OutputOverrides overrides;
        overrides.unused_bones = c.asked;
        const std::string text = std::string(R"({"schema":1,"animals":{"deer":{"model":"d.glb","output":)")
                                     .append(c.output)
                                     .append("}}}");
        const AnimalEntry deer = read(text, overrides).animals[0];
        EXPECT_EQ(deer.output.drops_unused_bones(), c.drops) << text;
        const char* named = c.drops ? R"("unused_bones":"drop")" : R"("unused_bones":"keep")";
        EXPECT_NE(deer.canonical_json.find(named), std::string::npos) << deer.canonical_json;
    }
    // The bound of the command line counts like one of the catalog, and so does its end.
    OutputOverrides bounded;
    bounded.bound = parse_error_bound("default");
    EXPECT_TRUE(read(kSmall, bounded).animals[0].output.drops_unused_bones());
    OutputOverrides fixed;
    fixed.encoding = Encoding::affine;
    const auto unbounded =
        read(R"({"schema":1,"animals":{"deer":{"model":"d.glb","output":{"max_error":0.02}}}})", fixed);
    EXPECT_FALSE(unbounded.animals[0].output.drops_unused_bones());
}

// A clip's bound alone is a fault (CatalogFaults), but not where the command line has the last word on the
// form.
TEST(ReadCatalog, TheCommandLineSettlesABoundOfOneClip) {
    const std::string text = R"({"schema":1,"animals":{"deer":{"model":"d.glb",)"
                             R"("clips":["idle",{"name":"walk","max_error":"hero"}]}}})";
    OutputOverrides bounded;
    bounded.bound = parse_error_bound("default");
    EXPECT_TRUE(read(text, bounded).animals[0].clips[1].bound);
    OutputOverrides fixed;
    fixed.encoding = Encoding::affine;
    EXPECT_FALSE(read(text, fixed).animals[0].output.bound);
}

TEST(CanonicalJson, LeavesOutIdAndPath) {
    const AnimalEntry deer = read(kSmall).animals[0];
    const AnimalEntry moved = read(R"({"schema":1,"animals":{"elk":{"model":"a/b.glb"}}})").animals[0];
    EXPECT_EQ(deer.canonical_json, moved.canonical_json);
    EXPECT_EQ(base::check_json(deer.canonical_json).fault, base::JsonFault::none);
    EXPECT_EQ(
        deer.canonical_json,
        R"({"clips":[],"default_state":"","forward":"+z","keywords":{"attack":["attack","bite"],)"
        R"("flee":["run","gallop"],"idle":["idle"],"wander":["walk"]},"metres_per_unit":1.0,)"
        R"("output":{"bound":null,"caps":"webgl2","encoding":"affine","influences":4,"row_pitch":"tight",)"
        R"("space":"normalised","texel_format":"rgba16f","texel_order":"bone-major","unused_bones":"keep"},)"
        R"("rate_hz":"keys"})");
}

TEST(CanonicalJson, DependsOnWhatIsBakedAndNotOnHowItIsWritten) {
    const auto canonical = [](std::string_view deer, std::string_view rest = "") {
        return read(std::string(R"({"schema":1,"animals":{"deer":{"model":"d.glb")")
                        .append(deer)
                        .append("}}")
                        .append(rest)
                        .append("}"))
            .animals[0]
            .canonical_json;
    };
    const std::string plain = canonical("");
    EXPECT_EQ(canonical(R"(,"forward":"+z","metres_per_unit":1e0,"rate_hz":"keys")"), plain);
    EXPECT_EQ(canonical(R"(,"rate_hz":30)"), canonical("", R"(,"defaults":{"rate_hz":30.0})"));
    for (const char* change :
         {R"(,"forward":"-z")", R"(,"metres_per_unit":2)", R"(,"rate_hz":30)", R"(,"default_state":"idle")",
          R"(,"keywords":{"idle":[]})", R"(,"clips":["*"])", R"(,"output":{"encoding":"mat4"})"}) {
        EXPECT_NE(canonical(change), plain) << change;
    }
}

// Languages that write 23,976, where this system has them; under any of them the number stays the same.
TEST(ReadCatalog, DoesNotDependOnTheLocale) {
    constexpr std::string_view kText =
        R"({"schema":1,"animals":{"deer":{"model":"d.glb","rate_hz":23.976}},"defaults":{"metres_per_unit":0.0254}})";
    const AnimalEntry expected = read(kText).animals[0];
    ASSERT_EQ(expected.rate_hz, 23.976);
    int tested = 0;
    for (const char* name : {"de_DE.UTF-8", "tr_TR.UTF-8"}) {
        if (std::setlocale(LC_ALL, name) == nullptr) continue;
        ++tested;
        EXPECT_EQ(*std::localeconv()->decimal_point, ',') << name;
        const AnimalEntry animal = read(kText).animals[0];
        EXPECT_EQ(animal.rate_hz, 23.976) << name;
        EXPECT_EQ(animal.canonical_json, expected.canonical_json) << name;
    }
    std::setlocale(LC_ALL, "C");
    if (std::getenv("POSEPACK_EXPECT_LOCALES") == nullptr && tested == 0) {
        GTEST_SKIP() << "the locales de_DE and tr_TR are not installed";
    }
    EXPECT_EQ(tested, 2);
}

TEST(NameOf, NamesEveryValue) {
    EXPECT_EQ(name_of(Encoding::affine), "affine");
    EXPECT_EQ(name_of(TexelFormat::rgba32f), "rgba32f");
    EXPECT_EQ(name_of(TexelOrder::planar), "planar");
    EXPECT_EQ(name_of(RowPitch::align256), "align256");
    EXPECT_EQ(name_of(Caps::desktop), "desktop");
    EXPECT_EQ(name_of(Wrap::ping_pong), "ping-pong");
    EXPECT_EQ(name_of(Seam::open), "open");
    EXPECT_EQ(name_of(ForwardAxis::minus_x), "-x");
}

TEST(Catalog, MinusZeroIsZero) {
    const auto catalog = read_catalog(
        R"({"schema":1,"animals":{"a":{"model":"a.glb","clips":[{"name":"x","speed_mps":-0.0,"stride_phase":-0.0}]}}})");
    ASSERT_TRUE(catalog);
    const ClipWish& wish = catalog.value().animals[0].clips[0];
    EXPECT_FALSE(std::signbit(wish.speed_mps));
    EXPECT_FALSE(std::signbit(wish.stride_phase));
    EXPECT_EQ(catalog.value().animals[0].canonical_json.find("-0"), std::string::npos);
}

}  // namespace
}  // namespace posepack::recipe

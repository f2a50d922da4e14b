// SPDX-License-Identifier: MIT
// Whole catalogs: what is published, what verify says of it, and of what was changed since.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "bake/bake_catalog.hpp"
#include "bake/compare.hpp"
#include "bake/report.hpp"
#include "bake/verify.hpp"
#include "base/interrupt.hpp"
#include "scratch_folder.hpp"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;
using base::read_text;
using base::write_text;

// A folder with two models and their catalog, baked into "out".
class Folder : public testing::Test {
 protected:
    Folder() {
        write_model("tail.glb", support::glb_of(support::tail()));
        support::ModelSpec spec = support::one_bone();
        spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
        write_model("bone.glb", support::glb_of(spec));
        write_text(root() / "catalog.json",
                   R"({"schema":1,"animals":{"tail":{"model":"tail.glb"},"bone":{"model":"bone.glb"}}})");
        source.catalog = root() / "catalog.json";
        options.output = root() / "out";
        options.sync_to_disk = false;
    }

    const std::filesystem::path& root() const { return scratch.path(); }
    std::filesystem::path out(const std::string& name) const { return root() / "out" / name; }

    void write_model(const std::string& name, const support::Bytes& bytes) {
        write_text(root() / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

    BakeOutcome bake() {
        auto outcome = bake_catalog(source, options);
        if (!outcome) throw std::runtime_error(base::format_issue(outcome.issue()));
        return std::move(outcome).value();
    }

    // Codes of what verify finds in the output folder.
    std::vector<IssueCode> found(bool strict = false) {
        const auto outcome = verify(root() / "out", strict);
        EXPECT_TRUE(outcome);
        std::vector<IssueCode> codes;
        if (outcome)
            for (const base::Issue& finding : outcome.value().findings) codes.push_back(finding.code);
        return codes;
    }

    void flip_byte(const std::string& name, std::size_t offset) {
        std::string bytes = read_text(out(name));
        bytes.at(offset) = static_cast<char>(bytes.at(offset) ^ 1);
        write_text(out(name), bytes);
    }

    base::ScratchFolder scratch;
    CatalogSource source;
    BakeOptions options;
};

using Codes = std::vector<IssueCode>;

TEST_F(Folder, BakesAndVerifies) {
    const BakeOutcome outcome = bake();
    ASSERT_EQ(outcome.manifest.records.size(), 2u);
    EXPECT_EQ(outcome.manifest.records[0].id, "bone") << "by id";
    EXPECT_EQ(base::names_in(root() / "out"),
              (std::set<std::string>{"bone.posepack", "manifest.json", "tail.posepack"}));
    const auto verified = verify(root() / "out", true);
    ASSERT_TRUE(verified);
    EXPECT_TRUE(verified.value().findings.empty());
    EXPECT_EQ(verified.value().container_count, 2u);
    EXPECT_EQ(verified.value().byte_count,
              outcome.manifest.records[0].container_bytes + outcome.manifest.records[1].container_bytes);
    const auto one = verify(out("tail.posepack"), false);
    ASSERT_TRUE(one);
    EXPECT_TRUE(one.value().findings.empty());
    EXPECT_EQ(one.value().container_count, 1u);
}

TEST_F(Folder, TwiceAndOnAnyNumberOfThreadsGivesTheSameBytes) {
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    const std::string tail = read_text(out("tail.posepack"));
    for (const unsigned jobs : {1u, 2u, 5u}) {
        options.jobs = jobs;
        bake();
        EXPECT_EQ(read_text(out("manifest.json")), manifest) << jobs;
        EXPECT_EQ(read_text(out("tail.posepack")), tail) << jobs;
    }
}

TEST_F(Folder, VerifyFindsWhatWasChanged) {
    struct Row {
        const char* what;
        std::function<void()> change;
        Codes expected;
    };
    const Row rows[] = {
        {"nothing", [] {}, {}},
        {"a texel", [&] { flip_byte("tail.posepack", 5000); }, {IssueCode::pack_invalid}},
        {"a container cut",
         [&] { std::filesystem::resize_file(out("tail.posepack"), 100); },
         {IssueCode::pack_invalid}},
        {"a container removed",
         [&] { std::filesystem::remove(out("bone.posepack")); },
         {IssueCode::man_missing}},
        {"a good container in another's place",
         [&] {
             std::filesystem::copy_file(out("tail.posepack"), out("bone.posepack"),
                                        std::filesystem::copy_options::overwrite_existing);
         },
         {IssueCode::man_hash}},
        {"a stray container",
         [&] { std::filesystem::copy_file(out("tail.posepack"), out("zebra.posepack")); },
         {IssueCode::warn_stray}},
        {"another stray file", [&] { write_text(out("notes.txt"), "x"); }, {}},
        {"two of them",
         [&] {
             flip_byte("bone.posepack", 40);
             std::filesystem::remove(out("tail.posepack"));
         },
         {IssueCode::pack_invalid, IssueCode::man_missing}},
    };
    for (const Row& row : rows) {
        std::filesystem::remove_all(root() / "out");
        bake();
        row.change();
        EXPECT_EQ(found(), row.expected) << row.what;
    }
}

TEST_F(Folder, StrictMakesAStrayAnError) {
    bake();
    std::filesystem::copy_file(out("tail.posepack"), out("zebra.posepack"));
    EXPECT_EQ(found(true), (Codes{IssueCode::man_stray}));
}

TEST_F(Folder, VerifyOfBrokenManifests) {
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    write_text(out("manifest.json"), manifest.substr(0, manifest.size() / 2));
    const auto cut = verify(root() / "out", false);
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.issue().code, IssueCode::man_json);
    std::filesystem::remove(out("manifest.json"));
    const auto missing = verify(root() / "out", false);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.issue().code, IssueCode::io_open);
    const auto nothing = verify(root() / "nowhere", false);
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.issue().code, IssueCode::io_open);
}

TEST_F(Folder, NewContainersUnderTheOldManifestAreFoundAndMended) {
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    source.overrides.texel_format = recipe::TexelFormat::rgba32f;
    bake();
    write_text(out("manifest.json"), manifest);
    EXPECT_EQ(found(), (Codes{IssueCode::man_hash, IssueCode::man_hash}));
    bake();
    EXPECT_TRUE(found().empty());
}

TEST_F(Folder, AFailurePublishesNothing) {
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    write_model("bone.glb", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    for (const unsigned jobs : {1u, 4u}) {
        options.jobs = jobs;
        const auto outcome = bake_catalog(source, options);
        ASSERT_FALSE(outcome);
        EXPECT_EQ(outcome.issue().code, IssueCode::glb_magic);
        EXPECT_EQ(read_text(out("manifest.json")), manifest);
        EXPECT_EQ(base::names_in(root() / "out").size(), 3u) << "no temporary file is left";
    }
}

TEST_F(Folder, KeepGoingBakesTheRest) {
    write_model("bone.glb", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    options.keep_going = true;
    const BakeOutcome outcome = bake();
    ASSERT_EQ(outcome.manifest.records.size(), 1u);
    EXPECT_EQ(outcome.manifest.records[0].id, "tail");
    ASSERT_EQ(outcome.failures.size(), 1u);
    EXPECT_EQ(outcome.failures[0].code, IssueCode::glb_magic);
    EXPECT_NE(outcome.failures[0].where.find("bone"), std::string::npos);
    EXPECT_TRUE(found().empty());
}

TEST_F(Folder, KeepGoingBakesTheRestWithoutAModel) {
    std::filesystem::remove(root() / "bone.glb");
    options.keep_going = true;
    const BakeOutcome outcome = bake();
    ASSERT_EQ(outcome.failures.size(), 1u);
    EXPECT_EQ(outcome.failures[0].code, IssueCode::io_open);
    ASSERT_EQ(outcome.manifest.records.size(), 1u);
    EXPECT_EQ(outcome.manifest.records[0].id, "tail");
}

TEST_F(Folder, KeepGoingNamesEveryFailureWhereNoneIsLeft) {
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    write_model("bone.glb", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    std::filesystem::remove(root() / "tail.glb");
    options.keep_going = true;
    const BakeOutcome outcome = bake();
    EXPECT_TRUE(outcome.manifest.records.empty());
    ASSERT_EQ(outcome.failures.size(), 2u);
    EXPECT_EQ(outcome.failures[0].code, IssueCode::glb_magic);
    EXPECT_EQ(outcome.failures[1].code, IssueCode::io_open);
    EXPECT_EQ(read_text(out("manifest.json")), manifest);
    EXPECT_EQ(base::names_in(root() / "out").size(), 3u) << "no temporary file is left";
}

TEST_F(Folder, AnInterruptPublishesNothing) {
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    options.animal.measure = false;
    base::request_interrupt();
    const auto outcome = bake_catalog(source, options);
    const auto verified = verify(root() / "out", false);
    base::clear_interrupt();
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.issue().code, IssueCode::interrupted);
    ASSERT_FALSE(verified);
    EXPECT_EQ(verified.issue().code, IssueCode::interrupted);
    EXPECT_EQ(read_text(out("manifest.json")), manifest);
    EXPECT_EQ(base::names_in(root() / "out").size(), 3u) << "no temporary file is left";
}

TEST_F(Folder, TheOrderOfOnlyDoesNotMatter) {
    source.only = {"tail", "bone", "tail"};
    bake();
    const std::string manifest = read_text(out("manifest.json"));
    source.only = {"bone", "tail"};
    bake();
    EXPECT_EQ(read_text(out("manifest.json")), manifest);
}

TEST_F(Folder, OnlySomeOfThem) {
    source.only = {"tail"};
    const BakeOutcome outcome = bake();
    ASSERT_EQ(outcome.manifest.records.size(), 1u);
    EXPECT_EQ(outcome.manifest.records[0].id, "tail");
    source.only = {"tial"};
    const auto unknown = bake_catalog(source, options);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.issue().code, IssueCode::usage);
    EXPECT_NE(unknown.issue().detail.find("'tail'?"), std::string::npos);
}

TEST_F(Folder, MissingModelsAndFoldersAreNamed) {
    std::filesystem::remove(root() / "bone.glb");
    const auto missing = bake_catalog(source, options);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.issue().code, IssueCode::io_open);
    EXPECT_NE(missing.issue().where.find("bone"), std::string::npos);
    source.catalog = root() / "no.json";
    const auto no_catalog = bake_catalog(source, options);
    ASSERT_FALSE(no_catalog);
    EXPECT_EQ(no_catalog.issue().code, IssueCode::io_open);
}

TEST_F(Folder, CompareSumsCopies) {
    const auto one = compare_catalog(source, 1);
    const auto thirty = compare_catalog(source, 30);
    ASSERT_TRUE(one && thirty);
    ASSERT_EQ(one.value().rows.size(), 2u);
    EXPECT_EQ(one.value().rows[0].id, "bone");
    EXPECT_EQ(one.value().total.id, "total");
    EXPECT_EQ(one.value().total.vram.mat4_rgba32f,
              one.value().rows[0].vram.mat4_rgba32f + one.value().rows[1].vram.mat4_rgba32f);
    EXPECT_EQ(thirty.value().total.vram.mat4_rgba32f, 30 * one.value().total.vram.mat4_rgba32f);
    EXPECT_EQ(thirty.value().total.vram.vat_position_rgb32f, 30 * one.value().total.vram.vat_position_rgb32f);
    EXPECT_EQ(thirty.value().rows[1].vertex_count, 12u);
}

TEST_F(Folder, ReportHasARowForEveryFormAndRate) {
    source.only = {"tail"};
    const auto report = report_catalog(source, {{std::nullopt, 10.0}});
    ASSERT_TRUE(report);
    ASSERT_EQ(report.value().animals.size(), 1u);
    const output::AnimalReport& tail = report.value().animals[0];
    EXPECT_EQ(tail.id, "tail");
    ASSERT_EQ(tail.rows.size(), 8u);
    ASSERT_EQ(tail.refused.size(), 4u) << "a tail that stretches has no dual quaternions";
    EXPECT_EQ(tail.refused[0].issue.code, base::IssueCode::lim_similarity);
    EXPECT_EQ(tail.refused[0].form, "dualquat rgba32f");
    std::set<std::string> schemes;
    for (const output::ReportRow& row : tail.rows) {
        schemes.insert(row.form + row.rows);
        EXPECT_TRUE(row.error.measured);
        EXPECT_GT(row.error.max, 0.0f);
        EXPECT_GT(row.decode_ns_per_vertex, 0.0);
        EXPECT_GT(row.fetches, 0u);
        EXPECT_GT(row.alu_operations, 0u);
        EXPECT_GT(row.bake_ms, 0.0);
        EXPECT_GT(row.bytes, 0u);
        EXPECT_EQ(row.is_chosen, row.form == "affine rgba16f" && row.rows == "keys");
    }
    EXPECT_EQ(schemes.size(), 8u);
    EXPECT_EQ(tail.clips.size(), 3u);
    EXPECT_FALSE(tail.heat) << "nobody asked for it";
}

TEST_F(Folder, ReportNamesBonesAndClipsOfTheHeat) {
    source.only = {"tail"};
    const auto report = report_catalog(source, {{10.0}, true});
    ASSERT_TRUE(report);
    const output::AnimalReport& tail = report.value().animals.at(0);
    const output::ReportRow* chosen = chosen_row(tail);
    ASSERT_TRUE(chosen && tail.heat);
    EXPECT_EQ(tail.rows.size(), 5u) << "four forms at 10 Hz, and the catalog's own on the key grids";
    EXPECT_EQ(chosen->rows, "keys");
    ASSERT_EQ(tail.heat->clips.size(), tail.clips.size());
    float largest = 0.0f;
    for (std::size_t c = 0; c < tail.clips.size(); ++c) {
        const output::HeatClip& clip = tail.heat->clips[c];
        EXPECT_EQ(clip.name, tail.clips[c].name);
        ASSERT_EQ(clip.errors.size(), (clip.edges_s.size() - 1) * tail.heat->bones.size());
        const float worst = *std::max_element(clip.errors.begin(), clip.errors.end());
        EXPECT_EQ(worst, tail.clips[c].error.max);
        largest = std::max(largest, worst);
    }
    EXPECT_EQ(largest, chosen->error.max);
    EXPECT_NE(std::find(tail.heat->bones.begin(), tail.heat->bones.end(), chosen->error.bone),
              tail.heat->bones.end());
}

}  // namespace
}  // namespace posepack::bake

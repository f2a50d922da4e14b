// SPDX-License-Identifier: MIT
// The page and its parts: hostile names, marks, classes of error, totals.
#include <gtest/gtest.h>

#include <algorithm>

#include "output/html_text.hpp"
#include "output/report_chart.hpp"
#include "output/report_heat.hpp"
#include "output/report_page.hpp"
#include "output/report_totals.hpp"
#include "output/report_writers.hpp"

namespace posepack::output {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

ReportRow row(const std::string& encoding, const std::string& rows, std::uint64_t bytes, float max) {
    ReportRow out;
    out.encoding = encoding;
    out.texel_format = "rgba16f";
    out.form = encoding + " rgba16f";
    out.rows = rows;
    out.bytes = bytes;
    out.error.max = max;
    out.error.p999 = max / 2;
    out.error.rms = max / 10;
    out.error.clip = "Walk";
    out.error.bone = "spine";
    out.decode_ns_per_vertex = 5.0;
    out.fetches = encoding == "affine" ? 24 : 16;
    out.alu_operations = encoding == "affine" ? 130 : 500;
    out.bake_ms = 2.0;
    return out;
}

Report sample() {
    Report report;
    report.catalog = "herd.json";
    for (const auto& [id, scale] : {std::pair("deer", 1.0f), {"elk", 2.0f}, {"fox", 3.0f}}) {
        AnimalReport animal;
        animal.id = id;
        animal.radius_m = 0.5f;
        animal.rows = {row("affine", "keys", 3000, 0.02f * scale),
                       row("affine", "15 Hz", 1500, 0.09f * scale),
                       row("dualquat", "keys", 2000, 0.01f * scale)};
        animal.rows[0].is_chosen = true;
        recipe::ClipRecord clip;
        clip.name = "Walk";
        animal.clips = {clip};
        animal.heat =
            HeatMap{{"root", "spine"}, {{"Walk", {0.0, 0.5, 1.0}, {0, 1e-5f, 2e-3f, 0.02f * scale}}}};
        report.animals.push_back(std::move(animal));
    }
    return report;
}

TEST(HtmlText, LeavesNothingThatMarkupCouldRead) {
    EXPECT_EQ(html_text("<b>&\"'"), "&lt;b&gt;&amp;&quot;&#39;");
    EXPECT_EQ(html_text("a\x01\x7f\xff"), "a\\x01\\x7f\\xff");
    EXPECT_EQ(html_text("\xE2\x80\xAE"
                        "evil\xE2\x81\xA6"),
              "\\u202eevil\\u2066");
    EXPECT_EQ(html_text("\xEF\xBF\xBE\xEF\xBF\xBF\xEF\xBF\xBD"), "\\ufffe\\uffff\xEF\xBF\xBD");
    EXPECT_EQ(html_text("\xE2\x82\xAC \xE8\xB1\xB9"), "\xE2\x82\xAC \xE8\xB1\xB9") << "other characters stay";
    EXPECT_EQ(html_text("<<<<", 2), "&lt;&lt;...");
}

TEST(ReportHtml, NamesAreEscapedWhereverTheyStand) {
    const std::string evil = "<script>alert('x')</script>\"&";
    Report report = sample();
    report.catalog = evil;
    for (AnimalReport& animal : report.animals) {
        animal.id = evil;
        animal.refused = {{evil, evil, {base::IssueCode::lim_similarity, evil, evil}}};
        for (ReportRow& r : animal.rows) {
            r.form = r.encoding = r.texel_format = r.rows = evil;
            r.error.clip = r.error.mesh = r.error.bone = evil;
        }
        animal.clips[0].name = animal.clips[0].wrap = animal.clips[0].error.bone = evil;
        animal.heat->bones = {evil, evil};
        animal.heat->clips[0].name = evil;
    }
    const std::string page = report_html(report);
    EXPECT_EQ(count_of(page, "<script"), 1u) << "the page's own";
    EXPECT_EQ(count_of(page, "alert('"), 0u);
    EXPECT_GT(count_of(page, "&lt;script&gt;"), 30u);
}

TEST(ReportHtml, IsOnePageOfItsOwn) {
    const std::string page = report_html(sample());
    for (const char* outside :
         {"http://", "https://", "//cdn", "url(", "@import", "<link", "<img", "src=", "fetch("})
        EXPECT_FALSE(holds(page, outside)) << outside;
    EXPECT_TRUE(holds(page, "default-src 'none'"));
    EXPECT_TRUE(holds(page, std::string(report_script())));
    EXPECT_EQ(page, report_html(sample()));
}

TEST(ReportHtml, PolicyNamesTheScriptByItsDigest) {
    // printf '' | openssl dgst -sha256 -binary | base64
    EXPECT_TRUE(holds(content_policy(""), "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='"));
    EXPECT_TRUE(holds(content_policy("abc"), "'sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0='"));
}

TEST(ReportHtml, MarksWhatIsChosen) {
    const std::string page = report_html(sample());
    EXPECT_EQ(count_of(page, "<tr class=\"c\">"), 4u) << "in three tables of forms and in the totals";
    EXPECT_EQ(count_of(page, ">chosen: keys</text>"), 4u * 12u) << "in twelve charts each";
}

TEST(ReportChart, DrawsTheFrontAndEveryPoint) {
    Chart chart;
    chart.cost_unit = AxisUnit::bytes;
    chart.points = {{1000, 0.1, "a", "first", 0, false, false},
                    {2000, 0.05, "b", "second", 1, true, true},
                    {2500, 0.07, "c", "beaten", 2, false, false},
                    {3000, 0.0, "d", "exact", 1, false, false}};
    const std::string svg = chart_svg(chart);
    EXPECT_EQ(count_of(svg, "<title>"), 4u);
    EXPECT_TRUE(holds(svg, "class=\"p s0 f\"><title>first"));
    EXPECT_TRUE(holds(svg, "class=\"p s1 o f\"><title>second"));
    EXPECT_TRUE(holds(svg, "class=\"p s2\"><title>beaten"));
    EXPECT_TRUE(holds(svg, "class=\"p s1 f\"><title>exact"));
    EXPECT_EQ(count_of(svg, "class=\"ch\""), 1u);
    EXPECT_FALSE(holds(svg, "nan"));
    EXPECT_FALSE(holds(svg, "inf"));
    EXPECT_FALSE(holds(chart_svg(Chart{}), "nan")) << "without any point";
}

TEST(ReportHeat, ClassesAreHalfOpen) {
    EXPECT_EQ(heat_class(0.0f), 0u);
    EXPECT_EQ(heat_class(9.99e-5f), 0u);
    for (std::size_t k = 0; k < heat_edges().size(); ++k) EXPECT_EQ(heat_class(heat_edges()[k]), k + 1);
    EXPECT_EQ(heat_class(1e9f), heat_edges().size());
}

TEST(ReportHeat, ShowsTheLargestErrorOfABoneInAClip) {
    const HeatMap heat{{"root", "spine"}, {{"Walk", {0.0, 0.5, 1.0}, {0, 1e-5f, 2e-3f, 0.02f}}}};
    const std::string svg = heat_svg(heat, "deer", 0.5);
    EXPECT_TRUE(holds(svg, "<title>root, Walk: 2.00e-3 R = 1 mm at 0.75 s</title>"));
    EXPECT_TRUE(holds(svg, "<title>spine, Walk: 2.00e-2 R = 10 mm at 0.75 s</title>"));
    EXPECT_EQ(count_of(svg, "<path class=\"h0\""), 1u);
    EXPECT_EQ(count_of(svg, "<path class=\"h" + std::to_string(heat_class(0.02f)) + "\""), 1u);
}

TEST(ReportHeat, DrawsTheBonesThatErrMost) {
    HeatMap heat{{}, {{"Still", {0.0, 0.0}, {}}, {"Walk", {0.0, 1.0}, {}}}};
    for (std::size_t b = 0; b < 200; ++b) {
        heat.bones.push_back("bone" + std::to_string(b) + ".");
        heat.clips[0].errors.push_back(0.0f);
        heat.clips[1].errors.push_back(b % 3 == 1 && b < 190 ? 0.01f : 0.0f);
    }
    const std::string svg = heat_svg(heat, "worm", 1.0);
    EXPECT_EQ(count_of(svg, "class=\"hb\""), kHeatBones);
    EXPECT_EQ(count_of(svg, "<title>"), 63u) << "those with an error";
    EXPECT_FALSE(holds(svg, "nan")) << "a clip may last no time";
}

TEST(ReportHeat, LongNamesKeepBothEnds) {
    const HeatMap heat{{"root"},
                       {{"1H_Melee_Attack_Chop", {0.0, 1.0}, {0.0f}},
                        {"\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9z",
                         {0.0, 1.0},
                         {0.0f}}}};
    const std::string svg = heat_svg(heat, "knight", 1.0);
    EXPECT_TRUE(holds(svg, ">1H_Melee_A...k_Chop<"));
    EXPECT_TRUE(holds(svg, ">\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9...\xC3\xA9\xC3\xA9z<"))
        << "whole characters";
}

TEST(ReportHeat, ManyClipsStandInBands) {
    for (const std::size_t clips : {std::size_t{1}, kHeatClips, kHeatClips + 1, 3 * kHeatClips + 4}) {
        HeatMap heat{{"root", "spine"}, {}};
        for (std::size_t c = 0; c < clips; ++c)
            heat.clips.push_back({"Clip", {0.0, c % 5 == 0 ? 0.0 : 1.0}, {0.0f, 0.01f}});
        const std::string svg = heat_svg(heat, "knight", 1.0);
        EXPECT_EQ(count_of(svg, "class=\"hb\""), 2 * ((clips + kHeatClips - 1) / kHeatClips)) << clips;
        EXPECT_EQ(count_of(svg, "class=\"hf\""), clips);
        EXPECT_FALSE(holds(svg, "h-0.0z") || holds(svg, "h--")) << "every clip has a width";
    }
}

TEST(ReportTotals, SumBytesAndSpreadErrors) {
    Report report = sample();
    report.animals[1].rows.pop_back();
    const std::vector<ReportTotal> totals = report_totals(report);
    ASSERT_EQ(totals.size(), 3u);
    EXPECT_EQ(totals[0].form, "affine rgba16f");
    EXPECT_EQ(totals[0].bytes, 9000u);
    EXPECT_EQ(totals[0].animal_count, 3u);
    EXPECT_TRUE(totals[0].is_chosen);
    EXPECT_FLOAT_EQ(static_cast<float>(totals[0].max.median), 0.04f);
    EXPECT_FLOAT_EQ(static_cast<float>(totals[0].max.worst), 0.06f);
    EXPECT_EQ(totals[0].max.worst_animal, "fox");
    EXPECT_DOUBLE_EQ(totals[0].decode_ns_per_vertex, 5.0);
    EXPECT_EQ(totals[2].animal_count, 2u);
    EXPECT_EQ(totals[2].bytes, 4000u);
    EXPECT_FLOAT_EQ(static_cast<float>(totals[2].max.median), 0.01f) << "the lower of two";
    EXPECT_FALSE(totals[1].is_chosen || totals[2].is_chosen);
}

TEST(ReportTotals, DifferentChoicesAreATotalOfTheirOwn) {
    Report report = sample();
    std::swap(report.animals[2].rows[0].is_chosen, report.animals[2].rows[2].is_chosen);
    const std::vector<ReportTotal> totals = report_totals(report);
    ASSERT_EQ(totals.size(), 4u);
    EXPECT_EQ(totals[3].form, "as chosen");
    EXPECT_TRUE(totals[3].is_chosen);
    EXPECT_FALSE(totals[0].is_chosen || totals[1].is_chosen || totals[2].is_chosen);
    EXPECT_EQ(totals[3].bytes, 8000u);
    EXPECT_NEAR(totals[3].fetches, (24 + 24 + 16) / 3.0, 1e-12);
    EXPECT_TRUE(report_totals(Report{}).empty());
}

TEST(ReportTotals, ComparesOverAnimalsThatHaveTheSame) {
    Report report = sample();
    report.animals[1].rows.pop_back();                            // cannot have what most have
    report.animals[2].rows.push_back(row("mat4", "7 Hz", 9, 1));  // has what no other has
    const ComparableTotals found = comparable_totals(report);
    EXPECT_EQ(found.left_out, std::vector<std::string>{"elk"});
    ASSERT_EQ(found.totals.size(), 3u) << "without the one of a single animal";
    for (const ReportTotal& total : found.totals) EXPECT_EQ(total.animal_count, 2u);
    EXPECT_EQ(found.totals[0].bytes, 6000u);
    EXPECT_TRUE(found.totals[0].is_chosen);
    EXPECT_TRUE(comparable_totals(sample()).left_out.empty());
    EXPECT_TRUE(holds(report_html(report), "Left out: elk."));
}

TEST(ReportWriters, AnEmptyReportIsStillWhole) {
    EXPECT_TRUE(holds(report_html(Report{}), "</html>"));
    EXPECT_TRUE(holds(report_json(Report{}, -1), "\"animals\":[]"));
    EXPECT_TRUE(holds(report_csv(Report{}), "animal,form"));
    EXPECT_TRUE(holds(report_text(Report{}), "animal"));
}

}  // namespace
}  // namespace posepack::output

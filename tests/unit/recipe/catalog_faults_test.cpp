// SPDX-License-Identifier: MIT
// Every way in which a catalog can be wrong, and the code and place it is reported with.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/text.hpp"
#include "recipe/catalog.hpp"

namespace posepack::recipe {
namespace {

using base::IssueCode;

struct Row {
    std::string text;
    IssueCode code;
    std::string where;
};

void expect_faults(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        const base::Result<Catalog> catalog = read_catalog(row.text);
        const std::string shown = base::printable(base::shortened(row.text, 200));
        ASSERT_FALSE(catalog) << shown;
        EXPECT_EQ(base::issue_kind(catalog.issue().code).id, base::issue_kind(row.code).id)
            << shown << "\n"
            << base::format_issue(catalog.issue());
        EXPECT_EQ(catalog.issue().where, row.where) << shown;
        EXPECT_NE(catalog.issue().detail.find("expected"), std::string::npos) << catalog.issue().detail;
        EXPECT_NE(catalog.issue().detail.find("found"), std::string::npos) << catalog.issue().detail;
    }
}

// A catalog of one deer with these further members.
std::string deer(std::string_view members) {
    return std::string(R"({"schema":1,"animals":{"deer":{"model":"d.glb",)").append(members).append("}}}");
}

std::string deer_clip(std::string_view members) {
    return deer(std::string(R"("clips":[{"name":"a",)").append(members).append("}]"));
}

std::string with_model(std::string_view json_string) {
    return std::string(R"({"schema":1,"animals":{"deer":{"model":)").append(json_string).append("}}}");
}

std::string with_id(std::string_view id) {
    return std::string(R"({"schema":1,"animals":{")").append(id).append(R"(":{"model":"d.glb"}}})");
}

std::string with_top(std::string_view members) {
    return std::string(R"({"schema":1,"animals":{"deer":{"model":"d.glb"}},)").append(members).append("}");
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += text;
    return out;
}

TEST(CatalogFaults, AreFoundInTheText) {
    expect_faults({
        {"", IssueCode::cat_json, "line 1, column 1"},
        {"{\n  \"schema\": 1,\n  oops\n}", IssueCode::cat_json, "line 3, column 3"},
        {deer("\"clips\":[\"\xFF\"]"), IssueCode::cat_json, "line 1, column 58"},
        {R"({"schema":1,"animals":{"deer":{"model":"a"},"deer":{"model":"b"}}})", IssueCode::cat_json_dup,
         "line 1, column 45"},
        {repeated("{\"a\":", 65).append("0").append(repeated("}", 65)), IssueCode::lim_json_depth,
         "line 1, column 321"},
        {repeated("[", 200'000), IssueCode::lim_json_depth, "line 1, column 65"},
        {deer("\"rate_hz\":1e999"), IssueCode::cat_range, "line 1, column 58"},
        {std::string(kMaxCatalogBytes + 1, ' '), IssueCode::lim_file, ""},
    });
}

TEST(CatalogFaults, OfTheSchemaNumber) {
    const auto with_schema = [](std::string_view number) {
        return std::string(R"({"animals":{"deer":{"model":"d.glb"}},"schema":)").append(number).append("}");
    };
    expect_faults({
        {R"({"animals":{"deer":{"model":"d.glb"}}})", IssueCode::cat_key, ""},
        {with_schema("2"), IssueCode::cat_version, "/schema"},
        {with_schema("1.5"), IssueCode::cat_version, "/schema"},
        {with_schema("99999999999999999999999"), IssueCode::cat_version, "/schema"},
        {with_schema("0"), IssueCode::cat_value, "/schema"},
        {with_schema("-1"), IssueCode::cat_value, "/schema"},
        {with_schema("\"1\""), IssueCode::cat_type, "/schema"},
        {with_schema("null"), IssueCode::cat_type, "/schema"},
        {R"({"schema":2,"herds":[]})", IssueCode::cat_version, "/schema"},
    });
    EXPECT_TRUE(read_catalog(with_schema("1.0")));
}

TEST(CatalogFaults, OfTheTopLevel) {
    expect_faults({
        {"[]", IssueCode::cat_type, ""},
        {"\"catalog\"", IssueCode::cat_type, ""},
        {R"({"schema":1})", IssueCode::cat_key, ""},
        {R"({"schema":1,"animals":[]})", IssueCode::cat_type, "/animals"},
        {R"({"schema":1,"animals":{}})", IssueCode::cat_value, "/animals"},
        {with_top(R"("animal":{})"), IssueCode::cat_key, ""},
        {with_top(R"("$schema":1)"), IssueCode::cat_type, "/$schema"},
        {with_top(R"("defaults":[])"), IssueCode::cat_type, "/defaults"},
        {with_top(R"("defaults":{"rate":1})"), IssueCode::cat_key, "/defaults"},
        {with_top(R"("defaults":{"rate_hz":0})"), IssueCode::cat_range, "/defaults/rate_hz"},
        {with_top(R"("defaults":{"metres_per_unit":"1"})"), IssueCode::cat_type, "/defaults/metres_per_unit"},
        {with_top(R"("defaults":{"forward":"+y"})"), IssueCode::cat_value, "/defaults/forward"},
        {with_top(R"("defaults":{"output":{"caps":"phone"}})"), IssueCode::cat_value,
         "/defaults/output/caps"},
        {with_top(R"("keywords":["walk"])"), IssueCode::cat_type, "/keywords"},
        {with_top(R"("keywords":{"walk":"walk"})"), IssueCode::cat_type, "/keywords/walk"},
        {with_top(R"("keywords":{"walk":[1]})"), IssueCode::cat_type, "/keywords/walk/0"},
        {with_top(R"("keywords":{"walk":[""]})"), IssueCode::cat_value, "/keywords/walk/0"},
        {with_top(R"("keywords":{"":["walk"]})"), IssueCode::cat_value, "/keywords/"},
        {with_top(R"("keywords":{"a/b~c":1})"), IssueCode::cat_type, "/keywords/a~1b~0c"},
    });
}

TEST(CatalogFaults, OfAnAnimal) {
    expect_faults({
        {R"({"schema":1,"animals":{"deer":"d.glb"}})", IssueCode::cat_type, "/animals/deer"},
        {R"({"schema":1,"animals":{"deer":{}}})", IssueCode::cat_key, "/animals/deer"},
        {deer(R"("clip":[])"), IssueCode::cat_key, "/animals/deer"},
        {deer(R"("rate_hz":"grid")"), IssueCode::cat_value, "/animals/deer/rate_hz"},
        {deer(R"("rate_hz":null)"), IssueCode::cat_type, "/animals/deer/rate_hz"},
        {deer(R"("metres_per_unit":0)"), IssueCode::cat_range, "/animals/deer/metres_per_unit"},
        {deer(R"("metres_per_unit":1000001)"), IssueCode::cat_range, "/animals/deer/metres_per_unit"},
        {deer(R"("forward":"z")"), IssueCode::cat_value, "/animals/deer/forward"},
        {deer(R"("default_state":"")"), IssueCode::cat_value, "/animals/deer/default_state"},
        {deer(R"("keywords":{"walk":[null]})"), IssueCode::cat_type, "/animals/deer/keywords/walk/0"},
        {deer(R"("clips":["idle",{"name":"walk","max_error":"hero"}])"), IssueCode::cat_value,
         "/animals/deer"},
        {deer(R"("clips":[{"name":"walk","max_error":"hero"}],"output":{"encoding":"affine"})"),
         IssueCode::cat_value, "/animals/deer"},
        {deer(R"("output":{"encodings":"mat4"})"), IssueCode::cat_key, "/animals/deer/output"},
        {deer(R"("output":{"encoding":"dual"})"), IssueCode::cat_value, "/animals/deer/output/encoding"},
        {deer(R"("output":{"encoding":1})"), IssueCode::cat_type, "/animals/deer/output/encoding"},
        {deer(R"("output":{"texel_format":"rgba8"})"), IssueCode::cat_value,
         "/animals/deer/output/texel_format"},
        {deer(R"("output":{"texel_order":"bone_major"})"), IssueCode::cat_value,
         "/animals/deer/output/texel_order"},
        {deer(R"("output":{"influences":"8"})"), IssueCode::cat_type, "/animals/deer/output/influences"},
        {deer(R"("output":{"influences":6})"), IssueCode::cat_value, "/animals/deer/output/influences"},
        {deer(R"("output":{"influences":0})"), IssueCode::cat_value, "/animals/deer/output/influences"},
        {deer(R"("output":{"influences":16})"), IssueCode::cat_range, "/animals/deer/output/influences"},
        {deer(R"("output":{"unused_bones":"remove"})"), IssueCode::cat_value,
         "/animals/deer/output/unused_bones"},
        {deer(R"("output":{"row_pitch":"256"})"), IssueCode::cat_value, "/animals/deer/output/row_pitch"},
    });
}

TEST(CatalogFaults, OfAClip) {
    expect_faults({
        {deer(R"("clips":"walk")"), IssueCode::cat_type, "/animals/deer/clips"},
        {deer(R"("clips":[])"), IssueCode::cat_value, "/animals/deer/clips"},
        {deer(R"("clips":[1])"), IssueCode::cat_type, "/animals/deer/clips/0"},
        {deer(R"("clips":["a",""])"), IssueCode::cat_value, "/animals/deer/clips/1"},
        {deer(R"("clips":["a\u0007"])"), IssueCode::cat_value, "/animals/deer/clips/0"},
        {deer(R"("clips":[{"wrap":"loop"}])"), IssueCode::cat_key, "/animals/deer/clips/0"},
        {deer(std::string("\"clips\":[\"").append(256, 'a').append("\"]")), IssueCode::lim_string,
         "/animals/deer/clips/0"},
        {deer_clip(R"("speed":1)"), IssueCode::cat_key, "/animals/deer/clips/0"},
        {deer_clip(R"("states":"walk")"), IssueCode::cat_type, "/animals/deer/clips/0/states"},
        {deer_clip(R"("states":["walk","walk"])"), IssueCode::cat_value, "/animals/deer/clips/0"},
        {deer(R"("clips":[{"name":"a","states":["s"]},{"name":"b","states":["s"]}])"), IssueCode::cat_value,
         "/animals/deer/clips/1"},
        {deer_clip(R"("wrap":"pingpong")"), IssueCode::cat_value, "/animals/deer/clips/0/wrap"},
        {deer_clip(R"("seam":"shut")"), IssueCode::cat_value, "/animals/deer/clips/0/seam"},
        {deer_clip(R"("speed_mps":-1)"), IssueCode::cat_range, "/animals/deer/clips/0/speed_mps"},
        {deer_clip(R"("speed_mps":1000.5)"), IssueCode::cat_range, "/animals/deer/clips/0/speed_mps"},
        {deer_clip(R"("stride_phase":1)"), IssueCode::cat_range, "/animals/deer/clips/0/stride_phase"},
        {deer_clip(R"("stride_phase":-0.1)"), IssueCode::cat_range, "/animals/deer/clips/0/stride_phase"},
    });
}

TEST(CatalogFaults, OfRates) {
    for (const char* rate : {"0", "-30", "1e9", "0.999", "1000.1"}) {
        const std::string member = std::string("\"rate_hz\":") + rate;
        expect_faults({{deer(member), IssueCode::cat_range, "/animals/deer/rate_hz"},
                       {deer_clip(member), IssueCode::cat_range, "/animals/deer/clips/0/rate_hz"}});
    }
    for (const char* rate : {"1", "23.976", "1000"}) {
        EXPECT_TRUE(read_catalog(deer(std::string("\"rate_hz\":") + rate))) << rate;
    }
    EXPECT_EQ(read_catalog(deer("\"rate_hz\":0")).issue().detail,
              "expected a number from 1 to 1000, found 0");
}

TEST(CatalogFaults, OfModelPaths) {
    for (const char* path :
         {R"("../outside/deer.glb")", R"("/m/deer.glb")", R"("C:\\m\\deer.glb")", R"("\\\\srv\\m\\deer.glb")",
          R"("C:deer.glb")", R"("")", R"("a//b.glb")", R"("./a.glb")", R"("a/../b.glb")", R"("a/")",
          R"("a\u0000b.glb")", R"("a\nb.glb")", R"("aux/deer.glb")"}) {
        expect_faults({{with_model(path), IssueCode::cat_path, "/animals/deer/model"}});
    }
    expect_faults({{with_model(std::string("\"").append(1025, 'a').append("\"")), IssueCode::cat_path,
                    "/animals/deer/model"},
                   {with_model("1"), IssueCode::cat_type, "/animals/deer/model"}});
}

TEST(CatalogFaults, OfIds) {
    for (const std::string& id :
         {std::string("CON"), std::string("aux.x"), std::string("deer."), std::string("deer "), std::string(),
          std::string("-deer"), std::string("lpt9"), std::string("d\xC3\xA4r"), std::string(65, 'a')}) {
        expect_faults({{with_id(id), IssueCode::cat_id, std::string("/animals/").append(id)}});
    }
    expect_faults({{with_id("d/e"), IssueCode::cat_id, "/animals/d~1e"},
                   {R"({"schema":1,"animals":{"Deer":{"model":"a"},"deer":{"model":"b"}}})",
                    IssueCode::cat_id, "/animals/deer"}});
}

TEST(CatalogFaults, OfTheNumberOfAnimals) {
    const auto with_count = [](std::size_t count) {
        std::string text = R"({"schema":1,"animals":{"a":{"model":"m"})";
        for (std::size_t i = 1; i < count; ++i)
            text.append(",\"").append(std::to_string(i)).append("\":{\"model\":\"m\"}");
        return text.append("}}");
    };
    expect_faults({{with_count(kMaxAnimals + 1), IssueCode::lim_entries, "/animals"}});
    const base::Result<Catalog> most = read_catalog(with_count(kMaxAnimals));
    ASSERT_TRUE(most);
    EXPECT_EQ(most.value().animals.size(), kMaxAnimals);
}

TEST(CatalogFaults, SuggestTheNearestKey) {
    const base::Result<Catalog> catalog = read_catalog(deer(R"("defaultstate":"idle")"));
    ASSERT_FALSE(catalog);
    EXPECT_EQ(catalog.issue().detail,
              "expected a known key, found 'defaultstate'; did you mean 'default_state'?");
}

TEST(CatalogFaults, ListTheAllowedValues) {
    const base::Result<Catalog> catalog = read_catalog(deer_clip(R"("wrap":"bounce")"));
    ASSERT_FALSE(catalog);
    EXPECT_EQ(catalog.issue().detail, "expected one of auto, loop, once, ping-pong, found \"bounce\"");
}

TEST(CatalogFaults, AreFoundInEveryTruncation) {
    const std::string text = deer(R"("clips":["a",{"name":"b","rate_hz":30}],"output":{"encoding":"mat4"})");
    ASSERT_TRUE(read_catalog(text));
    for (std::size_t size = 0; size < text.size(); ++size) {
        const base::Result<Catalog> catalog = read_catalog(text.substr(0, size));
        ASSERT_FALSE(catalog) << size;
        EXPECT_EQ(catalog.issue().code, IssueCode::cat_json) << size;
    }
}

}  // namespace
}  // namespace posepack::recipe

// SPDX-License-Identifier: MIT
// The compiler must accept and refuse the catalogs of tests/schemas/catalog_cases.json as that table says;
// the schema is held to the same table.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "recipe/catalog.hpp"

namespace posepack::recipe {
namespace {

TEST(CatalogCases, AreReadAsTheTableSays) {
    std::ifstream file(POSEPACK_CATALOG_CASES);
    const nlohmann::json cases = nlohmann::json::parse(file);
    ASSERT_GT(cases.size(), 100u);
    for (const nlohmann::json& row : cases) {
        const base::Result<Catalog> catalog = read_catalog(row["catalog"].dump());
        EXPECT_EQ(static_cast<bool>(catalog), row["valid"].get<bool>())
            << row["name"] << ": "
            << (catalog ? std::string("accepted") : base::format_issue(catalog.issue()));
    }
}

}  // namespace
}  // namespace posepack::recipe

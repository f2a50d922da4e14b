// SPDX-License-Identifier: MIT
// What each means of the chooser is worth: the bytes of a catalog under a bound with all of them, and with
// one taken out at a time.
//
//     posepack_worth CATALOG MODELS [BOUND]
//
// docs/choice.md quotes the table.
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "bake/bake_catalog.hpp"
#include "bake/workers.hpp"
#include "recipe/bound.hpp"

namespace {

using namespace posepack;

struct Case {
    const char* name;
    choose::Means means;
};

std::vector<Case> cases() {
    std::vector<Case> all{{"all", {}},
                          {"no dual quaternions", {}},
                          {"no slots", {}},
                          {"no rows of bones' own", {}},
                          {"no sharing", {}},
                          {"no least squares", {}},
                          {"rows of bones' own, and no slots, sharing or least squares", {}},
                          {"none of them", {}}};
    all[1].means.dual_quaternions = false;
    all[2].means.slots = false;
    all[3].means.rows.own_rows = false;
    all[4].means.rows.sharing = false;
    all[5].means.rows.least_squares = false;
    all[6].means = {true, false, {true, false, false}};
    all[7].means = {false, false, {false, false, false}};
    return all;
}

struct Sum {
    std::uint64_t bytes = 0;
    int refused = 0, floats = 0;
};

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count < 3 || argument_count > 4) {
        std::fprintf(stderr, "usage: posepack_worth CATALOG MODELS [BOUND]\n");
        return 1;
    }
    const char* bound_text = argument_count == 4 ? arguments[3] : "default";
    const auto bound = recipe::parse_error_bound(bound_text);
    bake::CatalogSource source;
    source.catalog = arguments[1];
    source.models = arguments[2];
    const auto file = bake::open_catalog(source);
    if (!bound || !file) {
        fmt::print(stderr, "{}\n", file ? "expected a bound" : base::format_issue(file.issue()));
        return 1;
    }
    const auto& animals = file.value().catalog.animals;
    double whole = 0.0;
    fmt::print(
        "bound {}, {} animals\n\n| taken out | bytes | times | refused | in floats "
        "|\n|---|--:|--:|--:|--:|\n",
        bound_text, animals.size());
    for (const Case& one : cases()) {
        std::vector<Sum> sums(animals.size());
        bake::run_jobs(animals.size(), 2, [&](std::size_t i) {
            recipe::AnimalEntry entry = animals[i];
            entry.output.bound = bound;
            const auto glb = bake::read_model(file.value(), entry);
            if (!glb) return false;
            bake::AnimalOptions options;
            options.means = one.means;
            const auto baked = bake::bake_animal(entry, glb.value(), options);
            if (!baked) {
                sums[i].refused = 1;
                return true;
            }
            const recipe::BakeRecord& record = baked.value().record;
            sums[i].bytes = record.texel_bytes + record.row_table_bytes;
            sums[i].floats = record.texel_format == "rgba32f" ? 1 : 0;
            return true;
        });
        Sum total;
        for (const Sum& sum : sums) {
            total.bytes += sum.bytes;
            total.refused += sum.refused;
            total.floats += sum.floats;
        }
        if (whole == 0.0) whole = static_cast<double>(total.bytes);
        fmt::print("| {} | {} | {:.2f} | {} | {} |\n", one.name, total.bytes,
                   static_cast<double>(total.bytes) / whole, total.refused, total.floats);
        std::fflush(stdout);
    }
    return 0;
}

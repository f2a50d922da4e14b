// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "menagerie/catalog_text.hpp"
#include "menagerie/glb_writer.hpp"
#include "menagerie/menagerie.hpp"
#include "menagerie/statistics.hpp"

namespace posepack::cli {
namespace {

constexpr std::size_t kMostAnimals = 3000;

struct Options {
    std::string folder;
    std::vector<std::string> only;
    std::optional<std::size_t> animals;
    std::optional<std::uint64_t> seed;
    bool statistics = false;
    bool birds = false;
    bool toy = false;
};

base::Status check_ids(const Options& options) {
    std::vector<std::string> known;
    if (options.toy)
        known = {"toy"};
    else if (options.birds)
        known.assign(menagerie::birds().begin(), menagerie::birds().end());
    else
        for (const auto& animal : menagerie::animals()) known.emplace_back(animal.id);
    for (const std::string& id : options.only)
        if (std::find(known.begin(), known.end(), id) == known.end())
            return base::Issue{base::IssueCode::usage, "--only",
                               fmt::format("expected one of {}, found '{}'", fmt::join(known, ", "), id)};
    return {};
}

// The members that --birds, --animals, --seed and --only ask for.
std::vector<menagerie::HerdMember> members_of(const Options& options) {
    std::vector<menagerie::HerdMember> members;
    if (options.toy)
        members.push_back({"toy", "toy", 0});
    else if (options.birds)
        for (const std::string_view id : menagerie::birds()) members.push_back({std::string(id), id, 0});
    else
        members =
            menagerie::herd(options.animals.value_or(menagerie::animals().size()), options.seed.value_or(1));
    if (!options.only.empty())
        std::erase_if(members, [&options](const menagerie::HerdMember& member) {
            return std::find(options.only.begin(), options.only.end(), member.kind) == options.only.end();
        });
    return members;
}

void print_statistics_head() {
    fmt::print("{:<16} {:>6} {:>5} {:>5} {:>8} {:>5} {:>10} {:>10} {:>9} {:>8} {:>4} {:>17}\n", "animal",
               "joints", "roots", "depth", "vertices", "clips", "influences", "weightless", "constant",
               "JSON", "Hz", "step p50/p99/max");
}

// glTF 2.0, section 4.4: the length of the JSON chunk stands behind the file header.
std::size_t json_chunk_bytes(const std::vector<std::uint8_t>& glb) {
    std::size_t size = 0;
    for (std::size_t byte = 4; byte-- > 0;) size = size << 8 | glb[12 + byte];
    return size;
}

void print_statistics(const std::string& id, const menagerie::Statistics& s) {
    fmt::print(
        "{:<16} {:>6} {:>5} {:>5} {:>8} {:>5} {:>10.2f} {:>8.1f} % {:>7.0f} % {:>8} {:>4} {:>17}\n", id,
        s.joints, s.root_joints, s.depth, s.vertices, s.clips, s.mean_influences, 100.0 * s.weightless_share,
        100.0 * s.constant_channel_share, base::grouped(s.json_bytes), s.rate_hz,
        fmt::format("{:.1f}/{:.0f}/{:.0f}", s.step_p50_degrees, s.step_p99_degrees, s.step_max_degrees));
}

void print_real_ranges() {
    fmt::print("\nnine four-legged animals made by hand, least to greatest:\n");
    for (const menagerie::RealRange& row : menagerie::real_ranges())
        fmt::print("  {:<24} {:>9} to {}\n", row.name, row.least, row.greatest);
}

int write_catalog(const Options& options, const std::vector<menagerie::CatalogAnimal>& animals) {
    const std::string text = menagerie::catalog_text(animals, "");
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    if (const auto status = base::write_file(std::filesystem::path(options.folder) / "catalog.json", bytes);
        !status)
        return fail(status.issue());
    fmt::print("wrote catalog.json, which names them\n");
    return 0;
}

menagerie::Model model_of(const Options& options, const menagerie::HerdMember& member) {
    if (options.toy) return menagerie::build_toy();
    return options.birds ? *menagerie::build_bird(member.kind)
                         : *menagerie::build_model(member.kind, member.seed);
}

int write_members(const Options& options) {
    const auto members = members_of(options);
    std::vector<menagerie::CatalogAnimal> catalog;
    if (options.statistics) print_statistics_head();
    for (const menagerie::HerdMember& member : members) {
        if (const auto status = base::check_interrupt(); !status) return fail(status.issue());
        const menagerie::Model model = model_of(options, member);
        const auto glb = menagerie::write_glb(model);
        const std::string file_name = member.id + ".glb";
        if (const auto status = base::write_file(std::filesystem::path(options.folder) / file_name, glb);
            !status)
            return fail(status.issue());
        if (options.statistics)
            print_statistics(member.id, menagerie::statistics_of(model, json_chunk_bytes(glb)));
        else
            fmt::print("{:<16} {:>9} bytes\n", file_name, base::grouped(glb.size()));
        if (options.animals || options.birds || options.toy)
            catalog.push_back(menagerie::catalog_animal(member.id, model));
    }
    if (options.statistics) print_real_ranges();
    fmt::print("wrote {} into {}\n", base::counted(members.size(), "animal"), options.folder);
    // A catalog without animals is none.
    return catalog.empty() ? 0 : write_catalog(options, catalog);
}

int run(const Options& options) {
    if (options.seed && !options.animals)
        return fail({base::IssueCode::usage, "--seed",
                     "expected --animals with it, whose others it chooses, found none"});
    if (const auto status = check_ids(options); !status) return fail(status.issue());
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error)
        return fail({base::IssueCode::io_write, options.folder,
                     "expected a folder that can be made, found: " + error.message()});
    return write_members(options);
}

}  // namespace

Runner add_menagerie(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("folder", options->folder, "Folder for the GLB files")->required()->type_name("DIR");
    app.add_option("--only", options->only, "Only these animals (ids, comma-separated)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("ID");
    auto* herd =
        app.add_option("--animals", options->animals,
                       "This many: behind the published ones others of each kind, and a catalog.json for all")
            ->check(whole_between(1, kMostAnimals))
            ->type_name("N");
    app.add_option("--seed", options->seed, "Which others --animals makes; default 1")
        ->check(whole_between(0, std::numeric_limits<std::uint64_t>::max()))
        ->type_name("S");
    auto* birds = app.add_flag("--birds", options->birds,
                               "Instead the 25 birds of the second catalog, with a catalog.json")
                      ->excludes(herd);
    app.add_flag("--toy", options->toy, "Instead a toy horse without a skin, with a catalog.json")
        ->excludes(herd)
        ->excludes(birds);
    app.add_flag("--statistics", options->statistics,
                 "Print how messy each animal is, and real animals for comparison");
    return [options] { return run(*options); };
}

}  // namespace posepack::cli

// SPDX-License-Identifier: MIT
#include "bake/bake_catalog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <set>

#include "animal/read_animal.hpp"
#include "bake/workers.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "posepack/format.h"

namespace posepack::bake {
namespace {

using base::Issue;
using base::IssueCode;

std::string_view as_text(const base::Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

base::Status keep_only(recipe::Catalog& catalog, const std::vector<std::string>& ids) {
    if (ids.empty()) return {};
    std::vector<recipe::AnimalEntry> kept;
    std::vector<std::string> known;
    for (const recipe::AnimalEntry& entry : catalog.animals) known.push_back(entry.id);
    for (const std::string& id : ids)
        if (std::find(known.begin(), known.end(), id) == known.end()) {
            const std::string near = base::nearest(id, known);
            return Issue{IssueCode::usage, "--only",
                         fmt::format("expected ids of the catalog, found '{}'{}", id,
                                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near))};
        }
    for (recipe::AnimalEntry& entry : catalog.animals)
        if (std::find(ids.begin(), ids.end(), entry.id) != ids.end()) kept.push_back(std::move(entry));
    catalog.animals = std::move(kept);
    return {};
}

// The options of the run that shape the bytes or the records, for the manifest.
std::string options_text(const CatalogSource& source, const AnimalOptions& options) {
    nlohmann::json json = nlohmann::json::object();
    const recipe::OutputOverrides& o = source.overrides;
    if (o.encoding) json["encoding"] = name_of(*o.encoding);
    if (o.space) json["space"] = name_of(*o.space);
    if (o.texel_format) json["texel_format"] = name_of(*o.texel_format);
    if (o.texel_order) json["texel_order"] = name_of(*o.texel_order);
    if (o.row_pitch) json["row_pitch"] = name_of(*o.row_pitch);
    if (o.influences) json["influences"] = *o.influences;
    if (o.unused_bones) json["unused_bones"] = name_of(*o.unused_bones);
    if (o.bound) json["bound"] = nlohmann::json::parse(bound_json(*o.bound));
    if (o.caps) json["caps"] = name_of(*o.caps);
    if (source.rate_hz) json["rate_hz"] = *source.rate_hz;
    // In one order, each once: what is asked for does not depend on how.
    if (!source.only.empty()) json["only"] = std::set<std::string>(source.only.begin(), source.only.end());
    if (options.strict) json["strict"] = true;
    if (options.allow_data_uris) json["allow_data_uris"] = true;
    if (!options.measure) json["measure"] = false;
    if (options.compare_vat) json["compare_vat"] = true;
    return json.dump();
}

// The outcome of one animal, kept small: the container is on disk by then.
struct Slot {
    recipe::BakeRecord record;
    BakedSummary times;
    std::vector<Issue> findings;
    std::optional<Issue> failure;
    bool done = false;
    bool is_environment = false;  // the failure is the output folder's: nothing after it would fare better
};

class CatalogBaker {
 public:
    CatalogBaker(const CatalogFile& file, const BakeOptions& options, base::OutputFolder& folder)
        : file_(file), options_(options), folder_(folder), slots_(file.catalog.animals.size()) {}

    std::vector<Slot> run() {
        run_jobs(slots_.size(), options_.jobs, [&](std::size_t i) {
            bake_one(i);
            return !slots_[i].failure || (options_.keep_going && !slots_[i].is_environment);
        });
        return std::move(slots_);
    }

 private:
    void bake_one(std::size_t index) {
        const recipe::AnimalEntry& entry = file_.catalog.animals[index];
        Slot& slot = slots_[index];
        slot.done = true;
        const auto glb = read_model(file_, entry);
        if (!glb) {
            slot.failure = glb.issue();
            return;
        }
        auto baked = bake_animal(entry, glb.value(), options_.animal);
        if (!baked) {
            slot.failure = baked.issue();
            return;
        }
        if (auto status = folder_.stage(baked.value().record.container, baked.value().container); !status) {
            slot.failure = status.issue();
            slot.is_environment = true;
            return;
        }
        slot.record = std::move(baked.value().record);
        slot.findings = std::move(baked.value().findings);
        slot.times = {entry.id, baked.value().bake_s, baked.value().measure_s};
    }

    const CatalogFile& file_;
    const BakeOptions& options_;
    base::OutputFolder& folder_;
    std::vector<Slot> slots_;
};

}  // namespace

base::Result<CatalogFile> open_catalog(const CatalogSource& source) {
    const auto bytes = base::read_file(source.catalog, recipe::kMaxCatalogBytes);
    if (!bytes) return bytes.issue();
    auto catalog = recipe::read_catalog(as_text(bytes.value()), source.overrides, source.rate_hz);
    if (!catalog) return base::at(source.catalog.filename().string(), catalog.issue());
    CatalogFile file{std::move(catalog).value(), source.models,
                     base::hexadecimal(base::sha256(bytes.value()))};
    if (file.models.empty())
        file.models = source.catalog.has_parent_path() ? source.catalog.parent_path() : ".";
    if (auto status = keep_only(file.catalog, source.only); !status) return status.issue();
    return file;
}

base::Result<base::Bytes> read_model(const CatalogFile& file, const recipe::AnimalEntry& entry) {
    const auto path = base::resolve_below(file.models, entry.model);
    if (!path) return base::at(entry.id, path.issue());
    auto bytes = base::read_file(path.value(), animal::kMaxGlbBytes);
    if (!bytes) return base::at(entry.id, bytes.issue());
    return bytes;
}

base::Result<BakeOutcome> bake_catalog(const CatalogSource& source, const BakeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const auto file = open_catalog(source);
    if (!file) return file.issue();
    // Opened before anything is baked: a folder that cannot be written is told at once.
    auto folder = base::OutputFolder::open(options.output, options.lock_timeout_s, options.sync_to_disk);
    if (!folder) return folder.issue();

    std::vector<Slot> slots = CatalogBaker(file.value(), options, folder.value()).run();
    if (auto status = base::check_interrupt(); !status) return status.issue();
    BakeOutcome outcome;
    for (Slot& slot : slots) {
        if (!slot.done) continue;
        if (slot.failure) {
            if (!options.keep_going || slot.is_environment) return *slot.failure;
            outcome.failures.push_back(std::move(*slot.failure));
            continue;
        }
        outcome.findings.insert(outcome.findings.end(), slot.findings.begin(), slot.findings.end());
        outcome.times.push_back(slot.times);
        outcome.manifest.records.push_back(std::move(slot.record));
    }
    if (outcome.manifest.records.empty()) return outcome;  // nothing to publish

    outcome.manifest.bake_abi = POSEPACK_BAKE_ABI;
    outcome.manifest.tool_version = POSEPACK_VERSION;
    outcome.manifest.catalog_sha256 = file.value().sha256;
    outcome.manifest.options_json = options_text(source, options.animal);
    const std::string text = write_manifest(outcome.manifest);
    const std::string manifest_name(recipe::kManifestName);
    if (auto status = folder.value().stage(manifest_name,
                                           {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        !status)
        return status.issue();
    if (auto status = folder.value().publish(manifest_name); !status) return status.issue();
    outcome.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

}  // namespace posepack::bake

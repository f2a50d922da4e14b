// SPDX-License-Identifier: MIT
#include "bake/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "bake/check_record.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/sha256.hpp"
#include "posepack/loader.h"
#include "recipe/manifest.hpp"

namespace posepack::bake {
namespace {

using base::Issue;
using base::IssueCode;

// The recipe text travels in the container; its digest stands in the header.
base::Status check_provenance(const posepack_view& view, const std::string& where) {
    const void* data = nullptr;
    std::size_t size = 0;
    if (posepack_get_section(&view, POSEPACK_SECTION_PROV, &data, &size) != POSEPACK_OK) return {};
    const base::Sha256 digest = base::sha256({static_cast<const std::uint8_t*>(data), size});
    if (std::memcmp(digest.data(), view.header.recipe_sha256, digest.size()) == 0) return {};
    return Issue{IssueCode::pack_invalid, where,
                 "expected the digest of the stored recipe in the header, found another"};
}

base::Status check_container(const base::Bytes& bytes, const std::string& where, posepack_view& view) {
    const posepack_result result = posepack_open(&view, bytes.data(), bytes.size());
    if (result != POSEPACK_OK)
        return Issue{IssueCode::pack_invalid, where,
                     fmt::format("expected a container of format {}.{}, found that the loader answers {}",
                                 POSEPACK_FORMAT_MAJOR, POSEPACK_FORMAT_MINOR, posepack_result_name(result))};
    return check_provenance(view, where);
}

void check_listed(const std::filesystem::path& folder, const recipe::BakeRecord& record,
                  std::uint32_t bake_abi, VerifyOutcome& outcome) {
    const std::filesystem::path path = folder / record.container;
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        outcome.findings.push_back(
            {IssueCode::man_missing, record.container, "expected the container, found no such file"});
        return;
    }
    const auto bytes = base::read_file(path, POSEPACK_MAX_FILE_BYTES);
    if (!bytes) {
        outcome.findings.push_back(bytes.issue());
        return;
    }
    ++outcome.container_count;
    outcome.byte_count += bytes.value().size();
    const std::string digest = base::hexadecimal(base::sha256(bytes.value()));
    posepack_view view;
    const base::Status sound = check_container(bytes.value(), record.container, view);
    if (!sound) {
        outcome.findings.push_back(sound.issue());
    } else if (digest != record.container_sha256) {
        outcome.findings.push_back(
            {IssueCode::man_hash, record.container,
             fmt::format("expected SHA-256 {}, found {}", record.container_sha256, digest)});
    } else {
        const std::vector<Issue> fields = check_record(record, bake_abi, bytes.value(), view);
        outcome.findings.insert(outcome.findings.end(), fields.begin(), fields.end());
    }
}

void check_strays(const std::filesystem::path& folder, const recipe::Manifest& manifest, bool strict,
                  VerifyOutcome& outcome) {
    std::set<std::string> listed, stray;
    for (const recipe::BakeRecord& record : manifest.records) listed.insert(record.container);
    std::error_code error;
    for (const auto& item : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = item.path().filename().string();
        if (item.path().extension() == ".posepack" && name.front() != '.' && !listed.contains(name))
            stray.insert(name);
    }
    for (const std::string& name : stray)
        outcome.findings.push_back(
            {strict ? IssueCode::man_stray : IssueCode::warn_stray, name,
             "expected every container in the manifest, found one that it does not list"});
}

base::Result<VerifyOutcome> verify_folder(const std::filesystem::path& folder, bool strict) {
    const auto bytes = base::read_file(folder / recipe::kManifestName, recipe::kMaxManifestBytes);
    if (!bytes) return bytes.issue();
    const auto manifest =
        recipe::read_manifest({reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size()});
    if (!manifest) return base::at(std::string(recipe::kManifestName), manifest.issue());
    VerifyOutcome outcome;
    for (const recipe::BakeRecord& record : manifest.value().records) {
        if (auto status = base::check_interrupt(); !status) return status.issue();
        check_listed(folder, record, manifest.value().bake_abi, outcome);
    }
    check_strays(folder, manifest.value(), strict, outcome);
    return outcome;
}

}  // namespace

base::Result<VerifyOutcome> verify(const std::filesystem::path& path, bool strict) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return verify_folder(path, strict);
    const auto bytes = base::read_file(path, POSEPACK_MAX_FILE_BYTES);
    if (!bytes) return bytes.issue();
    VerifyOutcome outcome{1, bytes.value().size(), {}};
    posepack_view view;
    if (auto status = check_container(bytes.value(), path.filename().string(), view); !status)
        outcome.findings.push_back(status.issue());
    return outcome;
}

}  // namespace posepack::bake

// SPDX-License-Identifier: MIT
#include "bake/compare.hpp"

#include <optional>

#include "bake/records.hpp"
#include "bake/workers.hpp"
#include "base/interrupt.hpp"

namespace posepack::bake {
namespace {

void add(recipe::VramRecord& sum, const recipe::VramRecord& vram, std::uint64_t copies) {
    sum.mat4_rgba32f += vram.mat4_rgba32f * copies;
    sum.mat4_rgba16f += vram.mat4_rgba16f * copies;
    sum.affine_rgba32f += vram.affine_rgba32f * copies;
    sum.affine_rgba16f += vram.affine_rgba16f * copies;
    sum.dualquat_rgba16f += vram.dualquat_rgba16f * copies;
    sum.vat_position_rgb32f += vram.vat_position_rgb32f * copies;
    sum.vat_rgba32f += vram.vat_rgba32f * copies;
    sum.vat_rgba16f += vram.vat_rgba16f * copies;
}

}  // namespace

base::Result<Comparison> compare_catalog(const CatalogSource& source, std::uint32_t copies) {
    const auto file = open_catalog(source);
    if (!file) return file.issue();
    const auto& animals = file.value().catalog.animals;
    std::vector<CompareRow> rows(animals.size());
    std::vector<std::optional<base::Issue>> failures(animals.size());
    run_jobs(animals.size(), 0, [&](std::size_t i) {
        const auto glb = read_model(file.value(), animals[i]);
        if (!glb) return failures[i] = glb.issue(), false;
        AnimalOptions options;
        options.measure = false;
        recipe::AnimalEntry entry = animals[i];
        entry.output.bound.reset();  // forms are compared at the same rows
        const auto baked = bake_animal(entry, glb.value(), options);
        if (!baked) return failures[i] = baked.issue(), false;
        const recipe::BakeRecord& record = baked.value().record;
        rows[i] = {record.id, record.bone_count, record.row_count, record.vertex_count, {}};
        add(rows[i].vram, vram_of(record.row_count, record.bone_count, record.vertex_count), copies);
        return true;
    });
    if (auto status = base::check_interrupt(); !status) return status.issue();
    for (const auto& failure : failures)
        if (failure) return *failure;
    Comparison comparison{std::move(rows), {}};
    comparison.total.id = "total";
    for (const CompareRow& row : comparison.rows) {
        comparison.total.bone_count += row.bone_count * copies;
        comparison.total.row_count += row.row_count * copies;
        comparison.total.vertex_count += row.vertex_count * copies;
        add(comparison.total.vram, row.vram, 1);
    }
    return comparison;
}

}  // namespace posepack::bake

// SPDX-License-Identifier: MIT
#include "creases/sheet_parts.h"

#include "curves/mesh_topology.h"

namespace hrbfnpr::curves {
namespace {

// The triangles of each sheet: those of sheet s are order[begin[s]] to order[begin[s + 1]].
struct BySheet {
    BySheet(base::Memory& memory, const SharpMesh& mesh, std::int32_t sheets)
        : begin(memory, sheets + 2), order(memory, mesh.sheet.size()) {
        for (const std::int32_t sheet : mesh.sheet) ++begin[sheet + 2];
        for (std::int64_t s = 2; s < begin.size(); ++s) begin[s] += begin[s - 1];
        for (std::int64_t t = 0; t < mesh.sheet.size(); ++t) order[begin[mesh.sheet[t] + 1]++] = t;
    }
    base::Array<std::int64_t> begin, order;
};

} // namespace

base::List<std::unique_ptr<SheetPart>> sheet_parts(const base::Runtime& runtime, const implicit::Implicit& whole,
                                                   const SharpMesh& mesh) {
    base::List<std::unique_ptr<SheetPart>> parts(runtime.memory);
    const implicit::Sheets* const all = whole.sheets();
    if (all == nullptr) return parts;
    const std::int32_t sheets = all->count();
    const BySheet by(runtime.memory, mesh, sheets);
    base::Array<std::int32_t> number(runtime.memory, mesh.mesh.vertices()); // in its part, and 1
    geometry::VecArray creases(runtime.memory);
    for (std::int32_t sheet = 0; sheet < sheets; ++sheet) {
        if (by.begin[sheet] == by.begin[sheet + 1]) continue;
        SheetPart& part = *parts.add(std::make_unique<SheetPart>(runtime.memory, whole, *all, sheet));
        base::Array<std::int32_t> used(runtime.memory);
        for (std::int64_t k = by.begin[sheet]; k < by.begin[sheet + 1]; ++k)
            for (std::int64_t i = 3 * by.order[k]; i < 3 * by.order[k] + 3; ++i) {
                const std::int32_t vertex = mesh.mesh.corner[i];
                if (number[vertex] == 0) {
                    part.mesh.position.push_back(mesh.mesh.position[vertex]);
                    part.mesh.gradient.push_back(mesh.mesh.gradient[vertex]);
                    number[vertex] = static_cast<std::int32_t>(part.mesh.vertices());
                    used.push_back(vertex);
                }
                part.mesh.corner.push_back(number[vertex] - 1);
            }
        for (const std::int32_t vertex : used) number[vertex] = 0;
        part.mesh.neighbour = find_neighbours(runtime, part.mesh.corner, part.mesh.vertices());
        part.mesh.region = mesh.mesh.region;
        part.mesh.side = mesh.mesh.side;
        for (std::int64_t e = 0; e < part.mesh.corner.size(); ++e)
            if (part.mesh.neighbour[e] < 0) creases.push_back(part.mesh.position[part.mesh.corner[e]]);
    }
    const auto grid = SheetEnd::grid_of(creases, mesh.mesh.side);
    for (const std::unique_ptr<SheetPart>& part : parts) {
        part->end = std::make_unique<SheetEnd>(whole, *all, part->sheet, grid, part->mesh, mesh.mesh.end);
        part->mesh.end = part->end.get();
    }
    return parts;
}

} // namespace hrbfnpr::curves

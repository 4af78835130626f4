// SPDX-License-Identifier: MIT
#include "creases/sheet_parts.h"

#include "base/assert.h"
#include "curves/mesh_topology.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "implicit/sheets.h"
#include "surface/sheets_meet.h"

#include <cmath>
#include <utility>

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

// One sheet of a whole surface: it is where this sheet is f.
class SheetDomain final : public implicit::Domain {
public:
    // creases: places along those of all sheets, no farther apart than a side of the mesh. Near any crease a sheet may
    // end: a curve that leaves it may come to another sheet that is the same function, as for cylinders on one axis.
    // own: the sheet's triangles, which must outlive it. base: the domain of the whole surface, or null.
    SheetDomain(const implicit::Implicit& whole, std::int32_t sheet, std::shared_ptr<const geometry::PointGrid> creases,
                const SurfaceMesh& own, const implicit::Domain* base)
        : whole_(whole), sheet_(sheet), own_(own), creases_(std::move(creases)),
          vertices_(own.position, curve_tuning.vertex_reach * own.side), base_(base) {
        HRBFNPR_ASSERT(whole.sheets() != nullptr && sheet >= 0 && sheet < whole.sheets()->count());
    }

    [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
        return (base_ != nullptr && base_->near_end(place)) || creases_->any_around(place);
    }
    // The distance from the whole surface, or a side where that is another sheet, unless the sheet is the active one.
    // Either of two equal sheets may be active: a place on the whole surface belongs to this sheet if one of its
    // vertices is near.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept override {
        const double on_surface = curve_tuning.on_sheet * own_.side;
        if (surface::active_at(*whole_.sheets(), place) != sheet_) {
            double value = 0.0;
            glm::dvec3 slope(0.0);
            whole_.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&slope.x, &slope.y, &slope.z}, {}});
            const double off = std::abs(value) / glm::length(slope);
            if (!(off <= on_surface)) return off;
            bool is_own = false;
            vertices_.around(place, [&](std::int64_t at) {
                const glm::dvec3 vertex = own_.position[vertices_.index(at)];
                is_own = is_own || glm::distance(vertex, place) <= curve_tuning.vertex_reach * own_.side;
            });
            if (!is_own) return own_.side;
        }
        return base_ != nullptr && base_->near_end(place) ? base_->beyond(place, gradient) : -on_surface;
    }

private:
    const implicit::Implicit& whole_;
    std::int32_t sheet_;
    const SurfaceMesh& own_;
    std::shared_ptr<const geometry::PointGrid> creases_;
    geometry::PointGrid vertices_;
    const implicit::Domain* base_;
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
    const auto grid = std::make_shared<const geometry::PointGrid>(creases, curve_tuning.border_reach * mesh.mesh.side);
    for (const std::unique_ptr<SheetPart>& part : parts) {
        part->domain = std::make_unique<SheetDomain>(whole, part->sheet, grid, part->mesh, mesh.mesh.domain);
        part->mesh.domain = part->domain.get();
    }
    return parts;
}

} // namespace hrbfnpr::curves

// SPDX-License-Identifier: MIT
#include "creases/settle_alone.h"

#include "surface/sheets_meet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::curves {
namespace {

constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t not_alone = -1;

template <class Visit>
void for_neighbours(const SurfaceMesh& mesh, const base::Progress& progress, Visit&& visit) {
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        if (t % 4096 == 0) progress.check();
        for (std::int64_t k = 0; k < 3; ++k) {
            const std::int32_t a = mesh.corner[3 * t + k];
            const std::int32_t b = mesh.corner[3 * t + (k + 1) % 3];
            visit(a, b);
            visit(b, a);
        }
    }
}

} // namespace

void settle_alone(const base::Runtime& runtime, const implicit::Sheets& sheets, double alike, SurfaceMesh& mesh,
                  base::Array<std::int32_t>& sheet, const base::Progress& progress) {
    base::Array<std::int32_t> first(runtime.memory, mesh.vertices()); // of the sheets beside each vertex
    std::fill(first.begin(), first.end(), none);
    for_neighbours(mesh, progress, [&](std::int32_t vertex, std::int32_t other) {
        first[vertex] = sheet[vertex] == sheet[other] ? not_alone : std::min(first[vertex], sheet[other]);
    });
    for_neighbours(mesh, progress, [&](std::int32_t vertex, std::int32_t other) {
        if (first[vertex] == not_alone) return;
        const glm::dvec3 place = mesh.position[vertex];
        const surface::SheetValue a = surface::sheet_at(sheets, first[vertex], place);
        const surface::SheetValue b = surface::sheet_at(sheets, sheet[other], place);
        const double slope = glm::length(b.gradient);
        const bool near = std::abs(b.value) <= alike * mesh.side * slope;
        if (!near || !(glm::distance(a.gradient / glm::length(a.gradient), b.gradient / slope) <= alike))
            first[vertex] = not_alone;
    });
    for (std::int32_t vertex = 0; vertex < mesh.vertices(); ++vertex) {
        if (first[vertex] == not_alone || first[vertex] == none) continue;
        const surface::SheetValue at = surface::sheet_at(sheets, first[vertex], mesh.position[vertex]);
        const double square = glm::dot(at.gradient, at.gradient);
        mesh.position.set(vertex, mesh.position[vertex] - at.value / square * at.gradient);
        mesh.gradient.set(vertex, at.gradient);
        sheet[vertex] = first[vertex];
    }
}

} // namespace hrbfnpr::curves

// SPDX-License-Identifier: MIT
#include "curves/clear_corners.h"

#include "geometry/long_vec_array.h"
#include "implicit/evaluate_all.h"
#include "surface/project.h"

namespace hrbfnpr::curves {
namespace {

// Of a side: nearer corners move, to this distance.  All tetrahedra keep their orientation.
constexpr double clearance = 0.05;
constexpr std::int64_t corners_a_look = 4096; // cells or corners without a look for a cancel

double shortest_side(const Lattice& lattice) noexcept {
    return std::min({lattice.side.x, lattice.side.y, lattice.side.z});
}

// Those that the surface is near along an edge, as far as values tell.
base::Array<std::int32_t> near_corners(const CrossedCells& cells, const base::Progress& progress) {
    base::Array<std::uint8_t> near(cells.value.memory(), cells.value.size());
    std::int64_t looked = 0;
    for (const CrossedCell& cell : cells.cell) {
        if (looked++ % corners_a_look == 0) progress.check();
        cells.sections_of(cell, [&](const Tetrahedron& tetrahedron, const Section& section) {
            for (std::size_t i = 0; i < section.size; ++i) {
                const std::int32_t a = cell.corner[tetrahedron.corner[section.edge[i][0]]];
                const std::int32_t b = cell.corner[tetrahedron.corner[section.edge[i][1]]];
                const double at = cells.value[a] / (cells.value[a] - cells.value[b]);
                if (at < clearance) near[a] = 1;
                if (at > 1.0 - clearance) near[b] = 1;
            }
        });
    }
    base::Array<std::int32_t> found(cells.value.memory());
    for (std::int64_t i = 0; i < near.size(); ++i)
        if (near[i] != 0) found.push_back(static_cast<std::int32_t>(i));
    return found;
}

// Away from the surface, but along the region's faces.
glm::dvec3 moved(const CrossedCells& cells, std::int32_t corner, const glm::dvec3& gradient) noexcept {
    const glm::dvec3 place = cells.position[corner];
    const double slope = glm::length(gradient);
    const double side = shortest_side(cells.lattice);
    const double missing = clearance * side - std::abs(cells.value[corner]) / slope;
    if (!surface::is_slope(slope) || !(missing > 0.0)) return place;
    glm::dvec3 way = gradient * ((cells.negative(corner) ? -missing : missing) / slope);
    const Lattice::Cell at = geometry::CellGrid::unpack(cells.place[corner]);
    for (int axis = 0; axis < 3; ++axis)
        if (cells.lattice.on_face(at, axis)) way[axis] = 0.0;
    return place + way;
}

} // namespace

void clear_corners(const base::Runtime& runtime, const implicit::Implicit& implicit, CrossedCells& cells,
                   const base::Progress& progress) {
    const base::Array<std::int32_t> near = near_corners(cells, progress);
    geometry::VecArray place(runtime.memory);
    resize_long(place, near.size(), progress);
    for (std::int64_t i = 0; i < near.size(); ++i) place.set(i, cells.position[near[i]]);
    geometry::VecArray gradient(runtime.memory);
    resize_long(gradient, near.size(), progress);
    implicit::evaluate_all(runtime, implicit, place,
                           {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}}, progress);
    for (std::int64_t i = 0; i < near.size(); ++i) {
        if (i % corners_a_look == 0) progress.check();
        place.set(i, moved(cells, near[i], gradient[i]));
    }
    base::Array<double> value(runtime.memory, near.size());
    implicit::evaluate_all(runtime, implicit, place, {value.data(), {}, {}}, progress);
    for (std::int64_t i = 0; i < near.size(); ++i) {
        if (!std::isfinite(value[i]) || (value[i] < 0.0) != cells.negative(near[i])) continue;
        cells.position.set(near[i], place[i]);
        cells.value[near[i]] = value[i];
    }
}

} // namespace hrbfnpr::curves

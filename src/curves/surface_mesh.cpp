// SPDX-License-Identifier: MIT
#include "curves/surface_mesh.h"

#include "base/long_array.h"
#include "curves/clear_corners.h"
#include "curves/crossed_cells.h"
#include "curves/edge_roots.h"
#include "curves/mesh_topology.h"
#include "curves/triangle_tree.h"
#include "surface/project.h"

#include <atomic>

namespace hrbfnpr::curves {
namespace {

constexpr double seed_tolerance = 1e-3; // in sides
constexpr double seed_reach = 1.5;      // in sides: how far from a seed its triangle may be
constexpr std::int64_t most_surface_triangles = std::int64_t{1} << 28;

constexpr std::int64_t meshed_a_look = 4096;

// Edges that the surface crosses, each once.
class CellEdges {
public:
    explicit CellEdges(const CrossedCells& cells)
        : edge(cells.value.memory()), cells_(cells), number_(cells.value.memory()) {}

    void number_all(const base::Progress& progress) {
        base::resize_long(number_, ways * cells_.value.size(), progress);
        for (std::int64_t i = 0; i < cells_.cell.size(); ++i) {
            if (i % meshed_a_look == 0) progress.check();
            const CrossedCell& cell = cells_.cell[i];
            cells_.sections_of(cell, [&](const Tetrahedron& tetrahedron, const Section& section) {
                for (std::size_t k = 0; k < section.size; ++k) add(cell, tetrahedron, section.edge[k]);
            });
        }
    }
    // Of an edge between two corners of a tetrahedron.
    [[nodiscard]] std::int32_t vertex(const CrossedCell& cell, const Tetrahedron& tetrahedron,
                                      const std::array<std::uint8_t, 2>& between) const noexcept {
        return number_[place(cell, tetrahedron, between)] - 1;
    }

    base::Array<CrossedEdges::Edge> edge;

private:
    static constexpr std::int64_t ways = 7;

    // An edge is known by its lower corner and by its way from there.
    [[nodiscard]] static std::int64_t place(const CrossedCell& cell, const Tetrahedron& tetrahedron,
                                            const std::array<std::uint8_t, 2>& between) noexcept {
        const std::uint8_t from = tetrahedron.corner[between[0]];
        const int way = from ^ tetrahedron.corner[between[1]];
        return ways * cell.corner[from] + way - 1;
    }
    void add(const CrossedCell& cell, const Tetrahedron& tetrahedron, const std::array<std::uint8_t, 2>& between) {
        std::int32_t& number = number_[place(cell, tetrahedron, between)];
        if (number != 0) return;
        edge.push_back({cell.corner[tetrahedron.corner[between[0]]], cell.corner[tetrahedron.corner[between[1]]]});
        number = static_cast<std::int32_t>(edge.size());
    }

    const CrossedCells& cells_;
    base::Array<std::int32_t> number_; // of the vertex there, and 1; 0: none
};

void add_triangle(SurfaceMesh& mesh, std::int32_t a, std::int32_t b, std::int32_t c, bool even) {
    mesh.corner.push_back(a);
    mesh.corner.push_back(even ? b : c);
    mesh.corner.push_back(even ? c : b);
}

// A quadrilateral is cut along its shorter diagonal.
void add_section(SurfaceMesh& mesh, const std::array<std::int32_t, 4>& v, std::size_t size, bool even) {
    if (size == 3) return add_triangle(mesh, v[0], v[1], v[2], even);
    const auto length = [&](std::int32_t a, std::int32_t b) {
        return glm::distance(mesh.position[a], mesh.position[b]);
    };
    const std::size_t first = length(v[0], v[2]) <= length(v[1], v[3]) ? 0 : 1;
    add_triangle(mesh, v[first], v[first + 1], v[first + 2], even);
    add_triangle(mesh, v[first], v[first + 2], v[(first + 3) % 4], even);
}

void add_triangles(const CrossedCells& cells, const CellEdges& edges, SurfaceMesh& mesh,
                   const base::Progress& progress) {
    mesh.corner.reserve(3 * cells.triangles);
    for (std::int64_t i = 0; i < cells.cell.size(); ++i) {
        if (i % meshed_a_look == 0) progress.check();
        const CrossedCell& cell = cells.cell[i];
        cells.sections_of(cell, [&](const Tetrahedron& tetrahedron, const Section& section) {
            std::array<std::int32_t, 4> vertex{};
            for (std::size_t k = 0; k < section.size; ++k) vertex[k] = edges.vertex(cell, tetrahedron, section.edge[k]);
            add_section(mesh, vertex, section.size, tetrahedron.even);
        });
    }
}

// Seeds are brought onto the surface; those that do not come there, or have to go far, are left out.
surface::Projection seeds_on_surface(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                     const geometry::VecArray& seeds, const MeshSettings& settings,
                                     const base::Progress& progress) {
    surface::Projection on(runtime.memory);
    for (std::int64_t i = 0; i < seeds.size(); ++i)
        if (settings.region.contains(seeds[i])) on.position.push_back(seeds[i]);
    geometry::VecArray before(runtime.memory);
    for (std::int64_t i = 0; i < on.position.size(); ++i) before.push_back(on.position[i]);
    surface::ProjectionSettings steps;
    steps.evaluation_limit = 12;
    steps.tolerance = std::max(settings.tolerance, seed_tolerance * settings.side / implicit.diagonal());
    surface::project(runtime, implicit, steps, on, progress);
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < before.size(); ++i) {
        const glm::dvec3 place = on.position[i];
        if (on.status[i] != surface::ProjectionStatus::converged || !settings.region.contains(place) ||
            glm::distance(place, before[i]) > settings.side)
            continue;
        on.position.set(kept, place);
        on.gradient.set(kept++, on.gradient[i]);
    }
    on.position.resize(kept);
    on.gradient.resize(kept);
    return on;
}

// Sums count(i) for i in [0, total).
template <class Count>
std::int64_t count_all(const base::Runtime& runtime, std::int64_t total, const base::Progress& progress,
                       Count&& count) {
    std::atomic<std::int64_t> sum{0};
    runtime.parallel.for_chunks(total, 1024, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        std::int64_t here = 0;
        for (std::int64_t i = begin; i < end; ++i) here += count(i) ? 1 : 0;
        sum += here;
    });
    return sum;
}

std::int64_t count_missed(const base::Runtime& runtime, const surface::Projection& seeds, const SurfaceMesh& mesh,
                          const base::Progress& progress) {
    const TriangleTree tree(runtime, mesh, progress);
    return count_all(runtime, seeds.position.size(), progress, [&](std::int64_t i) {
        return !tree.any_facing(seeds.position[i], seeds.gradient[i], seed_reach * mesh.side);
    });
}

Lattice lattice_of(const MeshSettings& settings) {
    const Lattice lattice(settings.region, settings.side);
    if (!lattice.valid())
        fail(Status::invalid_argument,
             "a region of %g x %g x %g cannot be cut into cells of side %g: give them a larger side (cell_size)",
             settings.region.size().x, settings.region.size().y, settings.region.size().z, settings.side);
    return lattice;
}

} // namespace

std::int64_t SurfaceMesh::bytes() const noexcept {
    return position.bytes() + gradient.bytes() + corner.bytes() + neighbour.bytes();
}

bool is_turned(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    const std::array<glm::dvec3, 3> p = corners_of(mesh, triangle);
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    for (std::int64_t k = 0; k < 3; ++k)
        if (glm::dot(mesh.gradient[mesh.corner[3 * triangle + k]], normal) < 0.0) return true;
    return false;
}

SurfaceMesh triangulate(const base::Runtime& runtime, const implicit::Implicit& implicit,
                        const geometry::VecArray& seeds, const MeshSettings& settings, const base::Progress& progress) {
    const Lattice lattice = lattice_of(settings);
    SurfaceMesh mesh(runtime.memory);
    mesh.region = settings.region;
    mesh.side = std::max({lattice.side.x, lattice.side.y, lattice.side.z});
    const surface::Projection on = seeds_on_surface(runtime, implicit, seeds, settings, progress.part(0.0, 0.05));
    MeshSettings within = settings;
    within.triangle_limit = std::min(settings.triangle_limit, most_surface_triangles);
    CrossedCells cells = find_crossed_cells(runtime, implicit, on.position, lattice, within, progress.part(0.05, 0.3));
    clear_corners(runtime, implicit, cells, progress.part(0.3, 0.4));
    CellEdges edges(cells);
    edges.number_all(progress);
    mesh.unresolved = find_edge_roots(runtime, implicit, {cells.position, cells.value, edges.edge},
                                      settings.tolerance * implicit.diagonal(), mesh.position, mesh.gradient,
                                      progress.part(0.4, 0.9));
    add_triangles(cells, edges, mesh, progress);
    mesh.neighbour = find_neighbours(runtime, mesh.corner, mesh.vertices(), progress);
    mesh.missed_seeds = count_missed(runtime, on, mesh, progress);
    mesh.turned = count_all(runtime, mesh.triangles(), progress, [&](std::int64_t t) { return is_turned(mesh, t); });
    progress.update(1.0);
    return mesh;
}

SurfaceMesh triangulate_of_any_size(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                    const geometry::VecArray& seeds, MeshSettings& settings,
                                    const base::Progress& progress) {
    while (true) {
        try {
            return triangulate(runtime, implicit, seeds, settings, progress);
        } catch (const Error& error) {
            if (error.status() != Status::invalid_argument || settings.side > implicit.diagonal()) throw;
            settings.side *= 2.0;
        }
    }
}

} // namespace hrbfnpr::curves

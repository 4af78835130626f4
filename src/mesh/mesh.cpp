// SPDX-License-Identifier: MIT
#include "mesh/mesh.h"

#include "base/clock.h"
#include "base/status.h"
#include "mesh/corner_normals.h"
#include "mesh/face_tree.h"
#include "mesh/nested.h"
#include "mesh/weld.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr double smallest_mesh = 1e-60; // across
constexpr std::int64_t at_once = 16384; // faces or vertices without a look for a cancel

// Closed components that are inside out are turned; with all parts kept, not those inside others: they are cavities.
void turn_components(const MeshInput& input, const base::Array<std::int32_t>& component,
                     base::Array<Component>& measured, Welded& welded, MeshReport& report) {
    for (Component& each : measured) {
        const bool cavity = input.parts == Parts::all && each.nested;
        each.turned = input.faces == Faces::turn && inside_out(each) && !cavity;
        report.turned_components += each.turned ? 1 : 0;
    }
    for (std::int64_t face = 0; face < welded.triangle.size(); ++face)
        if (measured[component[face]].turned) turn(welded.triangle[face]);
}

[[nodiscard]] base::Array<std::uint8_t> kept_components(base::Memory& memory, Parts parts,
                                                        const base::Array<Component>& measured) {
    base::Array<std::uint8_t> kept(memory, measured.size());
    std::int64_t largest = 0;
    for (std::int64_t i = 1; i < measured.size(); ++i)
        if (measured[i].area > measured[largest].area) largest = i;
    for (std::int64_t i = 0; i < measured.size(); ++i)
        kept[i] = parts == Parts::largest ? i == largest : parts == Parts::all || !measured[i].nested;
    return kept;
}

void keep(const Welded& welded, const base::Array<std::int32_t>& component, const base::Array<std::uint8_t>& kept,
          Mesh& mesh, const base::Progress& progress) {
    base::Memory& memory = welded.vertex.memory();
    base::Array<std::int32_t> name(memory, kept.size()); // of what is kept, and 1
    std::int32_t names = 0;
    for (std::int64_t i = 0; i < kept.size(); ++i)
        if (kept[i] != 0) name[i] = ++names;
    base::Array<std::int32_t> number(memory, welded.vertex.size()); // and 1
    for (std::int64_t face = 0; face < welded.triangle.size(); ++face)
        if (kept[component[face]] != 0)
            for (const std::int32_t corner : welded.triangle[face]) number[corner] = 1;
    for (std::int64_t v = 0; v < welded.vertex.size(); ++v) {
        if (v % at_once == 0) progress.check();
        if (number[v] == 0) continue;
        mesh.vertex.push_back(welded.vertex[v]);
        mesh.bounds.extend(welded.vertex[v]);
        number[v] = static_cast<std::int32_t>(mesh.vertex.size());
    }
    for (std::int64_t face = 0; face < welded.triangle.size(); ++face) {
        if (face % at_once == 0) progress.check();
        if (kept[component[face]] == 0) {
            ++mesh.report.left_out_faces;
            continue;
        }
        const Triangle& t = welded.triangle[face];
        mesh.triangle.push_back({number[t[0]] - 1, number[t[1]] - 1, number[t[2]] - 1});
        mesh.component.push_back(name[component[face]] - 1);
        mesh.given_face.push_back(welded.given_face[face]);
    }
}

// Counts edges of what is kept.
void measure_edges(const base::Runtime& runtime, Mesh& mesh, const base::Progress& progress) {
    MeshReport& report = mesh.report;
    mesh.border.resize(mesh.faces());
    const base::Array<Side> sides = sides_by_edge(runtime, mesh.triangle, progress);
    Sets rims(runtime.memory, mesh.vertex.size());
    std::int64_t edges = 0;
    std::int64_t joined = 0; // vertices of borders that are in a rim with another
    base::Array<std::uint8_t> at_border(runtime.memory, mesh.vertex.size());
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        report.nonmanifold_edges += last - first > 2 ? 1 : 0;
        ++edges;
        report.contrary_edges += last - first == 2 && first[0].forward == first[1].forward ? 1 : 0;
        if (last - first != 1) return;
        ++report.boundary_edges;
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& t = mesh.triangle[first->face];
            const auto a = static_cast<std::uint64_t>(t[k]);
            const auto b = static_cast<std::uint64_t>(t[(k + 1) % 3]);
            if ((std::min(a, b) << 32U | std::max(a, b)) == first->edge)
                mesh.border[first->face] = static_cast<std::uint8_t>(mesh.border[first->face] | 1U << k);
        }
        const auto a = static_cast<std::int32_t>(first->edge >> 32U);
        const auto b = static_cast<std::int32_t>(first->edge & 0xffffffffU);
        at_border[a] = at_border[b] = 1;
        if (rims.of(a) == rims.of(b)) return;
        rims.join(a, b);
        ++joined;
    });
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        for (std::size_t k = 0; k < 3; ++k)
            if (at_border[mesh.triangle[face][k]] != 0)
                mesh.border[face] = static_cast<std::uint8_t>(mesh.border[face] | 1U << (k + 3));
    report.boundary_loops = -joined;
    for (const std::uint8_t is : at_border) report.boundary_loops += is;
    report.closed = report.boundary_edges == 0 && report.nonmanifold_edges == 0 && report.contrary_edges == 0;
    report.euler_characteristic = mesh.vertex.size() - edges + mesh.faces();
}

void measure(const base::Runtime& runtime, Mesh& mesh, const base::Progress& progress) {
    MeshReport& report = mesh.report;
    measure_edges(runtime, mesh, progress);
    double volume = 0.0;
    const glm::dvec3 middle = mesh.bounds.centre();
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        if (face % at_once == 0) progress.check();
        const auto p = mesh.corners(face);
        report.area += 0.5 * glm::length(doubled_area(p));
        volume += glm::dot(p[0] - middle, doubled_area(p)) / 6.0;
    }
    if (!report.closed) return;
    report.volume = volume;
    const std::int64_t kept = report.components - report.left_out_components;
    if (report.euler_characteristic % 2 == 0) report.genus = kept - report.euler_characteristic / 2;
}

void check_extent(const Welded& welded) {
    geometry::Bounds bounds;
    for (const glm::dvec3& p : welded.vertex) bounds.extend(p);
    if (!(bounds.diagonal() >= smallest_mesh))
        fail(Status::invalid_argument, "the mesh is %g across; it must be at least 1e-60: scale it", bounds.diagonal());
}

} // namespace

bool on_border(const Mesh& mesh, std::int64_t face, const glm::dvec3& place) noexcept {
    constexpr double at_the_side = 1e-9; // share of the corner across
    if (mesh.border[face] == 0) return false;
    const glm::dvec3 shares = shares_of(mesh.corners(face), place);
    const auto border = unsigned{mesh.border[face]};
    for (glm::length_t k = 0; k < 3; ++k) {
        if ((border >> k & 1U) != 0 && shares[(k + 2) % 3] <= at_the_side) return true;
        if ((border >> (k + 3) & 1U) != 0 && shares[k] >= 1.0 - at_the_side) return true;
    }
    return false;
}

Mesh make_mesh(const base::Runtime& runtime, const MeshInput& input, const base::Progress& progress) {
    const base::Stopwatch watch;
    Mesh mesh(runtime.memory);
    MeshReport& report = mesh.report;
    Welded welded = weld(runtime, input, report, progress);
    check_extent(welded);
    progress.update(0.3);
    if (input.faces == Faces::turn) report.turned_faces = agree(runtime, welded.vertex, welded.triangle, progress);
    const base::Array<std::int32_t> component =
        components_of(welded.triangle, welded.vertex.size(), report.components, progress);
    base::Array<Component> measured =
        measure_components(runtime, welded.vertex, welded.triangle, component, report.components, progress);
    progress.update(0.6);
    find_nested(runtime, welded.vertex, welded.triangle, component, measured, progress);
    turn_components(input, component, measured, welded, report);
    for (const Component& each : measured) report.nested_components += each.nested ? 1 : 0;
    const base::Array<std::uint8_t> kept = kept_components(runtime.memory, input.parts, measured);
    for (const std::uint8_t is : kept) report.left_out_components += 1 - is;
    keep(welded, component, kept, mesh, progress);
    measure(runtime, mesh, progress);
    progress.update(0.8);
    set_corner_normals(runtime, input.crease_angle, mesh, progress);
    report.seconds = watch.seconds();
    progress.update(1.0);
    return mesh;
}

} // namespace hrbfnpr::mesh

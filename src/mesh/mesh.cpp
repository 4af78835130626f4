// SPDX-License-Identifier: MIT
// The steps of make_mesh(), in order:
//
//   weld                  merges vertices, drops faces without area, parts solids that touch
//   agree                 turns faces to agree with their neighbours
//   measure_components    measures the components, and the volumes that they enclose
//   find_nested           finds components that lie inside others
//   turn_components       turns closed components so that they face outward
//   keep_components       makes the mesh of the components that are wanted
//   measure               measures its borders, area, volume and genus
//   set_corner_normals    sets the normals of its corners
#include "mesh/mesh.h"

#include "base/clock.h"
#include "base/status.h"
#include "mesh/edges.h"
#include "mesh/plan.h"
#include "mesh/tuning.h"
#include "mesh/weld.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

void turn_components(const MeshInput& input, const base::Array<std::int32_t>& component,
                     base::Array<Component>& measured, Welded& welded, MeshReport& report) {
    for (Component& each : measured) {
        each.turned = is_turned(each, input.parts, input.faces);
        report.turned_components += each.turned ? 1 : 0;
    }
    for (std::int64_t face = 0; face < welded.triangle.size(); ++face)
        if (measured[component[face]].turned) turn(welded.triangle[face]);
}

void keep_components(const Welded& welded, const base::Array<std::int32_t>& component, Parts parts,
                     const base::Array<Component>& measured, Mesh& mesh, const base::Progress& progress) {
    base::Memory& memory = welded.vertex.memory();
    const Component* const largest = std::max_element(
        measured.begin(), measured.end(), [](const Component& a, const Component& b) { return a.area < b.area; });
    // For each component: its new index plus 1, or 0 if it is dropped.
    base::Array<std::int32_t> name(memory, measured.size());
    std::int32_t names = 0;
    for (const Component& each : measured) {
        const bool kept = is_kept(each, &each == largest, parts);
        if (kept) name[&each - measured.begin()] = ++names;
        mesh.report.nested_components += each.is_nested() ? 1 : 0;
        mesh.report.cavities += kept && each.is_cavity() ? 1 : 0;
        mesh.report.left_out_components += kept ? 0 : 1;
    }
    // For each vertex: its new index plus 1, or 0 if it is dropped.
    base::Array<std::int32_t> number(memory, welded.vertex.size());
    for (std::int64_t face = 0; face < welded.triangle.size(); ++face)
        if (name[component[face]] != 0)
            for (const std::int32_t corner : welded.triangle[face]) number[corner] = 1;
    for (const std::int64_t v : progress.over(welded.vertex.size())) {
        if (number[v] == 0) continue;
        mesh.vertex.push_back(welded.vertex[v]);
        mesh.bounds.extend(welded.vertex[v]);
        number[v] = static_cast<std::int32_t>(mesh.vertex.size());
    }
    for (const std::int64_t face : progress.over(welded.triangle.size())) {
        if (name[component[face]] == 0) {
            ++mesh.report.left_out_faces;
            continue;
        }
        const Triangle& t = welded.triangle[face];
        mesh.triangle.push_back({number[t[0]] - 1, number[t[1]] - 1, number[t[2]] - 1});
        mesh.component.push_back(name[component[face]] - 1);
        mesh.given_face.push_back(welded.given_face[face]);
    }
}

void measure_edges(const base::Work& work, Mesh& mesh) {
    MeshReport& report = mesh.report;
    mesh.border.resize(mesh.faces());
    const auto mark = [&](std::int64_t face, std::int64_t bit) {
        mesh.border[face] = static_cast<std::uint8_t>(mesh.border[face] | 1U << static_cast<unsigned>(bit));
    };
    UnionFind rims(work.memory, mesh.vertex.size());
    std::int64_t edges = 0;
    std::int64_t joined = 0; // the number of times that border vertices were joined
    base::Array<std::uint8_t> at_border(work.memory, mesh.vertex.size());
    for_edges(sides_by_edge(work, mesh.triangle), work, [&](const Side* first, const Side* last) {
        report.nonmanifold_edges += last - first > 2 ? 1 : 0;
        ++edges;
        report.contrary_edges += last - first == 2 && first[0].forward == first[1].forward ? 1 : 0;
        if (last - first != 1) return;
        ++report.boundary_edges;
        mark(first->face, number_of(mesh.triangle, *first) % 3);
        const std::int32_t a = low_end(*first);
        const std::int32_t b = high_end(*first);
        at_border[a] = at_border[b] = 1;
        if (rims.find(a) == rims.find(b)) return;
        rims.join(a, b);
        ++joined;
    });
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        for (std::size_t k = 0; k < 3; ++k)
            if (at_border[mesh.triangle[face][k]] != 0) mark(face, static_cast<std::int64_t>(k) + 3);
    report.boundary_loops = std::count(at_border.begin(), at_border.end(), std::uint8_t{1}) - joined;
    report.closed = report.boundary_edges == 0 && report.nonmanifold_edges == 0 && report.contrary_edges == 0;
    report.euler_characteristic = mesh.vertex.size() - edges + mesh.faces();
}

void measure(const base::Work& work, Mesh& mesh) {
    MeshReport& report = mesh.report;
    measure_edges(work, mesh);
    double volume = 0.0;
    const glm::dvec3 middle = mesh.bounds.centre();
    for (const std::int64_t face : work.over(mesh.faces())) {
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
    constexpr double smallest_mesh = 1e-60; // A mesh with a smaller diagonal is refused.
    geometry::Bounds bounds;
    for (const glm::dvec3& p : welded.vertex) bounds.extend(p);
    if (!(bounds.diagonal() >= smallest_mesh))
        fail(Status::invalid_argument, "the mesh is %g across; it must be at least 1e-60: use a smaller unit",
             bounds.diagonal());
}

// Sets the unit normals of all corners. The normal of a corner is a mean over the faces at its vertex whose normals are
// within the crease angle, weighted by their angles at the vertex.
void set_corner_normals(const base::Work& work, double crease_angle, Mesh& mesh) {
    const base::Groups corners = corners_at_vertices(mesh, work);
    base::Array<glm::dvec3> normal(work.memory);   // normals of the faces
    base::Array<glm::dvec3> weighted(work.memory); // for each corner: the face normal times the angle
    normal.resize_for_overwrite(mesh.faces());
    weighted.resize_for_overwrite(3 * mesh.faces());
    mesh.corner_normal.resize_for_overwrite(3 * mesh.faces());
    const auto for_faces = [&](auto&& visit) {
        work.for_chunks(mesh.faces(), mesh_tuning.at_once, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t face = begin; face < end; ++face) visit(face);
        });
    };
    for_faces([&](std::int64_t face) {
        const auto p = mesh.corners(face);
        normal[face] = glm::normalize(doubled_area(p));
        for (std::size_t k = 0; k < 3; ++k)
            weighted[3 * face + static_cast<std::int64_t>(k)] = angle_at(p, k) * normal[face];
    });
    const double least = std::cos(glm::radians(crease_angle)) - 1e-12;
    for_faces([&](std::int64_t face) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::span<const std::int32_t> about = corners[mesh.triangle[face][k]];
            const std::int64_t corner = 3 * face + static_cast<std::int64_t>(k);
            const auto most = static_cast<std::size_t>(mesh_tuning.most_corners);
            // If a vertex has very many faces, only every step-th corner is used.
            const std::size_t step = (about.size() + most - 1) / most;
            glm::dvec3 sum = step > 1 ? weighted[corner] : glm::dvec3(0.0);
            for (std::size_t at = 0; at < about.size(); at += step)
                if (glm::dot(normal[face], normal[about[at] / 3]) >= least) sum += weighted[about[at]];
            const double length = glm::length(sum);
            mesh.corner_normal[corner] = length > 1e-12 ? sum / length : normal[face];
        }
    });
}

} // namespace

bool on_border(const Mesh& mesh, std::int64_t face, const glm::dvec3& place) noexcept {
    HRBFNPR_ASSERT(face >= 0 && face < mesh.faces());
    if (mesh.border[face] == 0) return false;
    const glm::dvec3 shares = shares_of(mesh.corners(face), place);
    const auto border = unsigned{mesh.border[face]};
    for (glm::length_t k = 0; k < 3; ++k) {
        if ((border >> k & 1U) != 0 && shares[(k + 2) % 3] <= mesh_tuning.on_side) return true;
        if ((border >> (k + 3) & 1U) != 0 && shares[k] >= 1.0 - mesh_tuning.on_side) return true;
    }
    return false;
}

glm::dvec3 shares_of(const std::array<glm::dvec3, 3>& p, const glm::dvec3& place) noexcept {
    const glm::dvec3 normal = doubled_area(p);
    const double whole = glm::dot(normal, normal);
    if (!(whole > 0.0)) return glm::dvec3(1.0 / 3.0);
    const double b = glm::dot(glm::cross(place - p[0], p[2] - p[0]), normal) / whole;
    const double c = glm::dot(glm::cross(p[1] - p[0], place - p[0]), normal) / whole;
    return {1.0 - b - c, b, c};
}

Mesh make_mesh(const base::Work& work, const MeshInput& input) {
    const base::Stopwatch watch;
    Mesh mesh(work.memory);
    MeshReport& report = mesh.report;
    Welded welded = weld(work, input, report);
    check_extent(welded);
    work.update(0.3);
    if (input.faces == Faces::turn) report.turned_faces = orient_consistently(work, welded.vertex, welded.triangle);
    const base::Array<std::int32_t> component =
        components_of(welded.triangle, welded.vertex.size(), report.components, work);
    base::Array<Component> measured =
        measure_components(work, welded.vertex, welded.triangle, component, report.components);
    work.update(0.6);
    find_nested(work, welded.vertex, welded.triangle, component, measured);
    turn_components(input, component, measured, welded, report);
    keep_components(welded, component, input.parts, measured, mesh, work);
    measure(work, mesh);
    work.update(0.8);
    set_corner_normals(work, input.crease_angle, mesh);
    report.seconds = watch.seconds();
    work.update(1.0);
    return mesh;
}

} // namespace hrbfnpr::mesh

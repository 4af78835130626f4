// SPDX-License-Identifier: MIT
// Rays count winding numbers. Two parts touch if an edge of one crosses a face of the other, or if a short line along a
// normal of one meets the other.
#include "mesh/fit/outer.h"

#include "base/assert.h"
#include "base/status.h"
#include "geometry/box_tree.h"
#include "mesh/fit/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr double rounding = 1e-9; // the error of places on rays, in diagonals

[[nodiscard]] int winding_along(const FaceTree& tree, const glm::dvec3& place, const glm::dvec3& direction) noexcept {
    int winding = 0;
    tree.crossings(place, direction, [&](std::int64_t, double, int sign) { winding += sign; });
    return winding;
}

[[nodiscard]] bool winds_around(const FaceTree& tree, const glm::dvec3& place, const glm::dvec3& direction) noexcept {
    return winding_along(tree, place, direction) > 0;
}

[[nodiscard]] bool may_overlap(const Mesh& mesh) noexcept { return mesh.report.closed && has_parts(mesh); }

// Returns whether the middle of a face, and places close to its corners, lie inside another component.
[[nodiscard]] bool is_covered(const Mesh& mesh, const FaceTree& tree, std::int64_t face, double off) noexcept {
    const auto p = mesh.corners(face);
    const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
    const glm::dvec3 beyond = off * glm::normalize(doubled_area(p));
    return is_inside(tree, middle + beyond) && std::all_of(p.begin(), p.end(), [&](const glm::dvec3& corner) {
               return is_inside(tree, corner + 0.01 * (middle - corner) + beyond);
           });
}

// The boxes of all components. Most faces of a large component are outside the boxes of all others, so they cannot meet
// another component.
class ComponentBoxes {
public:
    ComponentBoxes(const base::Work& work, const Mesh& mesh)
        : box_(boxes_of(work.memory, mesh)),
          tree_(work.without_progress(), box_.size(), [&](std::int64_t c) { return box_[c]; }) {}

    // Returns whether the box of a component other than `own` overlaps a box.
    [[nodiscard]] bool has_other(const geometry::Bounds& box, std::int32_t own) const noexcept {
        const auto overlaps = [&](const geometry::Bounds& other) {
            return glm::all(glm::lessThanEqual(box.min, other.max)) && glm::all(glm::lessThanEqual(other.min, box.max));
        };
        bool found = false;
        tree_.visit([&](const geometry::Bounds& node) { return !found && overlaps(node); },
                    [&](std::int64_t c) { found = found || (c != own && overlaps(box_[c])); });
        return found;
    }

private:
    [[nodiscard]] static base::Array<geometry::Bounds> boxes_of(base::Memory& memory, const Mesh& mesh) {
        base::Array<geometry::Bounds> boxes(memory, mesh.report.components);
        for (std::int64_t face = 0; face < mesh.faces(); ++face)
            for (const glm::dvec3& corner : mesh.corners(face)) boxes[mesh.component[face]].extend(corner);
        return boxes;
    }

    base::Array<geometry::Bounds> box_;
    geometry::BoxTree tree_;
};

// Searches a short way along the normal of a place, and against it, for a face of another component. Returns the index
// of that component, or -1. The cosine between the normals of the place and the face must be at least `alike`, or at
// most -alike.
[[nodiscard]] std::int32_t other_component(const Mesh& mesh, const FaceTree& tree, const ComponentBoxes& boxes,
                                           const MeshSamples& places, std::int64_t i, double near,
                                           double alike) noexcept {
    const std::int32_t own = mesh.component[places.face[i]];
    if (!boxes.has_other(
            geometry::Bounds{places.position[i], places.position[i]}.grown(near + rounding * mesh.bounds.diagonal()),
            own))
        return -1;
    for (const double side : {near, -near}) {
        const FaceTree::Hit hit = tree.first_hit(places.position[i], side * places.normal[i], 1e-3, 1.0);
        if (hit.face < 0 || mesh.component[hit.face] == own) continue;
        const glm::dvec3 there = doubled_area(mesh.corners(hit.face));
        if (std::abs(glm::dot(there, places.normal[i])) >= alike * glm::length(there)) return mesh.component[hit.face];
    }
    return -1;
}

// Searches along the edges of a face for the first crossing with a face of another component. Returns the index of that
// component, or -1.
[[nodiscard]] std::int32_t pierced_by(const Mesh& mesh, const FaceTree& tree, const ComponentBoxes& boxes,
                                      std::int64_t face, glm::dvec3& place) noexcept {
    constexpr double beyond = 1e-9;
    const std::array<glm::dvec3, 3> p = mesh.corners(face);
    geometry::Bounds box;
    for (const glm::dvec3& corner : p) box.extend(corner);
    if (!boxes.has_other(box.grown(rounding * mesh.bounds.diagonal()), mesh.component[face])) return -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 along = p[(k + 1) % 3] - p[k];
        FaceTree::Hit hit{0.0, face};
        for (int own = 0; own < mesh_fit_tuning.most_own && hit.face >= 0; ++own) {
            hit = tree.first_hit(p[k], along, hit.t + beyond, 1.0);
            if (hit.face < 0 || mesh.component[hit.face] == mesh.component[face]) continue;
            place = p[k] + hit.t * along;
            return mesh.component[hit.face];
        }
    }
    return -1;
}

// Finds the first i below `count` for which find(i, place) returns the index of a component. component_of(i) returns
// the component that i belongs to.
template <class Find, class ComponentOf>
[[nodiscard]] PartContact first_of(const base::Work& work, std::int64_t count, Find&& find,
                                   ComponentOf&& component_of) {
    base::Array<std::int32_t> other(work.memory, count);
    work.for_chunks(count, 256, [&](std::int64_t begin, std::int64_t end) {
        glm::dvec3 place;
        for (std::int64_t i = begin; i < end; ++i) other[i] = find(i, place);
    });
    const auto at = std::find_if(other.begin(), other.end(), [](std::int32_t one) { return one >= 0; });
    PartContact found;
    if (at == other.end()) return found;
    found.other = find(at - other.begin(), found.place);
    found.one = component_of(at - other.begin());
    return found;
}

} // namespace

bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept {
    const bool first = winds_around(tree, place, ray_directions[0]);
    const bool second = winds_around(tree, place, ray_directions[1]);
    // The third ray is needed only if the first two disagree.
    return first == second ? first : winds_around(tree, place, ray_directions[2]);
}

int winding_number(const FaceTree& tree, const glm::dvec3& place) noexcept {
    const int first = winding_along(tree, place, ray_directions[0]);
    const int second = winding_along(tree, place, ray_directions[1]);
    if (first == second) return first;
    const int third = winding_along(tree, place, ray_directions[2]);
    return std::clamp(third, std::min(first, second), std::max(first, second)); // the middle one
}

MeshSide side_of_mesh(const FaceTree& tree, const glm::dvec3& place) noexcept {
    constexpr int rays = 16;
    int votes = 0;
    for (int k = 0; k < rays; ++k) {
        // The directions are spread evenly over the sphere [Vogel 1979], and rotated as a whole.
        const double z = 1.0 - (2.0 * k + 1.0) / rays;
        const double angle = 0.6 + 2.399963229728653 * k;
        const double r = std::sqrt(1.0 - z * z);
        votes += winds_around(tree, place,
                              r * std::cos(angle) * ray_directions[0] + r * std::sin(angle) * ray_directions[1] +
                                  z * glm::cross(ray_directions[0], ray_directions[1]))
                     ? 1
                     : 0;
    }
    if (votes >= rays - mesh_fit_tuning.dissenters) return MeshSide::inside;
    return votes <= mesh_fit_tuning.dissenters ? MeshSide::outside : MeshSide::unsure;
}

void keep_outer(const base::Work& work, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal) {
    HRBFNPR_ASSERT(position.size() == normal.size());
    if (!may_overlap(mesh)) return;
    base::Array<std::uint8_t> inside(work.memory, position.size());
    const double off = mesh_fit_tuning.beside_face * mesh.bounds.diagonal();
    work.for_chunks(position.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) inside[i] = is_inside(tree, position[i] + off * normal[i]) ? 1 : 0;
    });
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < position.size(); ++i) {
        if (inside[i] != 0) continue;
        position.set(kept, position[i]);
        normal.set(kept++, normal[i]);
    }
    if (kept == 0) return; // If every sample is inside another part, all samples are kept.
    position.resize(kept);
    normal.resize(kept);
}

OuterFaces::OuterFaces(const base::Work& work, const Mesh& mesh, const FaceTree& all) : all_(all) {
    if (!may_overlap(mesh)) return;
    base::Array<std::uint8_t> covered(work.memory, mesh.faces());
    const double off = mesh_fit_tuning.beside_face * mesh.bounds.diagonal();
    work.for_chunks(mesh.faces(), 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t face = begin; face < end; ++face) covered[face] = is_covered(mesh, all, face, off) ? 1 : 0;
    });
    base::Array<Triangle> outer(work.memory);
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        if (covered[face] == 0) outer.push_back(mesh.triangle[face]);
    if (!outer.empty() && outer.size() < mesh.faces()) outer_.emplace(work, mesh.vertex, outer);
}

bool has_parts(const Mesh& mesh) noexcept { return mesh.report.components - mesh.report.left_out_components >= 2; }

PartContact find_crossing(const base::Work& work, const Mesh& mesh, const FaceTree& tree) {
    if (!has_parts(mesh)) return {};
    const ComponentBoxes boxes(work, mesh);
    return first_of(
        work, mesh.faces(),
        [&](std::int64_t face, glm::dvec3& place) { return pierced_by(mesh, tree, boxes, face, place); },
        [&](std::int64_t face) { return mesh.component[face]; });
}

PartContact find_part_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree, const MeshSamples& places,
                              double near, bool solids_apart) {
    HRBFNPR_ASSERT(places.face.size() == places.position.size());
    if (!has_parts(mesh)) return {};
    PartContact found;
    if (!solids_apart) found = find_crossing(work, mesh, tree);
    if (found.one < 0) {
        const double alike = solids_apart ? mesh_fit_tuning.least_alike : 0.0;
        const ComponentBoxes boxes(work, mesh);
        found = first_of(
            work, places.position.size(),
            [&](std::int64_t i, glm::dvec3& place) {
                place = places.position[i];
                return other_component(mesh, tree, boxes, places, i, near, alike);
            },
            [&](std::int64_t i) { return mesh.component[places.face[i]]; });
    }
    found.may_cross = found.one >= 0 && !solids_apart;
    return found;
}

PartContact warn_of_part_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                 const MeshSamples& places, double near, bool solids_apart) {
    const PartContact found = find_part_contact(work, mesh, tree, places, near, solids_apart);
    if (found.one >= 0)
        work.runtime().log(
            base::LogLevel::warning,
            "mesh fit: parts %d and %d %s nearer than the tolerance at %.4g %.4g %.4g, and may join; lower it",
            static_cast<int>(found.one), static_cast<int>(found.other), found.may_cross ? "cross or are" : "are",
            found.place.x, found.place.y, found.place.z);
    return found;
}

void refuse_flat_solid(const Mesh& mesh) {
    glm::dvec3 normal(0.0); // first the area vector of the largest face, then its unit normal
    glm::dvec3 place(0.0);
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const std::array<glm::dvec3, 3> corners = mesh.corners(face);
        const glm::dvec3 area = doubled_area(corners);
        if (glm::dot(area, area) <= glm::dot(normal, normal)) continue;
        normal = area;
        place = corners[0];
    }
    if (const double length = glm::length(normal); length > 0.0) normal = normal / length;
    const double most = mesh_fit_tuning.flatness * glm::length(mesh.bounds.size());
    double toward = 0.0;
    double away = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const std::array<glm::dvec3, 3> corners = mesh.corners(face);
        for (const glm::dvec3& corner : corners)
            if (std::abs(glm::dot(corner - place, normal)) > most) return;
        const double area = glm::dot(doubled_area(corners), normal);
        (area < 0.0 ? away : toward) += std::abs(area);
    }
    const double all = toward + away;
    if (std::min(toward, away) > mesh_fit_tuning.other_way * all)
        fail(Status::invalid_argument,
             "the mesh is flat: all of its vertices lie in one plane, %.0f %% of the area looks one way and %.0f %% "
             "the other, so it has no inside; keep the faces of one side, or give it a thickness",
             100.0 * std::max(toward, away) / all, 100.0 * std::min(toward, away) / all);
}

} // namespace hrbfnpr::mesh

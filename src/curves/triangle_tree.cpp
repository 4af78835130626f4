// SPDX-License-Identifier: MIT
#include "curves/triangle_tree.h"

#include "base/long_array.h"
#include "surface/project.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// Of a side: how far the surface may be from a flat triangle.
constexpr double least_bulge = 0.02;
constexpr std::int64_t boxes_a_look = 16384;

// An arc over a chord of length h that leaves it at an angle a is h a / 4 away from it: twice that, for arcs that are
// not circles.
double bulge_of(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    const std::array<glm::dvec3, 3> p = corners_of(mesh, triangle);
    const double longest = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    double sine = 0.0;
    for (std::int64_t k = 0; k < 3; ++k) {
        const glm::dvec3 gradient = mesh.gradient[mesh.corner[3 * triangle + k]];
        const double scale = glm::length(gradient) * glm::length(area);
        const bool faces = glm::dot(gradient, area) > 0.0;
        sine = std::max(sine, faces ? glm::length(glm::cross(gradient, area)) / scale : 1.0);
    }
    return least_bulge * mesh.side + 0.5 * longest * std::min(sine, 1.0);
}

// Ericson, Real-Time Collision Detection (2005), 5.1.5.
glm::dvec3 nearest_on_triangle(const std::array<glm::dvec3, 3>& v, const glm::dvec3& p) noexcept {
    const glm::dvec3 ab = v[1] - v[0], ac = v[2] - v[0];
    const glm::dvec3 ap = p - v[0], bp = p - v[1], cp = p - v[2];
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return v[0];
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return v[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return v[0] + (d1 / (d1 - d3)) * ab;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return v[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return v[0] + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return v[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (v[2] - v[1]);
    const double sum = va + vb + vc;
    return v[0] + ab * (vb / sum) + ac * (vc / sum);
}

double distance_to_box(const geometry::Bounds& box, const glm::dvec3& p) noexcept {
    return glm::length(glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0.0)));
}

} // namespace

TriangleTree::TriangleTree(const base::Runtime& runtime, const SurfaceMesh& mesh, const base::Progress& progress)
    : mesh_(mesh), box_(runtime.memory), bulge_(runtime.memory) {
    while (leaves_ * leaf_size < mesh.triangles()) leaves_ *= 2;
    base::resize_long(bulge_, mesh.triangles(), progress);
    box_.resize_for_overwrite(2 * leaves_);
    for (std::int64_t node = 0; node < 2 * leaves_; ++node) {
        if (node % boxes_a_look == 0) progress.check();
        box_[node] = {};
    }
    const std::int64_t used = (mesh.triangles() + leaf_size - 1) / leaf_size;
    runtime.parallel.for_chunks(used, 1024, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t t = begin * leaf_size; t < std::min(end * leaf_size, mesh.triangles()); ++t) {
            bulge_[t] = bulge_of(mesh, t);
            geometry::Bounds own;
            for (const glm::dvec3& corner : corners_of(mesh, t)) own.extend(corner);
            geometry::Bounds& box = box_[leaves_ + t / leaf_size];
            box.extend(own.min - bulge_[t]);
            box.extend(own.max + bulge_[t]);
        }
    });
    for (std::int64_t node = leaves_ - 1; node > 0; --node) {
        if (node % boxes_a_look == 0) progress.check();
        box_[node] = {glm::min(box_[2 * node].min, box_[2 * node + 1].min),
                      glm::max(box_[2 * node].max, box_[2 * node + 1].max)};
    }
}

bool TriangleTree::any_facing(const glm::dvec3& p, const glm::dvec3& direction, double distance) const noexcept {
    bool found = false;
    visit([&](const geometry::Bounds& box) { return !found && distance_to_box(box, p) <= distance; },
          [&](std::int64_t t) {
              const std::array<glm::dvec3, 3> v = corners_of(mesh_, t);
              found = found || (glm::dot(glm::cross(v[1] - v[0], v[2] - v[0]), direction) > 0.0 &&
                                glm::distance(nearest_on_triangle(v, p), p) <= distance);
          });
    return found;
}

} // namespace hrbfnpr::curves

// SPDX-License-Identifier: MIT
#include "mesh/pieces/flat_faces.h"

#include "mesh/pieces/patch_normals.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr double flat_cosine = 0.99985; // a degree: faces of one flat, as files have them
constexpr double much_larger = 3.0;     // than any other at the vertex

// The face beyond each side (3 face + k) that is no crease; -1: none.
[[nodiscard]] base::Array<std::int32_t> faces_beside(const base::Runtime& runtime, const Mesh& mesh,
                                                     const Creases& creases) {
    base::Array<std::int32_t> beside(runtime.memory);
    beside.resize_for_overwrite(3 * mesh.faces());
    std::fill(beside.begin(), beside.end(), -1);
    const base::Array<Side> sides = sides_by_edge(runtime, mesh.triangle);
    for_edges(sides, [&](const Side* first, const Side* last) {
        if (last != first + 2) return;
        for (int i = 0; i < 2; ++i) {
            const auto low = static_cast<std::int32_t>(first[i].edge >> 32U);
            const auto high = static_cast<std::int32_t>(first[i].edge & 0xFFFFFFFFU);
            const Triangle& t = mesh.triangle[first[i].face];
            const std::int32_t from = first[i].forward != 0 ? low : high;
            const std::int64_t side = 3 * std::int64_t{first[i].face} + (t[0] == from ? 0 : t[1] == from ? 1 : 2);
            if (creases.cut[side] != 1) beside[side] = first[1 - i].face;
        }
    });
    return beside;
}

} // namespace

FlatFaces::FlatFaces(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                     const base::Array<glm::dvec3>& mean, double tolerance)
    : region_(runtime.memory), area_(runtime.memory), normal_(runtime.memory), bulge_(runtime.memory),
      mean_(runtime.memory), tolerance_(tolerance) {
    base::Array<double> bulge(runtime.memory);
    double most = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        bulge.push_back(chord_error(mesh, mean, face));
        most = std::max(most, bulge.back());
    }
    if (!(most > tolerance)) return;
    for (const glm::dvec3& normal : mean) mean_.push_back(normal);
    grow(runtime, mesh, creases);
    bulge_.resize(area_.size());
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        bulge_[region_[face]] = std::max(bulge_[region_[face]], bulge[face]);
}

// Over edges that are no crease, from the larger faces on: their normals are the most exact.
void FlatFaces::grow(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases) {
    base::Memory& memory = runtime.memory;
    const base::Array<std::int32_t> beside = faces_beside(runtime, mesh, creases);
    base::Array<std::int64_t> order(memory);
    base::Array<glm::dvec3> area(memory);
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        order.push_back(face);
        area.push_back(0.5 * doubled_area(mesh.corners(face)));
    }
    // Of equal areas by their numbers; std::stable_sort would take memory of its own.
    std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
        const double of_a = glm::length(area[a]);
        const double of_b = glm::length(area[b]);
        return of_a > of_b || (of_a == of_b && a < b);
    });
    region_.resize_for_overwrite(mesh.faces());
    std::fill(region_.begin(), region_.end(), -1);
    base::Array<std::int64_t> todo(memory);
    for (const std::int64_t seed : order) {
        if (region_[seed] >= 0) continue;
        const auto region = static_cast<std::int32_t>(area_.size());
        const glm::dvec3 normal = glm::normalize(area[seed]);
        area_.push_back(0.0);
        normal_.push_back(normal);
        region_[seed] = region;
        todo.push_back(seed);
        while (!todo.empty()) {
            const std::int64_t face = todo.back();
            todo.resize(todo.size() - 1);
            area_[region] += glm::length(area[face]);
            for (int k = 0; k < 3; ++k) {
                const std::int64_t other = beside[3 * face + k];
                if (other < 0 || region_[other] >= 0) continue;
                if (glm::dot(area[other], normal) < flat_cosine * glm::length(area[other])) continue;
                region_[other] = region;
                todo.push_back(other);
            }
        }
    }
}

void LargestFlat::add(std::int64_t face) noexcept {
    const std::int32_t region = flats_.region_of(face);
    if (region == largest_) return;
    const double area = flats_.area(region);
    if (largest_ >= 0 && area <= flats_.area(largest_)) {
        next_ = std::max(next_, area);
        return;
    }
    if (largest_ >= 0) next_ = flats_.area(largest_);
    largest_ = region;
}

std::int32_t LargestFlat::region() const noexcept {
    const bool keeps = largest_ >= 0 && flats_.bulges(largest_) && flats_.area(largest_) >= much_larger * next_;
    return keeps ? largest_ : -1;
}

} // namespace hrbfnpr::mesh

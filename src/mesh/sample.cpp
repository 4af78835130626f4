// SPDX-License-Identifier: MIT
// Random places are chosen by the running sum of areas, and uniformly within the face. Even samples are random places
// in farthest-point order. Near a border, rows of places at constant distances from the border replace the even
// samples. The first row is dense, and each further row has a larger spacing, up to that of the even samples.
#include "mesh/sample.h"

#include "base/random.h"
#include "geometry/farthest_order.h"
#include "geometry/point_tree.h"
#include "mesh/edges.h"
#include "mesh/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::mesh {
namespace {

// Calls visit(face, k) for each side of a face that has no other face.
template <class Visit>
void for_border_sides(const Mesh& mesh, Visit&& visit) {
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        for (std::size_t k = 0; k < 3; ++k)
            if ((mesh.border[face] >> k & 1) != 0) visit(face, k);
}

[[nodiscard]] double side_length(const Mesh& mesh, std::int64_t face, std::size_t k) noexcept {
    const Triangle& t = mesh.triangle[face];
    return glm::distance(mesh.vertex[t[k]], mesh.vertex[t[(k + 1) % 3]]);
}

// Places on the borders. Their normals are replaced by directions into the mesh.
struct BorderPlaces {
    explicit BorderPlaces(base::Memory& memory) : along(memory), fans(memory) {}

    MeshSamples along; // evenly spaced places
    MeshSamples fans;  // for each corner that juts into the mesh: the corner, with the directions between its two sides
};

// Returns places along the borders, `step` apart. At the distance `reach` from a corner, the directions of its fan are
// `step` apart. Borders shorter than `shortest` get no places.
[[nodiscard]] BorderPlaces border_places(const Mesh& mesh, double step, double reach, double shortest) {
    base::Memory& memory = mesh.vertex.memory();
    UnionFind borders(memory, mesh.vertex.size());
    for_border_sides(mesh, [&](std::int64_t face, std::size_t k) {
        borders.join(mesh.triangle[face][k], mesh.triangle[face][(k + 1) % 3]);
    });
    base::Array<double> length_of(memory, mesh.vertex.size());
    for_border_sides(mesh, [&](std::int64_t face, std::size_t k) {
        length_of[borders.find(mesh.triangle[face][k])] += side_length(mesh, face, k);
    });
    // For each vertex, the direction of the side that ends there and its direction into the mesh.
    base::Array<glm::dvec3> way_to(memory, mesh.vertex.size()), in_before(memory, mesh.vertex.size());
    const auto in_from = [&](std::int64_t face, const glm::dvec3& side) {
        return glm::normalize(glm::cross(doubled_area(mesh.corners(face)), side));
    };
    for_border_sides(mesh, [&](std::int64_t face, std::size_t k) {
        const auto p = mesh.corners(face);
        const glm::dvec3 side = p[(k + 1) % 3] - p[k];
        const std::int32_t end = mesh.triangle[face][(k + 1) % 3];
        way_to[end] = glm::normalize(side);
        in_before[end] = in_from(face, side);
    });
    BorderPlaces places(memory);
    double along = 0.5 * step; // the distance along the border to the next place
    for_border_sides(mesh, [&](std::int64_t face, std::size_t k) {
        if (length_of[borders.find(mesh.triangle[face][k])] < shortest) return;
        const auto p = mesh.corners(face);
        const glm::dvec3 side = p[(k + 1) % 3] - p[k];
        const double length = glm::length(side);
        const glm::dvec3 in = in_from(face, side);
        for (; along < length; along += step) places.along.add(p[k] + along / length * side, in, face);
        along -= length;
        const glm::dvec3& before = in_before[mesh.triangle[face][k]];
        const glm::dvec3& way = way_to[mesh.triangle[face][k]];
        const double angle = std::atan2(glm::dot(in, way), glm::dot(in, before));
        const double parts = std::ceil(angle * reach / step);
        for (double i = 1.0; i < parts; i += 1.0) {
            const double turn = angle * i / parts;
            places.fans.add(p[k], std::cos(turn) * before + std::sin(turn) * way, face);
        }
    });
    return places;
}

// A row of places beside a border.
struct BorderRow {
    double inset;   // the distance of the row from the border
    double spacing; // the distance to the next row
};

// Returns the rows between a border and even samples of a spacing.
[[nodiscard]] base::Array<BorderRow> rows_beside_border(base::Memory& memory, double closest, double even_spacing) {
    base::Array<BorderRow> rows(memory);
    rows.push_back({mesh_tuning.row_inset * closest, closest});
    while (rows.back().spacing < mesh_tuning.last_row * even_spacing)
        rows.push_back({rows.back().inset + rows.back().spacing, mesh_tuning.row_growth * rows.back().spacing});
    return rows;
}

// Returns the index of the point nearest to a place, or -1 if there are no points.
[[nodiscard]] std::int64_t nearest_in(const geometry::PointTree& tree, const glm::dvec3& p) {
    if (tree.size() == 0) return -1;
    std::int64_t at = -1;
    const auto any = [](std::int64_t) { return true; };
    return tree.nearest(p, 1, any, any, &at) == 1 ? tree.index(at) : -1;
}

} // namespace

glm::dvec3 normal_at(const Mesh& mesh, std::int64_t face, const glm::dvec3& shares) noexcept {
    HRBFNPR_ASSERT(face >= 0 && face < mesh.faces());
    const glm::dvec3* const n = mesh.corner_normal.data() + 3 * face;
    const glm::dvec3 sum = shares.x * n[0] + shares.y * n[1] + shares.z * n[2];
    const double length = glm::length(sum);
    return length > 1e-12 ? sum / length : glm::normalize(doubled_area(mesh.corners(face)));
}

RandomPlaces::Place RandomPlaces::at(std::uint64_t seed, std::int64_t number, std::uint32_t stream) const noexcept {
    const auto random = base::uniform4(seed, static_cast<std::uint64_t>(number), base::Purpose::mesh_sample, stream);
    const double* const found = std::upper_bound(area_.begin(), area_.end(), random[0] * area_[area_.size() - 1]);
    const double root = std::sqrt(random[1]);
    return {std::min<std::int64_t>(found - area_.begin(), area_.size() - 1),
            {1.0 - root, root * (1.0 - random[2]), root * random[2]}};
}

MeshSamples random_samples(const base::Work& work, const Mesh& mesh, std::int64_t count, std::uint64_t seed,
                           std::uint32_t stream) {
    MeshSamples samples(work.memory);
    samples.position.resize(count);
    samples.normal.resize(count);
    samples.face.resize(count);
    const RandomPlaces places(
        work.memory, mesh.faces(), [&](std::int64_t face) { return mesh.corners(face); }, work);
    work.for_chunks(count, mesh_tuning.at_once, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto [face, shares] = places.at(seed, i, stream);
            const auto p = mesh.corners(face);
            samples.position.set(i, shares.x * p[0] + shares.y * p[1] + shares.z * p[2]);
            samples.normal.set(i, normal_at(mesh, face, shares));
            samples.face[i] = static_cast<std::int32_t>(face);
        }
    });
    return samples;
}

MeshSamples even_samples(const base::Work& work, const Mesh& mesh, std::int64_t count, std::int64_t candidates,
                         std::uint64_t seed) {
    MeshSamples all = random_samples(work, mesh, std::max(count, candidates), seed, 0);
    if (candidates <= count) return all;
    const geometry::FarthestOrder chosen = geometry::farthest_order(all.position, count, work.part(0.2, 1.0));
    MeshSamples samples(work.memory);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t i = chosen.order[k];
        samples.add(all.position[i], all.normal[i], all.face[i]);
    }
    return samples;
}

double border_length(const Mesh& mesh) noexcept {
    double length = 0.0;
    for_border_sides(mesh, [&](std::int64_t face, std::size_t k) { length += side_length(mesh, face, k); });
    return length;
}

MeshSamples end_samples(const base::Work& work, const Mesh& mesh, const FaceTree& tree, std::int64_t count,
                        double closest, std::uint64_t seed) {
    HRBFNPR_ASSERT(count > 0 && closest > 0.0);
    const MeshSamples even = even_samples(work.part(0.0, 0.7), mesh, count, mesh_tuning.candidates_each * count, seed);
    const double even_spacing = std::sqrt(mesh.report.area / static_cast<double>(count));
    const base::Array<BorderRow> rows = rows_beside_border(work.memory, closest, even_spacing);
    const double inset = rows[0].inset;
    const double step = mesh_tuning.row_step * closest;
    const BorderPlaces places = border_places(mesh, step, rows[rows.size() - 1].inset,
                                              mesh_tuning.shortest_border * 2.0 * std::numbers::pi * closest);
    const MeshSamples& border = places.along;
    const geometry::PointTree border_tree(border.position, base::Progress{});
    MeshSamples row(work.memory);
    const auto add_to_row = [&](const glm::dvec3& place, std::int64_t face) {
        row.add(place, normal_at(mesh, face, shares_of(mesh.corners(face), place)), face);
    };
    const auto add_row = [&](double distance, std::int64_t each) {
        for (const MeshSamples* const from : {&places.along, &places.fans})
            for (std::int64_t i = 0; i < from->position.size(); i += each) {
                const FaceTree::Nearest found = tree.nearest(from->position[i] + distance * from->normal[i]);
                const std::int64_t beside = nearest_in(border_tree, found.place);
                if (beside >= 0 &&
                    glm::distance(border.position[beside], found.place) >= mesh_tuning.least_inset * distance)
                    add_to_row(found.place, found.face);
            }
    };
    add_row(inset, 1);
    const geometry::PointTree row_tree(row.position, base::Progress{});
    const auto has_row = [&](std::int64_t i) {
        const std::int64_t at = nearest_in(row_tree, border.position[i]);
        return at >= 0 && glm::distance(row.position[at], border.position[i]) < mesh_tuning.covered * inset;
    };
    // Where there is no space for a row, for example on a narrow strip, places on the border are used instead.
    for (std::int64_t i = 0; i < border.position.size(); ++i)
        if (!has_row(i)) add_to_row(border.position[i], border.face[i]);
    for (std::int64_t k = 1; k < rows.size(); ++k)
        add_row(rows[k].inset, std::max(std::int64_t{1}, static_cast<std::int64_t>(0.5 * rows[k].spacing / step)));
    const geometry::PointTree rows_tree(row.position, base::Progress{});
    base::Array<std::uint8_t> replaced(work.memory, even.position.size());
    work.for_chunks(replaced.size(), 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const std::int64_t at = nearest_in(border_tree, even.position[i]);
            if (at < 0) continue;
            const double away = glm::distance(border.position[at], even.position[i]);
            const double to_row =
                glm::distance(row.position[nearest_in(rows_tree, even.position[i])], even.position[i]);
            const auto is_beside = [&](const BorderRow& one) {
                return away < one.inset + one.spacing && to_row < mesh_tuning.crowded * one.spacing;
            };
            replaced[i] = (has_row(at) && away < mesh_tuning.replaced * inset) ||
                          std::any_of(rows.begin() + 1, rows.end(), is_beside);
        }
    });
    MeshSamples all(work.memory);
    for (std::int64_t i = 0; i < replaced.size(); ++i)
        if (replaced[i] == 0) all.add(even.position[i], even.normal[i], even.face[i]);
    for (std::int64_t i = 0; i < row.position.size(); ++i) all.add(row.position[i], row.normal[i], row.face[i]);
    work.update(1.0);
    return all;
}

} // namespace hrbfnpr::mesh

// SPDX-License-Identifier: MIT
#include "mesh/pieces/patch_normals.h"

#include "mesh/pieces/flat_faces.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t most_about = 1024; // corners of a vertex

[[nodiscard]] double corner_angle(const std::array<glm::dvec3, 3>& p, std::size_t k) noexcept {
    const glm::dvec3 u = p[(k + 1) % 3] - p[k];
    const glm::dvec3 v = p[(k + 2) % 3] - p[k];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

// How far the middle of a side is from what is curved as the normals at its ends are.
[[nodiscard]] double bulge(const glm::dvec3& side, const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return std::abs(glm::dot(side, b - a)) / 8.0;
}

// The corners at one vertex that hang together by sides that are no crease.
class Fan {
public:
    explicit Fan(base::Memory& memory) noexcept : above_(memory) {}

    void join(const Mesh& mesh, const Creases& creases, const std::int64_t* corner, std::int64_t count) {
        above_.resize(count);
        for (std::int64_t i = 0; i < count; ++i) above_[i] = i;
        for (std::int64_t i = 0; i < count; ++i) {
            for (std::int64_t j = 0; j < count; ++j)
                if (go_on(mesh, creases, corner[i], corner[j])) above_[root(i)] = root(j);
        }
    }
    // Whether the second one's face lies across the side from the vertex onward, and that is no crease.
    [[nodiscard]] static bool go_on(const Mesh& mesh, const Creases& creases, std::int64_t a, std::int64_t b) {
        return creases.cut[a] != 1 && ahead(mesh, b, 2) == ahead(mesh, a, 1);
    }
    [[nodiscard]] std::int64_t root(std::int64_t i) const noexcept {
        while (above_[i] != i) i = above_[i];
        return i;
    }

private:
    [[nodiscard]] static std::int32_t ahead(const Mesh& mesh, std::int64_t corner, std::int64_t by) noexcept {
        return mesh.triangle[corner / 3][static_cast<std::size_t>((corner % 3 + by) % 3)];
    }
    base::Array<std::int64_t> above_;
};

// At the tip of a cone the mean normal is turned from that of each face; at the face's far side the normals there are
// so small a part of that.  On a sphere they are turned as much at all corners of a face.
constexpr double straight = 0.25;
constexpr double least_turn = 0.05; // radians, on average
constexpr double small_step = 0.3;  // from face to face, of the whole turn

// The normals of the corners at one vertex after another.
class VertexNormals {
public:
    VertexNormals(base::Memory& memory, const Mesh& mesh, const Creases& creases,
                  const base::Array<glm::dvec3>& weighted, PatchNormals& result) noexcept
        : mesh_(mesh), creases_(creases), weighted_(weighted), result_(result), fan_(memory) {}

    void set(const std::int64_t* corner, std::int64_t count) {
        const bool joined = count <= most_about; // else by patches
        if (joined) fan_.join(mesh_, creases_, corner, count);
        for (std::int64_t i = 0; i < count; ++i) {
            const auto together = [&](std::int64_t j) {
                return joined ? fan_.root(i) == fan_.root(j)
                              : creases_.patch[corner[i] / 3] == creases_.patch[corner[j] / 3];
            };
            glm::dvec3 sum(0.0);
            for (std::int64_t j = 0; j < count; ++j)
                if (together(j)) sum += weighted_[corner[j]];
            const double length = glm::length(sum);
            const bool usable = length > 0.0 && std::isfinite(length);
            result_.normal[corner[i]] = usable ? sum / length : own(corner[i]);
        }
    }

    // Where one flat is much larger than all others there: it stays flat, and what is beside it bends.
    void keep_flat(const std::int64_t* corner, std::int64_t count, const FlatFaces& flats) {
        if (count > most_about) return;
        const bool any =
            std::any_of(corner, corner + count, [&](std::int64_t at) { return flats.bulges(flats.region_of(at / 3)); });
        if (!any) return;
        fan_.join(mesh_, creases_, corner, count);
        for (std::int64_t root = 0; root < count; ++root) {
            if (fan_.root(root) != root) continue;
            LargestFlat largest(flats);
            for (std::int64_t i = 0; i < count; ++i)
                if (fan_.root(i) == root) largest.add(corner[i] / 3);
            const std::int32_t flat = largest.region();
            if (flat < 0 || !bends_less(corner, count, root, flats, flat)) continue;
            for (std::int64_t i = 0; i < count; ++i)
                if (fan_.root(i) == root) result_.normal[corner[i]] = flats.normal(flat);
        }
    }

    // Once all have normals.
    void find_tips(const std::int64_t* corner, std::int64_t count) {
        const auto turned = [&](std::int64_t i) { return glm::distance(own(corner[i]), result_.normal[corner[i]]); };
        double most = 0.0;
        for (std::int64_t i = 0; i < count; ++i) most = std::max(most, turned(i));
        if (most < least_turn || count > most_about) return;
        fan_.join(mesh_, creases_, corner, count);
        for (std::int64_t root = 0; root < count; ++root) {
            if (fan_.root(root) != root) continue;
            double here = 0.0, beyond = 0.0, angles = 0.0;
            for (std::int64_t i = 0; i < count; ++i) {
                if (fan_.root(i) != root) continue;
                const double angle =
                    corner_angle(mesh_.corners(corner[i] / 3), static_cast<std::size_t>(corner[i] % 3));
                here += angle * turned(i);
                beyond += angle * turned_beyond(corner[i]);
                angles += angle;
            }
            if (here < least_turn * angles || beyond > straight * here || !turns_slowly(corner, count, root)) continue;
            for (std::int64_t i = 0; i < count; ++i)
                if (fan_.root(i) == root) result_.tip[corner[i]] = 1;
        }
    }

private:
    [[nodiscard]] glm::dvec3 own(std::int64_t corner) const noexcept {
        return glm::normalize(doubled_area(mesh_.corners(corner / 3)));
    }
    // Whether what is beside a flat bulges less, once the flat keeps its normal there, than the flat did with means.
    [[nodiscard]] bool bends_less(const std::int64_t* corner, std::int64_t count, std::int64_t root,
                                  const FlatFaces& flats, std::int32_t flat) const noexcept {
        double most = 0.0;
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int64_t face = corner[i] / 3;
            if (fan_.root(i) != root || flats.region_of(face) == flat) continue;
            const auto p = mesh_.corners(face);
            const auto k = static_cast<std::size_t>(corner[i] % 3);
            for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
                const glm::dvec3& beyond = flats.mean(3 * face + static_cast<std::int64_t>(other));
                most = std::max(most, bulge(p[other] - p[k], flats.normal(flat), beyond));
            }
        }
        return most < flats.bulge(flat);
    }
    // An edge that is no crease turns at once.
    [[nodiscard]] bool turns_slowly(const std::int64_t* corner, std::int64_t count, std::int64_t root) const noexcept {
        double turn = 0.0;
        double step = 0.0;
        for (std::int64_t i = 0; i < count; ++i)
            for (std::int64_t j = 0; j < count; ++j) {
                if (fan_.root(i) != root || fan_.root(j) != root) continue;
                const double angle = glm::distance(own(corner[i]), own(corner[j]));
                turn = std::max(turn, angle);
                if (Fan::go_on(mesh_, creases_, corner[i], corner[j])) step = std::max(step, angle);
            }
        return step <= small_step * turn;
    }

    // At the face's other corners: at that where it does less, as the other one may be a tip itself.
    [[nodiscard]] double turned_beyond(std::int64_t corner) const noexcept {
        const std::int64_t first = corner - corner % 3;
        const auto turned = [&](std::int64_t k) {
            return glm::distance(own(corner), result_.normal[first + (corner + k) % 3]);
        };
        return std::min(turned(1), turned(2));
    }

    const Mesh& mesh_;
    const Creases& creases_;
    const base::Array<glm::dvec3>& weighted_;
    PatchNormals& result_;
    Fan fan_;
};

// The corners of the faces at each vertex, those of one after those of another.
struct Corners {
    Corners(base::Memory& memory, const Mesh& mesh)
        : first(memory, mesh.vertex.size() + 1), corner(memory, 3 * mesh.faces()) {
        for (const Triangle& t : mesh.triangle)
            for (const std::int32_t v : t) ++first[v + 1];
        for (std::int64_t v = 0; v < mesh.vertex.size(); ++v) first[v + 1] += first[v];
        base::Array<std::int64_t> next(memory);
        for (const std::int64_t at : first) next.push_back(at);
        for (std::int64_t i = 0; i < corner.size(); ++i)
            corner[next[mesh.triangle[i / 3][static_cast<std::size_t>(i % 3)]]++] = i;
    }
    [[nodiscard]] const std::int64_t* of(std::int64_t vertex) const noexcept { return corner.data() + first[vertex]; }
    [[nodiscard]] std::int64_t count(std::int64_t vertex) const noexcept { return first[vertex + 1] - first[vertex]; }

    base::Array<std::int64_t> first;
    base::Array<std::int64_t> corner;
};

// By which the normals of faces count at their corners.
[[nodiscard]] base::Array<glm::dvec3> weighted_normals(const base::Runtime& runtime, const Mesh& mesh) {
    base::Array<glm::dvec3> result(runtime.memory);
    result.resize_for_overwrite(3 * mesh.faces());
    runtime.parallel.for_chunks(mesh.faces(), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t face = begin; face < end; ++face) {
            const auto p = mesh.corners(face);
            const glm::dvec3 area = doubled_area(p);
            for (std::size_t k = 0; k < 3; ++k)
                result[3 * face + static_cast<std::int64_t>(k)] = corner_angle(p, k) * area;
        }
    });
    return result;
}

} // namespace

PatchNormals patch_normals(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases, double tolerance) {
    const Corners corners(runtime.memory, mesh);
    const base::Array<glm::dvec3> weighted = weighted_normals(runtime, mesh);
    PatchNormals result(runtime.memory);
    result.normal.resize_for_overwrite(3 * mesh.faces());
    result.tip.resize(3 * mesh.faces());
    const auto for_vertices = [&](auto&& visit) {
        runtime.parallel.for_chunks(mesh.vertex.size(), 4096, [&](std::int64_t begin, std::int64_t end) {
            VertexNormals normals(runtime.memory, mesh, creases, weighted, result);
            for (std::int64_t v = begin; v < end; ++v) visit(normals, corners.of(v), corners.count(v));
        });
    };
    for_vertices(
        [](VertexNormals& normals, const std::int64_t* corner, std::int64_t count) { normals.set(corner, count); });
    if (const FlatFaces flats(runtime, mesh, creases, result.normal, tolerance); flats.any())
        for_vertices([&](VertexNormals& normals, const std::int64_t* corner, std::int64_t count) {
            normals.keep_flat(corner, count, flats);
        });
    for_vertices([](VertexNormals& normals, const std::int64_t* corner, std::int64_t count) {
        normals.find_tips(corner, count);
    });
    for (std::int64_t i = 0; i < result.tip.size(); ++i)
        if (result.tip[i] != 0) result.normal[i] = glm::normalize(doubled_area(mesh.corners(i / 3)));
    return result;
}

double chord_error(const Mesh& mesh, const base::Array<glm::dvec3>& normal, std::int64_t face) noexcept {
    const auto p = mesh.corners(face);
    const glm::dvec3* const n = normal.data() + 3 * face;
    double most = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        most = std::max(most, bulge(p[next] - p[k], n[k], n[next]));
    }
    return most;
}

base::Array<double> chord_errors(const Mesh& mesh, const base::Array<glm::dvec3>& normal) {
    base::Array<double> error(mesh.vertex.memory(), mesh.vertex.size());
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const double off = chord_error(mesh, normal, face);
        for (const std::int32_t v : mesh.triangle[face]) error[v] = std::max(error[v], off);
    }
    return error;
}

} // namespace hrbfnpr::mesh

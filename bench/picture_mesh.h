// SPDX-License-Identifier: MIT
// Meshes that the benchmark of pictures generates: their form, files of them, and the mesh of a level set.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace bench {

using Face = std::array<std::int32_t, 3>;

struct PictureMesh {
    std::vector<glm::dvec3> points;
    std::vector<Face> faces; // none: a point cloud

    // Adds a copy of a mesh, moved by `place`.
    void append(const PictureMesh& other, const glm::dmat4& place = glm::dmat4(1.0)) {
        const auto first = static_cast<std::int32_t>(points.size());
        for (const glm::dvec3& p : other.points) points.emplace_back(place * glm::dvec4(p, 1.0));
        for (const Face& f : other.faces) faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
};

// Writes a binary PLY file for the command line.
inline void write_ply(const PictureMesh& mesh, const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error("cannot write " + path);
    std::fprintf(file,
                 "ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty double x\nproperty double y\n"
                 "property double z\n",
                 mesh.points.size());
    if (!mesh.faces.empty())
        std::fprintf(file, "element face %zu\nproperty list uchar int vertex_indices\n", mesh.faces.size());
    std::fputs("end_header\n", file);
    std::fwrite(mesh.points.data(), sizeof(glm::dvec3), mesh.points.size(), file);
    for (const Face& face : mesh.faces) {
        std::fputc(3, file);
        std::fwrite(face.data(), sizeof(Face), 1, file);
    }
    std::fclose(file);
}

// A function that is negative inside, and a bound of its gradient's length.
struct Field {
    std::function<double(const glm::dvec3&)> value;
    double steepness;
    glm::dvec3 low, high; // the box around the surface
};

// Meshes the zero level of a field by surface nets: one vertex in each grid cell that the surface passes, and one
// quadrilateral around each grid edge that it crosses.
class SurfaceNets {
public:
    SurfaceNets(const Field& field, double cell) : field_(field), cell_(cell) {
        for (int c = 0; c < 3; ++c) cells_[c] = static_cast<int>(std::ceil((field.high[c] - field.low[c]) / cell)) + 1;
        for (int k = 0; k < cells_.z; k += block)
            for (int j = 0; j < cells_.y; j += block)
                for (int i = 0; i < cells_.x; i += block) visit({i, j, k});
        for (const Crossing& crossing : crossings_) add_quad(crossing);
    }
    [[nodiscard]] PictureMesh take() { return std::move(mesh_); }

private:
    static constexpr int block = 8; // cells along an edge of a block that is visited or skipped
    using Cell = glm::ivec3;
    struct Crossing {
        Cell from;
        int axis;
        bool leaves; // the field grows along the axis
    };

    [[nodiscard]] glm::dvec3 corner(const Cell& cell) const { return field_.low + cell_ * glm::dvec3(cell); }
    [[nodiscard]] static std::uint64_t key(const Cell& cell) {
        return static_cast<std::uint64_t>(cell.x) | static_cast<std::uint64_t>(cell.y) << 20 |
               static_cast<std::uint64_t>(cell.z) << 40;
    }
    [[nodiscard]] static std::size_t at(int i, int j, int k) {
        return static_cast<std::size_t>((k * (block + 1) + j) * (block + 1) + i);
    }

    void visit(const Cell& first) {
        const glm::dvec3 middle = corner(first) + 0.5 * block * cell_;
        if (std::abs(field_.value(middle)) > field_.steepness * 0.5 * std::sqrt(3.0) * block * cell_) return;
        for (int k = 0; k <= block; ++k)
            for (int j = 0; j <= block; ++j)
                for (int i = 0; i <= block; ++i) values_[at(i, j, k)] = field_.value(corner(first + Cell(i, j, k)));
        for (int k = 0; k < block; ++k)
            for (int j = 0; j < block; ++j)
                for (int i = 0; i < block; ++i) add_vertex(first, {i, j, k});
    }

    void add_vertex(const Cell& first, const Cell& in_block) {
        glm::dvec3 sum(0.0);
        int crossed = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 4; ++side) {
                Cell from(0);
                from[(axis + 1) % 3] = side % 2;
                from[(axis + 2) % 3] = side / 2;
                Cell to = from;
                to[axis] = 1;
                const Cell a = in_block + from;
                const Cell b = in_block + to;
                const double at_a = values_[at(a.x, a.y, a.z)];
                const double at_b = values_[at(b.x, b.y, b.z)];
                if ((at_a < 0.0) == (at_b < 0.0)) continue;
                sum += glm::mix(corner(first + a), corner(first + b), at_a / (at_a - at_b));
                ++crossed;
                if (side == 0) crossings_.push_back({first + in_block, axis, at_a < 0.0});
            }
        if (crossed == 0) return;
        vertices_[key(first + in_block)] = static_cast<std::int32_t>(mesh_.points.size());
        mesh_.points.push_back(onto_surface(sum / static_cast<double>(crossed), corner(first + in_block)));
    }

    // Moves a point along the gradient to the surface, within the cell that begins at `low`. A margin keeps vertices of
    // neighbouring cells apart.
    [[nodiscard]] glm::dvec3 onto_surface(glm::dvec3 p, const glm::dvec3& low) const {
        for (int step = 0; step < 2; ++step) {
            const double h = 0.01 * cell_;
            glm::dvec3 gradient;
            for (int c = 0; c < 3; ++c) {
                glm::dvec3 offset(0.0);
                offset[c] = h;
                gradient[c] = (field_.value(p + offset) - field_.value(p - offset)) / (2.0 * h);
            }
            p -= gradient * (field_.value(p) / std::max(glm::dot(gradient, gradient), 1e-12));
        }
        return glm::clamp(p, low + 0.05 * cell_, low + 0.95 * cell_);
    }

    void add_quad(const Crossing& crossing) {
        const int u = (crossing.axis + 1) % 3;
        const int v = (crossing.axis + 2) % 3;
        std::array<std::int32_t, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
            Cell cell = crossing.from;
            if (i == 0 || i == 3) --cell[u];
            if (i < 2) --cell[v];
            const auto found = vertices_.find(key(cell));
            if (found == vertices_.end()) return; // the box cuts the surface
            corners[i] = found->second;
        }
        if (!crossing.leaves) std::swap(corners[1], corners[3]);
        const auto length = [&](std::size_t a, std::size_t b) {
            return glm::distance(mesh_.points[static_cast<std::size_t>(corners[a])],
                                 mesh_.points[static_cast<std::size_t>(corners[b])]);
        };
        const std::size_t turn = length(0, 2) <= length(1, 3) ? 0 : 1;
        mesh_.faces.push_back({corners[turn], corners[turn + 1], corners[turn + 2]});
        mesh_.faces.push_back({corners[turn], corners[turn + 2], corners[(turn + 3) % 4]});
    }

    const Field& field_;
    double cell_;
    Cell cells_;
    std::array<double, static_cast<std::size_t>((block + 1) * (block + 1) * (block + 1))> values_;
    std::unordered_map<std::uint64_t, std::int32_t> vertices_;
    std::vector<Crossing> crossings_;
    PictureMesh mesh_;
};

// Returns the mesh of a field with this number of faces, up to 3 %. The number grows with the square of the resolution.
[[nodiscard]] inline PictureMesh mesh_of(const Field& field, double faces) {
    double cell = glm::length(field.high - field.low) / 64.0;
    for (int attempt = 0;; ++attempt) {
        PictureMesh mesh = SurfaceNets(field, cell).take();
        const double excess = static_cast<double>(mesh.faces.size()) / faces;
        if (attempt == 5 || std::abs(excess - 1.0) < 0.03) return mesh;
        cell *= std::sqrt(excess);
    }
}

// Divides each face into four flat ones.
[[nodiscard]] inline PictureMesh divided(const PictureMesh& coarse) {
    PictureMesh mesh;
    mesh.points = coarse.points;
    std::unordered_map<std::uint64_t, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const std::uint64_t edge = static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
        const auto [found, is_new] = middles.try_emplace(edge, static_cast<std::int32_t>(mesh.points.size()));
        if (is_new)
            mesh.points.push_back(
                0.5 * (mesh.points[static_cast<std::size_t>(a)] + mesh.points[static_cast<std::size_t>(b)]));
        return found->second;
    };
    for (const Face& f : coarse.faces) {
        const Face m = {middle(f[0], f[1]), middle(f[1], f[2]), middle(f[2], f[0])};
        mesh.faces.insert(mesh.faces.end(), {{f[0], m[0], m[2]}, {f[1], m[1], m[0]}, {f[2], m[2], m[1]}, m});
    }
    return mesh;
}

} // namespace bench

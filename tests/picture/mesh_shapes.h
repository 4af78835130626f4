// SPDX-License-Identifier: MIT
// Makes meshes of known shapes for tests of the picture's steps.
#pragma once

#include "picture/faces.h"
#include "picture/shape.h"
#include "support/meshes.h"

#include <array>
#include <cmath>

namespace picture_tests {

[[nodiscard]] inline hrbfnpr::picture::Shape shape_of(const hrbfnpr::test::Triangles& from,
                                                      hrbfnpr::picture::Pool& pool) {
    hrbfnpr::picture::Shape shape(pool);
    for (std::size_t i = 0; i < from.vertices.size(); i += 3)
        shape.points.emplace_back(from.vertices[i], from.vertices[i + 1], from.vertices[i + 2]);
    for (std::size_t i = 0; i < from.triangles.size(); i += 3)
        shape.triangles.push_back({from.triangles[i], from.triangles[i + 1], from.triangles[i + 2]});
    return shape;
}

// Makes a wall from `corner` along u and v, which are each divided into `cells` cells.
[[nodiscard]] inline hrbfnpr::test::Triangles wall(const std::array<double, 3>& corner, const std::array<double, 3>& u,
                                                   const std::array<double, 3>& v, int cells = 12) {
    hrbfnpr::test::Triangles mesh;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            std::array<double, 3> p{};
            for (std::size_t c = 0; c < 3; ++c) p[c] = corner[c] + (u[c] * j + v[c] * i) / cells;
            static_cast<void>(mesh.add(p[0], p[1], p[2]));
        }
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const std::int32_t a = i * (cells + 1) + j, b = a + cells + 1;
            mesh.face(a, a + 1, b + 1);
            mesh.face(a, b + 1, b);
        }
    return mesh;
}

// Makes an open pipe of radius 1 around the y axis, from y = 0 to 3.
[[nodiscard]] inline hrbfnpr::test::Triangles pipe() {
    constexpr int around = 24;
    constexpr int along = 12;
    hrbfnpr::test::Triangles mesh;
    for (int ring = 0; ring < along; ++ring)
        for (int i = 0; i < around; ++i) {
            const double angle = 6.283185307179586 * i / around;
            static_cast<void>(mesh.add(std::cos(angle), 3.0 * ring / (along - 1), std::sin(angle)));
        }
    for (int ring = 0; ring + 1 < along; ++ring)
        for (int i = 0; i < around; ++i) {
            const std::int32_t a = ring * around + i, b = ring * around + (i + 1) % around;
            mesh.face(a, a + around, b + around);
            mesh.face(a, b + around, b);
        }
    return mesh;
}

// Makes the same pipe around the z axis, so that it crosses pipe().
[[nodiscard]] inline hrbfnpr::test::Triangles pipe_across() {
    hrbfnpr::test::Triangles mesh = pipe();
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        const std::array<double, 3> p{mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]};
        mesh.vertices[i] = p[2] - 1.0;
        mesh.vertices[i + 1] = p[0] + 1.5;
        mesh.vertices[i + 2] = p[1] + 0.3;
    }
    return mesh;
}

// Makes a mesh of the library that has all parts.
[[nodiscard]] inline hrbfnpr::picture::Mesh mesh_of(hrbfnpr_context& context, const hrbfnpr::test::Triangles& from) {
    namespace picture = hrbfnpr::picture;
    auto desc = picture::defaults<hrbfnpr_mesh_desc>(hrbfnpr_mesh_desc_init);
    desc.parts = HRBFNPR_PARTS_ALL;
    desc.vertices = {from.vertices.data(), static_cast<std::int64_t>(from.vertices.size() / 3), 0,
                     HRBFNPR_SCALAR_FLOAT64, 3};
    desc.triangles = {from.triangles.data(), static_cast<std::int64_t>(from.faces()), 0, HRBFNPR_SCALAR_INT32, 3};
    return picture::make<picture::Mesh>([&](hrbfnpr_mesh** made, hrbfnpr_error* error) {
        return hrbfnpr_mesh_create(&context, &desc, nullptr, made, error);
    });
}

} // namespace picture_tests

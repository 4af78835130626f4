// SPDX-License-Identifier: MIT
// Makes a usable triangle mesh from a caller's arrays: welds vertices, drops faces without area, orients faces, and
// drops parts inside other parts or makes them cavities.
#pragma once

#include "base/assert.h"
#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "geometry/vec_array.h"

#include <array>
#include <cstdint>
#include <limits>

namespace hrbfnpr::mesh {

// The values equal the HRBFNPR_PARTS_ and HRBFNPR_FACES_ constants of hrbfnpr.h.
enum class Parts : std::uint32_t { outer = 0, all = 1, largest = 2, solids = 3, automatic = 4 };
enum class Faces : std::uint32_t { turn = 0, keep = 1 };

// The largest coordinate. Squares of coordinates and of areas then stay in the range of a double.
inline constexpr double largest_coordinate = 1e60;
inline constexpr std::int64_t most_vertices = (std::int64_t{1} << 31U) - 1;
inline constexpr std::int64_t most_faces = std::int64_t{1} << 29U;

struct MeshInput {
    base::InView vertices;  // 3 components, float32 or float64
    base::InView triangles; // 3 components, int32, int64 or uint32
    Parts parts = Parts::outer;
    Faces faces = Faces::turn;
    double crease_angle = 60.0; // in degrees
};

struct MeshReport {
    bool closed = false;
    std::int64_t given_vertices = 0;
    std::int64_t given_faces = 0;
    std::int64_t welded_vertices = 0;
    std::int64_t degenerate_faces = 0;
    std::int64_t repeated_faces = 0;
    std::int64_t turned_faces = 0;
    std::int64_t components = 0;
    std::int64_t turned_components = 0;
    std::int64_t nested_components = 0;
    std::int64_t left_out_components = 0;
    std::int64_t cavities = 0; // kept components that are walls of cavities
    std::int64_t left_out_faces = 0;
    std::int64_t boundary_edges = 0;
    std::int64_t boundary_loops = 0;
    std::int64_t nonmanifold_edges = 0;
    std::int64_t contrary_edges = 0;
    std::int64_t euler_characteristic = 0;
    std::int64_t genus = -1;
    double area = 0.0;
    double volume = std::numeric_limits<double>::quiet_NaN();
    double seconds = 0.0;
};

using Triangle = std::array<std::int32_t, 3>;

// The faces and vertices that make_mesh() keeps.
struct Mesh {
    explicit Mesh(base::Memory& memory) noexcept
        : vertex(memory), triangle(memory), component(memory), given_face(memory), border(memory),
          corner_normal(memory) {}

    base::Array<glm::dvec3> vertex;
    base::Array<Triangle> triangle;       // counter-clockwise as seen from outside
    base::Array<std::int32_t> component;  // for each face: the index of its component, from 0
    base::Array<std::int32_t> given_face; // for each face: its index in the input
    // For each face: bit k is set if no other face shares the side from corner k. Bit k + 3 is set if corner k is an
    // end of such a side, either of this face or of another face.
    base::Array<std::uint8_t> border;
    base::Array<glm::dvec3> corner_normal; // three unit normals for each face
    geometry::Bounds bounds;
    MeshReport report;

    [[nodiscard]] std::int64_t faces() const noexcept { return triangle.size(); }
    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::int64_t face) const noexcept {
        HRBFNPR_ASSERT(face >= 0 && face < faces());
        const Triangle& t = triangle[face];
        return {vertex[t[0]], vertex[t[1]], vertex[t[2]]};
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return vertex.bytes() + triangle.bytes() + component.bytes() + given_face.bytes() + border.bytes() +
               corner_normal.bytes();
    }
};

// Returns whether a place of a face is on the border of the mesh.
[[nodiscard]] bool on_border(const Mesh& mesh, std::int64_t face, const glm::dvec3& place) noexcept;

// Returns the normal of a triangle. Its length is twice the area.
[[nodiscard]] inline glm::dvec3 doubled_area(const std::array<glm::dvec3, 3>& p) noexcept {
    return glm::cross(p[1] - p[0], p[2] - p[0]);
}

// Returns the barycentric coordinates of a place in the plane of a face. They sum up to 1.
[[nodiscard]] glm::dvec3 shares_of(const std::array<glm::dvec3, 3>& p, const glm::dvec3& place) noexcept;

// Throws Error{invalid_argument, out_of_memory, cancelled}. The message of invalid_argument names the face and the
// index, or the vertex.
[[nodiscard]] Mesh make_mesh(const base::Work& work, const MeshInput& input);

} // namespace hrbfnpr::mesh

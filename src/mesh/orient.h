// SPDX-License-Identifier: MIT
// The second half of make_mesh(): turns faces to agree with their neighbours, and measures the components.
#pragma once

#include "mesh/edges.h"

#include <utility>

namespace hrbfnpr::mesh {

struct Component {
    std::int64_t faces = 0;
    double area = 0.0;
    double volume = 0.0;     // the volume, with holes closed by fans of triangles
    double holes = 0.0;      // the total area of the holes
    bool closed = true;      // True if equally many faces run through each edge in both directions.
    std::int32_t around = 0; // the number of closed components that it lies inside
    bool turned = false;

    [[nodiscard]] bool is_nested() const noexcept { return around > 0; }
    // A closed component inside an odd number of closed components is the wall of a cavity.
    [[nodiscard]] bool is_cavity() const noexcept { return closed && around % 2 == 1; }
};

inline void turn(Triangle& triangle) noexcept { std::swap(triangle[1], triangle[2]); }

// Turns faces so that each patch has the orientation of most of its area. A patch ends at edges that do not have
// exactly two faces. Returns the number of faces turned.
std::int64_t orient_consistently(const base::Work& work, const base::Array<glm::dvec3>& vertex,
                                 base::Array<Triangle>& triangle);

[[nodiscard]] base::Array<Component> measure_components(const base::Work& work, const base::Array<glm::dvec3>& vertex,
                                                        const base::Array<Triangle>& triangle,
                                                        const base::Array<std::int32_t>& component, std::int64_t count);

// Returns whether a component encloses a negative volume and is closed, except for small holes.
[[nodiscard]] bool inside_out(const Component& component) noexcept;

// Counts for each component the closed components that it lies inside. Rays from some of its faces decide.
void find_nested(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle,
                 const base::Array<std::int32_t>& component, base::Array<Component>& measured);

} // namespace hrbfnpr::mesh

// SPDX-License-Identifier: MIT
// The second half of make_mesh(): faces that agree with those beside them, and components with what is known of them.
#pragma once

#include "mesh/edges.h"

#include <utility>

namespace hrbfnpr::mesh {

struct Component {
    std::int64_t faces = 0;
    double area = 0.0;
    double volume = 0.0; // enclosed with its holes closed by fans
    double holes = 0.0;  // their area
    bool closed = true;  // Each edge is run through as often one way as the other.
    bool nested = false; // It lies inside another.
    bool turned = false;
};

inline void turn(Triangle& triangle) noexcept { std::swap(triangle[1], triangle[2]); }

// Turns faces to agree with most of their patch, which ends at edges that not exactly two faces have. Returns how many
// it turned.
std::int64_t agree(const base::Work& work, const base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle);

[[nodiscard]] base::Array<Component> measure_components(const base::Work& work, const base::Array<glm::dvec3>& vertex,
                                                        const base::Array<Triangle>& triangle,
                                                        const base::Array<std::int32_t>& component, std::int64_t count);

// Tells whether a component encloses a volume, but for small holes, and that is negative.
[[nodiscard]] bool inside_out(const Component& component) noexcept;

// Sets `nested` of components that lie wholly inside a closed one, as rays from some of their faces tell.
void find_nested(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle,
                 const base::Array<std::int32_t>& component, base::Array<Component>& measured);

} // namespace hrbfnpr::mesh

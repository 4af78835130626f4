// SPDX-License-Identifier: MIT
// Faces that agree with those beside them, and closed components that look outward.
#pragma once

#include "mesh/edges.h"

namespace hrbfnpr::mesh {

// What is known of each component.
struct Component {
    std::int64_t faces = 0;
    double area = 0.0;
    double volume = 0.0; // enclosed with its holes closed by fans
    double holes = 0.0;  // their area
    bool closed = true;  // each edge is run through as often one way as the other
    bool manifold = true;
    bool nested = false; // inside another
    bool turned = false;
};

// Turns faces to agree with most of their patch, which ends at edges that not exactly two faces have; how many.
std::int64_t agree(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                   const base::Progress& progress);

[[nodiscard]] base::Array<Component> measure_components(const base::Runtime& runtime,
                                                        const base::Array<glm::dvec3>& vertex,
                                                        const base::Array<Triangle>& triangle,
                                                        const base::Array<std::int32_t>& component, std::int64_t count,
                                                        const base::Progress& progress);

// Whether it is inside out: it encloses a volume but for small holes, and that is negative.
[[nodiscard]] bool inside_out(const Component& component) noexcept;

void turn(Triangle& triangle) noexcept;

} // namespace hrbfnpr::mesh

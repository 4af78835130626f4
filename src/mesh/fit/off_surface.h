// SPDX-License-Identifier: MIT
// Centres off a closed mesh, where f is held to the signed distance: they keep the surface from going where there is
// no mesh.
#pragma once

#include "geometry/vec_array.h"
#include "mesh/fit/outer.h"

namespace hrbfnpr::mesh {

struct OffSurface {
    explicit OffSurface(base::Memory& memory) noexcept : position(memory), normal(memory), value(memory) {}

    // Adds places of a surface that are farther from the mesh than the tolerance, farthest first, each as far from
    // those before as it is from the mesh; how many.  distance: theirs from the mesh.
    std::int64_t add_from(const geometry::VecArray& place, const base::Array<double>& distance, double tolerance,
                          std::int64_t most, const OuterFaces& faces);
    // Only the first `count` stay.
    void shorten(std::int64_t count) {
        position.resize(count);
        normal.resize(count);
        value.resize(count);
    }

    [[nodiscard]] std::int64_t count() const noexcept { return value.size(); }

    geometry::VecArray position;
    geometry::VecArray normal;
    base::Array<double> value;
};

} // namespace hrbfnpr::mesh

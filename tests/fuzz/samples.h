// SPDX-License-Identifier: MIT
// Points with normals on a few surfaces, for fits and meshes.
#pragma once

#include "input.h"

#include <hrbfnpr.h>

namespace fuzz {

struct Samples {
    std::vector<double> points; // x y z of each
    std::vector<double> normals;

    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(points.size() / 3); }
    void add(const double (&point)[3], const double (&normal)[3]) {
        points.insert(points.end(), point, point + 3);
        normals.insert(normals.end(), normal, normal + 3);
    }
};

enum class Surface { sphere, torus, sheet, two_spheres, nested_spheres, box, line, one_place, count };

Samples samples_of(Surface surface, int count);

// Samples of a surface that the input selects: moved, scaled, with noise and some odd numbers.
Samples some_samples(Input& input, int most);

} // namespace fuzz

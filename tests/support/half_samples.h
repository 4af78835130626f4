// SPDX-License-Identifier: MIT
// Samples of a part of a surface, like those of a scanner that stands on one side.
#pragma once

#include "base/memory.h"
#include "geometry/vec_array.h"

#include <cmath>
#include <vector>

namespace hrbfnpr::test {

struct PartSamples {
    std::vector<double> points, normals; // packed

    void add(const glm::dvec3& p, const glm::dvec3& n) {
        for (int c = 0; c < 3; ++c) points.push_back(p[c]);
        for (int c = 0; c < 3; ++c) normals.push_back(n[c]);
    }
    [[nodiscard]] static geometry::VecArray unpacked(base::Memory& memory, const std::vector<double>& packed) {
        geometry::VecArray array(memory);
        for (std::size_t i = 0; i < packed.size(); i += 3) array.push_back({packed[i], packed[i + 1], packed[i + 2]});
        return array;
    }
};

// Returns those of `count` even samples of the unit sphere that have z > above.
inline PartSamples sphere_cap(int count, double above) {
    PartSamples samples;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double turn = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - z * z);
        const glm::dvec3 p(r * std::cos(turn), r * std::sin(turn), z);
        if (z > above) samples.add(p, p);
    }
    return samples;
}

// Samples of the half with y >= 0 of a torus with these radii.
inline PartSamples half_torus(double ring, double tube, int around_ring = 24, int around_tube = 16) {
    PartSamples samples;
    for (int i = 0; i < around_ring; ++i) {
        const double a = 3.141592653589793 * i / (around_ring - 1);
        for (int j = 0; j < around_tube; ++j) {
            const double b = 6.283185307179586 * j / around_tube;
            const glm::dvec3 out(std::cos(a), std::sin(a), 0.0);
            const glm::dvec3 n = std::cos(b) * out + glm::dvec3(0.0, 0.0, std::sin(b));
            samples.add(ring * out + tube * n, n);
        }
    }
    return samples;
}

} // namespace hrbfnpr::test

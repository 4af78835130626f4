// SPDX-License-Identifier: MIT
// Exact implicits for hrbfnpr_model_create_custom: the plane z = 0, the unit sphere, and a torus about the z axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bench {

inline std::int32_t plane(void*, std::int64_t count, const double* points, double* value, double* gradient, double*) {
    for (std::int64_t i = 0; i < count; ++i) {
        value[i] = points[3 * i + 2];
        if (gradient == nullptr) continue;
        gradient[3 * i] = gradient[3 * i + 1] = 0.0;
        gradient[3 * i + 2] = 1.0;
    }
    return 0;
}

inline std::int32_t sphere(void*, std::int64_t count, const double* points, double* value, double* gradient, double*) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        value[i] = r - 1.0;
        for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = p[c] / std::max(r, 1e-12);
    }
    return 0;
}

// The radius of the torus's tube, which goes round a circle of radius 1.
inline constexpr double tube = 0.4;

inline std::int32_t torus(void*, std::int64_t count, const double* points, double* value, double* gradient, double*) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        const double ring = std::max(std::hypot(p[0], p[1]), 1e-12);
        const double out = std::max(std::hypot(ring - 1.0, p[2]), 1e-12);
        value[i] = out - tube;
        if (gradient == nullptr) continue;
        gradient[3 * i] = (ring - 1.0) / out * p[0] / ring;
        gradient[3 * i + 1] = (ring - 1.0) / out * p[1] / ring;
        gradient[3 * i + 2] = p[2] / out;
    }
    return 0;
}

} // namespace bench

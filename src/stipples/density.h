// SPDX-License-Identifier: MIT
// Densities on the surface: where stipples are to be denser.
#pragma once

#include <cstdint>

namespace hrbfnpr::stipples {

// Same numbers as HRBFNPR_DENSITY_...
enum class Density : std::uint32_t { uniform = 0, curvature = 1, callback = 2 };

using DensityFn = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                   double* density);

struct DensitySettings {
    Density kind = Density::uniform;
    double strength = 0.5;
    DensityFn function = nullptr;
    void* user = nullptr;
};

} // namespace hrbfnpr::stipples

// SPDX-License-Identifier: MIT
// Normals of a cloud whatever its noise and size.
#pragma once

#include "orient/least_energy.h"

namespace hrbfnpr::orient {

inline constexpr double doubtful = 0.5; // a confidence that is warned of

struct CloudNormals {
    explicit CloudNormals(base::Memory& memory) noexcept : fitted(memory) {}

    LeastEnergy fitted; // its form is null if the cloud was replaced by means of its points
    double noise = 0.0; // standard deviation, in spacings
    double confidence = 0.0;
};

// given: see least_energy().
[[nodiscard]] CloudNormals normals_of_cloud(const base::Runtime& runtime, const Cloud& cloud, const Near& near,
                                            const geometry::VecArray* given, const base::Progress& progress);

} // namespace hrbfnpr::orient

// SPDX-License-Identifier: MIT
// Finds normals for points, and repairs given normals.
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "orient/given_normals.h"
#include "orient/outward.h"

#include <limits>

namespace hrbfnpr::orient {

// The fields are those of hrbfnpr_orient_desc. Views have 3 components. The number of normals is 0 or the number of
// points; the boundary checks this.
struct OrientInput {
    base::InView points;
    base::InView normals;
    NormalMode mode = NormalMode::automatic;
    glm::dvec3 up{0.0, 0.0, 1.0};
    glm::dvec3 viewpoint{0.0};
    bool has_viewpoint = false;
};

struct OrientReport {
    NormalMode found = NormalMode::given;
    std::int64_t turned = 0;
    std::int64_t made = 0;
    std::int64_t merged = 0;
    double direction_change = std::numeric_limits<double>::quiet_NaN(); // degrees
    double noise = 0.0;                                                 // in the caller's unit
    double spacing = 0.0;                                               // in the caller's unit
    double energy = 0.0;
    double confidence = 0.0;
    bool closed = false;
    OutwardBy outward_by = OutwardBy::inside;
    std::int64_t components = 0;
    double seconds = 0.0;
};

struct Orientation {
    explicit Orientation(base::Memory& memory) noexcept : normal(memory) {}

    geometry::VecArray normal; // One for each given point. Given normals that stay are copied exactly.
    OrientReport report;
};

// Throws Error{invalid_argument, out_of_memory, cancelled}.
[[nodiscard]] Orientation orient(const base::Work& work, const OrientInput& input);

// Returns whether all given normals clearly point into a closed surface. It uses only some thousand points, so it is
// fast.
[[nodiscard]] bool plainly_inward(const base::Work& work, const base::InView& points, const base::InView& normals);

} // namespace hrbfnpr::orient

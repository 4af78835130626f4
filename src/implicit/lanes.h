// SPDX-License-Identifier: MIT
// Some points of a batch side by side, so that one function is evaluated at all of them at once, and the fields that
// come back and go to the points' places in the batch.
#pragma once

#include "base/assert.h"
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

template <std::size_t size>
struct PointLanes {
    double at[3][size];
    std::int32_t index[size]; // in the batch
    std::int64_t count = 0;

    void add(const glm::dvec3& point, std::int64_t i) noexcept {
        HRBFNPR_ASSERT(count < std::int64_t{size});
        for (int c = 0; c < 3; ++c) at[c][count] = point[c];
        index[count++] = static_cast<std::int32_t>(i);
    }
    [[nodiscard]] PointBatch points() const noexcept { return {at[0], at[1], at[2], count}; }
};

// Calls visit(c, column) for the columns that are wanted: 0 is the value, from 1 on the gradient, from 4 on the
// Hessian.
template <class Visit>
void for_columns(const FieldBatch& fields, Visit&& visit) {
    if (fields.value != nullptr) visit(std::size_t{0}, fields.value);
    for (std::size_t c = 0; fields.wants_gradient() && c < 3; ++c) visit(1 + c, fields.gradient[c]);
    for (std::size_t c = 0; fields.wants_hessian() && c < 6; ++c) visit(4 + c, fields.hessian[c]);
}

// Value, gradient and Hessian of each lane.
template <std::size_t size>
struct FieldLanes {
    double field[10][size];

    [[nodiscard]] FieldBatch fields(bool value, bool gradient, bool hessian) noexcept {
        FieldBatch fields;
        if (value) fields.value = field[0];
        for (std::size_t c = 0; gradient && c < 3; ++c) fields.gradient[c] = field[1 + c];
        for (std::size_t c = 0; hessian && c < 6; ++c) fields.hessian[c] = field[4 + c];
        return fields;
    }
    // Moves lane k to element index[k] of the fields that are wanted.
    void scatter(const std::int32_t* index, std::int64_t count, const FieldBatch& to) const noexcept {
        HRBFNPR_ASSERT(count <= std::int64_t{size});
        for_columns(to, [&](std::size_t c, double* column) {
            for (std::int64_t k = 0; k < count; ++k) column[index[k]] = field[c][k];
        });
    }
};

[[nodiscard]] inline glm::dvec3 point_at(const PointBatch& points, std::int64_t i) noexcept {
    HRBFNPR_ASSERT(i >= 0 && i < points.count);
    return {points.x[i], points.y[i], points.z[i]};
}

} // namespace hrbfnpr::implicit

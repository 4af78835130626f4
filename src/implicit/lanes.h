// SPDX-License-Identifier: MIT
// Tools for functions that combine several other functions. PointLanes gathers some points of a batch, so that a
// function is evaluated at all of them at once. FieldLanes holds the resulting fields. A Jet holds the fields at one
// point.
#pragma once

#include "base/assert.h"
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

template <std::size_t size>
struct PointLanes {
    double at[3][size];
    std::int32_t index[size]; // each point's index in the batch
    std::int64_t count = 0;

    void add(const glm::dvec3& point, std::int64_t i) noexcept {
        HRBFNPR_ASSERT(count < std::int64_t{size});
        for (int c = 0; c < 3; ++c) at[c][count] = point[c];
        index[count++] = static_cast<std::int32_t>(i);
    }
    [[nodiscard]] PointBatch points() const noexcept { return {at[0], at[1], at[2], count}; }
};

// Calls visit(c, column) for each wanted column: 0 is the value, 1 to 3 are the gradient, 4 to 9 the Hessian.
template <class Visit>
void for_columns(const FieldBatch& fields, Visit&& visit) {
    if (fields.value != nullptr) visit(std::size_t{0}, fields.value);
    for (std::size_t c = 0; fields.wants_gradient() && c < 3; ++c) visit(1 + c, fields.gradient[c]);
    for (std::size_t c = 0; fields.wants_hessian() && c < 6; ++c) visit(4 + c, fields.hessian[c]);
}

// The value and derivatives of a function, or of a weight, at a point. Members have no initializers, so that large
// blocks are not cleared.
struct Jet {
    double value;
    glm::dvec3 gradient;
    std::array<double, 6> hessian; // in the order xx xy xz yy yz zz

    // Returns column c, numbered as in for_columns.
    [[nodiscard]] double& operator[](std::size_t c) noexcept {
        HRBFNPR_ASSERT(c < 10);
        return c == 0 ? value : c < 4 ? gradient[static_cast<glm::length_t>(c) - 1] : hessian[c - 4];
    }
    void add(const Jet& other) noexcept {
        value += other.value;
        gradient += other.gradient;
        for (std::size_t c = 0; c < 6; ++c) hessian[c] += other.hessian[c];
    }
};

// The value, gradient and Hessian of several points, one in each lane.
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
    // Returns the jet of a lane. Only its first `columns` columns are set: 1 for the value, 4 with the gradient, 10
    // with the Hessian.
    [[nodiscard]] Jet take(std::int64_t k, int columns) const noexcept {
        Jet jet{};
        jet.value = field[0][k];
        for (int c = 0; c < 3 && columns > 1; ++c) jet.gradient[c] = field[1 + c][k];
        for (std::size_t c = 0; c < 6 && columns > 4; ++c) jet.hessian[c] = field[4 + c][k];
        return jet;
    }
    void set(std::int64_t k, const Jet& jet, int columns) noexcept {
        field[0][k] = jet.value;
        for (int c = 0; c < 3 && columns > 1; ++c) field[1 + c][k] = jet.gradient[c];
        for (std::size_t c = 0; c < 6 && columns > 4; ++c) field[4 + c][k] = jet.hessian[c];
    }
    // Copies lane k to element index[k] of the fields that are wanted.
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

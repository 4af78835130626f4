// SPDX-License-Identifier: MIT
#include "implicit/implicit.h"

namespace hrbfnpr::implicit {

FieldBatch FieldBatch::from(std::int64_t begin) const noexcept {
    FieldBatch rest = *this;
    if (rest.value != nullptr) rest.value += begin;
    if (wants_gradient())
        for (double*& pointer : rest.gradient) pointer += begin;
    if (wants_hessian())
        for (double*& pointer : rest.hessian) pointer += begin;
    return rest;
}

PointBatch slice(const PointBatch& points, std::int64_t begin, std::int64_t end) noexcept {
    return {points.x + begin, points.y + begin, points.z + begin, end - begin};
}

double Implicit::diagonal() const noexcept {
    const double diagonal = bounds().diagonal();
    return diagonal > 0.0 ? diagonal : 1.0; // a single sample has a diagonal of 0
}

} // namespace hrbfnpr::implicit

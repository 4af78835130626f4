// SPDX-License-Identifier: MIT
// The frame around the sums of an HRBF: normalisation and polynomial before them, and the way back after.
#pragma once

#include "implicit/hermite_sums.h"
#include "implicit/hrbf.h"

namespace hrbfnpr::implicit {

// Points whose results are accumulated together: they stay in the first-level cache while
// all centres pass by.
inline constexpr std::int64_t block_size = 64;

// The centres, as the sums take them.
[[nodiscard]] inline Sources sources_of(const HrbfData& data) noexcept {
    return {data.centre_position.x.data(),
            data.centre_position.y.data(),
            data.centre_position.z.data(),
            data.alpha.data(),
            data.beta.x.data(),
            data.beta.y.data(),
            data.beta.z.data(),
            data.count()};
}

// Normalised points and what has been summed up for them.
struct Block {
    double x[block_size];
    double y[block_size];
    double z[block_size];
    double value[block_size];
    double gradient[3][block_size];
    double hessian[6][block_size];
};

// Normalises the points, block_size at most, and starts the sums with the polynomial.
void start(const HrbfData& data, const PointBatch& points, Block& block) noexcept;
// Undoes the normalisation: f = scale g, so grad f = grad g and Hess f = Hess g / scale.
void finish(const HrbfData& data, const Block& block, std::int64_t count, const FieldBatch& fields) noexcept;

} // namespace hrbfnpr::implicit

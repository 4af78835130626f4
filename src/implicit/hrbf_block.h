// SPDX-License-Identifier: MIT
// The steps before and after the sums of an HRBF: normalisation, polynomial, and the conversion of results to the
// caller's coordinates.
#pragma once

#include "implicit/hermite_sums.h"
#include "implicit/hrbf.h"

namespace hrbfnpr::implicit {

// The number of points whose results are accumulated together. The results stay in the first-level cache while all
// centres are summed.
inline constexpr std::int64_t block_size = 64;

// Returns the centres in the form that the sum functions take.
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

// Normalised points, and their unfinished sums.
struct Block {
    double x[block_size];
    double y[block_size];
    double z[block_size];
    double value[block_size];
    double gradient[3][block_size];
    double hessian[6][block_size];
};

// Normalises at most block_size points, and starts their sums with the polynomial.
void start(const HrbfData& data, const PointBatch& points, Block& block) noexcept;
// Undoes the normalisation: f = scale g, so grad f = grad g and Hess f = Hess g / scale.
void finish(const HrbfData& data, const Block& block, std::int64_t count, const FieldBatch& fields) noexcept;

} // namespace hrbfnpr::implicit

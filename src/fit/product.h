// y = A x of a Hermite system, without A.
#pragma once

#include "fit/system.h"
#include "implicit/hermite_sums.h"

namespace hrbfnpr::fit {

// Not thread-safe: it keeps its vectors.
class HermiteProduct {
public:
    HermiteProduct(const base::Runtime& runtime, const geometry::VecArray& position,
                   const HermiteSystem::Options& options);

    // 4 numbers a sample: value, x, y, z.  x and y do not overlap.
    void multiply(const double* x, double* y, const base::Progress& progress);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    [[nodiscard]] implicit::Sources sources() const noexcept;

    const base::Runtime& runtime_;
    const geometry::VecArray& position_;
    HermiteSystem::Options options_;
    base::Array<double> alpha_;
    geometry::VecArray beta_;
    base::Array<double> value_;
    geometry::VecArray gradient_;
};

} // namespace hrbfnpr::fit

// SPDX-License-Identifier: MIT
// y = A x of a Hermite system, without A.  Where the kernel ends, or is 0 to rounding, pairs are left out.
#pragma once

#include "fit/system.h"
#include "implicit/far_field.h"
#include "implicit/hermite_sums.h"

#include <memory>

namespace hrbfnpr::fit {

// Not thread-safe: it keeps its vectors.
class HermiteProduct {
public:
    // tolerance: relative to the right-hand side, for which a fast product is accurate enough.
    HermiteProduct(const base::Work& work, const geometry::VecArray& position, const HermiteSystem::Options& options,
                   double tolerance);

    // 4 numbers a sample: value, x, y, z.  x and y do not overlap.
    void multiply(const double* x, double* y, const base::Progress& progress);
    // The exact product's elements for samples 0, stride, 2 stride, ...
    [[nodiscard]] base::Array<double> multiply_some(const double* x, std::int64_t stride,
                                                    const base::Progress& progress);
    // What regularization adds to the product.
    void add_diagonal(const double* x, double* y) const noexcept;
    // Whether multiply() is fast and only accurate enough for conjugate gradients to converge.
    [[nodiscard]] bool approximate() const noexcept { return far_ != nullptr; }
    // Makes it ten times as accurate; false if it can't be.
    bool refine(const base::Progress& progress);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void make_far_field(const base::Progress& progress);
    void make_boxes();
    template <class Sum>
    void for_runs_in_reach(const geometry::Bounds& box, const Sum& sum) const;
    void load(const double* x) noexcept;
    void sum_directly(const geometry::VecArray& at, base::Array<double>& value, geometry::VecArray& gradient,
                      const base::Progress& progress) const;

    const base::Runtime& runtime_;
    const geometry::VecArray& position_;
    HermiteSystem::Options options_;
    implicit::SourceTreeOptions far_options_;
    base::Array<double> alpha_;
    geometry::VecArray beta_;
    base::Array<double> value_;
    geometry::VecArray gradient_;
    std::unique_ptr<implicit::FarField> far_; // none: all pairs, one by one
    base::Array<geometry::Bounds> boxes_;     // of box_samples consecutive samples each
};

} // namespace hrbfnpr::fit

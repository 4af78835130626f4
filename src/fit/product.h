// SPDX-License-Identifier: MIT
// The product y = A x of a Hermite system, without A. Pairs where the kernel is 0, or below rounding, are left out.
#pragma once

#include "base/work.h"
#include "fit/system.h"
#include "implicit/far_field.h"
#include "implicit/hermite_sums.h"

#include <memory>

namespace hrbfnpr::fit {

// Multiplies by the matrix. The object keeps working vectors, so it is not thread-safe.
class HermiteProduct {
public:
    // If the product is approximate, its error is at most `tolerance` relative to the right-hand side.
    HermiteProduct(const base::Work& work, const geometry::VecArray& position, const HermiteSystem::Options& options,
                   double tolerance);

    // Vectors have 4 numbers per sample: value, x, y, z. x and y must not overlap.
    void multiply(const double* x, double* y, const base::Progress& progress);
    // Returns the elements of the exact product for samples 0, stride, 2 stride and so on.
    [[nodiscard]] base::Array<double> multiply_some(const double* x, std::int64_t stride,
                                                    const base::Progress& progress);
    // Adds the part of the product that comes from regularization to y.
    void add_diagonal(const double* x, double* y) const noexcept;
    // Returns whether multiply() is approximate: fast, and accurate enough for conjugate gradients to converge.
    [[nodiscard]] bool approximate() const noexcept { return far_ != nullptr; }
    // Makes the fast product ten times as accurate. Returns false if that is not possible.
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
    std::unique_ptr<implicit::FarField> far_; // null: pairs are summed one by one
    base::Array<geometry::Bounds> boxes_;     // Each box bounds box_samples consecutive samples.
};

} // namespace hrbfnpr::fit

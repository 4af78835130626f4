// SPDX-License-Identifier: MIT
// The orthogonal change of coordinates that eliminates the side constraints.
//
// P = Q [0; R] by Householder reflections that work upwards from the last row. The first rows() - terms() coordinates
// of Q^T w are free, and the last ones are fixed by P^T w. Row rows() - 1 - k of Q^T P is row k of R. Reflections do
// not depend on how P's columns are scaled.
#pragma once

#include "fit/system.h"

#include <Eigen/Core>

namespace hrbfnpr::fit {

class NullSpace {
public:
    static constexpr int terms_max = 20;
    // Matrices with as many rows as P has columns. They are small enough for the stack.
    using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, terms_max, terms_max>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, terms_max, 1>;
    using Columns = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>>;
    using ConstColumns = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>>;

    // Throws Error{invalid_argument} if the samples do not determine the polynomial uniquely.
    NullSpace(base::Memory& memory, const HermiteSystem& system);

    [[nodiscard]] std::int64_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::int64_t terms() const noexcept { return terms_; }
    [[nodiscard]] std::int64_t free() const noexcept { return rows_ - terms_; }

    // Q = I - V T V^T.
    [[nodiscard]] ConstColumns v() const noexcept {
        return {v_.data(), static_cast<Eigen::Index>(rows_), static_cast<Eigen::Index>(terms_)};
    }
    [[nodiscard]] const Small& t() const noexcept { return t_; }
    [[nodiscard]] const Small& r() const noexcept { return r_; }

    void apply(double* x) const noexcept;            // x = Q x
    void apply_transposed(double* x) const noexcept; // x = Q^T x

private:
    void factor(const HermiteSystem& system);

    std::int64_t rows_;
    std::int64_t terms_;
    base::Array<double> v_;
    Small t_;
    Small r_;
};

} // namespace hrbfnpr::fit

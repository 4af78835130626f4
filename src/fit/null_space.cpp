// SPDX-License-Identifier: MIT
#include "fit/null_space.h"

#include <cmath>

namespace hrbfnpr::fit {
namespace {

// The smallest allowed length of the part of a column of P that is orthogonal to the earlier columns, as a share of the
// column's length. If the part is shorter, a polynomial and its gradient vanish at all samples.
constexpr double independence = 1e-10;

[[noreturn]] void fail_undetermined(const HermiteSystem& system) {
    fail(Status::invalid_argument,
         "polynomial_degree is %d, but the %lld samples do not determine such a polynomial; lower it, or give more "
         "samples, not all on one plane",
         static_cast<int>(system.options().degree), static_cast<long long>(system.samples()));
}

} // namespace

NullSpace::NullSpace(base::Memory& memory, const HermiteSystem& system)
    : rows_(system.rows()), terms_(system.terms()), v_(memory), t_(Small::Zero(terms_, terms_)),
      r_(Small::Zero(terms_, terms_)) {
    if (terms_ > rows_) fail_undetermined(system);
    v_.resize(rows_ * terms_);
    system.constraints(v_.data());
    factor(system);
}

void NullSpace::factor(const HermiteSystem& system) {
    Columns p(v_.data(), rows_, terms_);
    Vector length(terms_);
    for (std::int64_t k = 0; k < terms_; ++k) length[k] = p.col(k).norm();
    for (std::int64_t k = 0; k < terms_; ++k) {
        const std::int64_t pivot = rows_ - 1 - k;
        auto v = p.col(k).head(pivot + 1);
        const double norm = v.norm();
        if (!(norm > independence * length[k])) fail_undetermined(system);
        const double diagonal = v[pivot] > 0.0 ? -norm : norm;
        const double tau = (diagonal - v[pivot]) / diagonal;
        v.head(pivot) /= v[pivot] - diagonal;
        v[pivot] = 1.0;
        r_(k, k) = diagonal;
        for (std::int64_t l = k + 1; l < terms_; ++l) {
            auto other = p.col(l).head(pivot + 1);
            other -= (tau * v.dot(other)) * v;
            r_(k, l) = other[pivot];
        }
        p.col(k).tail(k).setZero();
        t_(k, k) = tau;
        for (std::int64_t l = 0; l < k; ++l) t_(l, k) = -tau * p.col(l).dot(p.col(k));
        t_.col(k).head(k) = (t_.topLeftCorner(k, k).triangularView<Eigen::Upper>() * t_.col(k).head(k)).eval();
    }
}

void NullSpace::apply(double* x) const noexcept {
    Eigen::Map<Eigen::VectorXd> map(x, rows_);
    Vector s(terms_);
    for (std::int64_t k = 0; k < terms_; ++k) s[k] = v().col(k).dot(map);
    const Vector ts = t_ * s;
    for (std::int64_t k = 0; k < terms_; ++k) map -= ts[k] * v().col(k);
}

void NullSpace::apply_transposed(double* x) const noexcept {
    Eigen::Map<Eigen::VectorXd> map(x, rows_);
    Vector s(terms_);
    for (std::int64_t k = 0; k < terms_; ++k) s[k] = v().col(k).dot(map);
    const Vector ts = t_.transpose() * s;
    for (std::int64_t k = 0; k < terms_; ++k) map -= ts[k] * v().col(k);
}

} // namespace hrbfnpr::fit

// SPDX-License-Identifier: MIT
#include "fit/polynomial_space.h"

#include "base/long_array.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace hrbfnpr::fit {
namespace {

// Sums are taken over chunks of this many rows, so the result does not depend on the number of threads.
constexpr std::int64_t rows_a_task = 16384;

using ConstMap = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Map = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

} // namespace

PolynomialSpace::PolynomialSpace(const base::Work& work, const HermiteSystem& system)
    : runtime_(work), rows_(system.rows()), terms_(system.terms()), q_(work.memory),
      r_(Small::Identity(terms_, terms_)) {
    if (terms_ == 0) return;
    base::resize_long(q_, rows_ * terms_, work);
    system.constraints(q_.data());
    for (std::int64_t k = 0; k < terms_; ++k) {
        work.check();
        Eigen::Map<Eigen::VectorXd> column(q_.data() + k * rows_, rows_);
        const double norm = column.norm();
        if (norm > 0.0) column /= norm;
        r_(k, k) = norm;
    }
    for (int pass = 0; pass < 2; ++pass) {
        work.check();
        orthonormalise();
    }
}

void PolynomialSpace::orthonormalise() {
    const std::int64_t chunks = (rows_ + rows_a_task - 1) / rows_a_task;
    base::Array<double> sums(runtime_.memory, chunks * terms_ * terms_);
    runtime_.parallel.for_chunks(rows_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
        const ConstMap part(q_.data() + begin, end - begin, terms_, Eigen::OuterStride<>(rows_));
        Eigen::Map<Eigen::MatrixXd>(sums.data() + begin / rows_a_task * terms_ * terms_, terms_, terms_).noalias() =
            part.transpose() * part;
    });
    Small gram = Small::Zero(terms_, terms_);
    for (std::int64_t k = 0; k < chunks; ++k)
        gram += Eigen::Map<const Eigen::MatrixXd>(sums.data() + k * terms_ * terms_, terms_, terms_);
    const Eigen::LLT<Small> cholesky(gram);
    const Small factor = cholesky.matrixU();
    for (std::int64_t k = 0; k < terms_; ++k)
        if (cholesky.info() != Eigen::Success || !(factor(k, k) > 1e-7))
            fail(Status::invalid_argument,
                 "points: the %lld samples do not determine the polynomial; lower polynomial_degree, or give more "
                 "samples",
                 static_cast<long long>(rows_ / 4));
    r_ = (factor * r_).eval();
    runtime_.parallel.for_chunks(rows_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
        Map part(q_.data() + begin, end - begin, terms_, Eigen::OuterStride<>(rows_));
        factor.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(part);
    });
}

PolynomialSpace::Vector PolynomialSpace::components(const double* x) const {
    const std::int64_t chunks = (rows_ + rows_a_task - 1) / rows_a_task;
    base::Array<double> sums(runtime_.memory, chunks * terms_);
    runtime_.parallel.for_chunks(rows_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
        const ConstMap part(q_.data() + begin, end - begin, terms_, Eigen::OuterStride<>(rows_));
        Eigen::Map<Eigen::VectorXd>(sums.data() + begin / rows_a_task * terms_, terms_).noalias() =
            part.transpose() * Eigen::Map<const Eigen::VectorXd>(x + begin, end - begin);
    });
    Vector sum = Vector::Zero(terms_);
    for (std::int64_t k = 0; k < chunks; ++k)
        sum += Eigen::Map<const Eigen::VectorXd>(sums.data() + k * terms_, terms_);
    return sum;
}

void PolynomialSpace::subtract(const Vector& components, double* x) const {
    runtime_.parallel.for_chunks(rows_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
        const ConstMap part(q_.data() + begin, end - begin, terms_, Eigen::OuterStride<>(rows_));
        Eigen::Map<Eigen::VectorXd>(x + begin, end - begin).noalias() -= part * components;
    });
}

void PolynomialSpace::make_orthogonal(double* x) const {
    if (terms_ > 0) subtract(components(x), x);
}

void PolynomialSpace::subtract_best_polynomial(double* x, double* c) const {
    if (terms_ == 0) return;
    Vector part = components(x);
    subtract(part, x);
    r_.triangularView<Eigen::Upper>().solveInPlace(part);
    Eigen::Map<Eigen::VectorXd>(c, terms_) += part;
}

std::array<double, 4> PolynomialSpace::at(std::int64_t sample, const double* c) const noexcept {
    const Vector part = r_.triangularView<Eigen::Upper>() * Eigen::Map<const Eigen::VectorXd>(c, terms_);
    std::array<double, 4> result{};
    for (std::int64_t i = 0; i < 4; ++i)
        for (std::int64_t k = 0; k < terms_; ++k)
            result[static_cast<std::size_t>(i)] += q_[k * rows_ + 4 * sample + i] * part[k];
    return result;
}

} // namespace hrbfnpr::fit

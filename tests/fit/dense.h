// SPDX-License-Identifier: MIT
// Eigen's solvers and products, with which the tests of this folder compare. They are compiled once, since each takes
// seconds.
#pragma once

#include <Eigen/Core>

namespace fit_test {

[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
[[nodiscard]] Eigen::VectorXd applied(const Eigen::MatrixXd& a, const Eigen::VectorXd& x);

// Solves by LU with full pivoting.
[[nodiscard]] Eigen::VectorXd solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& right);
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);

// The x that brings a x nearest to `right`, by the normal equations: `a` must be well conditioned.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& right);

// Returns U^-1 with U^T U = a. The result is undefined if `a` is not positive definite.
[[nodiscard]] Eigen::MatrixXd inverse_of_upper_cholesky(const Eigen::MatrixXd& a);

} // namespace fit_test

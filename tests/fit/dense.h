// SPDX-License-Identifier: MIT
// Eigen's solvers and products, which the tests of this folder compare with: compiled once, since each takes seconds.
#pragma once

#include <Eigen/Core>

namespace fit_test {

[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
[[nodiscard]] Eigen::VectorXd applied(const Eigen::MatrixXd& a, const Eigen::VectorXd& x);

// By LU with full pivoting.
[[nodiscard]] Eigen::VectorXd solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& right);
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);

// The x that brings a x nearest, by the normal equations: a must not be badly conditioned.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& right);

// U^-1 with U^T U = a; nothing of a matrix that is not positive definite is promised.
[[nodiscard]] Eigen::MatrixXd inverse_of_upper_cholesky(const Eigen::MatrixXd& a);

} // namespace fit_test

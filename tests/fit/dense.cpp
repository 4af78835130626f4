// SPDX-License-Identifier: MIT
#include "dense.h"

#include <Eigen/Dense>

namespace fit_test {

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a * b; }
Eigen::VectorXd applied(const Eigen::MatrixXd& a, const Eigen::VectorXd& x) { return a * x; }

Eigen::VectorXd solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& right) { return a.fullPivLu().solve(right); }
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) { return a.fullPivLu().inverse(); }

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& right) {
    return solved(product(a.transpose(), a), applied(a.transpose(), right));
}

Eigen::MatrixXd inverse_of_upper_cholesky(const Eigen::MatrixXd& a) {
    return a.llt().matrixU().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols()));
}

} // namespace fit_test

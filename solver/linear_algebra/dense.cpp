// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "src/base/ensure.hpp"

namespace abut::solver {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {
constexpr const char* rows_differ = "a right-hand side has the rows of its matrix";
constexpr double singular = 1e-15;  // reciprocal condition number
}  // namespace

SymmetricEigen symmetric_eigen(const MatrixXd& a) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(a);
    return {eigen.eigenvalues(), eigen.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& a) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

SingularVectors left_singular_vectors(const MatrixXd& a) {
    const Eigen::JacobiSVD<MatrixXd> svd(a, Eigen::ComputeThinU);
    return {svd.singularValues(), svd.matrixU()};
}

SingularVectors right_singular_vectors(const MatrixXd& a) {
    const Eigen::JacobiSVD<MatrixXd> svd(a, Eigen::ComputeFullV);
    return {svd.singularValues(), svd.matrixV()};
}

VectorXd least_squares(const MatrixXd& a, const VectorXd& b) {
    ENSURE(a.rows() == b.size(), rows_differ);
    return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(a).solve(b);
}

std::optional<VectorXd> solve_square(const MatrixXd& a, const VectorXd& b) {
    ENSURE(a.rows() == a.cols() && a.rows() == b.size(), rows_differ);
    if (b.size() == 0) return b;
    const Eigen::PartialPivLU<MatrixXd> factor(a);
    if (!(factor.rcond() > singular)) return std::nullopt;
    VectorXd x = factor.solve(b);
    x += factor.solve(b - a * x);
    return x;
}

bool Cholesky::compute(const MatrixXd& a) {
    ENSURE(a.rows() == a.cols(), "a symmetric matrix is square");
    factor_.compute(a);
    return succeeded();
}

VectorXd Cholesky::solve(const VectorXd& b) const {
    ENSURE(factor_.rows() == b.size(), rows_differ);
    return factor_.solve(b);
}

MatrixXd Cholesky::solve_columns(const MatrixXd& b) const {
    ENSURE(factor_.rows() == b.rows(), rows_differ);
    return factor_.solve(b);
}

MatrixXd Cholesky::solve_lower(const MatrixXd& b) const {
    ENSURE(factor_.rows() == b.rows(), rows_differ);
    return factor_.matrixL().solve(b);
}

PivotedCholesky::PivotedCholesky(const MatrixXd& a) : factor_(a) {}

VectorXd PivotedCholesky::solve(const VectorXd& b) const {
    ENSURE(factor_.rows() == b.size(), rows_differ);
    return factor_.solve(b);
}

MatrixXd PivotedCholesky::solve_columns(const MatrixXd& b) const {
    ENSURE(factor_.rows() == b.rows(), rows_differ);
    return factor_.solve(b);
}

}  // namespace abut::solver

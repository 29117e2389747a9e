// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <vector>

#include "solver/linear_algebra/blas.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {
constexpr const char* rows_differ = "a right-hand side has the rows of its matrix";
constexpr double singular = 1e-15;   // reciprocal condition number
constexpr double dependent = 1e-13;  // of the largest pivot

/// x = L^-1 x, or L'^-1 x.
void solve_triangle(const MatrixXd& l, const char* transposed, MatrixXd& x) {
    const int n = static_cast<int>(x.rows()), columns = static_cast<int>(x.cols());
    const double one = 1;
    if (n > 0 && columns > 0) dtrsm_("L", "L", transposed, "N", &n, &columns, &one, l.data(), &n, x.data(), &n);
}

}  // namespace

SymmetricEigen symmetric_eigen(const MatrixXd& a) {
    if (a.size() == 0) return {VectorXd(0), a};
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(a);
    return {eigen.eigenvalues(), eigen.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& a) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

VectorXd tridiagonal_eigenvalues(const VectorXd& diagonal, const VectorXd& side) {
    Eigen::SelfAdjointEigenSolver<MatrixXd> eigen;
    eigen.computeFromTridiagonal(diagonal, side, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues();
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
    const std::optional<MatrixXd> x = solve_square_columns(a, b);
    return x ? std::optional<VectorXd>(x->col(0)) : std::nullopt;
}

std::optional<MatrixXd> solve_square_columns(const MatrixXd& a, const MatrixXd& b) {
    ENSURE(a.rows() == a.cols() && a.rows() == b.rows(), rows_differ);
    if (b.size() == 0) return b;
    const SquareFactor factor(a);
    if (!factor.succeeded() || !(factor.reciprocal_condition() > singular)) return std::nullopt;
    MatrixXd x = factor.solve_columns(b);
    x += factor.solve_columns(b - product(a, x));
    return x;
}

SquareFactor::SquareFactor(MatrixXd a) : lu_(std::move(a)), pivots_(static_cast<std::size_t>(lu_.rows())) {
    ENSURE(lu_.rows() == lu_.cols(), rows_differ);
    const int n = static_cast<int>(lu_.rows());
    int info = 0;
    if (n > 0) {
        norm_ = lu_.cwiseAbs().colwise().sum().maxCoeff();
        dgetrf_(&n, &n, lu_.data(), &n, pivots_.data(), &info);
    }
    succeeded_ = info == 0;
}

double SquareFactor::reciprocal_condition() const {
    const int n = static_cast<int>(lu_.rows());
    double reciprocal = n > 0 ? 0 : 1;
    int info = 0;
    std::vector<int> work_of_ints(pivots_.size());
    VectorXd work(4 * n);
    if (n > 0) dgecon_("1", &n, lu_.data(), &n, &norm_, &reciprocal, work.data(), work_of_ints.data(), &info);
    return reciprocal;
}

MatrixXd SquareFactor::solve_columns(MatrixXd b) const {
    ENSURE(b.rows() == lu_.rows(), rows_differ);
    const int n = static_cast<int>(lu_.rows()), columns = static_cast<int>(b.cols());
    int info = 0;
    if (b.size() > 0) dgetrs_("N", &n, &columns, lu_.data(), &n, pivots_.data(), b.data(), &n, &info);
    return b;
}

std::optional<VectorXd> kernel_of(MatrixXd a) {
    ENSURE(a.cols() == a.rows() + 1, "there is one column more than rows");
    const auto scale_of = [](const auto& norms) { return (norms.array() > 0).select(norms, 1.0).cwiseInverse().eval(); };
    const VectorXd columns = scale_of(VectorXd(a.colwise().norm().transpose()));
    a = a * columns.asDiagonal();
    a = scale_of(VectorXd(a.rowwise().norm())).asDiagonal() * a;
    Eigen::FullPivLU<MatrixXd> factor(a);
    factor.setThreshold(dependent);
    if (factor.dimensionOfKernel() != 1) return std::nullopt;
    return columns.cwiseProduct(factor.kernel().col(0));
}

MatrixXd product(const MatrixXd& a, const MatrixXd& b) {
    MatrixXd c = MatrixXd::Zero(a.rows(), b.cols());
    add_product(a, b, c);
    return c;
}

void add_product(const MatrixXd& a, const MatrixXd& b, MatrixXd& c) {
    ENSURE(a.cols() == b.rows() && c.rows() == a.rows() && c.cols() == b.cols(), "a product has its factors' sizes");
    const int m = static_cast<int>(a.rows()), n = static_cast<int>(b.cols()), k = static_cast<int>(a.cols());
    const double one = 1;
    if (m > 0 && n > 0 && k > 0) dgemm_("N", "N", &m, &n, &k, &one, a.data(), &m, b.data(), &k, &one, c.data(), &m);
}

bool Cholesky::compute(MatrixXd a) {
    ENSURE(a.rows() == a.cols(), "a symmetric matrix is square");
    l_ = std::move(a);
    const int n = static_cast<int>(l_.rows());
    int info = 0;
    if (n > 0) dpotrf_("L", &n, l_.data(), &n, &info);
    succeeded_ = info == 0 && l_.diagonal().allFinite();
    return succeeded_;
}

VectorXd Cholesky::solve(const VectorXd& b) const {
    return solve_columns(b);
}

MatrixXd Cholesky::solve_columns(const MatrixXd& b) const {
    MatrixXd x = solve_lower(b);
    solve_triangle(l_, "T", x);
    return x;
}

MatrixXd Cholesky::solve_lower(const MatrixXd& b) const {
    ENSURE(l_.rows() == b.rows(), rows_differ);
    MatrixXd x = b;
    solve_triangle(l_, "N", x);
    return x;
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

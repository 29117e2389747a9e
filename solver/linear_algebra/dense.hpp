// SPDX-License-Identifier: GPL-3.0-or-later
// Decompositions of dense matrices of some rows. Most are Eigen's; each takes seconds to compile, hence one place for all of
// this floor. Elsewhere geometry/interfaces/screw.cpp, which must not know this floor, has singular vectors of its own, and
// src/plan/edge_traction.cpp and src/solution/preload.cpp have what they need of a few rows.
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace abut::solver {

struct SymmetricEigen {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< orthonormal columns
};
/// Reads the lower triangle.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& a);  ///< ascending
/// The eigenvalues, ascending, of the tridiagonal matrix with these entries on the diagonal (n) and beside it (n - 1).
Eigen::VectorXd tridiagonal_eigenvalues(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& side);

struct SingularVectors {
    Eigen::VectorXd values;   ///< descending, min(rows, columns) of them
    Eigen::MatrixXd vectors;  ///< orthonormal columns, in the order of the values
};
/// The singular vectors of A, by Jacobi's rotations, which leave apart what nothing couples.
SingularVectors left_singular_vectors(const Eigen::MatrixXd& a);   ///< (rows x number of values)
SingularVectors right_singular_vectors(const Eigen::MatrixXd& a);  ///< (columns x columns): those of the null space come last

/// The shortest x that minimises |A x - b|, for any rank of A.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// x of A x = b for a square A, by LU decomposition with partial pivots and a step of refinement; nothing where A is singular
/// to rounding.
std::optional<Eigen::VectorXd> solve_square(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
std::optional<Eigen::MatrixXd> solve_square_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);  ///< A X = B

/// P A = L U of a square matrix.
class SquareFactor {
public:
    explicit SquareFactor(Eigen::MatrixXd a);
    bool succeeded() const { return succeeded_; }  ///< false: a pivot is zero
    double reciprocal_condition() const;           ///< an estimate
    Eigen::VectorXd solve(Eigen::VectorXd b) const { return solve_columns(std::move(b)); }
    Eigen::MatrixXd solve_columns(Eigen::MatrixXd b) const;

private:
    Eigen::MatrixXd lu_;
    std::vector<int> pivots_;
    double norm_ = 0;
    bool succeeded_ = false;
};

/// The vector that a matrix with one row less than columns, its rows and columns scaled, maps to nothing; nothing where there
/// are more of them than one, to rounding.
std::optional<Eigen::VectorXd> kernel_of(Eigen::MatrixXd a);

/// A B and C += A B by BLAS, which is several times as fast as Eigen built for any processor.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
void add_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::MatrixXd& c);

/// A = L L' of a positive definite matrix, of which the lower triangle is read.
class Cholesky {
public:
    Cholesky() = default;
    explicit Cholesky(Eigen::MatrixXd a) { compute(std::move(a)); }
    bool compute(Eigen::MatrixXd a);  ///< false: not positive definite
    bool succeeded() const { return succeeded_; }
    Eigen::VectorXd diagonal() const { return l_.diagonal(); }  ///< of L
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& b) const;
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;  ///< L^-1 b

private:
    Eigen::MatrixXd l_;  ///< its lower triangle
    bool succeeded_ = false;
};

/// P A P' = L D L' of a semidefinite matrix, the largest pivots first. Solutions of what has tiny pivots mean little: look at
/// these before.
class PivotedCholesky {
public:
    explicit PivotedCholesky(const Eigen::MatrixXd& a);
    bool succeeded() const { return factor_.info() == Eigen::Success; }
    Eigen::VectorXd pivots() const { return factor_.vectorD(); }  ///< D
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& b) const;

private:
    Eigen::LDLT<Eigen::MatrixXd> factor_;
};

}  // namespace abut::solver

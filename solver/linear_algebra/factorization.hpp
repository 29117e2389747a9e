// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factorisation of a sparse symmetric positive definite matrix, scaled to a unit diagonal: frontal, banded or
// supernodal.
//
// The rule: frontal where the rows' places on a grid are known, but for narrow strips. Milliseconds of one part of the Hertz
// scene, degree 2, analysis and factor, one thread (CHOLMOD by its defaults):
//
//   unknowns   frontal   banded   supernodal   CHOLMOD alone
//   1763       1.8       1.9      3.5          3.4
//   7777       13        19       22           22
//   34850      105       -        239          209
//
// Else banded up to a bandwidth of 8 entries of the lower triangle's mean row (9.5, 25.5, 49.5, 81.5 for degrees 1 to 4).
// Measured: time of analysis, factor and solve_lower(20 columns), banded over supernodal, of squares (s), discs (d), bars 10 x
// 1 (b) and 100 x 1 (l), extended basis; in brackets the bandwidth; *: supernodal is chosen.
//
//   unknowns   degree 1        2               3               4
//   1000       s 0.56 (47)     0.54 (93)       0.50 (139)      0.48 (185)
//              b 0.37 (25)     0.46 (52)       0.48 (65)       0.48 (88)
//   3000       s 0.64 (81)*    0.73 (161)      0.92 (241)      0.62 (321)
//              b 0.50 (45)     0.57 (87)       0.60 (125)      0.58 (159)
//   10000      s 1.43 (145)*   1.47 (289)*     0.99 (433)*     0.83 (577)
//              d 0.96 (145)*   0.98 (289)*     1.02 (433)*     0.77 (577)
//              b 0.80 (85)*    0.81 (167)      0.87 (245)      0.82 (328)
//              l 0.37 (25)     0.51 (52)       0.54 (65)       0.40 (88)
//   30000      s 1.61 (247)*   1.70 (493)*     1.38 (739)*
//              b 1.45 (153)*   1.23 (308)*     1.06 (456)*     1.05 (600)
//              l 0.52 (45)     0.65 (92)       0.74 (132)      0.55 (168)
//
// With 200 columns banded is better still (squares of degree 2: 0.98 at 10000, 1.11 at 30000).
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "solver/linear_algebra/block_matrix.hpp"
#include "solver/linear_algebra/grid_dissection.hpp"

namespace abut::solver {

enum class FactorMethod { banded, supernodal, frontal };

/// What is known of a matrix's rows beside the pattern. It makes for a better order, and changes answers by rounding only.
struct RowHints {
    std::vector<GridPlace> place{};  ///< on a grid, by row; empty: not known
    int reach = 0;                   ///< rows more than this apart in either number are not coupled, but for few
    /// Rows in which inverse_form() will find entries. Banded: the order is turned so that they come late, and the columns
    /// begin there.
    std::vector<int> late{};
    std::optional<FactorMethod> method{};  ///< in place of the one that the rule picks
};

/// P S A S P' = L L', S the inverse root of the diagonal. Copies share the factor, which nothing changes. The same input gives
/// the same factor bit for bit.
class Factorization {
public:
    Factorization() = default;
    /// The matrix is scaled in place: moved in, it costs no copy. A frontal factor is made on `threads` threads at most, the
    /// same for any number.
    explicit Factorization(SparseSymmetric matrix, const RowHints& hints = {}, int threads = 1);
    /// Factorises K = A + B' M^-1 B, which is full, given by the sparse matrix [A B'; B -M] whose last n_eliminated rows are
    /// those of M, which has to be positive definite like A. What follows is of K, its rows, its condition; solve_lower() there
    /// is none.
    Factorization(SparseSymmetric matrix, int n_eliminated);

    /// False: the matrix is not positive definite to working precision; failed_at() tells the row, nothing else may be called.
    bool ok() const;
    /// The row of the first pivot that is negative, not a number, or nothing but rounding (below the unit of double precision,
    /// the diagonal being 1); -1: none.
    int failed_at() const;

    FactorMethod method() const;
    int bandwidth() const;   ///< below the diagonal in the order of a banded factor; 0: it is not banded
    double entries() const;  ///< numbers that the factor stores
    double bytes() const;    ///< of the factor

    /// 2-norm condition number of S A S, from below, by Lanczos' method: typically to a few per cent. Computed anew at every
    /// call; measured: the price of 10 to 15 solutions.
    double condition_estimate() const;
    /// 2-norm condition number of S A S from products with A as it was given, where they cost less than the factor's.
    double condition_estimate(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& matrix) const;
    /// 1-norm condition number of A as it was given, not scaled, as in the tables of [Grishin10], from below; costs five
    /// solutions.
    double unscaled_condition_one() const;

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// Y = L^-1 P S B, so that B' A^-1 B = Y'Y.
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;
    /// B' A^-1 B, of a K, too. Sparse columns cost a fraction of solve_lower's.
    Eigen::MatrixXd inverse_form(const Eigen::SparseMatrix<double>& b) const;
    /// From now on the forms found last are kept, for all copies, and given again where the same B is asked for.
    void keep_forms();
    bool keeps_forms() const { return kept_ != nullptr; }

private:
    struct Data;
    struct KeptForms;
    Eigen::MatrixXd new_inverse_form(const Eigen::SparseMatrix<double>& b) const;

    std::shared_ptr<const Data> data_;
    std::shared_ptr<KeptForms> kept_;  ///< null: none are
};

}  // namespace abut::solver

// SPDX-License-Identifier: GPL-3.0-or-later
// The compliance of the rows of a contact problem: how far each gives way under unit forces on the others.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "solver/linear_algebra/block_matrix.hpp"

namespace abut::solver {

/// A symmetric matrix, dense or, where each row is coupled with few others, sparse. Copies share the numbers, which nothing
/// changes.
class Compliance {
public:
    Compliance() : Compliance(Eigen::MatrixXd(0, 0)) {}
    Compliance(Eigen::MatrixXd dense) : dense_(std::make_shared<const Eigen::MatrixXd>(std::move(dense))) {}
    template <class Expression>
    Compliance(const Eigen::MatrixBase<Expression>& dense) : Compliance(Eigen::MatrixXd(dense)) {}
    /// Both triangles, with all of the diagonal.
    Compliance(const Eigen::SparseMatrix<double>& sparse)
        : sparse_(std::make_shared<const Eigen::SparseMatrix<double>>(sparse)) {}

    bool is_sparse() const { return sparse_ != nullptr; }
    /// The numbers of a dense one; of a sparse one they are made.
    Eigen::MatrixXd to_dense() const { return sparse_ ? Eigen::MatrixXd(*sparse_) : *dense_; }
    const Eigen::MatrixXd& dense() const;  ///< of a dense one

    /// Is it a copy of the other one?
    bool shares(const Compliance& other) const { return dense_ == other.dense_ && sparse_ == other.sparse_; }

    Eigen::Index rows() const { return sparse_ ? sparse_->rows() : dense_->rows(); }
    Eigen::Index cols() const { return sparse_ ? sparse_->cols() : dense_->cols(); }
    double operator()(Eigen::Index row, Eigen::Index column) const {
        return sparse_ ? sparse_->coeff(row, column) : (*dense_)(row, column);
    }
    Eigen::VectorXd diagonal() const;
    Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;
    /// These rows of the product with x: of few rows in much less time.
    Eigen::VectorXd product_at(const std::vector<Eigen::Index>& rows, const Eigen::VectorXd& x) const;
    /// S C S with a diagonal S.
    Compliance scaled(const Eigen::VectorXd& s) const;
    /// The lower triangle among some rows (ascending) of a sparse one.
    SparseSymmetric among(const std::vector<Eigen::Index>& rows) const;

private:
    std::shared_ptr<const Eigen::MatrixXd> dense_;  ///< null: sparse
    std::shared_ptr<const Eigen::SparseMatrix<double>> sparse_;
};

}  // namespace abut::solver

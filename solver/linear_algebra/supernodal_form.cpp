// SPDX-License-Identifier: GPL-3.0-or-later
// B' A^-1 B from a factor by supernodes, for right-hand sides of few entries.
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "solver/linear_algebra/blas.hpp"
#include "solver/linear_algebra/supernodes.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::size_t size(Index n) {
    return static_cast<std::size_t>(n);
}

using Columns = std::vector<int>;  // of B, ascending

/// What one supernode holds of the right-hand sides: those that reach it, and their rows there (width x columns); nothing
/// before the first of them does.
struct Share {
    Columns columns;
    MatrixXd values;
};

bool are_consecutive(const Columns& columns) {
    return columns.back() - columns.front() + 1 == static_cast<int>(columns.size());
}

/// Where each of some columns stands among others that hold them all.
std::vector<Index> places(const Columns& some, const Columns& all) {
    std::vector<Index> result;
    result.reserve(some.size());
    std::size_t k = 0;
    for (int c : some) {
        while (all[k] != c) ++k;
        result.push_back(static_cast<Index>(k));
    }
    return result;
}

/// A matrix by columns in memory that is used again: unset.
double* room_for(std::vector<double>& memory, Index rows, Index columns) {
    if (memory.size() < size(rows * columns)) memory.resize(size(rows * columns));
    return memory.data();
}

class Forward {
public:
    Forward(const Supernodes& factor, const Eigen::SparseMatrix<double>& b)
        : pattern_(factor.pattern),
          values_(factor.values),
          sign_(factor.sign),
          owner_(pattern_.order.size()),
          position_(pattern_.order.size()),
          shares_(at(pattern_.count())),
          form_(MatrixXd::Zero(b.cols(), b.cols())) {
        for (std::size_t k = 0; k < position_.size(); ++k) position_[at(pattern_.order[k])] = static_cast<int>(k);
        for (std::size_t s = 0; s < shares_.size(); ++s)
            std::fill(owner_.begin() + pattern_.first_column[s], owner_.begin() + pattern_.first_column[s + 1],
                      static_cast<int>(s));
        find_columns(b);
        add_entries(b);
    }

    /// The lower triangle.
    MatrixXd run() && {
        for (std::size_t s = 0; s < shares_.size(); ++s) {
            if (shares_[s].columns.empty()) continue;
            const Share own = eliminate(s);
            pass_on(supernode(s), own);
            add_to_form(supernode(s), own);
        }
        return std::move(form_);
    }

private:
    using Entry = Eigen::SparseMatrix<double>::InnerIterator;

    Supernode supernode(std::size_t s) const { return pattern_[static_cast<int>(s)]; }
    std::size_t owner_of(int position) const { return at(owner_[at(position)]); }

    /// Columns begin where B has entries and go on to the supernode of the first row below, as all of them do.
    void find_columns(const Eigen::SparseMatrix<double>& b) {
        for (int c = 0; c < b.cols(); ++c)
            for (Entry e(b, c); e; ++e) {
                Columns& list = shares_[owner_of(position_[size(e.row())])].columns;
                if (list.empty() || list.back() != c) list.push_back(c);
            }
        Columns all;
        for (std::size_t s = 0; s < shares_.size(); ++s) {
            const Supernode node = supernode(s);
            const Columns& own = shares_[s].columns;
            if (own.empty() || node.under() == 0) continue;
            Columns& next = shares_[owner_of(node.row[node.width])].columns;
            all.clear();
            std::set_union(next.begin(), next.end(), own.begin(), own.end(), std::back_inserter(all));
            std::swap(next, all);
        }
    }

    MatrixXd& values_of(std::size_t s) {
        Share& share = shares_[s];
        if (share.values.size() == 0)
            share.values = MatrixXd::Zero(supernode(s).width, static_cast<Index>(share.columns.size()));
        return share.values;
    }

    void add_entries(const Eigen::SparseMatrix<double>& b) {
        for (int c = 0; c < b.cols(); ++c)
            for (Entry e(b, c); e; ++e) {
                const int k = position_[size(e.row())];
                const std::size_t s = owner_of(k);
                const Columns& columns = shares_[s].columns;
                const auto column = std::lower_bound(columns.begin(), columns.end(), c) - columns.begin();
                values_of(s)(k - pattern_.first_column[s], column) += e.value();
            }
    }

    /// Y = L_ss^-1 of what has come together in s, which is emptied.
    Share eliminate(std::size_t s) {
        values_of(s);
        Share own = std::exchange(shares_[s], {});
        const Supernode node = supernode(s);
        const int n = static_cast<int>(own.columns.size());
        const double one = 1;
        dtrsm_("L", "L", "N", "N", &node.width, &n, &one, values_ + node.first_value, &node.rows, own.values.data(),
               &node.width);
        return own;
    }

    /// Takes L Y of the rows below off the supernodes that they belong to.
    void pass_on(const Supernode& node, const Share& own) {
        const int n = static_cast<int>(own.columns.size()), under = node.under();
        if (under == 0) return;
        const double one = 1, zero = 0;
        double* below = room_for(product_, under, n);
        dgemm_("N", "N", &under, &n, &node.width, &one, values_ + node.first_value + node.width, &node.rows, own.values.data(),
               &node.width, &zero, below, &under);
        for (int r = node.width; r < node.rows;) {
            const std::size_t target = owner_of(node.row[r]);
            const int begin = pattern_.first_column[target], end = pattern_.first_column[target + 1];
            int last = r;
            while (last < node.rows && node.row[last] < end) ++last;
            const std::vector<Index> to = places(own.columns, shares_[target].columns);
            MatrixXd& values = values_of(target);
            for (int c = 0; c < n; ++c) {
                double* column = &values(0, to[at(c)]) - begin;
                const double* from = below + static_cast<Index>(c) * under - node.width;
                for (int k = r; k < last; ++k) column[node.row[k]] -= from[k];
            }
            r = last;
        }
    }

    /// Adds Y' S Y.
    void add_to_form(const Supernode& node, const Share& own) {
        const int n = static_cast<int>(own.columns.size()), ld = static_cast<int>(form_.rows());
        const double zero = 0, one = 1;
        if (are_consecutive(own.columns)) {
            product_of(node, own, one, &form_(own.columns.front(), own.columns.front()), ld);
            return;
        }
        double* product = room_for(product_, n, n);
        product_of(node, own, zero, product, n);
        for (int j = 0; j < n; ++j)
            for (int i = j; i < n; ++i) form_(own.columns[at(i)], own.columns[at(j)]) += product[i + static_cast<Index>(j) * n];
    }

    /// c = factor c + Y' S Y, its lower triangle.
    void product_of(const Supernode& node, const Share& own, double factor, double* c, int ld) {
        const int n = static_cast<int>(own.columns.size());
        const double one = 1;
        const double* y = own.values.data();
        if (sign_ == nullptr) {
            dsyrk_("L", "T", &n, &node.width, &one, y, &node.width, &factor, c, &ld);
            return;
        }
        const MatrixXd signed_y = Eigen::Map<const Eigen::VectorXd>(sign_ + node.begin, node.width).asDiagonal() * own.values;
        dgemm_("T", "N", &n, &n, &node.width, &one, y, &node.width, signed_y.data(), &node.width, &factor, c, &ld);
    }

    const SupernodePattern pattern_;
    const double *values_, *sign_;
    std::vector<int> owner_, position_;
    std::vector<Share> shares_;
    std::vector<double> product_;
    MatrixXd form_;
};

}  // namespace

MatrixXd Supernodes::inverse_form(const Eigen::SparseMatrix<double>& b) const {
    const MatrixXd form = Forward(*this, b).run();
    return form.selfadjointView<Eigen::Lower>();
}

}  // namespace abut::solver

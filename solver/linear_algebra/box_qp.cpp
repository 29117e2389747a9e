// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/box_qp.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>

#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double gradient_rounding = 1e-13;  // of its terms
constexpr int patience = 10;                 // steps, while no fewer entries are wrong

class BoxQp {
public:
    BoxQp(const Semidefinite& a, const VectorXd& b, const VectorXd& lower, const VectorXd& upper, const VectorXd& start)
        : a_(a), b_(b), lower_(lower), upper_(upper), x_(start.cwiseMax(lower).cwiseMin(upper)), free_(between_bounds()) {}

    std::optional<VectorXd> run(int& steps) {
        if (by_blocks(steps)) return x_;
        const Index most = 10 * (x_.size() + 10);
        for (Index releases = 0; releases < most; ++releases) {
            settle(steps);
            const Index k = most_against_its_bound();
            if (k < 0) return x_;
            free_.push_back(k);
        }
        return std::nullopt;
    }

private:
    VectorXd gradient() const { return a_.times(x_) + b_; }
    double rounding() const {
        return gradient_rounding * (b_.cwiseAbs().maxCoeff() + a_.diagonal.maxCoeff() * x_.cwiseAbs().sum());
    }

    /// All entries that are beyond a bound or against it change at once [Hintermueller02], mostly to the end in a few steps.
    /// False: it goes round in circles; x is where fewest were wrong.
    bool by_blocks(int& steps) {
        VectorXd nearest = x_;
        Index fewest = x_.size() + 1;
        for (int left = patience; left > 0; --left) {
            ++steps;
            x_(free_).setZero();
            if (!free_.empty()) {
                const Cholesky factor(a_.among(free_));
                if (!factor.succeeded()) break;
                x_(free_) = -factor.solve(gradient()(free_));
            }
            std::vector<Index> wrong = take_to_bounds();
            if (wrong.empty()) return true;
            if (static_cast<Index>(wrong.size()) < fewest) {
                fewest = static_cast<Index>(wrong.size());
                nearest = x_;
                left = patience + 1;
            }
            std::vector<Index> changed;
            std::set_symmetric_difference(free_.begin(), free_.end(), wrong.begin(), wrong.end(), std::back_inserter(changed));
            free_ = std::move(changed);
        }
        x_ = std::move(nearest);
        free_ = between_bounds();
        return false;
    }

    std::vector<Index> between_bounds() const {
        std::vector<Index> between;
        for (Index k = 0; k < x_.size(); ++k)
            if (x_[k] > lower_[k] && x_[k] < upper_[k]) between.push_back(k);
        return between;
    }

    /// Free entries beyond a bound are taken there. These, and those against their bounds.
    std::vector<Index> take_to_bounds() {
        const VectorXd g = gradient();
        const double least = rounding();
        std::vector<Index> wrong;
        auto free = free_.begin();
        for (Index k = 0; k < x_.size(); ++k) {
            if (free == free_.end() || *free != k) {
                if (against_its_bound(k, g) > least) wrong.push_back(k);
                continue;
            }
            ++free;
            const double inside = std::clamp(x_[k], lower_[k], upper_[k]);
            if (x_[k] != inside) wrong.push_back(k);
            x_[k] = inside;
        }
        return wrong;
    }

    /// How much the value falls by as an entry leaves its bound; not positive: it does not.
    double against_its_bound(Index k, const VectorXd& gradient) const {
        const bool may_rise = x_[k] <= lower_[k] && x_[k] < upper_[k], may_fall = x_[k] >= upper_[k] && x_[k] > lower_[k];
        return may_rise ? -gradient[k] : may_fall ? gradient[k] : 0;
    }

    /// To the least value with the free entries, fewer by each that comes to a bound on the way.
    void settle(int& steps) {
        if (free_.empty()) return;
        VectorXd left = gradient()(free_);
        MatrixXd a = a_.among(free_);
        while (!free_.empty()) {
            ++steps;
            const Cholesky factor(a);
            const VectorXd way = factor.succeeded() ? VectorXd(-factor.solve(left)) : VectorXd(-least_squares(a, left));
            double share = 1;
            std::size_t first = free_.size();  // to come to its bound
            for (std::size_t i = 0; i < free_.size(); ++i) {
                const Index k = free_[i];
                const double step = way[static_cast<Index>(i)], to = (step > 0 ? upper_ : lower_)[k];
                if (step == 0 || !((to - x_[k]) / step < share)) continue;
                share = (to - x_[k]) / step;
                first = i;
            }
            x_(free_) += share * way;
            if (first == free_.size()) return;
            left *= 1 - share;
            const Index k = free_[first];
            x_[k] = (way[static_cast<Index>(first)] > 0 ? upper_ : lower_)[k];
            take_out(first, a, left);
        }
    }

    void take_out(std::size_t place, MatrixXd& a, VectorXd& left) {
        std::vector<Index> kept;
        for (std::size_t i = 0; i < free_.size(); ++i)
            if (i != place) kept.push_back(static_cast<Index>(i));
        a = MatrixXd(a(kept, kept));
        left = VectorXd(left(kept));
        free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(place));
    }

    /// Which entry at a bound gains most by leaving it; -1: none does.
    Index most_against_its_bound() const {
        const VectorXd g = gradient();
        const double least = rounding();
        Index found = -1;
        double most = 0;
        for (Index k = 0; k < x_.size(); ++k) {
            const double against = against_its_bound(k, g);
            if (!(against > least)) continue;
            const double gain = against * against / std::max(a_.diagonal[k], std::numeric_limits<double>::min());
            if (gain > most) {
                most = gain;
                found = k;
            }
        }
        return found;
    }

    const Semidefinite& a_;
    const VectorXd &b_, &lower_, &upper_;
    VectorXd x_;
    std::vector<Index> free_;
};

}  // namespace

std::optional<VectorXd> minimize_in_box(const Semidefinite& a, const VectorXd& b, const VectorXd& lower, const VectorXd& upper,
                                        const VectorXd& start, int& steps) {
    const Index n = b.size();
    ENSURE(a.diagonal.size() == n && lower.size() == n && upper.size() == n && start.size() == n,
           "there is a diagonal, two bounds and a start for every entry");
    if (n == 0) return start;
    const std::optional<VectorXd> x = BoxQp(a, b, lower, upper, start).run(steps);
    return x && x->allFinite() ? x : std::nullopt;
}

}  // namespace abut::solver

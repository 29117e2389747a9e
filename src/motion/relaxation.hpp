// SPDX-License-Identifier: GPL-3.0-or-later
// Steps to a place of rest that overshoot it, or creep to it.
#pragma once
#include <Eigen/Core>
#include <algorithm>

namespace abut {

/// Factors on steps to a place that they overshoot, or creep to, from what the last factor left over (Aitken).
class Relaxation {
public:
    Eigen::VectorXd of(const Eigen::VectorXd& step) {
        if (before_.size() > 0)
            if (const Eigen::VectorXd change = step - before_; change.norm() > 0)
                factor_ = std::clamp(-factor_ * before_.dot(change) / change.squaredNorm(), 1 / most, most);
        before_ = step;
        return factor_ * step;
    }

    /// Does a step go against the one before? However much longer it is, the place lies between.
    bool turns_back(const Eigen::VectorXd& step) const { return before_.size() > 0 && before_.dot(step) < 0; }

private:
    static constexpr double most = 10;
    Eigen::VectorXd before_{};
    double factor_ = 1;
};

}  // namespace abut

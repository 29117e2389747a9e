// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of rigid bodies that friction slows down or holds: Coulomb's, in every gap that is closed.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "src/motion/moving_parts.hpp"

namespace abut {

/// The gaps that stop parts which may roll: no two at one place, and none beside where a round face is closest.
std::vector<ClosingRow> rolling_rows(const std::vector<ClosingRow>& rows, double touching);

/// The amplitudes of a step on the gaps no wider than `touching`: what little drives is dragged less. Nothing where they are
/// not found. rows: rolling_rows.
std::optional<Eigen::VectorXd> driven_step(const MovingParts& moving, const std::vector<ClosingRow>& rows,
                                           const std::vector<Lead>& leads, double touching);

/// Likewise, of parts that friction holds and that go along with those that supports lead, which are as soft beside gaps as
/// `leading`.
std::optional<Eigen::VectorXd> led_step(const MovingParts& moving, const std::vector<ClosingRow>& rows,
                                        const std::vector<Lead>& leads, double leading, double touching);

/// Such a step as far as the first of the wider gaps lets it, and no longer than steps may be.
Eigen::VectorXd until_touch(const MovingParts& moving, const std::vector<ClosingRow>& rows, const std::vector<Lead>& leads,
                            Eigen::VectorXd step, double touching);

/// The amplitudes by which parts close gaps where friction holds them all; nothing where it lets one go farther, or no step is
/// found. rows: rolling_rows.
std::optional<Eigen::VectorXd> held_step(const MovingParts& moving, const std::vector<ClosingRow>& rows,
                                         const std::vector<Lead>& leads, double touching);

/// Is every part that is loaded pressed, without friction, on another that it touches? rows: rolling_rows.
bool are_all_pressed(const MovingParts& moving, const std::vector<ClosingRow>& rows, const std::vector<Lead>& leads,
                     double touching);

}  // namespace abut

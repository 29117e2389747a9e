// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated errors of a solution.
//
// Near a free end the exact pressure is A sqrt(d), d the distance to the end: A and the end are fitted to the force there, and
// the spline's L2 distance to that root is its error (pressed_stretches). Everywhere else, and of peaks and forces, the error
// is a share of the change from the solution before; of contacts small beside their parts no more than the distance from the
// pressure that half planes would have (plane_pressure), which knows nothing of grids. Corners at which the pressure may have
// no limit are left out. Where cells stayed as they were the error does, too: a change tells nothing of it. Energy and stress:
// from the smoothed stresses of one solution (stress_error).
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "src/analysis/pass_record.hpp"

namespace abut {

/// The estimated errors of one contact, relative to its own values.
struct ContactError {
    double pressure = 0;  ///< L2 over the contact, the larger of the pressure's and of friction's traction over its bound:
    double ends = 0, inside = 0;  ///<   of its free ends, to which the borders of slip belong, and of the rest
    double change = 0;            ///< of the rest, from the grids before
    double peak = 0, force = 0, length = 0;
    double stick_length = 0;   ///< of what sticks, absolute
    double of_integral = 1;    ///< the resultant's size over the pressure's integral: rounding where a fit presses all round
    double share = 1;          ///< of the strongest contact's pressure (L2)
    double share_of_peak = 1;  ///< of the largest pressure of all contacts
    std::vector<double>
        local{};  ///< of the rest, by interval of the pressure: squared error over length, relative to the pressure's norm
    std::vector<double> local_of_shear{};  ///< the same of friction's traction, relative to its bound
    bool at_corner = false;                ///< the largest pressure stands at a corner, where it may have no limit
    double whole_change = 0;               ///< of the pressure, from the grids before
    double kept = 0;                       ///< `inside` by changes before and how fast errors fall
    double of_stiffness = 0;               ///< of the pressure's integral: by how stiff its parts are; not by estimate_errors
    double peak_inside = 0;  ///< `peak` but for what a change beside a free end adds, where it stands while that end moves
};

/// The estimated errors of a solution; unset: nothing to compare with.
struct ErrorEstimate {
    std::vector<std::optional<ContactError>> contacts;  ///< by candidate; unset too where the contact is open
    std::optional<double> contact_pressure;             ///< largest L2 error of contacts, relative to the strongest; no bond's
    std::optional<double> peak;                         ///< largest error of their largest pressures, but for those at corners
    std::optional<double> smoothing;                    ///< energy of what smoothed stresses differ by; not by estimate_errors
    std::optional<double> energy;                       ///< strain energy; not by estimate_errors
    std::optional<double> stress;                       ///< in the energy norm: the root of the energy's
    std::vector<double> own_energy{};                   ///< by solved grid: the strain energy's, of that part's own
    std::vector<double> moved{};             ///< by part of the grids: the largest change of its edges' displacement, absolute
    std::optional<double> largest_stress{};  ///< of the largest von Mises stress, where it has a limit (largest_stress)
};

/// What the target is an error of.
std::optional<double> steering(const ErrorEstimate& e);

/// Estimates the errors of the last pass's contacts. passes: those on the same candidates; before: the estimate of the last but
/// one, which stands where a contact's cells stayed as they were; theory: by candidate, or empty. It knows nothing of the
/// grids: a solution that is nearer to it than the change says is that near to the truth, but for what both are off by in the
/// same direction.
ErrorEstimate estimate_errors(std::span<const PassRecord> passes, const ErrorEstimate& before,
                              std::span<const std::optional<PlanePressure>> theory = {});

/// The strain energy of a solution, and the energy of what its smoothed stresses differ by, relative to it.
struct EnergyOnGrid {
    double energy, smoothing;
};
/// The relative error of the energy on the later of two grids. The differences of smoothed stresses tell how the errors of both
/// compare; the change of the energy is the difference of those errors, which gives their size: at corners without a limit of
/// the stress the smoothed ones see a quarter of the error (error of stress: half), and miss the same fraction on both grids.
double energy_error_of(const EnergyOnGrid& before, const EnergyOnGrid& now);

/// Has the last pressure error fallen by as much as a pass is worth? True where there are no two.
bool has_fallen(std::span<const ErrorEstimate> errors);

/// Has the pressure error fallen over the last two passes by as much as these are worth? Asked where one part has as many cells
/// as it may and others may still have too few: the first estimates are of coarse grids, and rise as often as they fall.
bool is_improving(std::span<const ErrorEstimate> errors);

/// Is the least pressure error of the last passes no smaller than one before? So where contacts that come and go on the way to
/// an answer go on doing so: bodies that friction leaves to roll take other places on each grid.
bool go_astray(std::span<const ErrorEstimate> errors, std::size_t last_ones);

}  // namespace abut

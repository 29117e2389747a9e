// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept of a solution to compare later ones with, without its grids and matrices.
#pragma once
#include <optional>

#include "src/analysis/plane_pressure.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A contact's tangential traction under friction in one pass.
struct ShearRecord {
    Eigen::VectorXd coefficients;         ///< of the pressure's spline
    double coefficient;                   ///< of friction, may be infinite
    std::vector<PressedStretch> borders;  ///< between sticking and slipping, each as a stretch without length
    double border_error;                  ///< L2, with that at the contact's ends
    double stick_length, unseen;          ///< and how much of it may slip unseen
};

/// A contact's pressure in one pass.
struct ContactRecord {
    std::vector<double> s1, s;    ///< table of the middle curve's length against that of the zone's first chain
    solver::KnotVector pressure;  ///< over s; no intervals: no interface
    Eigen::VectorXd coefficients;
    std::vector<PressedStretch> stretches;
    double thickness = 1;
    std::optional<Vec2> resultant{};  ///< force on the first part
    std::optional<ShearRecord> shear{};
    bool is_bond = false;
};

/// What is kept of one pass.
struct PassRecord {
    std::vector<ContactRecord> contacts;  ///< by candidate
    double energy = 0;
    int unknowns = 0, multipliers = 0;
    double seconds = 0;  ///< since the first grid was begun
    /// The displacements, by part of the grids, where edges begin and in their middles, in assembly coordinates.
    std::vector<std::vector<Vec2>> moved{};
};

/// Records a solution; seconds: since the first grid was begun.
PassRecord record_of(const SolvedAssembly& solved, double seconds);

/// The largest difference of two passes' displacements along a part's edges.
double change_of_displacement(const PassRecord& now, const PassRecord& before, std::size_t grid);

/// The largest displacement along a part's edges since the state before, of a step; zero where there is none before.
double displacement_in_step(const SolvedAssembly& solved, std::size_t grid);

/// A change in one interval of a pressure's knots, without the neighbourhoods of corners and of free ends.
struct LocalChange {
    double square = 0;      ///< of the difference, integrated
    double kept = 0;        ///< squared error of before, integrated where the knots stand no closer than then
    double refinement = 0;  ///< the knots' spacing over that before, at most
};

/// The change of a contact's pressure along the middle curve, over both solutions' contact; `before` must be of the same zone.
struct PressureChange {
    double difference = 0;               ///< L2, like the norm without the neighbourhoods of corners
    double inside = 0;                   ///< L2, without the neighbourhoods of corners and of free ends
    double refinement = 1;               ///< of the knots there: their spacing over that before, geometric mean
    double norm = 0;                     ///< L2 of the pressure
    double peak = 0, peak_before = 0;    ///< largest magnitude: bonds pull, too
    double around_peak = 0;              ///< largest difference inside where it could have made, or hidden, the peak
    double at_ends = 0;                  ///< the same in the neighbourhoods of free ends
    double force = 0, force_before = 0;  ///< integral of the pressure, times the thickness
    double force_change = 0;         ///< of the resultant, relative to it; of the integral where that is unknown or rounding
    double ends_left = 0;            ///< what its free ends still have to move, of the contact's length
    std::vector<LocalChange> local;  ///< by interval
    bool peak_stayed = false;        ///< the knots there stand no closer than before
};
/// error_before: by interval of `before`, its squared error over length; empty: unknown.
PressureChange change_of(const ContactRecord& now, const ContactRecord& before, const std::vector<double>& error_before = {});
/// Do both tables begin and end at the same places? Those of a closed zone may have moved.
bool are_of_one_zone(const ContactRecord& now, const PlanePressure& theory);
/// The change of a contact's pressure from the theory's, which has no force and no knots: refinement 1.
PressureChange change_from(const ContactRecord& now, const PlanePressure& theory);

}  // namespace abut

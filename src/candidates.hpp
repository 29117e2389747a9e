// SPDX-License-Identifier: GPL-3.0-or-later
// Which stretches of which parts can come into contact.
#pragma once
#include <vector>

#include "geometry/facing.hpp"
#include "src/scene.hpp"

namespace abut {

/// Where contact is expected to end, from the grids before.
struct ExpectedEnd {
    double s1;    ///< arc length on the zone's first chain
    int outward;  ///< +1: beyond it, at larger s1, the gap is open; -1: the other way
};

/// Coefficients of the pressure that was found along a zone.
struct ExpectedPressure {
    std::vector<double> s1;  ///< of each the place on the zone's first chain (arc length), ascending; closed zones: once around
    std::vector<double> pressure;
};

struct Candidate {
    int first, second;  ///< indices into Scene::parts, first < second
    geometry::FacingZone zone;
    double closing = 0;       ///< interference
    bool no_overlap = false;  ///< drawn overlaps count as touching
    bool bonded = false;      ///< held together as drawn
    int rule = -1;            ///< the scene's rule for this pair, if any
    std::vector<ExpectedEnd> ends{};
    ExpectedPressure expected{};  ///< empty: nothing is known
};

/// Drawn overlaps up to this fraction of the smaller part's diagonal are the drawing's rounding, not a fault.
inline constexpr double overlap_fraction = 1e-6;

/// Distance up to which two parts are candidates at first, as a fraction of the smaller diagonal; it grows where contact
/// reaches the end of a zone.
inline constexpr double first_search_fraction = 0.05;

/// Distance up to which two parts are searched.
double search_distance(const Scene& scene, int first, int second, double factor);

using PartPairs = std::vector<std::pair<int, int>>;
/// The parts of every candidate; those that an interference presses together, or with "press_fit" a drawn overlap.
PartPairs touching_pairs(const std::vector<Candidate>& candidates);
PartPairs closing_pairs(const Scene& scene, const std::vector<Candidate>& candidates);

/// factor: widens the search distance. Throws InputError for drawn overlaps that the scene does not allow, naming edges and
/// place.
std::vector<Candidate> find_candidates(const Scene& scene, double factor);

}  // namespace abut

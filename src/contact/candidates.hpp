// SPDX-License-Identifier: GPL-3.0-or-later
// Which stretches of which parts can come into contact: the one search that all commands share.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "geometry/brep/closest_points.hpp"
#include "geometry/csg/overlap.hpp"
#include "geometry/proximity/facing.hpp"
#include "src/contact/cell_search.hpp"
#include "src/contact/pair_rules.hpp"
#include "src/contact/search_distances.hpp"
#include "src/scene/scene.hpp"

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

/// A zone of two parts that may come into contact, with the scene's rule for it and what earlier grids know of it.
struct Candidate {
    int first, second;  ///< indices into Scene::parts, first < second, or the same: a part with itself
    geometry::FacingZone zone;
    double interference = 0;  ///< by the rule
    double apart = 0;  ///< an overlap that counts as touching (SearchDistances::precision; where a solution has the parts)
    bool no_overlap = false;  ///< drawn overlaps count as touching
    bool bonded = false;      ///< held together as drawn
    double friction = 0;      ///< coefficient; infinite: rough
    int rule = -1;            ///< the scene's rule for this pair, if any
    bool shown = true;        ///< within the distance that `contacts` shows
    std::vector<ExpectedEnd> ends{};
    ExpectedPressure expected{};  ///< empty: nothing is known

    /// What is taken off the drawn gap.
    double closing() const { return interference - apart; }
};

using PartPairs = std::vector<std::pair<int, int>>;
/// touching_pairs: the parts of every candidate. closing_pairs: those that an interference presses together, or, with
/// "press_fit", that drawn overlaps may: all of them.
PartPairs touching_pairs(const std::vector<Candidate>& candidates);
PartPairs closing_pairs(const Scene& scene, const std::vector<Candidate>& candidates);

/// Makes a closed zone begin, and end, at a pair.
void begin_at(const geometry::FacingPair& pair, geometry::FacingZone& zone);

/// What two parts have to do with each other as drawn.
struct Encounter {
    int first, second;
    std::vector<Candidate> candidates{};               ///< along the first part
    std::optional<geometry::ClosestPoints> closest{};  ///< of the boundaries, within the distance asked for
    bool unpaired = false;                             ///< at the closest points no faces oppose each other
    std::optional<geometry::Overlap> overlap{};        ///< more than rounding, and not left alone by a rule
    bool too_deep = false;                             ///< the overlap: no faces are paired across it
    bool counts_as_touching = false;                   ///< whatever overlaps is within what drawings are precise to
    bool is_refused = false;                           ///< the overlap: neither allowed nor within what drawings are precise to
};

/// Distances up to which zones are looked for, are shown, and closest points are looked for; with the dissertation's search
/// the zones are what its cells let in.
struct EncounterDistances {
    double search, shown, closest;
    const CellSearch* cells = nullptr;
};

/// Finds what two parts have to do with each other. Zones are cut where rules change; those left alone are not among the
/// candidates.
Encounter encounter_of(const Scene& scene, const PairRules& rules, const SearchDistances& distances, int first, int second,
                       const EncounterDistances& within);

/// A candidate's smallest gap; at a corner the distance, since gaps along middle normals are longer there.
double drawn_gap(const Scene& scene, const Encounter& encounter, const Candidate& candidate, double touching);

/// A part's candidates with itself within a distance. They are not among those that `contacts` shows.
std::vector<Candidate> own_candidates(const Scene& scene, const PairRules& rules, int part, double distance);

/// All encounters within the search distance that `factor` widens, by parts; those of one part come last.
std::vector<Encounter> find_encounters(const Scene& scene, double factor);

/// Does `a` come before `b` in the order of contacts 1, 2, ...? Those shown come first, in the order of parts.
bool comes_before(const Candidate& a, const Candidate& b);

/// The candidates of all encounters, in that order. With factor 1 throws InputError for overlaps that the scene does not allow,
/// naming edges and place.
std::vector<Candidate> find_candidates(const Scene& scene, double factor);
/// The candidates of all encounters, in that order, whatever overlaps.
std::vector<Candidate> find_candidates_anyway(const Scene& scene, double factor);

/// Does friction act anywhere?
bool has_friction(const std::vector<Candidate>& candidates);

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
// What every formulation's interface is made of: where grid lines cross a face, the cells there, points with both bodies'
// frames.
#pragma once
#include <vector>

#include "src/solution/contact_interface.hpp"

namespace abut {

/// Pieces shorter than this fraction of the zone are rounding between crossings that coincide.
inline constexpr double shortest_piece = 1e-9;

/// The arc lengths on a chain where its part's grid lines cross it or its edges meet, within (low, high), which may run past a
/// turn.
std::vector<double> crossings(const PartOnGrid& g, const geometry::Chain& chain, double low, double high);

/// The places on chain 1 where either part's grid lines cross its face, with the zone's ends, ascending: between them
/// everything is smooth. Those of the second part by the middle curve's pairs.
std::vector<double> crossings_of_both(const Scene& scene, const geometry::FacingZone& zone, const PartOnGrid& first,
                                      const PartOnGrid& second);

/// The places in ascending order, those closer together than the shortest piece as one. The last stays.
std::vector<double> without_short_pieces(std::vector<double> places, double whole);

/// The larger side of the cell around a boundary point. What a pressure of short waves does to a body decays away from the face
/// as fast as it changes along it, so that it changes along both sides of a cell alike, however the face lies.
double cell_size(const PartOnGrid& g, const geometry::ChainPoint& p);

/// The compliance 1/E of a part on its grid.
double compliance(const Scene& scene, const PartOnGrid& g);

/// Appends the pair as a point of the interface, at arc length s; its gap as c.drawn has it.
void append_point(ContactInterface& c, const geometry::FacingPair& pair, const PartOnGrid& first, const PartOnGrid& second,
                  double s, double weight);

/// The stiffness of a Winkler foundation as deep as the larger body's tenth: only the start of the active set depends on it.
double winkler_stiffness(const Scene& scene, const PartOnGrid& first, const PartOnGrid& second);

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
// How the faces of a candidate meet: which edges, as what kind of contact.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/interfaces/functional_interface.hpp"
#include "src/contact/candidates.hpp"

namespace abut {

using geometry::FunctionalInterface;

/// The faces of a candidate, by pairs of edges, and what they make of it.
struct CandidateFaces {
    std::map<std::array<int, 2>, double> lengths;  ///< on the first part, by pair of edges
    std::array<int, 2> carrying{0, 0};             ///< the pair that is longest
    double shared_length = 0;                      ///< of edges that lie on each other wherever they face each other
    std::string kind{};                            ///< "pin-in-hole", "flat-on-flat", ...
    FunctionalInterface functional{};              ///< about the origin of assembly coordinates
};
CandidateFaces faces_of(const Scene& scene, const Candidate& candidate);

/// An edge as users know it: "part/edge".
std::string name_of_edge(const ScenePart& part, int edge);
/// The edges of both parts that have a share in a candidate's faces, by name; those next to rounding are not named.
std::array<std::vector<std::string>, 2> edge_names(const Scene& scene, const Candidate& candidate, const CandidateFaces& faces);

/// The kind of contact at the corner that meets a face, where a candidate's faces come closest at an end at which they are not
/// parallel; else nothing.
std::optional<std::string> corner_kind(const Scene& scene, const Candidate& candidate);

/// The functional interface of two boundary points, one at least a corner's, that are all there is of a contact.
FunctionalInterface functional_at_corner(const Scene& scene, int first, int second, const geometry::ClosestPoints& at,
                                         const std::string& kind);

}  // namespace abut

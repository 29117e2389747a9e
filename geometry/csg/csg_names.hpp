// SPDX-License-Identifier: GPL-3.0-or-later
// From pieces of primitives' edges to the named edges of a part.
#pragma once
#include <vector>

#include "geometry/csg/primitives.hpp"

namespace abut::geometry {

/// An edge of a primitive where it has been placed, as the pieces refer to it.
struct PlacedSource {
    Curve curve;         ///< in its own direction
    std::string name;    ///< "left"
    std::string prefix;  ///< names of the nodes, may be empty
    int primitive = 0;   ///< place in the tree, counted from 0 in reading order
    double begin = 0;    ///< see SourceEdge
};

/// Edges of all primitives, primitive after primitive: a piece's source is an index into this list.
std::vector<PlacedSource> placed_sources(const std::vector<Primitive>& primitives);

/// A piece of the result's boundary, material on the left.
struct Piece {
    Curve curve;
    int source = -1;
    double t_begin = 0,
           t_end = 1;  ///< its portion of the source: t_begin > t_end where it runs against the source's direction.
                       ///< Beyond 1 behind the seam of a circle or ellipse; anything on the line of a half plane
};

/// Names the pieces as csg.hpp says, fills in where each lies on its source, and puts everything into a lasting order: outer
/// loops before holes, loops by their first piece (lowest source, then lowest arc length), each loop beginning there.
Part named_part(const std::vector<PlacedSource>& sources, const std::vector<std::vector<Piece>>& loops);

}  // namespace abut::geometry

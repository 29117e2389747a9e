// SPDX-License-Identifier: GPL-3.0-or-later
// What a grid misses where the stress has no limit. Near such a place the exact strain energy within a distance r grows with a
// power of r, 1 to 1.5 (Williams, J. Appl. Mech. 19, 1952), and splines miss a fixed fraction of what lies within a cell's
// size: contact pressures far away do not show it, displacements do. Where a load ends on a smooth edge the stress has a limit
// but in no direction the same: splines miss what such a jump stores in a cell's area, half of which smoothed stresses see.
#pragma once
#include <vector>

#include "src/solution/assembly_model.hpp"

namespace abut {

/// The energy that a grid misses at one place.
struct SingularError {
    std::size_t grid;  ///< index into SolvedAssembly::grids
    Vec2 at;           ///< assembly coordinates
    bool is_of_contact;
    double cell;    ///< size of the cell there
    double energy;  ///< strain energy that is missed
    double order;   ///< it falls with this power of the cell
};

/// The errors at all places of parts that are not rigid. Cost: the stress at the quadrature points of some ten cells a place.
std::vector<SingularError> singular_errors(const Scene& scene, const ResolvedConditions& conditions,
                                           const SolvedAssembly& solved);

/// Adds cells at these places that miss no more than the fraction `target` of the strain energy, of all of them together, but
/// for ends of contact, whose cells follow the pressure. Also where the present ones miss less: the next would be larger.
void add_singular_cells(const SolvedAssembly& solved, const std::vector<SingularError>& errors, double target,
                        WantedSizes& wanted);

}  // namespace abut

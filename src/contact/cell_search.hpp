// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's contact search as the one that decides [Grishin10, section 4.5.1]: parts whose cells on one grid are the
// same or neighbours are in contact, along the first part's boundary in those cells and nowhere else.
#pragma once
#include <optional>
#include <vector>

#include "geometry/interfaces/common_grid.hpp"
#include "geometry/proximity/facing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// The size of the cells of the one grid over all parts: accuracy.cell_size, or case_cell_fraction of the smallest extent.
double search_cell(const Scene& scene);

/// How far apart points of two cells that share a side can be: zones up to there hold all that the cells let in.
double cell_search_distance(const Scene& scene);

/// Makes the one grid over all parts, from their classes of cells to the split. Throws InputError where it would have too many
/// cells.
geometry::CommonGrid search_grid(const Scene& scene);

/// A scene's search on its grid.
class CellSearch {
public:
    explicit CellSearch(const Scene& scene);
    /// The case a to e of two parts, in either order; of 'e', and so of all that have no level in common, there is no contact.
    char case_of(int first, int second) const;
    /// The stretches of zones that lie in the first part's contact cells. Where one ends at a cell's side it is marked as a
    /// limit of the search.
    std::vector<geometry::FacingZone> in_cells(const Scene& scene, int first, int second,
                                               const std::vector<geometry::FacingZone>& zones) const;

private:
    geometry::CommonGrid grid_;
    std::vector<Levels> levels_;
};

/// The search of a scene by the dissertation's method; none for others.
std::optional<CellSearch> cell_search(const Scene& scene);

}  // namespace abut

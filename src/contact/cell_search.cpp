// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/cell_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/brep/extent.hpp"
#include "geometry/proximity/zone_pieces.hpp"
#include "src/base/index.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/scene/part_levels.hpp"

namespace abut {

namespace {

using geometry::FacingZone;

/// Arc lengths on a zone's first chain.
struct Stretch {
    double begin, end;
};

/// Stretches this short, of the chain, lie between two that are one.
constexpr double rounding_of_length = 1e-9;

/// The stretches of a chain in contact cells: pieces between grid lines, each in one cell.
std::vector<Stretch> in_contact(const geometry::Part& part, const geometry::Chain& chain, const geometry::CutCells& cells,
                                const std::vector<char>& is_contact) {
    std::vector<Stretch> found;
    for (std::size_t k = 0; k < chain.edges.size(); ++k) {
        const int e = chain.edges[k];
        const geometry::Curve& curve = part.edges[at(e)].curve;
        for (int i = cells.first_piece[at(e)]; i < cells.first_piece[at(e) + 1]; ++i) {
            const geometry::BoundaryPiece& piece = cells.pieces[at(i)];
            if (piece.cell < 0 || !is_contact[at(piece.cell)]) continue;
            const Stretch s{chain.begin[k] + length(curve, 0, piece.t0), chain.begin[k] + length(curve, 0, piece.t1)};
            if (!found.empty() && s.begin - found.back().end <= rounding_of_length * chain.length)
                found.back().end = s.end;
            else
                found.push_back(s);
        }
    }
    return found;
}

/// What stretches and zone have in common, in the zone's arc lengths; what goes on beyond a full turn is one.
std::vector<Stretch> clipped(const std::vector<Stretch>& stretches, const FacingZone& zone) {
    const double turn = zone.chain1.length, slack = rounding_of_length * turn;
    std::vector<Stretch> found;
    for (const int turns : zone.chain1.closed ? std::vector{-1, 0, 1} : std::vector{0})
        for (const Stretch& s : stretches) {
            const Stretch part{std::max(zone.begin1, s.begin + turns * turn), std::min(zone.end1, s.end + turns * turn)};
            if (part.end - part.begin <= slack) continue;
            if (!found.empty() && part.begin - found.back().end <= slack)
                found.back().end = part.end;
            else
                found.push_back(part);
        }
    const bool goes_on =
        zone.closed && found.size() > 1 && found.front().begin - zone.begin1 <= slack && zone.end1 - found.back().end <= slack;
    if (goes_on) {
        found.back().end = found.front().end + turn;
        found.erase(found.begin());
    }
    return found;
}

void fill_gaps(const geometry::Part& part1, const geometry::Part& part2, FacingZone& zone) {
    zone.gap_min = std::numeric_limits<double>::infinity();
    zone.gap_max = -zone.gap_min;
    for (const geometry::ZonePiece& p : zone_pieces(part1, part2, zone)) {
        zone.gap_min = std::min(zone.gap_min, p.gap_min);
        zone.gap_max = std::max(zone.gap_max, p.gap_max);
    }
}

}  // namespace

double search_cell(const Scene& scene) {
    if (scene.accuracy.cell_size) return *scene.accuracy.cell_size;
    double smallest = std::numeric_limits<double>::infinity();
    for (const ScenePart& part : scene.parts) smallest = std::min(smallest, geometry::extent(part.part));
    return geometry::case_cell_fraction * smallest;
}

double cell_search_distance(const Scene& scene) {
    return std::sqrt(5.0) * search_cell(scene);  // the diagonal of two cells side by side
}

geometry::CommonGrid search_grid(const Scene& scene) {
    std::vector<const geometry::Part*> parts;
    for (const ScenePart& part : scene.parts) parts.push_back(&part.part);
    geometry::CommonGrid grid = geometry::common_grid(parts, search_cell(scene));
    if (!grid.refusal.empty())
        throw InputError(scene.accuracy.cell_size ? "/accuracy/cell_size" : "/accuracy/method",
                         "the dissertation's one grid over all parts cannot be made: " + grid.refusal,
                         "give accuracy.cell_size a larger value");
    return grid;
}

CellSearch::CellSearch(const Scene& scene) : grid_(search_grid(scene)) {
    for (const ScenePart& part : scene.parts) levels_.push_back(part.level);
}

char CellSearch::case_of(int first, int second) const {
    return have_common_level(levels_[at(first)], levels_[at(second)]) ? case_of_parts(grid_, first, second) : 'e';
}

std::vector<FacingZone> CellSearch::in_cells(const Scene& scene, int first, int second,
                                             const std::vector<FacingZone>& zones) const {
    if (zones.empty()) return {};
    const geometry::Part &part1 = part_of(scene, first), &part2 = part_of(scene, second);
    const geometry::CutCells cells = cut_cells(part1, split_grid(grid_, first));
    const geometry::CellRange& box = grid_.split[at(first)];
    std::vector<char> is_contact(cells.cell_class.size(), 0);
    for (const int cell : cells_beside(grid_.parts[at(first)], grid_.parts[at(second)], grid_.grid.columns)) {
        const int column = cell % grid_.grid.columns, row = cell / grid_.grid.columns;
        if (box.holds(column, row)) is_contact[box.index(column, row)] = 1;
    }
    std::vector<FacingZone> found;
    for (const FacingZone& as_found : zones) {
        // its ends are paired anew where forces act along other lines: before they are cut
        const FacingZone zone = acting_zone(part1, part2, as_found);
        const double slack = rounding_of_length * zone.chain1.length;
        for (const Stretch& s : clipped(in_contact(part1, zone.chain1, cells, is_contact), zone)) {
            if (s.begin - zone.begin1 <= slack && zone.end1 - s.end <= slack) {
                found.push_back(zone);
                continue;
            }
            FacingZone part = stretch_of(part1, part2, zone, s.begin, s.end);
            part.begin_is_limit = part.begin_is_limit || s.begin - zone.begin1 > slack;
            part.end_is_limit = part.end_is_limit || zone.end1 - s.end > slack;
            fill_gaps(part1, part2, part);
            found.push_back(std::move(part));
        }
    }
    return found;
}

std::optional<CellSearch> cell_search(const Scene& scene) {
    if (!is_by_dissertation(scene) || scene.parts.size() < 2) return std::nullopt;
    return CellSearch(scene);
}

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/detect.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "geometry/interfaces/cell_case.hpp"
#include "geometry/interfaces/interface_kind.hpp"
#include "src/contact/candidate_faces.hpp"
#include "src/contact/drawn_overlap.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

using geometry::ClosestPoints;
using geometry::FacingPair;
using geometry::FacingZone;
using geometry::Part;

constexpr double near_miss_fraction = 0.10;  // of the smaller part's extent

/// What all rows of two parts have in common.
DetectedPair row_of(const Scene& scene, const Encounter& m, const std::array<int, 2>& carrying) {
    DetectedPair row;
    row.part = {m.first, m.second};
    for (std::size_t side = 0; side < 2; ++side) {
        row.parts[side] = scene_part(scene, row.part[side]).name;
        row.between[side] = name_of_edge(scene_part(scene, row.part[side]), carrying[side]);
    }
    return row;
}

/// Some of the zone's pairs, from end to end.
std::vector<FacingPair> pairs_along(const Scene& scene, const Candidate& c) {
    constexpr int n = 48;
    std::vector<FacingPair> pairs;
    double guess = c.zone.begin2;
    for (int i = 0; i <= n; ++i) {
        const double s1 = c.zone.begin1 + (c.zone.end1 - c.zone.begin1) * i / n;
        const FacingPair pair =
            pair_from_first(scene_part(scene, c.first).part, scene_part(scene, c.second).part, c.zone, s1, guess);
        if (!pair.found) continue;
        guess = pair.s2;
        pairs.push_back(pair);
    }
    return pairs;
}

std::string status_of(double gap, double touching) {
    return gap < -touching ? "overlap" : gap <= touching ? "touching" : "gap";
}

std::string why_overlapping(const Scene& scene, const Encounter& m) {
    return overlap_text(scene, m) + (m.is_refused ? ": " + overlap_hint(scene, m) : "");
}

/// "touching at (0, 0)", "0.1 mm apart at (0, 0)".
std::string how_close(const Scene& scene, double gap, double touching, const Vec2& at) {
    return (gap <= touching ? "touching" : with_unit(gap, 4, scene.length_unit) + " apart") + " at " + pair_text(at, 6);
}

std::string rule_text(const Scene& scene, const Candidate& c) {
    if (c.bonded) return ", bonded";
    return c.interference == 0 ? "" : ", with an interference of " + with_unit(c.interference, 4, scene.length_unit);
}

/// How the encounters of two parts are listed.
struct Listing {
    const Scene& scene;
    const Encounter& encounter;
    double searched, shown, touching;
};

DetectedPair row_of(const Listing& l, const Candidate& c, const Candidate* deepest) {
    const Encounter& m = l.encounter;
    const CandidateFaces faces = faces_of(l.scene, c);
    DetectedPair row = row_of(l.scene, m, faces.carrying);
    row.edges = edge_names(l.scene, c, faces);
    const double drawn = drawn_gap(l.scene, m, c, l.touching);
    row.gap_min = drawn - c.interference;
    row.gap_max = c.zone.gap_max - c.interference;
    row.status = status_of(drawn, l.touching);
    row.interface = faces.kind;
    row.functional = faces.functional;
    row.overlap_area = m.overlap && &c == deepest ? m.overlap->area : 0;
    row.length = c.zone.end1 - c.zone.begin1;
    row.shared_length = faces.shared_length;
    const std::vector<FacingPair> pairs = pairs_along(l.scene, c);
    for (const FacingPair& p : pairs) row.marks.push_back({p.on1.x, p.on2.x});
    const auto closest =
        std::min_element(pairs.begin(), pairs.end(), [](const FacingPair& a, const FacingPair& b) { return a.gap < b.gap; });
    const std::string along = ", facing within " + with_unit(l.searched, 4, l.scene.length_unit) + " along " +
                              with_unit(row.length, 4, l.scene.length_unit);
    if (row.overlap_area > 0)
        row.why = why_overlapping(l.scene, m);
    else if (row.status == "overlap")
        row.why = "drawn into each other by up to " + with_unit(-drawn, 4, l.scene.length_unit) + along;
    else
        row.why = how_close(l.scene, drawn, l.touching, closest == pairs.end() ? Vec2(0, 0) : closest->on1.x) + along;
    row.why += rule_text(l.scene, c);
    return row;
}

/// An overlap that no faces measure.
DetectedPair overlap_row(const Listing& l) {
    const Encounter& m = l.encounter;
    const geometry::Overlap& o = *m.overlap;
    DetectedPair row = row_of(l.scene, m, {o.edge1, o.edge2});
    row.edges = {std::vector{row.between[0]}, std::vector{row.between[1]}};
    row.gap_min = row.gap_max = -o.depth;
    row.status = "overlap";
    row.interface =
        geometry::interface_kind(scene_part(l.scene, m.first).part, o.edge1, scene_part(l.scene, m.second).part, o.edge2);
    row.functional.kind = row.interface;
    row.overlap_area = o.area;
    row.marks = {{o.at, o.at}};
    row.why = why_overlapping(l.scene, m);
    return row;
}

/// Closest points where no faces oppose each other.
DetectedPair place_row(const Listing& l) {
    const Encounter& m = l.encounter;
    const ClosestPoints& c = *m.closest;
    const Part &first = scene_part(l.scene, m.first).part, &second = scene_part(l.scene, m.second).part;
    DetectedPair row = row_of(l.scene, m, {c.edge1, c.edge2});
    row.edges = {std::vector{row.between[0]}, std::vector{row.between[1]}};
    row.gap_min = row.gap_max = c.distance;
    row.status = status_of(c.distance, l.touching);
    const bool corner = is_convex_corner(first, c.edge1, c.t1) || is_convex_corner(second, c.edge2, c.t2);
    row.interface = corner ? corner_interface(first, c.edge1, c.t1, second, c.edge2, c.t2)
                           : geometry::interface_kind(first, c.edge1, second, c.edge2);
    row.functional = functional_at_corner(l.scene, m.first, m.second, c, row.interface);
    row.marks = {{c.x1, c.x2}};
    row.why = how_close(l.scene, c.distance, l.touching, c.x1) + ", where no faces oppose each other";
    return row;
}

/// What lies between the distances of pairs and of near misses, if anything: its zones reach that far.
void list_near_miss(const Listing& l, std::vector<DetectedPair>& near_misses) {
    const std::vector<Candidate>& all = l.encounter.candidates;
    const auto nearest = std::min_element(
        all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.zone.gap_min < b.zone.gap_min; });
    if (nearest == all.end() && !l.encounter.unpaired) return;
    near_misses.push_back(nearest == all.end() || l.encounter.unpaired ? place_row(l) : row_of(l, *nearest, nullptr));
    near_misses.back().marks = {{l.encounter.closest->x1, l.encounter.closest->x2}};
    near_misses.back().why = how_close(l.scene, near_misses.back().gap_min, l.touching, l.encounter.closest->x1) +
                             ", farther than the distance of pairs " + with_unit(l.shown, 4, l.scene.length_unit);
}

/// PairRows of two parts, those of places without faces apart from the others.
struct PairRows {
    std::vector<DetectedPair> faces, places;
};

void list_pairs(const Listing& l, PairRows& rows) {
    const Encounter& m = l.encounter;
    const auto deepest = std::min_element(m.candidates.begin(), m.candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.zone.gap_min < b.zone.gap_min;
    });
    const bool faces_measure_it = !m.too_deep && deepest != m.candidates.end() && deepest->zone.gap_min < -l.touching;
    if (m.overlap && !faces_measure_it) rows.places.push_back(overlap_row(l));
    for (const Candidate& c : m.candidates) {
        const bool covered = m.too_deep && c.zone.gap_min < -l.touching;  // the zone ends on its way into the overlap
        if (c.shown && !covered) rows.faces.push_back(row_of(l, c, faces_measure_it ? &*deepest : nullptr));
    }
    if (m.unpaired && !m.overlap && m.closest->distance <= std::max(l.shown, l.touching)) rows.places.push_back(place_row(l));
}

/// By the search that decided, or each pair on a grid of its own.
void fill_cell_cases(const Scene& scene, const SearchDistances& distances, const std::optional<CellSearch>& cells,
                     std::vector<DetectedPair>& rows) {
    std::map<std::array<int, 2>, std::string> cases;
    for (DetectedPair& row : rows) {
        std::string& letter = cases[row.part];
        if (letter.empty() && cells) letter = {cells->case_of(row.part[0], row.part[1])};
        if (letter.empty())
            letter = {cell_case(scene_part(scene, row.part[0]).part, scene_part(scene, row.part[1]).part,
                                geometry::case_cell_fraction * distances.size(row.part[0], row.part[1]))};
        row.cells_case = letter;
    }
}

}  // namespace

Detection detect_contacts(const Scene& scene, std::optional<double> distance) {
    Detection found;
    const PairRules rules(scene);
    const SearchDistances distances(scene);
    PairRows rows;
    const int n = static_cast<int>(scene.parts.size());
    const std::optional<CellSearch> cells = cell_search(scene);
    for (int i = 0; i < n; ++i)
        for (int k = i + 1; k < n; ++k) {
            if (cells) {
                const double all = cell_search_distance(scene);
                found.distance = all;
                if (cells->case_of(i, k) == 'e') continue;
                const Encounter m = encounter_of(scene, rules, distances, i, k, {all, all, all, &*cells});
                if (m.overlap || m.closest) list_pairs({scene, m, all, all, distances.touching(i, k)}, rows);
                continue;
            }
            const double shown = distance.value_or(distances.shown(i, k)),
                         searched = std::max(shown, distances.searched(i, k, 1));
            const double near_miss = std::max(searched, near_miss_fraction * distances.size(i, k));
            found.distance = std::max(found.distance, shown);
            if (!distances.within(i, k, near_miss)) continue;
            const Encounter m = encounter_of(scene, rules, distances, i, k, {searched, shown, near_miss});
            if (!m.overlap && !m.closest) continue;
            const std::size_t before = rows.faces.size() + rows.places.size();
            list_pairs({scene, m, searched, shown, distances.touching(i, k)}, rows);
            if (rows.faces.size() + rows.places.size() > before || m.overlap || m.closest->distance <= shown) continue;
            const Encounter wider = encounter_of(scene, rules, distances, i, k, {near_miss, shown, near_miss});
            list_near_miss({scene, wider, near_miss, shown, distances.touching(i, k)}, found.near_misses);
        }
    found.pairs = std::move(rows.faces);
    std::move(rows.places.begin(), rows.places.end(), std::back_inserter(found.pairs));
    for (std::vector<DetectedPair>* list : {&found.pairs, &found.near_misses}) fill_cell_cases(scene, distances, cells, *list);
    return found;
}

}  // namespace abut

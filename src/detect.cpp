// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/detect.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "geometry/cell_case.hpp"
#include "geometry/closest_points.hpp"
#include "geometry/extent.hpp"
#include "geometry/facing.hpp"
#include "geometry/interface_kind.hpp"
#include "geometry/overlap.hpp"
#include "geometry/zone_pieces.hpp"
#include "src/facing_edges.hpp"
#include "src/result_units.hpp"
#include "src/selection.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

using geometry::ClosestPoints;
using geometry::Edge;
using geometry::FacingPair;
using geometry::FacingZone;
using geometry::Part;

constexpr double near_miss_fraction = 0.10;  // of the smaller part's extent
/// Gaps and overlaps below this fraction of the smaller extent are touching: above the six digits that drawings are commonly
/// written with, below the joining tolerance of imports and any clearance that means something.
constexpr double touching_fraction = 1e-6;
/// Edges with a smaller share of the facing length are not named: rounding next to the ends of others.
constexpr double least_share = 1e-3;
/// Shares that differ by less are equal but for rounding: the first one counts, however the assembly lies.
constexpr double equal_shares = 1e-9;

/// Facing length, on the first part, by pair of edges.
using Shares = std::map<std::array<int, 2>, double>;

/// What is known about two parts.
struct Meeting {
    std::array<int, 2> part;
    const Part &first, &second;
    double distance, touching;
    std::optional<ClosestPoints> closest;
    geometry::Overlap overlap;
    std::vector<FacingZone> zones;
    Shares shares;
    double shared_length = 0;
    std::vector<std::array<Vec2, 2>> marks;
    std::vector<FacingEdges> stretches;
};

/// Pairs of edges that the scene wants left alone.
class IgnoredEdges {
public:
    explicit IgnoredEdges(const Scene& scene) {
        for (const PairRule& rule : scene.contacts.pairs) {
            if (rule.kind != PairRule::Kind::ignore) continue;
            rules_.push_back({edges_of(scene, rule.between[0]), edges_of(scene, rule.between[1])});
        }
    }
    bool holds(int part1, int edge1, int part2, int edge2) const {
        const std::array<int, 2> a{part1, edge1}, b{part2, edge2};
        return std::any_of(rules_.begin(), rules_.end(),
                           [&](const auto& r) { return (r[0].count(a) && r[1].count(b)) || (r[0].count(b) && r[1].count(a)); });
    }
    /// Does one rule cover all edges of both parts?
    bool holds(const Scene& scene, int part1, int part2) const {
        const auto all = [&](const Edges& edges, int part) {
            for (int e = 0; e < n_edges(scene, part); ++e)
                if (!edges.count({part, e})) return false;
            return true;
        };
        return std::any_of(rules_.begin(), rules_.end(), [&](const auto& r) {
            return (all(r[0], part1) && all(r[1], part2)) || (all(r[0], part2) && all(r[1], part1));
        });
    }

private:
    using Edges = std::set<std::array<int, 2>>;
    static int n_edges(const Scene& scene, int part) {
        return static_cast<int>(scene.parts[static_cast<std::size_t>(part)].part.edges.size());
    }
    static Edges edges_of(const Scene& scene, const Selector& selector) {
        Edges edges;
        for (std::size_t p = 0; p < scene.parts.size(); ++p)  // a part's name stands for all of its edges
            if (selector.pattern == scene.parts[p].name)
                for (int e = 0; e < n_edges(scene, static_cast<int>(p)); ++e) edges.insert({static_cast<int>(p), e});
        if (!edges.empty()) return edges;
        for (const EdgePortion& portion : select(scene, {selector})) edges.insert({portion.part, portion.edge});
        return edges;
    }
    std::vector<std::array<Edges, 2>> rules_;
};

/// Follows the zone through n + 1 pairs from end to end; `visit` gets each pair.
template <class Visit>
void follow(const Meeting& m, const FacingZone& zone, int n, Visit visit) {
    double guess = zone.begin2;
    for (int i = 0; i <= n; ++i) {
        const double s1 = zone.begin1 + (zone.end1 - zone.begin1) * i / n;
        const FacingPair pair = geometry::pair_from_first(m.first, m.second, zone, s1, guess);
        if (!pair.found) continue;
        guess = pair.s2;
        visit(pair);
    }
}

/// Shares the zone's length out among the pairs of edges along it. Edges that lie on each other wherever they face each other
/// are shared boundary.
void share_out(Meeting& m, const FacingZone& zone, const IgnoredEdges& ignored) {
    for (const geometry::ZonePiece& piece : zone_pieces(m.first, m.second, zone)) {
        if (ignored.holds(m.part[0], piece.edge1, m.part[1], piece.edge2)) continue;
        m.shares[{piece.edge1, piece.edge2}] += piece.end1 - piece.begin1;
        m.stretches.push_back(facing_edges(m.first, m.second, zone, piece));
        if (std::max(std::abs(piece.gap_min), std::abs(piece.gap_max)) <= m.touching)
            m.shared_length += piece.end1 - piece.begin1;
    }
}

void follow_zones(Meeting& m, const IgnoredEdges& ignored) {
    constexpr int marks_per_zone = 48;
    for (const FacingZone& zone : m.zones) {
        share_out(m, zone, ignored);
        follow(m, zone, marks_per_zone, [&](const FacingPair& p) {
            if (!ignored.holds(m.part[0], p.on1.edge, m.part[1], p.on2.edge)) m.marks.push_back({p.on1.x, p.on2.x});
        });
    }
}

double facing_length(const Meeting& m) {
    double sum = 0;
    for (const auto& [edges, length] : m.shares) sum += length;
    return sum;
}

std::array<int, 2> carrying_edges(const Meeting& m) {
    if (m.shares.empty()) return m.closest ? std::array{m.closest->edge1, m.closest->edge2} : std::array{0, 0};
    double largest = 0;
    for (const auto& [edges, length] : m.shares) largest = std::max(largest, length);
    const auto carries = [&](const auto& share) { return share.second >= (1 - equal_shares) * largest; };
    return std::find_if(m.shares.begin(), m.shares.end(), carries)->first;
}

std::string edge_name(const ScenePart& part, int edge) {
    return part.name + "/" + part.part.edges[static_cast<std::size_t>(edge)].name;
}

void name_edges(const Scene& scene, const Meeting& m, DetectedPair& pair) {
    const std::array<int, 2> carrying = carrying_edges(m);
    const double least = least_share * facing_length(m);
    for (std::size_t side = 0; side < 2; ++side) {
        const ScenePart& part = scene.parts[static_cast<std::size_t>(m.part[side])];
        pair.parts[side] = part.name;
        pair.between[side] = edge_name(part, carrying[side]);
        std::map<int, double> lengths{{carrying[side], 0}};
        for (const auto& [edges, length] : m.shares) lengths[edges[side]] += length;
        for (const auto& [edge, length] : lengths)
            if (edge == carrying[side] || length > least) pair.edges[side].push_back(edge_name(part, edge));
    }
}

/// Two faces farther from parallel than this make contact at a corner, not along a face (cosine of 1 degree).
constexpr double least_flush = 0.99985;

/// Outward normals at a boundary point: two of them at the joint of two edges.
std::vector<Vec2> normals_at(const Part& part, int edge, double t) {
    std::vector<Vec2> normals{outward_normal(part.edges[static_cast<std::size_t>(edge)].curve, t)};
    const Vec2 x = point(part.edges[static_cast<std::size_t>(edge)].curve, t);
    for (const Edge& other : part.edges)
        for (const double end : {0.0, 1.0})
            if ((point(other.curve, end) - x).norm() <= merge_length(part)) normals.push_back(outward_normal(other.curve, end));
    return normals;
}

/// Are the faces parallel at the closest points, and across from each other? For parts too far apart to have zones.
bool faces_across(const Meeting& m, const ClosestPoints& c) {
    for (const Vec2& n1 : normals_at(m.first, c.edge1, c.t1))
        for (const Vec2& n2 : normals_at(m.second, c.edge2, c.t2))
            if (-n1.dot(n2) >= least_flush && n1.dot(c.x2 - c.x1) >= least_flush * c.distance) return true;
    return false;
}

/// Does a zone come as close as the closest points do, with its faces parallel there? A zone that is closest at an end where
/// they are not has a corner there.
bool closest_face_to_face(const Meeting& m, const FacingZone& zone) {
    if (zone.gap_min > m.closest->distance + m.touching) return false;
    const auto tilted_end = [&](double s1, double guess) {
        const FacingPair p = geometry::pair_from_first(m.first, m.second, zone, s1, guess);
        return p.gap <= zone.gap_min + m.touching && -p.on1.normal.dot(p.on2.normal) < least_flush;
    };
    return zone.closed || (!tilted_end(zone.begin1, zone.begin2) && !tilted_end(zone.end1, zone.end2));
}

/// Do the parts come together at a corner, whatever else faces each other farther away?
bool meets_at_corner(const Meeting& m) {
    if (!m.closest || m.overlap.depth() > m.touching) return false;
    const ClosestPoints& c = *m.closest;
    if (!geometry::is_convex_corner(m.first, c.edge1, c.t1) && !geometry::is_convex_corner(m.second, c.edge2, c.t2))
        return false;
    if (c.distance > m.distance) return !faces_across(m, c);
    return std::none_of(m.zones.begin(), m.zones.end(), [&](const FacingZone& zone) { return closest_face_to_face(m, zone); });
}

std::string kind_of(const Meeting& m) {
    if (meets_at_corner(m)) {
        const ClosestPoints& c = *m.closest;
        return geometry::corner_interface(m.first, c.edge1, c.t1, m.second, c.edge2, c.t2);
    }
    const std::array<int, 2> carrying = carrying_edges(m);
    return geometry::interface_kind(m.first, carrying[0], m.second, carrying[1]);
}

/// Where nothing faces, the closest points are all there is; a corner's contact is its closest points, too.
FunctionalInterface functional_of(Meeting m, const std::string& kind) {
    if (m.stretches.empty() && !m.closest) return {kind, {}, {}, {}, {}, {}, {}, {}};
    if (m.stretches.empty() || meets_at_corner(m)) {
        const ClosestPoints& c = *m.closest;
        m.stretches = {{c.edge1, c.edge2, {c.x1, c.x1}, 0, c.distance}};
    }
    const std::array<int, 2> carrying = carrying_edges(m);
    put_first(m.stretches, carrying[0], carrying[1]);
    geometry::Box2 box = bounding_box(m.first);
    box.extend(bounding_box(m.second));
    return functional_interface(m.first, m.second, kind, m.stretches, {box.center(), box.diagonal()});
}

/// Gaps along the zones; the closest points where they are closer than any facing ones (a corner), or where nothing faces.
void set_gaps(const Meeting& m, DetectedPair& pair) {
    const double closest = m.closest ? m.closest->distance : 0;
    pair.gap_min = pair.gap_max = closest;
    const bool facing = !m.shares.empty();
    if (facing) {
        pair.gap_min = m.zones.front().gap_min;
        pair.gap_max = m.zones.front().gap_max;
        for (const FacingZone& zone : m.zones) {
            pair.gap_min = std::min(pair.gap_min, zone.gap_min);
            pair.gap_max = std::max(pair.gap_max, zone.gap_max);
        }
        if (m.closest) pair.gap_min = std::min(pair.gap_min, closest);
    }
    // An overlap deeper than the search distance has no facing pair that measures it.
    if (m.overlap.depth() > m.touching && pair.gap_min >= -m.touching) pair.gap_min = -m.overlap.depth();
    pair.gap_max = std::max(pair.gap_max, pair.gap_min);
}

std::string status_of(const Meeting& m, const DetectedPair& pair) {
    if (m.overlap.depth() > m.touching || pair.gap_min < -m.touching) return "overlap";
    return pair.gap_min <= m.touching ? "touching" : "gap";
}

std::string why_of(const Scene& scene, const Meeting& m, const DetectedPair& pair, bool near_miss) {
    const auto with_unit_of = [&](double v) { return with_unit(v, 4, scene.length_unit); };
    const std::string at = m.closest ? " at " + pair_text(m.closest->x1, 6) : "";
    const std::string against = "the search distance " + with_unit_of(m.distance);
    if (near_miss) return with_unit_of(pair.gap_min) + " apart" + at + ", farther than " + against;
    if (pair.status == "overlap" && pair.length == 0) return "they overlap and no boundaries face each other within " + against;
    if (pair.status == "overlap")
        return "drawn into each other by up to " + with_unit_of(-pair.gap_min) + ", facing along " + with_unit_of(pair.length);
    if (pair.length == 0)
        return (pair.status == "touching" ? "touching" : with_unit_of(pair.gap_min) + " apart") + at +
               ", where no faces oppose each other";
    const std::string along = " along " + with_unit_of(pair.length);
    if (pair.status == "touching") return "touching" + at + ", facing within " + with_unit_of(m.distance) + along;
    return with_unit_of(pair.gap_min) + " apart" + at + ", within " + against + along;
}

DetectedPair describe(const Scene& scene, const Meeting& m, bool near_miss) {
    DetectedPair pair;
    pair.part = m.part;
    name_edges(scene, m, pair);
    set_gaps(m, pair);
    pair.status = status_of(m, pair);
    pair.interface = kind_of(m);
    if (!near_miss) pair.functional = functional_of(m, pair.interface);
    pair.overlap_area = pair.status == "overlap" ? m.overlap.area : 0;
    pair.length = facing_length(m);
    pair.shared_length = m.shared_length;
    const double size = std::min(extent(m.first), extent(m.second));
    pair.cells_case = std::string(1, geometry::cell_case(m.first, m.second, geometry::case_cell_fraction * size));
    pair.why = why_of(scene, m, pair, near_miss);
    pair.marks = m.marks;
    if (pair.marks.empty() && m.closest) pair.marks.push_back({m.closest->x1, m.closest->x2});
    return pair;
}

/// How far a pair of parts is searched.
struct Reach {
    double distance, near_miss, touching;
};
Reach reach_of(const Scene& scene, const Part& first, const Part& second, std::optional<double> distance) {
    const double size = std::min(extent(first), extent(second));
    Reach reach;
    reach.distance = distance.value_or(scene.contacts.search_distance.value_or(default_distance_fraction * size));
    reach.touching = touching_fraction * size;
    reach.near_miss = std::max(reach.distance, near_miss_fraction * size);
    return reach;
}

void examine(const Scene& scene, int i, int k, std::optional<double> distance, const IgnoredEdges& ignored, Detection& found) {
    const Part &first = scene.parts[static_cast<std::size_t>(i)].part, &second = scene.parts[static_cast<std::size_t>(k)].part;
    const Reach reach = reach_of(scene, first, second, distance);
    found.distance = std::max(found.distance, reach.distance);
    if (!bounding_box(first).overlaps(bounding_box(second), reach.near_miss) || ignored.holds(scene, i, k)) return;

    Meeting m{{i, k}, first, second, reach.distance, reach.touching, {}, {}, {}, {}, 0, {}, {}};
    m.closest = geometry::closest_points(first, second, reach.near_miss);
    m.overlap = geometry::overlap(first, second, reach.touching);
    m.zones = geometry::find_facing_zones(first, second, std::max(reach.distance, reach.touching));
    const bool overlapping = m.overlap.depth() > reach.touching;
    if (!m.closest && !overlapping) return;
    follow_zones(m, ignored);
    if (m.shares.empty() && !m.zones.empty()) return;  // all that faces each other is to be left alone
    if (m.shares.empty() && m.closest && ignored.holds(i, m.closest->edge1, k, m.closest->edge2)) return;

    const bool close =
        overlapping || !m.shares.empty() || (m.closest && m.closest->distance <= std::max(reach.distance, reach.touching));
    (close ? found.pairs : found.near_misses).push_back(describe(scene, m, !close));
}

}  // namespace

Detection detect_contacts(const Scene& scene, std::optional<double> distance) {
    Detection found;
    const IgnoredEdges ignored(scene);
    const int n = static_cast<int>(scene.parts.size());
    for (int i = 0; i < n; ++i)
        for (int k = i + 1; k < n; ++k) examine(scene, i, k, distance, ignored, found);
    return found;
}

}  // namespace abut

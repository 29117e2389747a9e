// SPDX-License-Identifier: GPL-3.0-or-later
// From each facet of a recovered piece feelers reach to the curve; what cuts one deeper than the tolerance is in the way, and
// so is an end of a curve between facet and curve.
#include "geometry/mesh/section_bulges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/brep/edge_tree.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

using std::size_t;

/// Where on a facet feelers stand.
constexpr std::array<double, 5> feelers = {0.1, 0.3, 0.5, 0.7, 0.9};

/// One curve of a piece.
struct Item {
    int body, outline, piece;
    const Curve* curve;
};

struct Ray {
    Vec2 from, direction;  ///< unit length
};

bool is_on(const Arc& arc, const Vec2& p) {
    const Vec2 d = p - arc.center;
    constexpr double full = 6.283185307179586;
    const double along = std::remainder(std::atan2(d.y(), d.x()) - arc.start - 0.5 * arc.sweep, full);
    return std::abs(along) <= 0.5 * std::abs(arc.sweep);
}

/// Distances along the ray (either way) where the curve, a line or an arc, crosses it; nothing where it only runs along it.
std::vector<double> crossings_of(const Ray& ray, const Curve& curve) {
    if (const Segment* s = std::get_if<Segment>(&curve)) {
        const double a = cross(ray.direction, s->from - ray.from), b = cross(ray.direction, s->to - ray.from);
        if ((a > 0) == (b > 0)) return {};
        const Vec2 p = s->from + a / (a - b) * (s->to - s->from);
        return {ray.direction.dot(p - ray.from)};
    }
    const Arc& arc = std::get<Arc>(curve);
    const Vec2 d = ray.from - arc.center;
    const double along = -ray.direction.dot(d), square = arc.radius * arc.radius - std::pow(cross(ray.direction, d), 2);
    if (!(square > 0)) return {};
    std::vector<double> found;
    for (double sign : {-1.0, 1.0}) {
        const double t = along + sign * std::sqrt(square);
        if (is_on(arc, ray.from + t * ray.direction)) found.push_back(t);
    }
    return found;
}

std::optional<double> first_beyond(const std::vector<double>& places, double least, double most) {
    std::optional<double> best;
    for (double t : places)
        if (t > least && t <= most && (!best || t < *best)) best = t;
    return best;
}

class Search {
public:
    explicit Search(const std::vector<BodyOutlines>& bodies)
        : bodies_(bodies), items_(items_of(bodies)), tree_(boxes_of(items_)) {}

    std::vector<BulgeConflict> conflicts() const {
        std::vector<BulgeConflict> found;
        for (size_t b = 0; b < bodies_.size(); ++b)
            for (size_t o = 0; o < bodies_[b].outlines.size(); ++o) {
                const RecoveredOutline& outline = bodies_[b].outlines[o];
                for (size_t p = 0; p < outline.pieces.size(); ++p) {
                    // No bulge of less height can hold anything deeper than the tolerance.
                    if (outline.pieces[p].sagitta <= bodies_[b].tolerance) continue;
                    const auto conflict = conflict_of({static_cast<int>(b), static_cast<int>(o), static_cast<int>(p), nullptr});
                    if (conflict) found.push_back(*conflict);
                }
            }
        return found;
    }

private:
    static std::vector<Item> items_of(const std::vector<BodyOutlines>& bodies) {
        std::vector<Item> items;
        for (size_t b = 0; b < bodies.size(); ++b)
            for (size_t o = 0; o < bodies[b].outlines.size(); ++o) {
                const std::vector<RecoveredPiece>& pieces = bodies[b].outlines[o].pieces;
                for (size_t p = 0; p < pieces.size(); ++p)
                    for (const Curve& curve : pieces[p].curves)
                        items.push_back({static_cast<int>(b), static_cast<int>(o), static_cast<int>(p), &curve});
            }
        return items;
    }
    static std::vector<Box2> boxes_of(const std::vector<Item>& items) {
        std::vector<Box2> boxes;
        for (const Item& item : items) boxes.push_back(bounding_box(*item.curve));
        return boxes;
    }

    const RecoveredOutline& outline(const Item& i) const { return bodies_[at(i.body)].outlines[at(i.outline)]; }
    const RecoveredPiece& piece(const Item& i) const { return outline(i).pieces[at(i.piece)]; }

    std::optional<BulgeConflict> conflict_of(const Item& own) const {
        const RecoveredOutline& line = outline(own);
        const RecoveredPiece& recovered = piece(own);
        for (int k = recovered.first; k < recovered.first + recovered.n_facets; ++k) {
            const Vec2 &a = point_of(line, k), &b = point_of(line, k + 1);
            Box2 box;
            box.extend(a);
            box.extend(b);
            for (int i : tree_.near(box, recovered.sagitta)) {
                const Item& other = items_[at(i)];
                if (other.body == own.body && other.outline == own.outline && other.piece == own.piece) continue;
                if (auto conflict = conflict_at(own, k, other)) return conflict;
            }
        }
        return std::nullopt;
    }

    std::optional<BulgeConflict> conflict_at(const Item& own, int facet, const Item& other) const {
        const RecoveredOutline& line = outline(own);
        const Vec2 &a = point_of(line, facet), &b = point_of(line, facet + 1);
        const bool turns_left = turning_of(own) > 0;
        if (!turns_left && other.body != own.body) return std::nullopt;  // its material shrinks
        const Vec2 out = (turns_left ? right_of(b - a) : left_of(b - a)).normalized();
        std::vector<Vec2> feet;
        for (double t : feelers) feet.push_back(a + t * (b - a));
        for (double end : {0.0, 1.0}) {
            const double t = (point(*other.curve, end) - a).dot(b - a) / (b - a).squaredNorm();
            if (t > 0 && t < 1) feet.push_back(a + t * (b - a));
        }
        std::optional<BulgeConflict> deepest;
        for (const Vec2& foot : feet) {
            const auto conflict = conflict_along({foot, out}, own, other);
            if (conflict && (!deepest || conflict->depth > deepest->depth)) deepest = conflict;
        }
        return deepest;
    }

    std::optional<BulgeConflict> conflict_along(const Ray& feeler, const Item& own, const Item& other) const {
        const RecoveredPiece& recovered = piece(own);
        const double tolerance = bodies_[at(own.body)].tolerance;
        std::optional<double> height;
        for (const Curve& curve : recovered.curves) {
            const auto here = first_beyond(crossings_of(feeler, curve), 0, 2 * recovered.sagitta + tolerance);
            if (here && (!height || *here < *height)) height = here;
        }
        if (!height) return std::nullopt;
        const double its_sagitta = piece(other).sagitta;  // its own curve may have passed this facet altogether
        const auto met =
            first_beyond(ends_and_crossings(feeler, *other.curve, tolerance), -its_sagitta - tolerance, *height - tolerance);
        if (!met || (*met < -tolerance && !facets_cross(other, feeler, -tolerance, *height + 2 * its_sagitta)) ||
            overlapped(own, other, feeler, *height))
            return std::nullopt;
        return BulgeConflict{own.body,      own.outline, own.piece, other.body, feeler.from + *met * feeler.direction,
                             *height - *met};
    }

    /// A feeler that stands for an end of the curve meets it there, though rounding may say that they miss each other.
    static std::vector<double> ends_and_crossings(const Ray& feeler, const Curve& curve, double tolerance) {
        std::vector<double> found = crossings_of(feeler, curve);
        for (double end : {0.0, 1.0}) {
            const Vec2 d = point(curve, end) - feeler.from;
            if (std::abs(cross(feeler.direction, d)) <= 1e-3 * tolerance) found.push_back(feeler.direction.dot(d));
        }
        return found;
    }

    /// Of the piece: positive where its curve lies on the right of its facets.
    double turning_of(const Item& own) const {
        const RecoveredOutline& line = outline(own);
        const int k = piece(own).first;
        return cross(point_of(line, k + 1) - point_of(line, k), point_of(line, k + 2) - point_of(line, k + 1));
    }

    bool facets_cross(const Item& item, const Ray& ray, double least, double most) const {
        const RecoveredOutline& line = outline(item);
        for (int k = piece(item).first; k < piece(item).first + piece(item).n_facets; ++k)
            if (first_beyond(crossings_of(ray, Segment{point_of(line, k), point_of(line, k + 1)}), least, most)) return true;
        return false;
    }

    /// Did the bodies' facets overlap before anything was recovered: there, behind the facet, or where two facets cross?
    bool overlapped(const Item& own, const Item& other, const Ray& feeler, double height) const {
        if (own.body == other.body) return false;
        const RecoveredOutline &mine = outline(own), &its = outline(other);
        const RecoveredPiece &my_piece = piece(own), &its_piece = piece(other);
        const double tolerance = bodies_[at(own.body)].tolerance;
        if (facets_cross(other, feeler, -height - its_piece.sagitta - tolerance, -tolerance)) return true;
        for (int j = its_piece.first; j < its_piece.first + its_piece.n_facets; ++j) {
            const Segment facet{point_of(its, j), point_of(its, j + 1)};
            const Vec2 chord = facet.to - facet.from;
            const double size = chord.norm();
            const Ray along{facet.from, chord / size};
            for (int k = my_piece.first; k < my_piece.first + my_piece.n_facets; ++k) {
                const Segment own_facet{point_of(mine, k), point_of(mine, k + 1)};
                if (first_beyond(crossings_of(along, own_facet), tolerance, size - tolerance) &&
                    std::min(std::abs(cross(along.direction, own_facet.from - facet.from)),
                             std::abs(cross(along.direction, own_facet.to - facet.from))) > tolerance)
                    return true;
            }
        }
        return false;
    }

    const std::vector<BodyOutlines>& bodies_;
    std::vector<Item> items_;
    EdgeTree tree_;
};

}  // namespace

std::vector<BulgeConflict> conflicts_of_bulges(const std::vector<BodyOutlines>& bodies) {
    return Search(bodies).conflicts();
}

}  // namespace abut::geometry

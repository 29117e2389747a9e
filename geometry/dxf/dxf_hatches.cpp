// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_hatches.hpp"

#include <cmath>
#include <numbers>

#include "geometry/curves/numbers.hpp"
#include "geometry/dxf/dxf_entities.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr double hatch_degree = std::numbers::pi / 180;

/// Walks over the groups of boundary paths, whose order is their meaning. What is missing leaves it not good.
class PathReader {
public:
    explicit PathReader(const Record& record) : groups_(record.groups) {
        while (next_ < groups_.size() && groups_[next_].code != 91) ++next_;
    }

    bool is_good() const { return is_good_; }
    bool is_next(int code) const { return next_ < groups_.size() && groups_[next_].code == code; }
    /// The number of the next group, which must have the code.
    double number(int code) {
        double value = 0;
        if (!is_next(code) || !parse_number(groups_[next_].value, value)) is_good_ = false;
        ++next_;
        return is_good_ ? value : 0;
    }
    int integer(int code) {
        constexpr int most = 1'000'000;
        const double value = number(code);
        if (!(value >= -1 && value <= most)) is_good_ = false;
        return is_good_ ? static_cast<int>(value) : 0;
    }
    double optional(int code, double missing) { return is_next(code) ? number(code) : missing; }
    Vec2 point(int x_code) {
        const double x = number(x_code);
        return {x, number(x_code + 10)};
    }
    void skip(int code) {
        if (is_next(code)) ++next_;
    }

private:
    std::span<const Group> groups_;
    std::size_t next_ = 0;
    bool is_good_ = true;
};

std::vector<Curve> read_polyline(PathReader& path) {
    path.integer(72);
    path.skip(73);
    const int n = path.integer(93);
    std::vector<Vec2> points;
    std::vector<double> bulges;
    for (int k = 0; k < n && path.is_good(); ++k) {
        points.push_back(path.point(10));
        bulges.push_back(path.optional(42, 0));
    }
    std::vector<Curve> loop;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2& to = points[(k + 1) % points.size()];
        if (points[k] != to) loop.push_back(from_bulge(points[k], to, bulges[k]));
    }
    return loop;
}

/// Angles of a clockwise edge are those of its mirror image.
double signed_sweep(double from, double to, double full) {
    double sweep = std::fmod(to - from, full);
    if (sweep <= 1e-9 * full) sweep += full;
    return sweep;
}

Curve read_arc(PathReader& path) {
    const Vec2 center = path.point(10);
    const double radius = path.number(40), from = path.number(50), sweep = signed_sweep(from, path.number(51), 360);
    const double side = path.optional(73, 1) == 0 ? -1 : 1;
    return Arc{center, radius, side * from * hatch_degree, side * sweep * hatch_degree};
}

Curve read_ellipse(PathReader& path) {
    const Vec2 center = path.point(10), a = path.point(11);
    const double ratio = path.number(40), from = path.number(50), sweep = signed_sweep(from, path.number(51), 360);
    const double side = path.optional(73, 1) == 0 ? -1 : 1;
    return circle_or_ellipse(center, a, ratio * left_of(a), side * from * hatch_degree, side * sweep * hatch_degree);
}

void read_spline(PathReader& path, std::vector<Curve>& loop) {
    path.integer(94);
    const bool is_rational = path.integer(73) != 0;
    path.integer(74);
    const int n_knots = path.integer(95), n_points = path.integer(96);
    for (int k = 0; k < n_knots && path.is_good(); ++k) path.number(40);
    std::vector<Vec2> points;
    for (int k = 0; k < n_points && path.is_good(); ++k) {
        points.push_back(path.point(10));
        if (is_rational) path.optional(42, 1);
    }
    const int n_fit = path.is_next(97) ? path.integer(97) : 0;
    for (int k = 0; k < n_fit && path.is_next(11); ++k) path.point(11);
    for (const int code : {12, 13})
        if (path.is_next(code)) path.point(code);
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
        if (points[k] != points[k + 1]) loop.push_back(Segment{points[k], points[k + 1]});
}

std::vector<Curve> read_edges(PathReader& path) {
    const int n = path.integer(93);
    std::vector<Curve> loop;
    for (int k = 0; k < n && path.is_good(); ++k) {
        const int type = path.integer(72);
        if (type == 1) {
            const Vec2 from = path.point(10), to = path.point(11);
            if (from != to) loop.push_back(Segment{from, to});
        } else if (type == 2) {
            loop.push_back(read_arc(path));
        } else if (type == 3) {
            loop.push_back(read_ellipse(path));
        } else {
            read_spline(path, loop);
        }
    }
    return loop;
}

}  // namespace

Hatch read_hatch(const Record& record, const Look& look) {
    constexpr int polyline = 2, text_box = 8;
    Hatch hatch;
    hatch.line = record.line;
    hatch.look.pattern = record.text(2);
    hatch.look.angle = record.number(52, 0);
    hatch.look.scale = record.number(41, 1);
    constexpr int of_true_colors = 1 << 24;  // beyond the indices
    hatch.look.layer = look.layer;
    hatch.look.color = record.find(420) ? of_true_colors + record.integer(420, 0) % of_true_colors : look.color;
    hatch.name = "hatch" + std::to_string(record.line);
    PathReader path(record);
    const int n_paths = path.integer(91);
    for (int k = 0; k < n_paths && path.is_good(); ++k) {
        const int flags = path.integer(92);
        std::vector<Curve> loop = (flags & polyline) != 0 ? read_polyline(path) : read_edges(path);
        const int n_sources = path.is_next(97) ? path.integer(97) : 0;
        for (int i = 0; i < n_sources; ++i) path.skip(330);
        if (path.is_good() && !loop.empty() && (flags & text_box) == 0) hatch.loops.push_back(std::move(loop));
    }
    if (!path.is_good()) hatch.loops.clear();
    if (record.number(230, 1) < 0) place_hatch(hatch, seen_from_below());
    return hatch;
}

void place_hatch(Hatch& hatch, const Placement& placement) {
    for (std::vector<Curve>& loop : hatch.loops)
        for (Curve& curve : loop) curve = placed(curve, placement);
    const double angle = hatch.look.angle * hatch_degree;
    const Vec2 along = placement.turned(Vec2(std::cos(angle), std::sin(angle)));
    hatch.look.angle = std::atan2(along.y(), along.x()) / hatch_degree;
    hatch.look.scale *= along.norm();
}

}  // namespace abut::geometry::dxf

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/drafting_callouts.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/closest_points.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

std::vector<int> Callouts::given(const LooseEntities& loose) const {
    std::vector<int> all;
    for (const int e : loose.entities)
        for (const int of : found_.closed.outlines.entities[at(e)].of) all.push_back(of);
    return all;
}

/// Does no other outline come as near, lie in it, or lie around it?
bool Callouts::is_clear(std::size_t shape, double reach) const {
    const Shape& own = found_.shapes[shape];
    for (std::size_t k = 0; k < found_.shapes.size(); ++k) {
        const Shape& other = found_.shapes[k];
        if (k == shape || found_.is_out[k] || !other.box.overlaps(own.box, reach)) continue;
        const bool is_around = is_upright_rectangle(other) && own.box.is_within(other.box, 0);  // a frame perhaps
        if (is_around && reach <= found_.tolerance) continue;
        if (closest_points(other.outline, own.outline, reach)) return false;
        if (!is_around && (contains(other.outline, own.box.center()) || other.box.is_within(own.box, 0))) return false;
    }
    return true;
}

bool Callouts::has_text(const Arc& circle, std::size_t most) const {
    return std::any_of(found_.drawing.texts.begin(), found_.drawing.texts.end(), [&](const DrawnText& text) {
        return text.text.size() <= most && (text.at - circle.center).norm() < circle.radius && text.height < 2 * circle.radius;
    });
}

/// Does the point lie in an outline that is no balloon itself? A leader from there points to a balloon, not to a part.
bool Callouts::begins_at_part(const Vec2& p) const {
    return std::any_of(found_.shapes.begin(), found_.shapes.end(), [&](const Shape& shape) {
        if (!holds(grown(shape.box, found_.tolerance), p) || !contains(shape.outline, p)) return false;
        const std::optional<Arc> round = circle(shape);
        return !round || !has_text(*round, most_letters);
    });
}

/// Does a loose line end on the circle, or just outside of it, and point to its middle?
bool Callouts::has_leader(const Arc& circle, bool is_labelled) const {
    constexpr double near = 0.25, off_middle = 0.5;  // of the radius: they are drawn by eye
    for (const LooseEntities& loose : found_.closed.loose)
        for (const int e : loose.entities) {
            const auto* line = std::get_if<Segment>(&found_.closed.outlines.entities[at(e)].curve);
            if (!line) continue;
            for (const bool is_begin : {true, false}) {
                const Vec2 end = is_begin ? line->from : line->to, far = is_begin ? line->to : line->from;
                const double distance = (end - circle.center).norm() - circle.radius;
                const Vec2 along = (end - far).normalized();
                const double off = std::abs(cross(along, circle.center - end));
                if (distance >= -near * circle.radius && distance <= near * circle.radius &&
                    off <= off_middle * circle.radius && along.dot(circle.center - end) > 0 &&
                    (far - circle.center).norm() > 2 * circle.radius && (is_labelled || begins_at_part(far)))
                    return true;
            }
        }
    return false;
}

void Callouts::find_balloons() {
    for (std::size_t s = 0; s < found_.shapes.size(); ++s) {
        const std::optional<Arc> own = circle(found_.shapes[s]);
        if (!own || found_.is_out[s]) continue;
        constexpr double clearance = 0.1;  // of the radius: nearer ones are parts with their numbers
        const bool is_labelled = has_text(*own, most_letters), is_pointed_at = has_leader(*own, is_labelled);
        if (!has_text(*own, 3) && !is_pointed_at) continue;
        if (!is_clear(s, is_pointed_at ? found_.tolerance : std::max(found_.tolerance, clearance * own->radius))) continue;
        found_.leave(s, drafting_kinds.balloon);
        balloons_.push_back(*own);
    }
}

bool Callouts::is_at_annotation(const Vec2& end) const {
    constexpr double near = 0.3;  // of the radius
    const auto is_near_balloon = [&](const Arc& balloon) {
        return std::abs((end - balloon.center).norm() - balloon.radius) <= near * balloon.radius;
    };
    const auto is_near_text = [&](const DrawnText& text) {
        const double width = text.height * static_cast<double>(std::min<std::size_t>(text.text.size(), 40));
        Box2 box;
        box.extend(text.at);
        box.extend(text.at + Vec2(width, text.height));
        return text.height > 0 && holds(grown(box, text.height), end);
    };
    const auto is_tip = [&](const Vec2& tip) { return (tip - end).norm() <= 10 * found_.tolerance; };
    return std::any_of(balloons_.begin(), balloons_.end(), is_near_balloon) ||
           std::any_of(found_.drawing.texts.begin(), found_.drawing.texts.end(), is_near_text) ||
           std::any_of(found_.drawing.arrows.begin(), found_.drawing.arrows.end(), is_tip);
}

std::vector<Vec2> Callouts::ends_of(const LooseEntities& loose) const {
    std::vector<Vec2> ends;
    for (const int e : loose.entities)
        for (const bool is_begin : {true, false}) ends.push_back(position(found_.closed.outlines.entities, {e, is_begin}));
    return ends;
}

namespace {

/// Is it an outline that stands open by a little? No line to a text ends where it began.
bool nearly_closes(const LooseEntities& loose) {
    const std::vector<Vec2>& ends = loose.free_ends;
    return ends.size() == 2 && (ends[0] - ends[1]).norm() <= nearly_closed_fraction * loose.length;
}

}  // namespace

void Callouts::find_leaders() {
    for (const LooseEntities& loose : found_.closed.loose) {
        if (nearly_closes(loose)) continue;
        const std::vector<Vec2> ends = ends_of(loose);
        if (std::any_of(ends.begin(), ends.end(), [&](const Vec2& end) { return is_at_annotation(end); })) {
            found_.leave(given(loose), drafting_kinds.leader);
            leaders_.push_back(&loose);
        }
    }
}

/// Of the circles about the end of a leader the smallest, where it is small beside balloons or the leader.
void Callouts::find_dots() {
    constexpr double of_balloon = 0.25, of_leader = 0.03;
    double largest = 0;
    for (const Arc& balloon : balloons_) largest = std::max(largest, of_balloon * balloon.radius);
    for (const LooseEntities* leader : leaders_)
        for (const Vec2& end : ends_of(*leader)) {
            std::size_t dot = found_.shapes.size();
            double radius = largest > 0 ? largest : of_leader * leader->length;
            for (std::size_t s = 0; s < found_.shapes.size(); ++s) {
                if (found_.is_out[s] || !holds(found_.shapes[s].box, end)) continue;
                const std::optional<Arc> own = circle(found_.shapes[s]);
                if (!own || (end - own->center).norm() > 10 * found_.tolerance || own->radius > radius) continue;
                dot = s;
                radius = own->radius;
            }
            if (dot < found_.shapes.size()) found_.leave(dot, drafting_kinds.dot);
        }
}

}  // namespace abut::geometry

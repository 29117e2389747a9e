// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_drafting.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/brep/closest_points.hpp"
#include "geometry/sketch/drafting_shapes.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Parts fill more of the plate that they are holes of, or fit into.
constexpr double most_filled = 0.1;
/// Margins of a sheet are narrower than this part of it.
constexpr double widest_margin = 0.1;

struct Kinds {
    const char *frame = "frame of a sheet", *table = "title block or table", *sheet = "content of the sheet",
               *balloon = "balloon", *leader = "leader or arrow", *dot = "dot of a leader";
};
constexpr Kinds kinds;

class Drafting {
public:
    Drafting(const Drawing& drawing, const SketchOptions& options)
        : drawing_(drawing), entities_(drawing.entities), kind_(drawing.entities.size(), nullptr) {
        SketchOptions plain = options;
        plain.recognise_arcs = false;
        Box2 box;
        for (const SketchEntity& entity : entities_) box.extend(bounding_box(entity.curve));
        closed_ =
            close_outlines(entities_, plain, rounding_fraction * std::max(box.diagonal(), box.max.cwiseAbs().maxCoeff()), true);
        tolerance_ = closed_.tolerance;
        for (const EntityChain& chain : closed_.outlines.closed) shapes_.push_back(shape_of(closed_.outlines, chain));
        for (const DividedOutline& divided : closed_.outlines.divided) {
            shapes_.push_back(shape_of(closed_.outlines, divided.contour));
            Shape& shape = shapes_.back();
            shape.entities.clear();
            for (const Face& face : divided.faces) {
                const Shape one = shape_of(closed_.outlines, face.boundary);
                shape.entities.insert(shape.entities.end(), one.entities.begin(), one.entities.end());
                shape.faces.push_back(one.outline);
            }
        }
        is_out_.assign(shapes_.size(), false);
    }

    DraftingFound find() {
        find_balloons();
        find_leaders();
        find_dots();
        find_tables();
        find_frames();
        find_balloons();  // those that the sheet kept from being clear
        find_leaders();
        find_dots();
        DraftingFound found;
        for (const char* kind : kind_) found.is_drafting.push_back(kind != nullptr);
        found.warnings = told();
        return found;
    }

private:
    static constexpr std::size_t most_letters = 12;  ///< of a balloon
    static constexpr int most_frames = 4;            ///< one in the other

    void leave(const std::vector<int>& entities, const char* kind) {
        for (const int e : entities)
            if (!kind_[at(e)]) kind_[at(e)] = kind;
    }
    void leave(std::size_t shape, const char* kind) {
        leave(shapes_[shape].entities, kind);
        is_out_[shape] = true;
    }
    std::vector<int> given(const LooseEntities& loose) const {
        std::vector<int> all;
        for (const int e : loose.entities)
            for (const int of : closed_.outlines.entities[at(e)].of) all.push_back(of);
        return all;
    }

    // ---- balloons and leaders ----

    std::optional<Arc> circle(const Shape& shape) const { return circle_of(shape, tolerance_); }

    /// Does no other outline touch it, lie in it, or lie around it?
    bool is_clear(std::size_t shape) const {
        const Vec2 center = shapes_[shape].box.center();
        for (std::size_t k = 0; k < shapes_.size(); ++k) {
            if (k == shape || is_out_[k] || !shapes_[k].box.overlaps(shapes_[shape].box, tolerance_)) continue;
            if (is_upright_rectangle(shapes_[k]) && shapes_[shape].box.is_within(shapes_[k].box, 0))
                continue;  // a frame perhaps
            if (contains(shapes_[k].outline, center) ||
                closest_points(shapes_[k].outline, shapes_[shape].outline, tolerance_) ||
                shapes_[k].box.is_within(shapes_[shape].box, 0))
                return false;
        }
        return true;
    }

    bool has_text(const Arc& circle, std::size_t most) const {
        return std::any_of(drawing_.texts.begin(), drawing_.texts.end(), [&](const DrawnText& text) {
            return text.text.size() <= most && (text.at - circle.center).norm() < circle.radius &&
                   text.height < 2 * circle.radius;
        });
    }

    /// Does the point lie in an outline that is no balloon itself? A leader from there points to a balloon, not to a part.
    bool begins_at_part(const Vec2& p) const {
        return std::any_of(shapes_.begin(), shapes_.end(), [&](const Shape& shape) {
            if (!holds(grown(shape.box, tolerance_), p) || !contains(shape.outline, p)) return false;
            const std::optional<Arc> round = circle(shape);
            return !round || !has_text(*round, most_letters);
        });
    }

    /// Does a loose line end on the circle, or just outside of it, and point to its middle?
    bool has_leader(const Arc& circle, bool is_labelled) const {
        constexpr double near = 0.25, off_middle = 0.5;  // of the radius: they are drawn by eye
        for (const LooseEntities& loose : closed_.loose)
            for (const int e : loose.entities) {
                const auto* line = std::get_if<Segment>(&closed_.outlines.entities[at(e)].curve);
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

    void find_balloons() {
        for (std::size_t s = 0; s < shapes_.size(); ++s) {
            const std::optional<Arc> own = circle(shapes_[s]);
            if (!own || is_out_[s]) continue;
            const bool is_labelled = has_text(*own, most_letters);
            if (!has_text(*own, 3) && !has_leader(*own, is_labelled)) continue;
            if (!is_clear(s)) continue;
            leave(s, kinds.balloon);
            balloons_.push_back(*own);
        }
    }

    bool is_at_annotation(const Vec2& end) const {
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
        const auto is_tip = [&](const Vec2& tip) { return (tip - end).norm() <= 10 * tolerance_; };
        return std::any_of(balloons_.begin(), balloons_.end(), is_near_balloon) ||
               std::any_of(drawing_.texts.begin(), drawing_.texts.end(), is_near_text) ||
               std::any_of(drawing_.arrows.begin(), drawing_.arrows.end(), is_tip);
    }

    std::vector<Vec2> ends_of(const LooseEntities& loose) const {
        std::vector<Vec2> ends;
        for (const int e : loose.entities)
            for (const bool is_begin : {true, false}) ends.push_back(position(closed_.outlines.entities, {e, is_begin}));
        return ends;
    }

    void find_leaders() {
        for (const LooseEntities& loose : closed_.loose) {
            const std::vector<Vec2> ends = ends_of(loose);
            if (std::any_of(ends.begin(), ends.end(), [&](const Vec2& end) { return is_at_annotation(end); })) {
                leave(given(loose), kinds.leader);
                leaders_.push_back(&loose);
            }
        }
    }

    /// Of the circles about the end of a leader the smallest, where it is small beside balloons or the leader.
    void find_dots() {
        constexpr double of_balloon = 0.25, of_leader = 0.03;
        double largest = 0;
        for (const Arc& balloon : balloons_) largest = std::max(largest, of_balloon * balloon.radius);
        for (const LooseEntities* leader : leaders_)
            for (const Vec2& end : ends_of(*leader)) {
                std::size_t dot = shapes_.size();
                double radius = largest > 0 ? largest : of_leader * leader->length;
                for (std::size_t s = 0; s < shapes_.size(); ++s) {
                    if (is_out_[s] || !holds(shapes_[s].box, end)) continue;
                    const std::optional<Arc> own = circle(shapes_[s]);
                    if (!own || (end - own->center).norm() > 10 * tolerance_ || own->radius > radius) continue;
                    dot = s;
                    radius = own->radius;
                }
                if (dot < shapes_.size()) leave(dot, kinds.dot);
            }
    }

    // ---- the sheet ----

    std::size_t n_texts_in(const Box2& box) const {
        return static_cast<std::size_t>(
            std::count_if(drawing_.texts.begin(), drawing_.texts.end(), [&](const DrawnText& t) { return holds(box, t.at); }));
    }

    /// Is the face a rectangle?
    static bool is_cell(const Part& face) {
        const Box2 box = bounding_box(face);
        return std::abs(box.size().prod() - area(face)) <= 1e-3 * area(face);
    }

    /// Small faces with texts, of a divided outline: all but the largest are cells.
    bool is_table(const std::vector<Part>& faces) const {
        std::size_t n_cells = 0, n_with_text = 0;
        for (const Part& face : faces) {
            n_cells += is_cell(face) ? 1 : 0;
            n_with_text += n_texts_in(bounding_box(face)) > 0 ? 1 : 0;
        }
        return faces.size() >= 2 && n_cells + 1 >= faces.size() && n_with_text >= 2 && 3 * n_with_text >= faces.size();
    }

    void leave_inside(const Box2& box, const char* kind) {
        for (std::size_t i = 0; i < entities_.size(); ++i)
            if (!kind_[i] && bounding_box(entities_[i].curve).is_within(box, tolerance_)) kind_[i] = kind;
        for (std::size_t s = 0; s < shapes_.size(); ++s)
            if (shapes_[s].box.is_within(box, tolerance_)) is_out_[s] = true;
    }

    void find_tables() {
        for (std::size_t s = 0; s < shapes_.size(); ++s) {
            if (is_out_[s] || shapes_[s].faces.empty() || !is_upright_rectangle(shapes_[s]) || !is_table(shapes_[s].faces))
                continue;
            const auto largest = std::max_element(shapes_[s].faces.begin(), shapes_[s].faces.end(),
                                                  [](const Part& a, const Part& b) { return area(a) < area(b); });
            if (area(*largest) > 0.5 * shapes_[s].area) continue;  // a frame with its title block
            leave(s, kinds.table);
            leave_inside(shapes_[s].box, kinds.sheet);
        }
    }

    /// What is not set aside and lies inside that box with its middle.
    std::vector<std::size_t> inside_of(std::size_t frame) const {
        std::vector<std::size_t> inside;
        for (std::size_t s = 0; s < shapes_.size(); ++s)
            if (!is_out_[s] && s != frame && holds(shapes_[frame].box, shapes_[s].box.center())) inside.push_back(s);
        return inside;
    }

    bool is_around_all(std::size_t frame) const {
        for (std::size_t s = 0; s < shapes_.size(); ++s)
            if (!is_out_[s] && s != frame && !shapes_[s].box.is_within(shapes_[frame].box, tolerance_)) return false;
        return true;
    }

    bool is_upright_frame_in(std::size_t inner, const Box2& outer) const {
        if (!is_upright_rectangle(shapes_[inner])) return false;
        const Box2& box = shapes_[inner].box;
        const Vec2 low = box.min - outer.min, high = outer.max - box.max;
        return std::max(low.maxCoeff(), high.maxCoeff()) <= widest_margin * outer.size().maxCoeff() &&
               std::min(low.minCoeff(), high.minCoeff()) > tolerance_;
    }

    /// Is the frame proved by what is in it?
    bool is_frame(std::size_t frame, const std::vector<std::size_t>& inside) const {
        const Shape& own = shapes_[frame];
        const bool has_table = !own.faces.empty() && has_cells_with_text(own);
        const bool has_margin = std::any_of(inside.begin(), inside.end(), [&](std::size_t s) {
            return is_upright_frame_in(s, own.box) && inside.size() > 1 && are_most_in(inside, s);
        });
        if (has_table || has_margin) return true;  // whatever is drawn across it
        if (!is_around_all(frame)) return false;
        if (has_proportions_of_paper(own.box) && n_texts_in(own.box) > 0 && own.faces.empty()) return true;
        double filled = 0;
        bool is_shared = false;
        for (const std::size_t s : inside) {
            filled += shapes_[s].area;
            is_shared = is_shared || shapes_[s].faces.size() > 1;
        }
        return own.faces.empty() && is_shared && filled < most_filled * own.area;
    }

    bool are_most_in(const std::vector<std::size_t>& shapes, std::size_t frame) const {
        const auto n = std::count_if(shapes.begin(), shapes.end(), [&](std::size_t s) {
            return s == frame || holds(shapes_[frame].box, shapes_[s].box.center());
        });
        return 4 * static_cast<std::size_t>(n) >= 3 * shapes.size();
    }

    bool has_cells_with_text(const Shape& shape) const {
        std::size_t n = 0;
        for (const Part& face : shape.faces)
            if (is_cell(face) && area(face) < 0.1 * shape.area && n_texts_in(bounding_box(face)) > 0) ++n;
        return n >= 2;
    }

    void find_frames() {
        for (int k = 0; k < most_frames; ++k) {
            std::size_t outermost = shapes_.size();
            for (std::size_t s = 0; s < shapes_.size(); ++s)
                if (!is_out_[s] && (outermost == shapes_.size() || shapes_[s].area > shapes_[outermost].area)) outermost = s;
            if (outermost == shapes_.size() || !is_upright_rectangle(shapes_[outermost])) return;
            const std::vector<std::size_t> inside = inside_of(outermost);
            if (inside.empty()) return;
            if (!is_frame(outermost, inside) && !(has_frame_ && is_upright_frame_in(outermost, last_frame_))) {
                doubt_frame(outermost, inside);
                return;
            }
            take_frame(outermost);
        }
    }

    void take_frame(std::size_t frame) {
        const Shape& own = shapes_[frame];
        has_frame_ = true;
        last_frame_ = own.box;
        if (!own.faces.empty()) {
            const auto largest = std::max_element(own.faces.begin(), own.faces.end(),
                                                  [](const Part& a, const Part& b) { return area(a) < area(b); });
            for (const Part& face : own.faces)
                if (&face != &*largest) leave_inside(bounding_box(face), kinds.sheet);
        }
        leave(frame, kinds.frame);
    }

    /// A plate with windows, or the frame of a sheet with parts that nearly touch?
    void doubt_frame(std::size_t frame, const std::vector<std::size_t>& inside) {
        constexpr double near_fraction = 0.02;  // of the smaller diagonal: pairs of parts are looked for so far
        if (!shapes_[frame].faces.empty() || !is_around_all(frame) || inside.size() > 50)
            return;  // so many holes are a plate's
        for (const std::size_t a : inside)
            for (const std::size_t b : inside) {
                if (b <= a || circle(shapes_[a]) || circle(shapes_[b])) continue;
                const double reach = near_fraction * std::min(shapes_[a].box.diagonal(), shapes_[b].box.diagonal());
                if (!shapes_[a].box.overlaps(shapes_[b].box, reach) || shapes_[a].box.is_within(shapes_[b].box, 0) ||
                    shapes_[b].box.is_within(shapes_[a].box, 0))
                    continue;
                if (!closest_points(shapes_[a].outline, shapes_[b].outline, reach)) continue;
                const SketchEntity& first = entities_[at(shapes_[frame].entities.front())];
                doubts_.push_back({"the rectangle of " + first.kind + " " + first.name + " on layer " + first.layer +
                                       " around all else is taken as a plate; outlines in it come as near as parts that touch, "
                                       "so it may be the frame of a sheet",
                                   shapes_[frame].box.min, first.name, first.line,
                                   "put it on a layer of its own and leave that out (--ignore-layer) where it is"});
                return;
            }
    }

    // ---- what was set aside ----

    std::vector<SketchProblem> told() const {
        std::vector<SketchProblem> warnings;
        for (const char* kind : {kinds.frame, kinds.table, kinds.sheet, kinds.balloon, kinds.leader, kinds.dot}) {
            constexpr std::size_t most_names = 6;
            std::size_t n = 0;
            std::string names;
            const SketchEntity* first = nullptr;
            for (std::size_t i = 0; i < entities_.size(); ++i) {
                if (kind_[i] != kind) continue;
                if (!first) first = &entities_[i];
                if (n++ < most_names) names += (names.empty() ? "" : ", ") + entities_[i].name;
            }
            if (!first) continue;
            warnings.push_back({std::to_string(n) + (n == 1 ? " entity on layer " : " entities, the first on layer ") +
                                    first->layer + ", set aside as " + kind + ": " + names + (n > most_names ? ", ..." : ""),
                                point(first->curve, 0.5), first->name, first->line,
                                "--keep-drafting (in a scene \"keep_drafting\": true) takes such things for parts"});
        }
        warnings.insert(warnings.end(), doubts_.begin(), doubts_.end());
        return warnings;
    }

    const Drawing& drawing_;
    const std::vector<SketchEntity>& entities_;
    std::vector<const char*> kind_;  ///< by entity; null of what is kept
    ClosedOutlines closed_;
    double tolerance_ = 0;
    std::vector<Shape> shapes_;
    std::vector<bool> is_out_;  ///< by shape
    std::vector<Arc> balloons_;
    std::vector<const LooseEntities*> leaders_;
    bool has_frame_ = false;
    Box2 last_frame_;
    std::vector<SketchProblem> doubts_;
};

}  // namespace

DraftingFound find_drafting(const Drawing& drawing, const SketchOptions& options) {
    if (drawing.entities.empty()) return {};
    return Drafting(drawing, options).find();
}

}  // namespace abut::geometry

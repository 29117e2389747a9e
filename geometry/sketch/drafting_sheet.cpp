// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/drafting_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "geometry/brep/closest_points.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Parts fill more of the plate that they are holes of, or fit into.
constexpr double most_filled = 0.1;
/// Margins of a sheet are narrower than this part of its longer side.
constexpr double widest_margin = 0.1;
/// They are wider than this part of it: on the longest sheet of ISO 5457 (A0 x 3, 2523 mm) the border of 10 mm is 0.4 %. What
/// is narrower is a wall.
constexpr double narrowest_margin = 0.003;
/// What is drawn on a sheet keeps clear of its frame by this part of its longer side; what does not rests on it, or fits.
constexpr double least_clearance = 0.01;

class SheetSearch {
public:
    explicit SheetSearch(DraftingSearch& found) : found_(found) {}

    std::vector<SketchProblem> find() {
        find_tables();
        find_frames();
        return doubts_;
    }

private:
    static constexpr int most_frames = 4;  ///< one in the other

    std::size_t n_texts_in(const Box2& box) const {
        return static_cast<std::size_t>(std::count_if(found_.drawing.texts.begin(), found_.drawing.texts.end(),
                                                      [&](const DrawnText& t) { return holds(box, t.at); }));
    }

    /// Is the face a rectangle?
    static bool is_cell(const Part& face) {
        const Box2 box = bounding_box(face);
        return std::abs(box.size().prod() - area(face)) <= 1e-3 * area(face);
    }

    std::set<std::string> layers_of(const Shape& shape) const {
        std::set<std::string> layers;
        for (const int e : shape.entities) layers.insert(found_.drawing.entities[at(e)].layer);
        return layers;
    }

    /// Small faces with texts, of a divided outline: all but the largest are cells. Faces with as many layers are parts, each
    /// with its name.
    bool is_table(const Shape& shape) const {
        const std::vector<Part>& faces = shape.faces;
        if (layers_of(shape).size() >= faces.size()) return false;
        std::size_t n_cells = 0, n_with_text = 0;
        for (const Part& face : faces) {
            n_cells += is_cell(face) ? 1 : 0;
            n_with_text += n_texts_in(bounding_box(face)) > 0 ? 1 : 0;
        }
        return faces.size() >= 2 && n_cells + 1 >= faces.size() && n_with_text >= 2 && 3 * n_with_text >= faces.size();
    }

    void find_tables() {
        for (std::size_t s = 0; s < found_.shapes.size(); ++s) {
            if (found_.is_out[s] || found_.shapes[s].faces.empty() || !is_upright_rectangle(found_.shapes[s]) ||
                !is_table(found_.shapes[s]))
                continue;
            const auto largest = std::max_element(found_.shapes[s].faces.begin(), found_.shapes[s].faces.end(),
                                                  [](const Part& a, const Part& b) { return area(a) < area(b); });
            if (area(*largest) > 0.5 * found_.shapes[s].area) continue;  // a frame with its title block
            found_.leave(s, drafting_kinds.table);
            found_.leave_inside(found_.shapes[s].box, drafting_kinds.sheet);
        }
    }

    /// What is not set aside and lies inside that box with its middle.
    std::vector<std::size_t> inside_of(std::size_t frame) const {
        std::vector<std::size_t> inside;
        for (std::size_t s = 0; s < found_.shapes.size(); ++s)
            if (!found_.is_out[s] && s != frame && holds(found_.shapes[frame].box, found_.shapes[s].box.center()))
                inside.push_back(s);
        return inside;
    }

    bool is_around_all(std::size_t frame) const {
        for (std::size_t s = 0; s < found_.shapes.size(); ++s)
            if (!found_.is_out[s] && s != frame && !found_.shapes[s].box.is_within(found_.shapes[frame].box, found_.tolerance))
                return false;
        return true;
    }

    bool is_upright_frame_in(std::size_t inner, const Box2& outer) const {
        if (!is_upright_rectangle(found_.shapes[inner])) return false;
        const Box2& box = found_.shapes[inner].box;
        const Vec2 low = box.min - outer.min, high = outer.max - box.max;
        const double longer = outer.size().maxCoeff(), least = std::max(narrowest_margin * longer, found_.tolerance);
        return std::max(low.maxCoeff(), high.maxCoeff()) <= widest_margin * longer &&
               std::min(low.minCoeff(), high.minCoeff()) > least;
    }

    /// Does anything but the other rectangle of a frame come near the one, from inside or from outside? What lies across it, as
    /// no part does, is not asked for.
    bool is_approached(std::size_t rectangle, std::size_t other) const {
        const Shape& own = found_.shapes[rectangle];
        const double reach = least_clearance * own.box.size().maxCoeff();
        for (std::size_t s = 0; s < found_.shapes.size(); ++s) {
            if (found_.is_out[s] || s == rectangle || s == other || !found_.shapes[s].box.overlaps(own.box, reach)) continue;
            const Box2& box = found_.shapes[s].box;
            const bool is_outside = !box.overlaps(grown(own.box, -2 * found_.tolerance), 0);
            if ((is_outside || box.is_within(own.box, found_.tolerance)) &&
                closest_points(found_.shapes[s].outline, own.outline, reach))
                return true;
        }
        return false;
    }

    /// Is some, but not all, of what is drawn in a rectangle on its layer, as holes of a plate are beside what stands in them?
    bool shares_its_layer(std::size_t rectangle, const std::vector<std::size_t>& inside) const {
        const std::set<std::string> own = layers_of(found_.shapes[rectangle]);
        bool any = false, all = true;
        for (const std::size_t s : inside)
            for (const std::string& layer : layers_of(found_.shapes[s])) {
                any = any || own.count(layer) > 0;
                all = all && own.count(layer) > 0;
            }
        return any && !all;
    }

    /// Is a rectangle with such outlines in it a plate with holes?
    bool is_plate(std::size_t frame, const std::vector<std::size_t>& inside) const {
        return shares_its_layer(frame, inside) || std::all_of(inside.begin(), inside.end(), [&](std::size_t s) {
                   return circle_of(found_.shapes[s], found_.tolerance).has_value();
               });
    }

    /// Is there a title block in the rectangle: a table that was set aside or hangs on a frame, or a small rectangle with
    /// several texts? Parts have none in them.
    bool has_title_in(const Box2& box) const {
        constexpr std::size_t several = 3;
        constexpr double small = 0.25;
        for (std::size_t s = 0; s < found_.shapes.size(); ++s) {
            const Shape& shape = found_.shapes[s];
            if (!shape.box.is_within(box, found_.tolerance)) continue;
            const bool is_table =
                found_.is_out[s] ? found_.kind[at(shape.entities.front())] == drafting_kinds.table : has_cells_with_text(shape);
            if (is_table || (!found_.is_out[s] && is_upright_rectangle(shape) && shape.area < small * box.size().prod() &&
                             n_texts_in(shape.box) >= several))
                return true;
        }
        return false;
    }

    /// Is the frame proved by what is in it?
    bool is_frame(std::size_t frame, const std::vector<std::size_t>& inside) const {
        const Shape& own = found_.shapes[frame];
        const bool has_table = !own.faces.empty() && has_cells_with_text(own);
        if (has_table) return true;  // whatever is drawn across it
        const auto inner = std::find_if(inside.begin(), inside.end(), [&](std::size_t s) {
            return is_upright_frame_in(s, own.box) && inside.size() > 1 && are_most_in(inside, s);
        });
        const bool has_margin = inner != inside.end(), has_text = n_texts_in(own.box) > 0;
        const bool has_title = has_title_in(own.box);
        const bool is_clear =
            has_title || (!is_approached(frame, has_margin ? *inner : frame) && (!has_margin || !is_approached(*inner, frame)));
        if (has_margin && is_clear && (has_text || is_sparse(frame, *inner, inside))) return true;
        if (!is_around_all(frame)) return false;
        if (has_proportions_of_paper(own.box) && has_text && own.faces.empty() && is_clear &&
            (has_title || !is_plate(frame, inside)))
            return true;
        return own.faces.empty() && is_sparse(frame, frame, inside) &&
               (has_proportions_of_paper(own.box) || !shares_its_layer(frame, inside));
    }

    /// Do outlines in a frame, but for another frame, share lines, as holes do not, and fill little of it?
    bool is_sparse(std::size_t frame, std::size_t other, const std::vector<std::size_t>& inside) const {
        double filled = 0;
        bool is_shared = false;
        for (const std::size_t s : inside) {
            if (s == other) continue;
            filled += found_.shapes[s].area;
            is_shared = is_shared || found_.shapes[s].faces.size() > 1;
        }
        return is_shared && filled < most_filled * found_.shapes[frame].area;
    }

    bool are_most_in(const std::vector<std::size_t>& shapes, std::size_t frame) const {
        const auto n = std::count_if(shapes.begin(), shapes.end(), [&](std::size_t s) {
            return s == frame || holds(found_.shapes[frame].box, found_.shapes[s].box.center());
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
            std::size_t outermost = found_.shapes.size();
            for (std::size_t s = 0; s < found_.shapes.size(); ++s)
                if (!found_.is_out[s] &&
                    (outermost == found_.shapes.size() || found_.shapes[s].area > found_.shapes[outermost].area))
                    outermost = s;
            if (outermost == found_.shapes.size() || !is_upright_rectangle(found_.shapes[outermost])) return;
            const std::vector<std::size_t> inside = inside_of(outermost);
            if (inside.empty()) return;
            if (!is_frame(outermost, inside) && !(has_frame_ && is_upright_frame_in(outermost, last_frame_) &&
                                                  (has_title_in(last_frame_) || !is_approached(outermost, outermost)))) {
                doubt_frame(outermost, inside);
                return;
            }
            take_frame(outermost);
        }
    }

    void take_frame(std::size_t frame) {
        const Shape& own = found_.shapes[frame];
        has_frame_ = true;
        last_frame_ = own.box;
        if (!own.faces.empty()) {
            const auto largest = std::max_element(own.faces.begin(), own.faces.end(),
                                                  [](const Part& a, const Part& b) { return area(a) < area(b); });
            for (const Part& face : own.faces)
                if (&face != &*largest) found_.leave_inside(bounding_box(face), drafting_kinds.sheet);
        }
        found_.leave(frame, drafting_kinds.frame);
    }

    /// A plate with windows, or the frame of a sheet with parts that nearly touch?
    void doubt_frame(std::size_t frame, const std::vector<std::size_t>& inside) {
        constexpr double near_fraction = 0.02;  // of the smaller diagonal: pairs of parts are looked for so far
        if (!found_.shapes[frame].faces.empty() || !is_around_all(frame) || inside.size() > 50)
            return;  // so many holes are a plate's
        if (has_proportions_of_paper(found_.shapes[frame].box) && n_texts_in(found_.shapes[frame].box) > 0) {
            doubt(frame, "it has the proportions of paper, and a text in it");
            return;
        }
        if (is_sparse(frame, frame, inside)) {
            doubt(frame, "outlines in it share lines, as parts that touch do");
            return;
        }
        for (const std::size_t a : inside)
            for (const std::size_t b : inside) {
                if (b <= a || circle_of(found_.shapes[a], found_.tolerance) || circle_of(found_.shapes[b], found_.tolerance))
                    continue;
                const double reach = near_fraction * std::min(found_.shapes[a].box.diagonal(), found_.shapes[b].box.diagonal());
                if (!found_.shapes[a].box.overlaps(found_.shapes[b].box, reach) ||
                    found_.shapes[a].box.is_within(found_.shapes[b].box, 0) ||
                    found_.shapes[b].box.is_within(found_.shapes[a].box, 0))
                    continue;
                if (!closest_points(found_.shapes[a].outline, found_.shapes[b].outline, reach)) continue;
                doubt(frame, "outlines in it come as near as parts that touch");
                return;
            }
    }

    void doubt(std::size_t frame, const std::string& why) {
        const SketchEntity& first = found_.drawing.entities[at(found_.shapes[frame].entities.front())];
        doubts_.push_back({"the rectangle of " + first.kind + " " + first.name + " on layer " + first.layer +
                               " around all else is taken as a plate; " + why + ", so it may be the frame of a sheet",
                           found_.shapes[frame].box.min, first.name, first.line,
                           "put it on a layer of its own and leave that out (--ignore-layer) where it is"});
    }

    DraftingSearch& found_;
    bool has_frame_ = false;
    Box2 last_frame_;
    std::vector<SketchProblem> doubts_;
};

}  // namespace

std::vector<SketchProblem> find_sheet(DraftingSearch& found) {
    return SheetSearch(found).find();
}

}  // namespace abut::geometry

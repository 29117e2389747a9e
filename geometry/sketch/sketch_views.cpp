// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/message_text.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Boxes that are nearer than this fraction of the smaller diagonal belong together: `contacts` lists parts as near.
constexpr double figure_fraction = 0.1;
/// A part has six sides to be seen from.
constexpr std::size_t most_views = 6;

/// Parts that belong together.
struct Figure {
    Box2 box;
    std::vector<int> parts;
    double area = 0, perimeter = 0;
};

bool are_near(const Box2& a, const Box2& b) {
    return a.overlaps(b, figure_fraction * std::min(a.diagonal(), b.diagonal()));
}

void take_in(Figure& figure, const Figure& other) {
    figure.box.extend(other.box);
    figure.parts.insert(figure.parts.end(), other.parts.begin(), other.parts.end());
    figure.area += other.area;
    figure.perimeter += other.perimeter;
}

/// Joins neighbours once; are there fewer then?
bool join_neighbours(std::vector<Figure>& figures) {
    std::vector<Box2> boxes;
    for (const Figure& figure : figures) boxes.push_back(figure.box);
    const EdgeTree tree(boxes);
    std::vector<int> root(figures.size());
    std::iota(root.begin(), root.end(), 0);
    const auto root_of = [&](int i) {
        while (root[at(i)] != i) i = root[at(i)] = root[at(root[at(i)])];
        return i;
    };
    for (std::size_t i = 0; i < figures.size(); ++i)
        for (const int k : tree.near(boxes[i], figure_fraction * boxes[i].diagonal()))
            if (are_near(boxes[i], boxes[at(k)])) {
                const int own = root_of(static_cast<int>(i)), other = root_of(k);
                root[at(std::max(own, other))] = std::min(own, other);
            }
    std::map<int, Figure> joined;
    for (std::size_t i = 0; i < figures.size(); ++i) take_in(joined[root_of(static_cast<int>(i))], figures[i]);
    const bool is_any = joined.size() < figures.size();
    figures.clear();
    for (auto& [first, figure] : joined) figures.push_back(std::move(figure));
    return is_any;
}

std::vector<Figure> figures_of(const std::vector<Part>& parts) {
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < parts.size(); ++i)
        figures.push_back({bounding_box(parts[i]), {static_cast<int>(i)}, area(parts[i]), perimeter(parts[i])});
    while (join_neighbours(figures)) {}
    return figures;
}

/// Figures by number, the first of them in the middle of the projection.
using Views = std::vector<int>;

struct Search {
    const std::vector<Figure>& figures;
    double tolerance;

    bool is_same(double a, double b) const { return std::abs(a - b) <= tolerance; }
    const Box2& box(int i) const { return figures[at(i)].box; }

    /// Do two figures begin and end at the same coordinates along an axis?
    bool is_flush(int i, int k, int axis) const {
        return is_same(box(i).min[axis], box(k).min[axis]) && is_same(box(i).max[axis], box(k).max[axis]);
    }
    bool is_as_large(int i, int k) const {
        return is_same(box(i).size().x(), box(k).size().x()) && is_same(box(i).size().y(), box(k).size().y());
    }

    /// Figures above, below and beside one, flush with it.
    Views flush_with(int front) const {
        Views found;
        for (int k = 0; k < static_cast<int>(figures.size()); ++k)
            if (k != front && (is_flush(front, k, 0) || is_flush(front, k, 1))) found.push_back(k);
        return found;
    }

    /// How deep the body is that a figure shows one flush with the front from the side.
    double depth_of(int front, int side) const { return box(side).size()[is_flush(front, side, 0) ? 1 : 0]; }

    /// A figure with those of its neighbours that are its views if it is so deep.
    Views around(int front, const Views& flush, double depth) const {
        Views views{front};
        for (const int k : flush)
            if (is_as_large(front, k) || is_same(depth_of(front, k), depth)) views.push_back(k);
        return views;
    }

    /// Are there views both above (or below) the front and beside it that tell the same depth?
    bool is_certain(const Views& views, double depth) const {
        std::array<bool, 2> is_there{false, false};
        for (std::size_t k = 1; k < views.size(); ++k)
            if (is_same(depth_of(views[0], views[k]), depth) && !is_as_large(views[0], views[k]))
                is_there[is_flush(views[0], views[k], 0) ? 0 : 1] = true;
        return is_there[0] && is_there[1];
    }

    /// The largest projection.
    Views projection() const {
        Views best;
        for (int front = 0; front < static_cast<int>(figures.size()); ++front) {
            const Views flush = flush_with(front);
            for (const int k : flush) {
                const double depth = depth_of(front, k);
                Views views = around(front, flush, depth);
                const bool is_all = views.size() == figures.size();
                if (views.size() <= most_views && views.size() > best.size() && (is_all || is_certain(views, depth)))
                    best = std::move(views);
            }
        }
        return best;
    }

    /// All figures, where they are the same.
    Views copies() const {
        const Figure& first = figures.front();
        const auto is_copy = [&](const Figure& other) {
            return is_same(first.box.size().x(), other.box.size().x()) && is_same(first.box.size().y(), other.box.size().y()) &&
                   is_same(first.perimeter, other.perimeter) &&
                   std::abs(first.area - other.area) <= tolerance * first.perimeter;
        };
        if (figures.size() > most_views || !std::all_of(figures.begin(), figures.end(), is_copy)) return {};
        Views all(figures.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
};

/// "A (3 parts) at (1, 2)".
std::string figure_text(const std::vector<Part>& parts, const Figure& figure) {
    const std::string more = figure.parts.size() > 1 ? " (" + std::to_string(figure.parts.size()) + " parts)" : "";
    return parts[at(figure.parts.front())].name + more + " at " + place_text(figure.box.center());
}

/// What leaves out all but the first: some of the names.
std::string ignoring(const std::vector<Part>& parts, const std::vector<Figure>& figures, const Views& views) {
    constexpr std::size_t most_named = 4;
    std::string text;
    std::size_t n = 0;
    for (std::size_t k = 1; k < views.size(); ++k)
        for (const int part : figures[at(views[k])].parts)
            if (n++ < most_named) text += (text.empty() ? "\"" : ", \"") + parts[at(part)].name + "\": \"ignore\"";
    return "{" + text + (n > most_named ? ", ..." : "") + "}";
}

}  // namespace

std::vector<SketchProblem> views_of_one_part(const std::vector<Part>& parts) {
    const std::vector<Figure> figures = figures_of(parts);
    if (figures.size() < 2) return {};
    Box2 all;
    for (const Figure& figure : figures) all.extend(figure.box);
    const Search search{figures, joining_fraction * all.diagonal()};
    Views views = search.projection();
    const bool is_projection = !views.empty();
    if (!is_projection) views = search.copies();
    if (views.empty()) return {};
    std::string names;
    for (const int view : views) names += (names.empty() ? "" : ", ") + figure_text(parts, figures[at(view)]);
    return {{names +
                 (is_projection ? " look like views of one part side by side: their widths and heights agree as in a projection"
                                : " look like one part drawn several times: they are of the same size and area") +
                 "; each is taken as a part by itself",
             figures[at(views.front())].box.center(), parts[at(figures[at(views.front())].parts.front())].name, 0,
             "to keep the first alone, say in the scene's assembly \"parts\": " + ignoring(parts, figures, views)}};
}

}  // namespace abut::geometry

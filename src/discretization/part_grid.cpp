// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/part_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/cells/tree_grid.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/cell_search.hpp"
#include "src/discretization/discretize.hpp"
#include "src/discretization/place_tree.hpp"
#include "src/io/number_text.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

/// What all parts together may take where the user bounds no memory: a share of what any workplace has.
constexpr double usual_bytes = 4e9;
/// Cells of one part at least, before wanted sizes are given up; coarsened by this factor at a time.
constexpr double least_cells_of_part = 3000, budget_coarsening = 1.3;

/// A leaf of a tree costs about this times what a cell of a tensor grid does: measured 1.3 to 1.45 from the space to the
/// smoothed stress where all leaves are of one level (20 000 and 80 000 unknowns); 1.7 to 2 in whole runs of few thousand
/// unknowns, where levels meet everywhere, and cells are cut once more to be counted.
constexpr double price_of_leaf = 2;
/// Cells are halved no deeper: their size keeps half the digits, and the gap beside a contact as small as they, of the square
/// of its size, none.
constexpr int deepest_level = 24;
/// Columns and rows of a level are counted by an int.
int deepest_level_of(const geometry::Grid& base) {
    constexpr int digits = std::numeric_limits<int>::digits - 1;
    const auto most = static_cast<unsigned>(std::max(base.columns(), base.rows()));
    return std::min(deepest_level, digits - static_cast<int>(std::bit_width(most)));
}

/// More cells than this in one part are a slip of the pen, not a wish.
constexpr double most_cells = 4e6;

void refuse_too_many(double columns, double rows, const std::string& where) {
    if (columns * rows > most_cells)
        throw InputError(where, "this asks for a grid of about " + number_text(columns * rows, 2) + " cells",
                         "at most " + std::to_string(static_cast<long>(most_cells)) + " are possible for one part");
}

/// Grid lines from the scene's explicit grid, in the part's local frame.
geometry::Grid explicit_grid(const GridOptions& options, const geometry::Part& local, const Frame& frame) {
    refuse_too_many(std::max<double>(options.cells[0], static_cast<double>(options.x.size())),
                    std::max<double>(options.cells[1], static_cast<double>(options.y.size())), options.where);
    geometry::Grid grid{options.x, options.y};
    const geometry::Box2 box = bounding_box(local);
    for (int axis : {0, 1}) {
        std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
        for (double& v : lines) v -= frame.shift[axis];
        if (!lines.empty()) continue;
        // a shifted grid of so many cells over the part needs one more cell to cover it
        const int n = options.cells[static_cast<std::size_t>(axis)];
        const double h = box.size()[axis] / n;
        double begin = std::fmod(options.offset[axis], h);
        if (begin > 0) begin -= h;
        const int cells = begin < 0 ? n + 1 : n;
        for (int k = 0; k <= cells; ++k) lines.push_back(box.min[axis] + begin + k * h);
        if (begin == 0) lines.back() = box.max[axis];
    }
    return grid;
}

/// Halves the cells of the scene's boxes.
geometry::Grid with_boxes(const GridOptions& options, const geometry::Part& local, const Frame& frame, geometry::Grid base) {
    if (options.refine.empty()) return base;
    double cells = base.n_cells();
    const int deepest = deepest_level_of(base);
    std::vector<char> halves(options.refine.size(), 0);
    geometry::Grid tree = tree_grid(local, base, [&](const geometry::Box2& cell, int level) {
        bool wanted = false;
        for (std::size_t k = 0; k < halves.size(); ++k) {
            const GridOptions::Halved& h = options.refine[k];
            if (level >= h.levels || !((cell.min.array() < (h.high - frame.shift).array()).all() &&
                                       ((h.low - frame.shift).array() < cell.max.array()).all()))
                continue;
            wanted = true;
            halves[k] = 1;
        }
        if (wanted && level >= deepest)
            throw InputError(
                options.where,
                "cells of so many columns or rows cannot be halved more than " + std::to_string(deepest) + " times",
                "give refine fewer levels, or the grid fewer cells");
        if (wanted) refuse_too_many(cells += 3, 1, options.where);
        return wanted;
    });
    for (std::size_t k = 0; k < halves.size(); ++k)
        if (!halves[k])
            throw InputError(options.where + "/refine/" + std::to_string(k), "the box overlaps no cell of the part",
                             "its corners are in assembly coordinates turned by -angle");
    return tree;
}

/// One of the grids that the dissertation's search splits its one grid into, in the part's local frame.
geometry::Grid search_grid_of(const Scene& scene, int part, const Frame& frame) {
    geometry::Grid grid = split_grid(search_grid(scene), part);
    if (grid.x.empty())
        throw InputError(scene.parts[at(part)].where, "part " + scene.parts[at(part)].name + " fills no cell of the grid",
                         "give accuracy.cell_size a smaller value");
    for (double& x : grid.x) x -= frame.shift.x();
    for (double& y : grid.y) y -= frame.shift.y();
    return grid;
}

std::vector<SizeFeature> local_features(const std::vector<WantedSize>& wanted, const Frame& frame) {
    std::vector<SizeFeature> features;
    for (const WantedSize& w : wanted) {
        SizeFeature f{{}, w.size, w.growth};
        for (const Vec2& p : w.points) f.line.push_back(frame.to_local(p));
        for (const Vec2& p : f.line) f.box.extend(p);
        features.push_back(std::move(f));
    }
    return features;
}

geometry::Grid tensor_grid(const geometry::Box2& box, const std::array<double, 2>& largest,
                           const std::vector<SizeFeature>& features) {
    return {graded_lines(box.min.x(), box.max.x(), 0, largest[0], features),
            graded_lines(box.min.y(), box.max.y(), 1, largest[1], features)};
}

/// The largest cells of a base whose walls want small ones along one axis: no more than so many times as long along the other,
/// since what is halved stays as long as it is.
constexpr double longest_of_base = 2;

std::array<double, 2> largest_of_base(std::array<double, 2> largest, const std::vector<SizeFeature>& walls) {
    std::array<double, 2> least = largest;
    for (const SizeFeature& f : walls)
        for (int axis : {0, 1})
            if (std::isfinite(f.box.min[axis])) least[at(axis)] = std::min(least[at(axis)], f.size);
    for (int axis : {0, 1}) largest[at(axis)] = std::min(largest[at(axis)], longest_of_base * least[at(1 - axis)]);
    return largest;
}

/// Condition numbers grow with the square of the ratio of cells' sides: strips longer than this would take a third of all
/// digits.
constexpr double longest_strip = 300;

/// The largest ratio of the sides of a grid's cells; of a tree's, those of its base.
double longest_cell(const geometry::Grid& grid) {
    const auto range = [](const std::vector<double>& lines) {
        double least = std::numeric_limits<double>::infinity(), most = 0;
        for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
            least = std::min(least, lines[k + 1] - lines[k]);
            most = std::max(most, lines[k + 1] - lines[k]);
        }
        return std::array<double, 2>{least, most};
    };
    const auto x = range(grid.x), y = range(grid.y);
    return std::max(x[1] / y[0], y[1] / x[0]);
}

/// What a grid costs, in cells of a tensor grid that hold material; too many cells cost too much.
struct PricedGrid {
    geometry::Grid grid;
    double price;
    double too_fine = 0;  ///< as in PartGrid
};

PricedGrid priced(const geometry::Part& local, geometry::Grid grid, double most) {
    constexpr double too_many = std::numeric_limits<double>::infinity();
    const double cells = grid.n_cells() > most_cells ? too_many : n_filled(local, grid);
    const double price = cells > most ? too_many : (grid.tree ? price_of_leaf : 1) * cells;
    return {std::move(grid), price};
}

double smallest_wanted(const std::vector<SizeFeature>& places) {
    double least = std::numeric_limits<double>::infinity();
    for (const SizeFeature& f : places) least = std::min(least, f.size);
    return least;
}

/// The base halved where places want smaller cells. A tree that grows to cost as much as it may is left unfinished.
PricedGrid halved_grid(const geometry::Part& local, const geometry::Grid& base, const std::vector<SizeFeature>& places,
                       double price, double most) {
    const PlaceTree wanted(places);
    const int deepest = deepest_level_of(base);
    double halved = 0, too_fine = 0;
    geometry::Grid tree = tree_grid(local, base, [&](const geometry::Box2& cell, int level) {
        if (price_of_leaf * halved >= price || 3 * halved >= most || !wanted.is_too_large(cell)) return false;
        if (level == deepest) too_fine = smallest_wanted(places);
        halved += level < deepest;
        return level < deepest;
    });
    PricedGrid result = priced(local, std::move(tree), most);
    if (price_of_leaf * halved >= price || 3 * halved >= most) result.price = std::numeric_limits<double>::infinity();
    result.too_fine = too_fine;
    return result;
}

/// The cheapest of three: a tensor grid of all wishes, where its cells are no long strips; one of the shape's own, or of its
/// extent and walls only, with cells halved where smaller ones are wanted. budget: of tensor grids; a tree's cells are where
/// they were asked for, and it may have as many as all parts. may_halve: false, the first of them.
PricedGrid cheapest_grid(const geometry::Part& local, const std::array<double, 2>& largest, const ShapeFeatures& shape,
                         const std::vector<SizeFeature>& wanted, double budget, double budget_of_all, bool may_halve) {
    const geometry::Box2 box = bounding_box(local);
    std::vector<SizeFeature> places = shape.places, own = shape.walls, all;
    places.insert(places.end(), wanted.begin(), wanted.end());
    own.insert(own.end(), shape.places.begin(), shape.places.end());
    all = own;
    all.insert(all.end(), wanted.begin(), wanted.end());
    PricedGrid best = priced(local, tensor_grid(box, largest, all), budget);
    if (!may_halve) return best;
    const double n_tensor = best.grid.n_cells();
    const bool has_strips = longest_cell(best.grid) > longest_strip;
    double most = has_strips ? std::numeric_limits<double>::infinity() : best.price;
    for (const bool is_of_shape : {true, false}) {
        const geometry::Grid base =
            is_of_shape ? tensor_grid(box, largest, own) : tensor_grid(box, largest_of_base(largest, shape.walls), shape.walls);
        if (price_of_leaf * base.n_cells() >= (has_strips ? most : n_tensor)) continue;  // as it is it already costs as much
        PricedGrid tree = halved_grid(local, base, is_of_shape ? wanted : places, most, budget_of_all);
        if (tree.price >= most || longest_cell(tree.grid) > longest_strip) continue;
        most = tree.price;
        best = std::move(tree);
    }
    return best;
}

/// Cells no longer than a part is thin would be too many.
void refuse_too_thin(const ScenePart& part, const geometry::Part& local) {
    const Vec2 size = bounding_box(local).size();
    if (size.maxCoeff() > most_cells * size.minCoeff())
        throw InputError(part.where,
                         "part " + part.name + " is " + number_text(size.maxCoeff(), 3) + " long and only " +
                             number_text(size.minCoeff(), 3) + " thick",
                         "draw it thicker, or leave it out");
}

/// Sets all of result but what it was given by.
void design_grid(const Scene& scene, const std::vector<WantedSize>& wanted, double coarseness, double refinement, double budget,
                 PartGrid& result) {
    const geometry::Part& local = result.local;
    const Frame& frame = result.frame;
    const geometry::Box2 box = bounding_box(local);
    if (scene.accuracy.cell_size)
        refuse_too_many(box.size().x() / *scene.accuracy.cell_size, box.size().y() / *scene.accuracy.cell_size,
                        "/accuracy/cell_size");
    std::array<double, 2> largest = largest_cells(local, coarseness);
    ShapeFeatures shape;
    std::vector<SizeFeature> more;
    if (scene.accuracy.cell_size)
        largest = {*scene.accuracy.cell_size, *scene.accuracy.cell_size};
    else
        shape = shape_features(local, coarseness);
    if (!scene.accuracy.cell_size || scene.accuracy.adapt.value_or(false)) more = local_features(wanted, frame);
    for (const Refinement& r : scene.accuracy.refine) {
        geometry::Box2 around;
        around.extend(Vec2(frame.to_local(r.near) - Vec2::Constant(r.radius)));
        around.extend(Vec2(frame.to_local(r.near) + Vec2::Constant(r.radius)));
        more.push_back({around, r.cell_size});
    }
    for (double& h : largest) h *= refinement;
    for (std::vector<SizeFeature>* features : {&shape.walls, &shape.places, &more})
        for (SizeFeature& f : *features) f.size *= refinement;
    if (scene.accuracy.cell_size) {
        result.grid = tensor_grid(box, largest, more);
        return;
    }
    // a penalty is as stiff as the first part's cells are small along its edge: halves of cells would be steps in it
    const bool may_halve = !scene.contacts.penalty;
    for (;;) {
        PricedGrid cheapest =
            cheapest_grid(local, largest, shape, more, budget, budget * static_cast<double>(scene.parts.size()), may_halve);
        result.too_fine = cheapest.too_fine;
        if (std::isfinite(cheapest.price)) {
            result.grid = std::move(cheapest.grid);
            return;
        }
        result.limited = true;
        for (std::vector<SizeFeature>* features : {&shape.walls, &shape.places, &more})
            for (SizeFeature& f : *features) f.size *= budget_coarsening;
        for (double& h : largest) h *= std::sqrt(budget_coarsening);
    }
}

}  // namespace

double n_filled(const geometry::Part& local, const geometry::Grid& grid) {
    const std::vector<geometry::CellClass> classes = cut_cells(local, grid).cell_class;
    const auto empty = std::count(classes.begin(), classes.end(), geometry::CellClass::outer);
    return static_cast<double>(static_cast<std::ptrdiff_t>(classes.size()) - empty);
}

PartGrid grid_of_part(const Scene& scene, int part, const std::vector<WantedSize>& wanted, double coarseness,
                      double refinement) {
    ENSURE(part >= 0 && at(part) < scene.parts.size(), "the part is one of the scene");
    ENSURE(coarseness > 0 && refinement > 0, "factors on sizes are positive");
    const ScenePart& source = scene.parts[at(part)];
    const auto given = scene.accuracy.grids.find(source.name);
    PartGrid result;
    result.given = given != scene.accuracy.grids.end();
    result.frame = frame_for(source.part, result.given ? given->second.angle : 0);
    result.local = transformed(source.part, result.frame.c, -result.frame.s, -result.frame.shift);
    result.degree = {scene.accuracy.degree, scene.accuracy.degree};
    refuse_too_thin(source, result.local);
    if (result.given) {
        result.grid =
            with_boxes(given->second, result.local, result.frame, explicit_grid(given->second, result.local, result.frame));
        result.degree = given->second.degree.value_or(result.degree);
        return result;
    }
    if (is_by_dissertation(scene)) {
        result.given = true;
        result.grid = search_grid_of(scene, part, result.frame);
        return result;
    }
    const double of_all = scene.accuracy.budget.bytes.value_or(usual_bytes) / (2 * bytes_per_unknown);
    const double budget = std::max(least_cells_of_part, of_all / static_cast<double>(scene.parts.size()));
    design_grid(scene, wanted, coarseness, refinement, budget, result);
    return result;
}

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/mirror.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/linear_algebra/index.hpp"

namespace abut::solver {

namespace {

/// The mirror's action on the grids.
class GridImage {
public:
    GridImage(const PartInput& part, const PartInput& image, const PlaceImage& place)
        : part_(part), image_(image), place_(place) {}

    /// How the grids differ; empty: they do not.
    std::string difference() const {
        const SplineSpace &a = part_.space, &b = image_.space;
        if (a.x.degree != b.x.degree || a.y.degree != b.y.degree || !same_lines(a.x, b.x, 0) || !same_lines(a.y, b.y, 1))
            return "its grid lines have no mirror image";
        return "";
    }

    int cell(int c) const {
        const int columns = part_.space.columns(), x = c % columns, y = c / columns;
        return place_.axis == 0 ? y * columns + columns - 1 - x : (part_.space.rows() - 1 - y) * columns + x;
    }

    /// Of the local B-splines of an element, x fastest.
    std::size_t local(std::size_t k) const {
        const auto p = at(part_.space.x.degree), q = at(part_.space.y.degree), i = k % (p + 1), j = k / (p + 1);
        return place_.axis == 0 ? j * (p + 1) + p - i : (q - j) * (p + 1) + i;
    }

    Vec2 place(const Vec2& x) const { return place_(x); }

private:
    bool same_lines(const KnotVector& a, const KnotVector& b, int direction) const {
        const std::size_t n = a.breakpoints.size();
        if (a.knots.size() != b.knots.size() || b.breakpoints.size() != n) return false;
        const double near = mirrored_place * (a.breakpoints.back() - a.breakpoints.front());
        for (std::size_t k = 0; k < n; ++k) {
            const double other = b.breakpoints[direction == place_.axis ? n - 1 - k : k];
            if (std::abs(place_.along(direction, a.breakpoints[k]) - other) > near) return false;
        }
        return true;
    }

    const PartInput &part_, &image_;
    const PlaceImage& place_;
};

/// Centroids of the elements that have rules of their own; points of rules may lie anywhere.
std::map<int, Vec2> middles(const PartInput& input) {
    std::map<int, Vec2> middle;
    for (const CellRule& rule : input.cut_rules) {
        Vec2 sum(0, 0);
        double area = 0;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            sum += rule.weights[q] * rule.points[q];
            area += rule.weights[q];
        }
        middle[rule.element] = sum / area;
    }
    return middle;
}

std::vector<std::vector<int>> elements_by_cell(const SplineSpace& space) {
    std::vector<std::vector<int>> elements(at(space.n_cells()));
    for (std::size_t e = 0; e < space.fraction.size(); ++e)
        if (space.fraction[e] > mirrored_sliver)
            elements[at(space.cell_of(static_cast<int>(e)))].push_back(static_cast<int>(e));
    return elements;
}

/// False: the cells hold different numbers of elements.
bool map_elements(const PartInput& part, const PartInput& image, const GridImage& grid, std::vector<int>& to) {
    const auto of_part = elements_by_cell(part.space), of_image = elements_by_cell(image.space);  // by cell, but for slivers
    const std::map<int, Vec2> from = middles(part), others = middles(image);
    to.assign(part.space.fraction.size(), -1);
    for (std::size_t c = 0; c < of_part.size(); ++c) {
        const std::vector<int>& there = of_image[at(grid.cell(static_cast<int>(c)))];
        if (there.size() != of_part[c].size()) return false;
        for (int e : of_part[c]) {
            if (there.size() == 1) {
                to[at(e)] = there[0];
                continue;
            }
            const Vec2 place = grid.place(from.at(e));
            to[at(e)] = *std::min_element(there.begin(), there.end(), [&](int a, int b) {
                return (others.at(a) - place).squaredNorm() < (others.at(b) - place).squaredNorm();
            });
        }
    }
    return true;
}

/// False: a branch has two images.
bool map_branches(const SplineSpace& part, const SplineSpace& image, const GridImage& grid, const std::vector<int>& element,
                  std::vector<int>& to) {
    to.assign(at(part.n_tensor()) + part.tensor_of_extra.size(), -1);
    if (image.tensor_of_extra.size() != part.tensor_of_extra.size()) return false;
    LocalFunctions own, other;
    for (std::size_t e = 0; e < element.size(); ++e) {
        if (element[e] < 0) continue;
        const std::size_t n = local_functions(part, static_cast<int>(e), own);
        local_functions(image, element[e], other);
        for (std::size_t k = 0; k < n; ++k) {
            int& branch = to[at(own[k])];
            if (branch >= 0 && branch != other[grid.local(k)]) return false;
            branch = other[grid.local(k)];
        }
    }
    return true;
}

/// The function that a branch is; -1: it is a combination of others.
int function_of(const SplineSpace& space, int branch) {
    const int row = space.first[at(branch)];
    if (space.first[at(branch) + 1] != row + 1) return -1;
    const int tensor = branch < space.n_tensor() ? branch : space.tensor_of_extra[at(branch - space.n_tensor())];
    return space.tensor_of[at(space.function[at(row)])] == tensor ? space.function[at(row)] : -1;
}

/// False: a function's image is none.
bool map_functions(const SplineSpace& part, const SplineSpace& image, const std::vector<int>& branch, std::vector<int>& to) {
    to.assign(at(part.n_functions), -1);
    if (image.n_functions != part.n_functions) return false;
    for (std::size_t b = 0; b < branch.size(); ++b) {
        const int own = part.has_row(static_cast<int>(b)) ? function_of(part, static_cast<int>(b)) : -1;
        if (own < 0) continue;
        to[at(own)] = branch[b] >= 0 && image.has_row(branch[b]) ? function_of(image, branch[b]) : -1;
    }
    return std::none_of(to.begin(), to.end(), [](int f) { return f < 0; });
}

}  // namespace

SpaceImage space_image(const PartInput& part, const PartInput& image, const PlaceImage& place) {
    SpaceImage result;
    const GridImage grid(part, image, place);
    result.failure = grid.difference();
    if (!result.failure.empty()) return result;
    if (!map_elements(part, image, grid, result.element))
        result.failure = "its cut cells have no mirror image";
    else if (!map_branches(part.space, image.space, grid, result.element, result.branch))
        result.failure = "its slots have no mirror image";
    else if (!map_functions(part.space, image.space, result.branch, result.function))
        result.failure = "of a cell and its image one alone is filled enough for a function of its own";
    return result;
}

}  // namespace abut::solver

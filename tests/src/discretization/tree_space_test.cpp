// SPDX-License-Identifier: GPL-3.0-or-later
// Hierarchical spaces on the cells of random parts: every kind of curve, slots, cuts to slivers, trees of any pattern.
#include <gtest/gtest.h>

#include "geometry/cells/elements.hpp"
#include "geometry/cells/tree_grid.hpp"
#include "solver/splines/spline_space.hpp"
#include "tests/geometry/cells/slotted_parts.hpp"

namespace tree_space_test {

namespace {

using namespace abut;
using namespace abut::geometry::test;
using geometry::CutCells;
using geometry::Elements;
using geometry::Grid;
using geometry::Part;
using solver::SplineSpace;
using solver::Vec2;

/// A polynomial of degree p in one variable by its blossom at p arguments; coefficients of 1, x, ..., x^p.
double blossom_of(const std::vector<double>& polynomial, const double* arguments) {
    const std::size_t p = polynomial.size() - 1;
    std::vector<double> symmetric(p + 1, 0.0);  // elementary symmetric polynomials of the arguments
    symmetric[0] = 1;
    for (std::size_t k = 0; k < p; ++k)
        for (std::size_t i = k + 1; i > 0; --i) symmetric[i] += arguments[k] * symmetric[i - 1];
    double sum = 0, binomial = 1;
    for (std::size_t i = 0; i <= p; ++i) {
        sum += polynomial[i] * symmetric[i] / binomial;
        binomial *= static_cast<double>(p - i) / static_cast<double>(i + 1);
    }
    return sum;
}

/// A product of two polynomials, of the space's degrees.
struct Product {
    std::vector<double> x, y;

    double coefficient(const SplineSpace& s, int element, int local) const {
        const int p = s.x.degree + 1;
        return blossom_of(x, s.along_x(element).inner_knots(local % p)) *
               blossom_of(y, s.along_y(element).inner_knots(local / p));
    }
};

Product random_product(const SplineSpace& s, Random& random) {
    Product f;
    for (int i = 0; i <= s.x.degree; ++i) f.x.push_back(between(-1, 1, random));
    for (int i = 0; i <= s.y.degree; ++i) f.y.push_back(between(-1, 1, random));
    return f;
}

/// The coefficients of a product, each from an element where its function is a B-spline. Not a number: there is none.
std::vector<double> coefficients_of(const SplineSpace& s, const Product& f) {
    std::vector<double> c(at(s.n_functions), std::numeric_limits<double>::quiet_NaN());
    for (int e = 0; e < static_cast<int>(s.fraction.size()); ++e)
        for (int k = 0; k < s.n_local(); ++k) {
            const int row = s.first[at(e * s.n_local() + k)];
            if (s.first[at(e * s.n_local() + k + 1)] == row + 1 && s.coefficient[at(row)] == 1)
                c[at(s.function[at(row)])] = f.coefficient(s, e, k);
        }
    return c;
}

/// The largest difference between the B-spline coefficients that an element needs for a product and those that its rows give.
double reproduction_error(const SplineSpace& s, const Product& f) {
    const std::vector<double> c = coefficients_of(s, f);
    double worst = 0;
    for (int e = 0; e < static_cast<int>(s.fraction.size()); ++e) {
        if (!(s.fraction[at(e)] > 0)) continue;
        for (int k = 0; k < s.n_local(); ++k) {
            double sum = 0;
            for (int i = s.first[at(e * s.n_local() + k)]; i < s.first[at(e * s.n_local() + k + 1)]; ++i)
                sum += s.coefficient[at(i)] * c[at(s.function[at(i)])];
            worst = std::max(worst, std::abs(sum - f.coefficient(s, e, k)));
            if (std::isnan(sum)) return sum;
        }
    }
    return worst;
}

struct Case {
    Part part;
    CutCells cells;
    Elements elements;
    SplineSpace space;
};

Case make_case(unsigned k, solver::Basis basis) {
    Random random(k);
    const int kind = static_cast<int>(k) % (n_slotted_kinds + n_part_kinds);
    Case c;
    c.part = kind < n_slotted_kinds ? slotted_part(kind, random) : random_part(kind - n_slotted_kinds, random);
    c.cells = cut_cells(c.part, random_tree(c.part, random));
    c.elements = find_elements(c.part, c.cells);
    const Grid& grid = c.cells.grid;
    c.space = solver::make_space({solver::clamped_knots(grid.x, 1 + static_cast<int>(k / 3 % 4)),
                          solver::clamped_knots(grid.y, 1 + static_cast<int>((k / 3 + k / 24) % 4)),
                          c.elements.fraction,
                          {c.elements.cell_of_extra, c.elements.neighbours},
                          basis,
                          [](int) { return std::vector<Vec2>{}; },
                          grid.tree});
    return c;
}

/// The largest coefficient: of extensions far beyond 1.
double largest_weight(const SplineSpace& s) {
    double most = 0;
    for (double c : s.coefficient) most = std::max(most, std::abs(c));
    return most;
}

/// Returns how many functions were extended.
int reproduce(unsigned first, unsigned n, solver::Basis basis) {
    int extended = 0;
    for (unsigned k = first; k < first + n; ++k) {
        SCOPED_TRACE("case " + std::to_string(k));
        const Case c = make_case(k, basis);
        if (!c.space.failure.empty()) continue;
        extended += c.space.n_extended;
        Random random(k);
        // rounding of the blossoms, of polynomials up to (1 + 1.5)^p each way on parts of this size, times the weights
        const double rounding = 1e-15 * std::pow(2.5, c.space.x.degree + c.space.y.degree) * 10;
        EXPECT_LT(reproduction_error(c.space, random_product(c.space, random)), rounding * largest_weight(c.space));
        if (testing::Test::HasFailure()) break;
    }
    return extended;
}

TEST(TreeSpace, ReproducesPolynomials) {
    EXPECT_GT(reproduce(0, 200, solver::Basis::web), 1000);
    EXPECT_EQ(reproduce(0, 60, solver::Basis::plain), 0);
}

TEST(LongTreeSpace, ReproducesPolynomials) {
    EXPECT_GT(reproduce(1000, 2000, solver::Basis::web), 1000);
}

}  // namespace

}  // namespace tree_space_test

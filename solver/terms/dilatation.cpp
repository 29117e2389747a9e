// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/dilatation.hpp"

#include <utility>

#include "solver/assembly/ring.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Entries = std::vector<Eigen::Triplet<double>>;

SplineSpace pressure_space(const SplineSpace& s) {
    const Basis basis = s.basis == Basis::web ? Basis::web : Basis::plain;  // the factor scales its rows: nothing to normalise
    return make_space({derivative_knots(s.x), derivative_knots(s.y), s.fraction, s.splits, basis, {}, s.tree});
}

/// Local values, by points, taken together to those of the space's functions.
Eigen::MatrixXd extracted(const Extraction& e, const Eigen::MatrixXd& local) {
    return e.identity ? local : Eigen::MatrixXd(local * e.matrix);
}

/// The volume strain that a free strain asks for by itself, 3 e.
void add_free_volume(const PartInput& input, const CellRule& rule, const std::vector<int>& functions,
                     const Eigen::MatrixXd& weighted, VectorXd& prescribed) {
    VectorXd free(static_cast<Index>(rule.points.size()));
    for (std::size_t k = 0; k < rule.points.size(); ++k) free[static_cast<Index>(k)] = 3 * input.free_strain(rule.points[k]);
    const VectorXd sum = weighted * free;
    for (std::size_t i = 0; i < functions.size(); ++i) prescribed[functions[i]] += sum[static_cast<Index>(i)];
}

/// Of u_x: du_x / dx, around an axis and u_x / r.
Eigen::MatrixXd volume_strain_of_x(const PartInput& input, const CellRule& rule, const Sampled& u) {
    if (!input.axis) return u.dx;
    VectorXd inverse(static_cast<Index>(rule.points.size()));
    for (std::size_t k = 0; k < rule.points.size(); ++k) inverse[static_cast<Index>(k)] = 1 / radius(input, rule.points[k]);
    return u.dx + inverse.asDiagonal() * u.value;
}

void add_block(Entries& entries, const std::vector<int>& rows, const std::vector<int>& columns, int stride, int offset,
               const Eigen::MatrixXd& block) {
    for (std::size_t j = 0; j < columns.size(); ++j)
        for (std::size_t i = 0; i < rows.size(); ++i)
            entries.emplace_back(rows[i], stride * columns[j] + offset, block(static_cast<Index>(i), static_cast<Index>(j)));
}

void add_element(const PartInput& input, const SplineSpace& space, const CellRule& rule, Entries& divergence, Entries& mass,
                 VectorXd& prescribed) {
    Sampled u, p;
    sample(input.space, rule.element, rule.points, u);
    sample(space, rule.element, rule.points, p);
    const Extraction eu = extraction(input.space, rule.element), ep = extraction(space, rule.element);
    const VectorXd w = input.thickness * VectorXd::Map(rule.weights.data(), static_cast<Index>(rule.weights.size()));
    const Eigen::MatrixXd q = extracted(ep, p.value), weighted = (w.asDiagonal() * q).transpose();
    add_block(divergence, ep.functions, eu.functions, 2, 0, extracted(eu, weighted * volume_strain_of_x(input, rule, u)));
    add_block(divergence, ep.functions, eu.functions, 2, 1, extracted(eu, weighted * u.dy));
    add_block(mass, ep.functions, ep.functions, 1, 0, weighted * q);
    if (input.free_strain) add_free_volume(input, rule, ep.functions, weighted, prescribed);
}

/// The work of the pressure's traction p d.n on the difference d.u - value.
void add_support(const PartInput& input, const SupportSet& set, Dilatation& d, Entries& divergence) {
    for (const SupportPoint& p : set.points) {
        const PointBasis q = evaluate(d.space, p.element, p.x), u = evaluate(input.space, p.element, p.x);
        const VectorXd traction = (-p.weight * input.thickness * p.direction.dot(p.normal)) * q.value;
        for (int c : {0, 1})
            add_block(divergence, q.functions, u.functions, 2, c, traction * (p.direction[c] * u.value).transpose());
        for (std::size_t i = 0; i < q.functions.size(); ++i)
            d.prescribed[q.functions[i]] += traction[static_cast<Index>(i)] * p.value;
    }
}

SparseSymmetric lower_triangle(const Entries& entries, int n) {
    Eigen::SparseMatrix<double> m(n, n);
    m.setFromTriplets(entries.begin(), entries.end());
    SparseSymmetric lower{n, {0}, {}, {}};
    for (int c = 0; c < n; ++c) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(m, c); it; ++it) {
            if (it.row() < c) continue;
            lower.row.push_back(static_cast<int>(it.row()));
            lower.value.push_back(it.value());
        }
        lower.first.push_back(static_cast<int>(lower.row.size()));
    }
    return lower;
}

}  // namespace

std::shared_ptr<const Dilatation> make_dilatation(const PartInput& input, const std::vector<const SupportSet*>& by_nitsche) {
    auto d = std::make_shared<Dilatation>();
    d->space = pressure_space(input.space);
    d->modulus = input.elasticity.d12;
    d->failure = d->space.failure;
    if (!d->failure.empty()) return d;
    Entries divergence, mass;
    d->prescribed = VectorXd::Zero(d->space.n_functions);
    for_all_cells(input, [&](const CellRule& rule) { add_element(input, d->space, rule, divergence, mass, d->prescribed); });
    for (const SupportSet* set : by_nitsche) add_support(input, *set, *d, divergence);
    d->divergence.resize(d->space.n_functions, 2 * input.space.n_functions);
    d->divergence.setFromTriplets(divergence.begin(), divergence.end());
    d->mass = lower_triangle(mass, d->space.n_functions);
    d->mass_factor = Factorization(d->mass);
    if (!d->mass_factor.ok())
        d->failure = "the projection of its volume strain is singular: some functions hardly reach into it";
    return d;
}

const Dilatation& dilatation_of(const PartInput& input) {
    ENSURE(input.dilatation, "the projection of a part's dilatation is made with its system");
    return *input.dilatation;
}

VectorXd pressure(const Dilatation& d, const VectorXd& displacement) {
    return d.modulus * d.mass_factor.solve(d.divergence * displacement - d.prescribed);
}

VectorXd volume_forces(const Dilatation& d, const VectorXd& displacement) {
    return d.modulus * (d.divergence.transpose() * d.mass_factor.solve(d.divergence * displacement));
}

VectorXd volume_load(const Dilatation& d) {
    return d.modulus * (d.divergence.transpose() * d.mass_factor.solve(d.prescribed));
}

double volume_energy(const Dilatation& d, const VectorXd& displacement) {
    return 0.5 * pressure(d, displacement).dot(d.divergence * displacement - d.prescribed);
}

SparseSymmetric with_pressures(const SparseSymmetric& a, const Dilatation& d, const std::vector<int>& number) {
    SparseSymmetric m{a.n + d.mass.n, {0}, {}, {}};
    const auto push = [&](int row, double value) {
        m.row.push_back(row);
        m.value.push_back(value);
    };
    const auto end_column = [&] { m.first.push_back(static_cast<int>(m.row.size())); };
    for (std::size_t dof = 0; dof < number.size(); ++dof) {
        if (number[dof] < 0) continue;
        const auto c = static_cast<std::size_t>(number[dof]);
        for (int k = a.first[c]; k < a.first[c + 1]; ++k)
            push(a.row[static_cast<std::size_t>(k)], a.value[static_cast<std::size_t>(k)]);
        for (Eigen::SparseMatrix<double>::InnerIterator it(d.divergence, static_cast<Index>(dof)); it; ++it)
            push(a.n + static_cast<int>(it.row()), it.value());
        end_column();
    }
    for (std::size_t c = 0; c + 1 < d.mass.first.size(); ++c) {
        for (int k = d.mass.first[c]; k < d.mass.first[c + 1]; ++k)
            push(a.n + d.mass.row[static_cast<std::size_t>(k)], -d.mass.value[static_cast<std::size_t>(k)] / d.modulus);
        end_column();
    }
    return m;
}

}  // namespace abut::solver

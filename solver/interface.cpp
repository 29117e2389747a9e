// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/interface.hpp"

#include <algorithm>

namespace abut::solver {

namespace {

using Eigen::Index;

/// Entries of one row and coefficient that came from several points are summed.
void compress(std::vector<RowEntry>& entries) {
    std::sort(entries.begin(), entries.end(), [](const RowEntry& a, const RowEntry& b) {
        return a.row != b.row ? a.row < b.row : a.coefficient < b.coefficient;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (kept > 0 && entries[kept - 1].row == entries[i].row && entries[kept - 1].coefficient == entries[i].coefficient)
            entries[kept - 1].value += entries[i].value;
        else
            entries[kept++] = entries[i];
    }
    entries.resize(kept);
}

void add_point(Rows& rows, const std::vector<PartSystem>& parts, const Interface& face, const InterfacePoint& p,
               int first_row) {
    const int interval = interval_of(face.pressure, p.s);
    LocalValues n;
    evaluate(face.pressure, interval, p.s, n);
    const double w = p.weight * face.thickness;
    const auto row = [&](int k) { return first_row + (interval + k) % n_rows(face); };
    for (int k = 0; k <= face.pressure.degree; ++k) {
        const double share = w * n[static_cast<std::size_t>(k)];
        rows.gap0[row(k)] += share * p.gap;
        rows.weight[row(k)] += share;
    }
    for (std::size_t side = 0; side < 2; ++side) {
        const auto part = static_cast<std::size_t>(face.part[side]);
        const DisplacementBasis b = displacement_basis(parts[part].input, p.element[side], p.x[side]);
        const Vec2 along = (side == 0 ? -1 : 1) * p.normal[side];
        for (int k = 0; k <= face.pressure.degree; ++k) {
            const double share = w * n[static_cast<std::size_t>(k)];
            rows.gap0[row(k)] += share * along.dot(b.data.value);
            for (std::size_t i = 0; i < b.x.functions.size(); ++i)
                for (int c = 0; c < 2; ++c)
                    rows.by_part[part].push_back(
                        {row(k), 2 * b.x.functions[i] + c, share * b.of(c).value[static_cast<Index>(i)] * along[c]});
        }
    }
}

}  // namespace

Rows interface_rows(const std::vector<PartSystem>& parts, const std::vector<Interface>& interfaces,
                    std::vector<int>& first_row) {
    Rows rows;
    first_row.clear();
    for (const Interface& face : interfaces) {
        first_row.push_back(rows.n);
        rows.n += n_rows(face);
    }
    rows.by_part.resize(parts.size());
    rows.gap0 = Eigen::VectorXd::Zero(rows.n);
    rows.weight = Eigen::VectorXd::Zero(rows.n);
    rows.unilateral.assign(static_cast<std::size_t>(rows.n), 1);
    for (std::size_t k = 0; k < interfaces.size(); ++k)
        for (const InterfacePoint& p : interfaces[k].points) add_point(rows, parts, interfaces[k], p, first_row[k]);
    for (auto& entries : rows.by_part) compress(entries);
    return rows;
}

Eigen::VectorXd all_coefficients(const Interface& face, const Eigen::VectorXd& unknown) {
    Eigen::VectorXd all(face.pressure.n_functions());
    for (Index k = 0; k < all.size(); ++k) all[k] = unknown[k % unknown.size()];
    return all;
}

int append_mean_constraint(Rows& rows, const PartSystem& system, int part, const FunctionIntegrals& integrals, double area,
                           const Eigen::Vector3d& coefficient, double size, double value) {
    const int row = rows.n++;
    for (int f = 0; f < system.n(); ++f) {
        const double mean = integrals.value[f] / area, turn = 0.5 * size / area;
        const double x = coefficient[0] * mean - coefficient[2] * turn * integrals.dy[f];
        const double y = coefficient[1] * mean + coefficient[2] * turn * integrals.dx[f];
        rows.by_part[static_cast<std::size_t>(part)].push_back({row, 2 * f, x});
        rows.by_part[static_cast<std::size_t>(part)].push_back({row, 2 * f + 1, y});
    }
    rows.gap0.conservativeResize(rows.n);
    rows.weight.conservativeResize(rows.n);
    rows.gap0[row] = -value;
    rows.weight[row] = 1;
    rows.unilateral.push_back(0);
    return row;
}

double pressure_at(const KnotVector& pressure, const Eigen::VectorXd& coefficients, double s) {
    const int interval = interval_of(pressure, s);
    LocalValues n;
    evaluate(pressure, interval, s, n);
    double sum = 0;
    for (int k = 0; k <= pressure.degree; ++k) sum += n[static_cast<std::size_t>(k)] * coefficients[interval + k];
    return sum;
}

}  // namespace abut::solver

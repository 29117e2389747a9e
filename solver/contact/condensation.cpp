// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/condensation.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The rows of one part, numbered among themselves, and its load where there is any.
struct PartColumns {
    std::vector<int> row;                 // in the assembly
    Eigen::SparseMatrix<double> columns;  // (kept unknowns x rows and load): D' of the part, f
    bool is_loaded = false;
};

std::vector<int> rows_of(const std::vector<RowEntry>& entries) {
    std::vector<int> rows;
    for (const RowEntry& e : entries)
        if (rows.empty() || rows.back() != e.row) rows.push_back(e.row);
    return rows;
}

/// One row's entries, ascending.
void fill_column(const PartSystem& part, std::span<const RowEntry> entries, Index column, Eigen::SparseMatrix<double>& to) {
    const auto unknown = [&](const RowEntry& e) { return part.number[static_cast<std::size_t>(e.coefficient)]; };
    for (const RowEntry& e : entries)
        if (unknown(e) >= 0) to.insertBack(unknown(e), column) = e.value;
}

/// entries: by row, then coefficient.
PartColumns columns_of(const PartSystem& part, const std::vector<RowEntry>& entries, const VectorXd& load) {
    PartColumns c{rows_of(entries), {}, load.size() > 0};
    c.columns.resize(part.n_kept, static_cast<Index>(c.row.size()) + (c.is_loaded ? 1 : 0));
    c.columns.reserve(static_cast<Index>(entries.size()) + (c.is_loaded ? load.size() : 0));
    std::size_t next = 0;
    for (Index column = 0; column < static_cast<Index>(c.row.size()); ++column) {
        c.columns.startVec(column);
        const std::size_t begin = next;
        while (next < entries.size() && entries[next].row == c.row[static_cast<std::size_t>(column)]) ++next;
        fill_column(part, std::span(entries).subspan(begin, next - begin), column, c.columns);
    }
    if (c.is_loaded) {
        const Index last = c.columns.cols() - 1;
        c.columns.startVec(last);
        for (Index i = 0; i < load.size(); ++i) c.columns.insertBack(i, last) = load[i];
    }
    c.columns.finalize();
    return c;
}

/// What one part adds to C, and the displacement of its rows under its load.
struct PartShare {
    std::vector<int> row;
    MatrixXd compliance;  // (rows x rows), and more where the part is loaded
    VectorXd opening;     // (rows of the assembly)
};

/// A part's entries, and its mean rotation as one row more where others turn with it.
std::vector<RowEntry> with_rotation(const Rows& rows, std::size_t part) {
    std::vector<RowEntry> entries = rows.by_part[part];
    const VectorXd& rotation = rows.turning[part].rotation;
    for (Index i = 0; i < rotation.size(); ++i)
        if (rotation[i] != 0) entries.push_back({rows.n, static_cast<int>(i), rotation[i]});
    return entries;
}

/// Takes the row of the mean rotation, the last, into those that turn with it.
void fold_rotation(const VectorXd& arm, PartShare& share) {
    MatrixXd& c = share.compliance;
    const auto n = static_cast<Index>(share.row.size()) - 1;
    VectorXd turned = VectorXd::Zero(n);
    for (Index k = 0; k < n; ++k)
        if (const Index row = share.row[static_cast<std::size_t>(k)]; row < arm.size()) turned[k] = arm[row];
    const Eigen::RowVectorXd of_rotation = c.row(n);
    c.topRows(n) += turned * of_rotation;
    c.topLeftCorner(n, n) += (of_rotation.head(n).transpose() + of_rotation[n] * turned) * turned.transpose();
    share.row.pop_back();
}

/// Adds what a part gives way by in motions on its springs.
void add_springs(const PartSystem& part, const Rows& rows, std::size_t i, const VectorXd& load, PartShare& share) {
    const auto n = static_cast<Index>(share.row.size());
    for (Index k = 0; k < part.sprung.cols(); ++k) {
        const VectorXd opened = opening_of(rows, i, part.sprung.col(k)), own = opened(share.row);
        share.compliance.topLeftCorner(n, n) += own * own.transpose();
        share.opening += part.sprung.col(k).dot(load) * opened;
    }
}

PartShare share_of(const PartSystem& part, const Rows& rows, std::size_t i) {
    if (rows.by_part[i].empty()) return {};
    if (part.body && part.sprung.cols() == 0) return {{}, {}, opening_of(rows, i, part.prescribed)};
    const VectorXd load = load_beside_prescribed(part, part.load);
    if (part.body) {
        PartShare share{rows_of(rows.by_part[i]), {}, opening_of(rows, i, part.prescribed)};
        share.compliance = MatrixXd::Zero(std::ssize(share.row), std::ssize(share.row));
        add_springs(part, rows, i, load, share);
        return share;
    }
    const bool turns = rows.turning[i].rotation.size() > 0;
    const bool is_loaded = !load.isZero(0), is_apart = part.factor.keeps_forms();  // forms are those of any load
    const VectorXd with_rows = is_loaded && !is_apart ? kept_entries(part, load) : VectorXd(0);
    PartColumns c = columns_of(part, turns ? with_rotation(rows, i) : rows.by_part[i], with_rows);
    PartShare share{std::move(c.row), part.factor.inverse_form(c.columns), opening_of(rows, i, part.prescribed)};
    if (turns) fold_rotation(rows.turning[i].arm, share);
    add_springs(part, rows, i, load, share);
    if (is_loaded && is_apart) share.opening = opening_of(rows, i, solve(part, part.load));
    if (c.is_loaded)
        for (std::size_t k = 0; k < share.row.size(); ++k)
            share.opening[share.row[k]] += share.compliance(static_cast<Index>(k), share.compliance.cols() - 1);
    return share;
}

void add_share(const PartShare& share, MatrixXd& compliance) {
    const auto n = static_cast<Index>(share.row.size());
    for (Index b = 0; b < n; ++b)
        for (Index a = 0; a < n; ++a)
            compliance(share.row[static_cast<std::size_t>(a)], share.row[static_cast<std::size_t>(b)]) +=
                share.compliance(a, b);
}

/// Where few rows share a part: the sum of the parts' blocks in order, column by column.
Eigen::SparseMatrix<double> sparse_sum(const std::vector<PartShare>& shares, int m) {
    std::vector<std::vector<std::array<std::size_t, 2>>> of_column(at(m));  // share, place in it
    Index entries = m;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const std::size_t n = shares[i].row.size();
        for (std::size_t k = 0; k < n; ++k) of_column[at(shares[i].row[k])].push_back({i, k});
        entries += static_cast<Index>(n * n);
    }
    Eigen::SparseMatrix<double> sum(m, m);
    sum.reserve(entries);
    VectorXd column = VectorXd::Zero(m);
    std::vector<int> rows;
    for (int j = 0; j < m; ++j) {
        rows.assign(1, j);  // the diagonal always
        for (const auto& [i, place] : of_column[at(j)]) {
            const PartShare& share = shares[i];
            for (std::size_t k = 0; k < share.row.size(); ++k)
                column[share.row[k]] += share.compliance(static_cast<Index>(k), static_cast<Index>(place));
            rows.insert(rows.end(), share.row.begin(), share.row.end());
        }
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        sum.startVec(j);
        for (int row : rows) sum.insertBack(row, j) = std::exchange(column[row], 0.0);
    }
    sum.finalize();
    return sum;
}

/// From so many rows on a sparse C is looked for, and taken where its blocks fill no more than this share of it: a dense
/// factor is made of larger products.
constexpr int least_sparse_rows = 800;
constexpr double sparse_fill = 0.25;

bool is_worth_sparse(const std::vector<PartShare>& shares, int m) {
    double entries = 0;
    for (const PartShare& share : shares) entries += static_cast<double>(share.row.size() * share.row.size());
    return m >= least_sparse_rows && entries <= sparse_fill * m * m;
}

Compliance sum_of(const std::vector<PartShare>& shares, int m, const VectorXd& softness) {
    if (is_worth_sparse(shares, m)) {
        Eigen::SparseMatrix<double> sum = sparse_sum(shares, m);
        for (Index k = 0; k < softness.size(); ++k) sum.coeffRef(k, k) += softness[k];
        return sum;
    }
    MatrixXd sum = MatrixXd::Zero(m, m);
    for (const PartShare& share : shares) add_share(share, sum);
    if (softness.size() > 0) sum.diagonal().head(softness.size()) += softness;
    return sum;
}

void add_modes(const PartSystem& part, const Rows& rows, std::size_t i, Index offset, ContactQp& qp) {
    const Index n_modes = part.modes.cols();
    if (n_modes == 0) return;
    qp.mode_load.segment(offset, n_modes) = part.modes.transpose() * part.load;
    // prescribed displacements load a part, too: what their entries add up from is the scale of their rounding
    qp.load_scale = std::max(qp.load_scale, (part.modes.cwiseAbs().transpose() * part.load.cwiseAbs()).maxCoeff());
    for (const RowEntry& e : rows.by_part[i])
        qp.modes.row(e.row).segment(offset, n_modes) += e.value * part.modes.row(e.coefficient);
    if (const Turning& t = rows.turning[i]; t.rotation.size() > 0)
        qp.modes.block(0, offset, t.arm.size(), n_modes) += t.arm * (t.rotation.transpose() * part.modes);
}

}  // namespace

std::vector<Index> mode_offsets(const std::vector<PartSystem>& parts) {
    std::vector<Index> offset{0};
    for (const PartSystem& p : parts) offset.push_back(offset.back() + p.modes.cols());
    return offset;
}

ContactQp rigid_problem(const std::vector<PartSystem>& parts, const Rows& rows, double load_scale) {
    const std::vector<Index> offset = mode_offsets(parts);
    const Index m = rows.n, n = offset.back();
    ENSURE(rows.by_part.size() == parts.size() && rows.turning.size() == parts.size() && rows.gap0.size() == m &&
               rows.weight.size() == m && static_cast<Index>(rows.unilateral.size()) == m && rows.softness.size() <= m,
           "rows are of these parts, with a gap, a weight and a kind each");
    ContactQp qp{{},        rows.gap0, MatrixXd::Zero(m, n), VectorXd::Zero(n), rows.unilateral, VectorXd::Zero(m),
                 rows.gap0, load_scale};
    for (std::size_t i = 0; i < parts.size(); ++i) add_modes(parts[i], rows, i, offset[i], qp);
    return qp;
}

ContactQp condense(const std::vector<PartSystem>& parts, const Rows& rows, double load_scale, int threads) {
    ContactQp qp = rigid_problem(parts, rows, load_scale);
    std::vector<PartShare> shares(parts.size());
    parallel_for(static_cast<int>(parts.size()), threads, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        shares[k] = share_of(parts[k], rows, k);
    });
    for (const PartShare& share : shares)
        if (share.opening.size() > 0) qp.gap += share.opening;
    qp.compliance = sum_of(shares, rows.n, rows.softness);
    return qp;
}

void scale_rows(ContactQp& qp, const VectorXd& weight) {
    const VectorXd s = weight.cwiseInverse();
    if (qp.compliance.rows() > 0) qp.compliance = qp.compliance.scaled(s);
    qp.gap = s.cwiseProduct(qp.gap);
    qp.drawn_gap = s.cwiseProduct(qp.drawn_gap);
    qp.modes = s.asDiagonal() * qp.modes;
}

}  // namespace abut::solver

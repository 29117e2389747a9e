// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/factorization.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <mutex>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "solver/linear_algebra/banded_factor.hpp"
#include "solver/linear_algebra/condition.hpp"
#include "solver/linear_algebra/frontal_factor.hpp"
#include "solver/linear_algebra/ordering.hpp"
#include "solver/linear_algebra/schur_complement.hpp"
#include "solver/linear_algebra/signed_factor.hpp"
#include "solver/linear_algebra/supernodal_factor.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::VectorXd;

/// The banded factor is chosen up to this bandwidth, in entries of the matrix in a row of its lower triangle: measured, see the
/// header's table.
constexpr double largest_relative_bandwidth = 8;

bool is_worthwhile(const SparseSymmetric& m, int bandwidth) {
    return bandwidth * static_cast<double>(m.n) <= largest_relative_bandwidth * static_cast<double>(m.row.size());
}

Band make_band(const SparseSymmetric& m, std::vector<int> order) {
    Band band{std::move(order), {}, 0};
    band.position = inverse_order(band.order);
    band.width = bandwidth(m, band.position);
    return band;
}

Band given_band(const SparseSymmetric& m) {
    std::vector<int> order(at(m.n));
    std::iota(order.begin(), order.end(), 0);
    return make_band(m, std::move(order));
}

/// The narrower of the given order and reverse Cuthill-McKee's.
Band narrow_band(const SparseSymmetric& m, const MergedPattern& pattern, const Neighbours& graph) {
    Band given = given_band(m), other = make_band(m, expanded(pattern, reverse_cuthill_mckee(graph)));
    return other.width < given.width ? std::move(other) : std::move(given);
}

/// The same band from its other end, where that brings the given rows later.
Band turned_late(Band band, const std::vector<int>& rows) {
    double sum = 0;
    for (int row : rows) sum += band.position[at(row)];
    if (2 * sum >= static_cast<double>(rows.size()) * (static_cast<double>(band.order.size()) - 1)) return band;
    std::reverse(band.order.begin(), band.order.end());
    band.position = inverse_order(band.order);
    return band;
}

/// norm_one: of the matrix before. Diagonal entries come first in their columns; from row n_positive on they are to be
/// negative. Result: row of the first of the wrong sign, or of an entry that is not a number.
int scale_to_unit_diagonal(SparseSymmetric& m, int n_positive, VectorXd& scale, double& norm_one) {
    scale.resize(m.n);
    VectorXd column_sums = VectorXd::Zero(m.n);
    for (int c = 0; c < m.n; ++c) {
        const double d = m.value[at(m.first[at(c)])] * (c < n_positive ? 1 : -1);
        if (!(d > 0)) return c;
        scale[c] = 1 / std::sqrt(d);
    }
    for (int c = 0; c < m.n; ++c)
        for (int k = m.first[at(c)]; k < m.first[at(c) + 1]; ++k) {
            double& value = m.value[at(k)];
            const int r = m.row[at(k)];
            if (!std::isfinite(value)) return r;
            column_sums[c] += std::abs(value);
            if (r != c) column_sums[r] += std::abs(value);
            value *= scale[c] * scale[r];
        }
    norm_one = m.n > 0 ? column_sums.maxCoeff() : 0;
    return -1;
}

/// Fronts of few nodes are joined to one that dense routines take at once: 8 to 32 hardly differ.
constexpr int nodes_of_front = 16;

struct FrontalStructure {
    std::shared_ptr<const Fronts> fronts;
    double entries() const { return fronts->first_value.back(); }
};

FrontalStructure frontal_structure(const SparseSymmetric& m, const MergedPattern& pattern, const RowHints& hints) {
    GridPlaces nodes{{}, hints.reach};
    nodes.at.reserve(at(pattern.n_nodes()));
    for (int k = 0; k < pattern.n_nodes(); ++k) nodes.at.push_back(hints.place[at(pattern.first_column[at(k)])]);
    return {std::make_shared<const Fronts>(make_fronts(m, pattern, dissected(nodes, nodes_of_front)))};
}

using Structure = std::variant<Band, SupernodalStructure, FrontalStructure>;

/// Strips of so few functions across, in reaches, have no separators worth the name. Banded, they are eliminated from one end
/// to the other, which also costs them fewer digits (a wedge of one degree, degree 4: 1e-5 of the displacement, dissected
/// 1e-3).
constexpr int strip_reaches = 3;

bool is_strip(const RowHints& hints) {
    if (hints.place.empty()) return false;
    std::array<int, 2> low = hints.place.front(), high = low;
    for (const GridPlace& p : hints.place)
        for (std::size_t axis : {0u, 1u}) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    return std::min(high[0] - low[0], high[1] - low[1]) < strip_reaches * hints.reach;
}

Structure structure_for(const SparseSymmetric& m, const RowHints& hints) {
    const std::optional<FactorMethod> method = hints.method;
    const MergedPattern pattern = merged_pattern(m);
    if (method == FactorMethod::frontal || (!method && !hints.place.empty() && !is_strip(hints)))
        return frontal_structure(m, pattern, hints);
    const Neighbours graph = neighbours(pattern);
    if (method == FactorMethod::banded || (!method && is_worthwhile(m, least_bandwidth(graph)))) {
        Band band = turned_late(narrow_band(m, pattern, graph), hints.late);
        if (method == FactorMethod::banded || is_worthwhile(m, band.width)) return band;
    }
    return SupernodalStructure(m, pattern);
}

}  // namespace

struct Factorization::Data {
    Structure structure;
    VectorXd scale;
    double norm_one = 0;  // of the matrix as it was given
    int failed_at = -1;
    std::variant<std::monostate, BandedFactor, SupernodalFactor, FrontalFactor, SignedFactor> factor;
    std::optional<SchurComplement> schur;  // with the signed factor only

    int n() const { return static_cast<int>(scale.size()); }
    int n_given() const { return schur ? schur->n() : n(); }  // a K is without the eliminated rows

    /// f of the factor: banded, or by supernodes.
    template <class F>
    auto with_factor(F f) const {
        if (const auto* banded = std::get_if<BandedFactor>(&factor)) return f(*banded);
        if (const auto* frontal = std::get_if<FrontalFactor>(&factor)) return f(frontal->supernodes());
        if (const auto* with_signs = std::get_if<SignedFactor>(&factor)) return f(with_signs->supernodes());
        return f(std::get<SupernodalFactor>(factor).supernodes());
    }
    VectorXd solved(const VectorXd& b) const {
        return with_factor([&](const auto& l) { return l.solve(b); });
    }
    VectorXd product(const VectorXd& x) const {
        return with_factor([&](const auto& l) { return l.product(x); });
    }
    /// The first row whose pivot is not positive, or lost in rounding.
    int failed_row() const {
        const auto ended = [](const auto& l) -> int {
            if constexpr (requires { l.failed_at(); })
                return l.failed_at();
            else
                return -1;
        };
        if (const int row = std::visit(ended, factor); row >= 0) return row;
        int row = -1;
        const double pivot = with_factor([&](const auto& l) { return l.smallest_pivot(row); });
        return pivot > std::numeric_limits<double>::epsilon() ? -1 : row;
    }
    LinearMap schur_product() const {
        const auto mass = std::make_shared<const Factorization>(schur->eliminated());
        return [this, mass](const VectorXd& x) { return schur->product(x, [&](const VectorXd& b) { return mass->solve(b); }); };
    }
};

Factorization::Factorization(SparseSymmetric matrix, const RowHints& hints, int threads) {
    const std::shared_ptr<Data> data(new Data{structure_for(matrix, hints), {}, 0, -1, {}, {}});
    data_ = data;
    Data& d = *data;
    d.failed_at = scale_to_unit_diagonal(matrix, matrix.n, d.scale, d.norm_one);
    if (d.failed_at >= 0 || matrix.n == 0) return;
    if (const Band* band = std::get_if<Band>(&d.structure))
        d.factor.emplace<BandedFactor>(matrix, *band);
    else if (const auto* frontal = std::get_if<FrontalStructure>(&d.structure))
        d.factor.emplace<FrontalFactor>(matrix, frontal->fronts, threads);
    else
        d.factor.emplace<SupernodalFactor>(matrix, std::get<SupernodalStructure>(d.structure));
    d.failed_at = d.failed_row();
}

Factorization::Factorization(SparseSymmetric matrix, int n_eliminated) {
    const std::shared_ptr<Data> data(new Data{SupernodalStructure(matrix, merged_pattern(matrix)), {}, 0, -1, {}, {}});
    data_ = data;
    Data& d = *data;
    const int n_positive = matrix.n - n_eliminated;
    d.schur.emplace(matrix, n_eliminated);
    d.failed_at = scale_to_unit_diagonal(matrix, n_positive, d.scale, d.norm_one);
    if (d.failed_at >= 0 || matrix.n == 0) return;
    std::vector<double> sign(at(matrix.n), 1.0);
    std::fill(sign.begin() + n_positive, sign.end(), -1.0);
    d.factor.emplace<SignedFactor>(matrix, std::get<SupernodalStructure>(d.structure), sign);
    d.failed_at = d.failed_row();
}

bool Factorization::ok() const {
    return data_ && data_->failed_at < 0;
}
int Factorization::failed_at() const {
    return data_ ? data_->failed_at : -1;
}
FactorMethod Factorization::method() const {
    constexpr std::array methods = {FactorMethod::banded, FactorMethod::supernodal, FactorMethod::frontal};
    return methods[data_->structure.index()];
}
int Factorization::bandwidth() const {
    const Band* band = std::get_if<Band>(&data_->structure);
    return band != nullptr ? band->width : 0;
}
double Factorization::entries() const {
    return std::visit([](const auto& s) { return s.entries(); }, data_->structure);
}
double Factorization::bytes() const {
    return entries() * sizeof(double);
}

double Factorization::condition_estimate() const {
    const Data& d = *data_;
    if (!d.schur)
        return condition_by_lanczos(
            d.n(), [&](const VectorXd& x) { return d.product(x); }, [&](const VectorXd& b) { return d.solved(b); });
    const VectorXd& s = d.schur->scale();
    const LinearMap k = d.schur_product();
    return condition_by_lanczos(
        d.schur->n(), [&](const VectorXd& x) -> VectorXd { return s.cwiseProduct(k(s.cwiseProduct(x))); },
        [&](const VectorXd& b) -> VectorXd { return solve(b.cwiseQuotient(s)).cwiseQuotient(s); });
}

double Factorization::condition_estimate(const LinearMap& matrix) const {
    const Data& d = *data_;
    if (d.schur) return condition_estimate();
    return condition_by_lanczos(
        d.n(), [&](const VectorXd& x) -> VectorXd { return d.scale.cwiseProduct(matrix(d.scale.cwiseProduct(x))); },
        [&](const VectorXd& b) { return d.solved(b); });
}

double Factorization::unscaled_condition_one() const {
    const Data& d = *data_;
    if (d.n() == 0) return 1;
    const int n = d.n_given();
    const double norm = d.schur ? solver::norm_one(n, d.schur_product()) : d.norm_one;
    return norm * solver::norm_one(n, [&](const VectorXd& b) { return solve(b); });
}

VectorXd Factorization::solve(const VectorXd& b) const {
    if (b.size() == 0) return b;
    ENSURE(b.size() == data_->n_given(), "a right-hand side has the rows of its matrix");
    const auto own = data_->scale.head(b.size());
    VectorXd padded = VectorXd::Zero(data_->n());
    padded.head(b.size()) = own.cwiseProduct(b);
    return own.cwiseProduct(data_->solved(padded).head(b.size()));
}

Eigen::MatrixXd Factorization::solve_lower(const Eigen::MatrixXd& b) const {
    if (b.size() == 0) return b;
    ENSURE(!data_->schur, "the factor of a Schur complement has signs: inverse_form() knows them");
    ENSURE(b.rows() == data_->n(), "a right-hand side has the rows of its matrix");
    const Eigen::MatrixXd scaled = data_->scale.asDiagonal() * b;
    return data_->with_factor([&](const auto& l) { return l.solve_lower(scaled); });
}

namespace {

bool is_same(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
    if (a.cols() != b.cols() || a.nonZeros() != b.nonZeros()) return false;
    const Eigen::Index n = a.nonZeros();
    return std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + n, b.innerIndexPtr()) &&
           std::equal(a.valuePtr(), a.valuePtr() + n, b.valuePtr());
}

}  // namespace

struct Factorization::KeptForms {
    static constexpr std::size_t most = 16;
    struct Form {
        Eigen::SparseMatrix<double> b;
        Eigen::MatrixXd form;
    };
    std::mutex busy;
    std::list<Form> last;  // first, what was asked for last

    std::optional<Eigen::MatrixXd> find(const Eigen::SparseMatrix<double>& b) {
        const std::scoped_lock lock(busy);
        const auto found = std::find_if(last.begin(), last.end(), [&](const Form& f) { return is_same(f.b, b); });
        if (found == last.end()) return std::nullopt;
        last.splice(last.begin(), last, found);
        return found->form;
    }

    void keep(const Eigen::SparseMatrix<double>& b, const Eigen::MatrixXd& form) {
        const std::scoped_lock lock(busy);
        last.push_front({b, form});
        if (last.size() > most) last.pop_back();
    }
};

void Factorization::keep_forms() {
    kept_ = std::make_shared<KeptForms>();
}

Eigen::MatrixXd Factorization::inverse_form(const Eigen::SparseMatrix<double>& b) const {
    if (!kept_) return new_inverse_form(b);
    if (std::optional<Eigen::MatrixXd> known = kept_->find(b)) return std::move(*known);
    Eigen::MatrixXd form = new_inverse_form(b);
    kept_->keep(b, form);
    return form;
}

Eigen::MatrixXd Factorization::new_inverse_form(const Eigen::SparseMatrix<double>& b) const {
    if (b.size() == 0) return Eigen::MatrixXd::Zero(b.cols(), b.cols());
    ENSURE(b.rows() == data_->n_given(), "a form has the rows of its matrix");
    const Eigen::SparseMatrix<double> scaled = data_->scale.head(b.rows()).asDiagonal() * b;
    return data_->with_factor([&](const auto& l) { return l.inverse_form(scaled); });
}

}  // namespace abut::solver

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/interface.hpp"

#include <algorithm>
#include <numeric>

#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The entries in the order of their rows, those of one row in the order in which they are given.
std::vector<RowEntry> sorted_by_row(const std::vector<RowEntry>& entries, int n_rows) {
    std::vector<std::size_t> next(static_cast<std::size_t>(n_rows) + 1, 0);
    for (const RowEntry& e : entries) ++next[static_cast<std::size_t>(e.row) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<RowEntry> sorted(entries.size());
    for (const RowEntry& e : entries) sorted[next[static_cast<std::size_t>(e.row)]++] = e;
    return sorted;
}

/// Entries by row, then coefficient; those of one row and coefficient that came from several points are summed.
void compress(std::vector<RowEntry>& entries, int n_rows, int n_coefficients) {
    const std::vector<RowEntry> by_row = sorted_by_row(entries, n_rows);
    std::vector<double> sum(static_cast<std::size_t>(n_coefficients));
    std::vector<int> last_row(sum.size(), -1), touched;
    entries.clear();
    for (std::size_t begin = 0, end = 0; begin < by_row.size(); begin = end) {
        const int row = by_row[begin].row;
        touched.clear();
        for (end = begin; end < by_row.size() && by_row[end].row == row; ++end) {
            const auto c = static_cast<std::size_t>(by_row[end].coefficient);
            if (last_row[c] != row) {
                last_row[c] = row;
                sum[c] = 0;
                touched.push_back(by_row[end].coefficient);
            }
            sum[c] += by_row[end].value;
        }
        std::sort(touched.begin(), touched.end());
        for (int c : touched) entries.push_back({row, c, sum[static_cast<std::size_t>(c)]});
    }
}

/// Rows that a point belongs to, and its part in their integrals.
struct PointRows {
    std::array<int, max_degree + 1> row;
    LocalValues share;
    std::size_t n;
};

PointRows mortar_rows(const Interface& face, std::size_t point, int first_row) {
    const InterfacePoint& p = face.points[point];
    const int interval = interval_of(face.pressure, p.s), first = face.pressure.first[static_cast<std::size_t>(interval)];
    PointRows rows;
    evaluate(face.pressure, interval, p.s, rows.share);
    rows.n = static_cast<std::size_t>(face.pressure.degree) + 1;
    for (std::size_t k = 0; k < rows.n; ++k) {
        rows.row[k] = first_row + (first + static_cast<int>(k)) % n_rows(face);
        rows.share[k] *= p.weight * face.thickness;
    }
    return rows;
}

PointRows penalty_row(const Interface& face, std::size_t point, int first_row) {
    PointRows rows;
    rows.row[0] = first_row + static_cast<int>(point);
    rows.share[0] = face.points[point].weight * face.thickness;
    rows.n = 1;
    return rows;
}

/// Gaps and weights of a point's rows.
void add_gap(Rows& rows, double gap, const PointRows& of) {
    for (std::size_t k = 0; k < of.n; ++k) {
        rows.gap0[of.row[k]] += of.share[k] * gap;
        rows.weight[of.row[k]] += of.share[k];
    }
}

Vec2 opening_direction(const InterfacePoint& p, std::size_t side) {
    return (side == 0 ? -1 : 1) * p.normal[side];
}

/// One side's entries of a point, on a body with a solution structure.
void add_structured(std::vector<RowEntry>& entries, const PartInput& input, const InterfacePoint& p, std::size_t side,
                    const PointRows& of) {
    const DisplacementBasis b = displacement_basis(input, p.element[side], p.x[side]);
    const Vec2 along = opening_direction(p, side);
    for (std::size_t k = 0; k < of.n; ++k)
        for (std::size_t i = 0; i < b.x.functions.size(); ++i)
            for (int c = 0; c < 2; ++c)
                entries.push_back(
                    {of.row[k], 2 * b.x.functions[i] + c, of.share[k] * b.of(c).value[static_cast<Index>(i)] * along[c]});
}

/// What a solution structure's boundary values open.
double structured_gap(const PartInput& input, const InterfacePoint& p, std::size_t side) {
    return opening_direction(p, side).dot(displacement_basis(input, p.element[side], p.x[side]).data.value);
}

/// Entries of one side's points that follow each other in the same element and rows: summed for the element's B-splines, then
/// given to the functions at once.
class RunOfPoints {
public:
    RunOfPoints(const SplineSpace& space, std::vector<RowEntry>& entries) : space_(space), entries_(entries) {}
    RunOfPoints(const RunOfPoints&) = delete;
    RunOfPoints& operator=(const RunOfPoints&) = delete;
    ~RunOfPoints() { close(); }

    void add(int element, const Vec2& x, const Vec2& along, const PointRows& of) {
        if (element != element_ || !is_same(of)) open(element, of);
        LocalValues vx, vy;
        evaluate(space_.along_x(element), x.x(), vx);
        evaluate(space_.along_y(element), x.y(), vy);
        Index k = 0;
        for (Index b = 0; b <= space_.y.degree; ++b)
            for (Index a = 0; a <= space_.x.degree; ++a, ++k) {
                const double value = vx[static_cast<std::size_t>(a)] * vy[static_cast<std::size_t>(b)];
                for (std::size_t r = 0; r < of.n; ++r)
                    for (Index c = 0; c < 2; ++c) sums_(2 * static_cast<Index>(r) + c, k) += of.share[r] * value * along[c];
            }
    }

private:
    bool is_same(const PointRows& of) const {
        return of.n == rows_.n && std::equal(of.row.begin(), of.row.begin() + of.n, rows_.row.begin());
    }

    void open(int element, const PointRows& of) {
        close();
        if (element != element_) extraction_ = extraction(space_, element);
        element_ = element;
        rows_ = of;
        sums_.setZero(2 * static_cast<Index>(of.n), Index{space_.x.degree + 1} * (space_.y.degree + 1));
    }

    void close() {
        if (element_ < 0) return;
        if (!extraction_.identity) sums_ = (sums_ * extraction_.matrix).eval();
        for (std::size_t r = 0; r < rows_.n; ++r)
            for (Index i = 0; i < sums_.cols(); ++i)
                for (int c = 0; c < 2; ++c)
                    entries_.push_back({rows_.row[r], 2 * extraction_.functions[static_cast<std::size_t>(i)] + c,
                                        sums_(2 * static_cast<Index>(r) + c, i)});
    }

    const SplineSpace& space_;
    std::vector<RowEntry>& entries_;
    int element_ = -1;
    PointRows rows_{};
    Extraction extraction_;
    Eigen::MatrixXd sums_;  // (row and component x B-spline of the element)
};

std::vector<PointRows> rows_of_points(const Interface& face, int first_row) {
    const auto rows_of = face.penalty.empty() ? mortar_rows : penalty_row;
    std::vector<PointRows> of;
    for (std::size_t q = 0; q < face.points.size(); ++q) of.push_back(rows_of(face, q, first_row));
    return of;
}

void add_side(std::vector<RowEntry>& entries, const PartInput& input, const Interface& face, std::size_t side,
              const std::vector<PointRows>& of) {
    RunOfPoints run(input.space, entries);
    for (std::size_t q = 0; q < face.points.size(); ++q) {
        const InterfacePoint& p = face.points[q];
        if (input.structure)
            add_structured(entries, input, p, side, of[q]);
        else
            run.add(p.element[side], p.x[side], opening_direction(p, side), of[q]);
    }
}

/// The gaps as drawn, with what boundary values open.
void add_gaps(Rows& rows, const std::vector<PartSystem>& parts, const Interface& face, const std::vector<PointRows>& of) {
    for (std::size_t q = 0; q < face.points.size(); ++q) {
        add_gap(rows, face.friction ? 0 : face.points[q].gap, of[q]);
        for (const std::size_t side : {0U, 1U}) {
            const PartInput& input = parts[static_cast<std::size_t>(face.part[side])].input;
            if (!input.structure) continue;
            const double gap = structured_gap(input, face.points[q], side);
            for (std::size_t k = 0; k < of[q].n; ++k) rows.gap0[of[q].row[k]] += of[q].share[k] * gap;
        }
    }
}

/// The mean rotation of a part by its coefficients (2n), in its own frame: half the mean curl. A rigid one has no cells, but
/// moves as a whole: of its coefficients what is no translation.
VectorXd make_mean_rotation(const PartSystem& part) {
    const std::vector<RigidMotion> rigid{{{1, 0}, 0}, {{0, 1}, 0}, {{0, 0}, 1}};
    const Eigen::MatrixXd motions = coefficients_of(part.input.space, rigid);
    VectorXd rotation = motions.col(2);
    if (part.body) {
        for (Index k = 0; k < 2; ++k) rotation -= motions.col(k) * motions.col(k).dot(rotation) / motions.col(k).squaredNorm();
    } else {
        const FunctionIntegrals integrals = integrate_functions(part.input);
        for (Index f = 0; f < integrals.dx.size(); ++f) rotation.segment<2>(2 * f) = Vec2(-integrals.dy[f], integrals.dx[f]);
    }
    return rotation / rotation.dot(motions.col(2));
}

/// Of friction, the interface's points have the gap as drawn. Around an axis no section turns as a whole.
void add_turnings(const std::vector<PartSystem>& parts, const Interface& face, int first_row, Rows& rows) {
    for (int part : face.part) {
        Turning& turning = rows.turning[static_cast<std::size_t>(part)];
        if (parts[static_cast<std::size_t>(part)].input.axis) return;
        if (turning.rotation.size() > 0) continue;
        const PartSystem& system = parts[static_cast<std::size_t>(part)];
        turning = {system.mean_rotation([&] { return make_mean_rotation(system); }), VectorXd::Zero(rows.n)};
    }
    for (std::size_t q = 0; q < face.points.size(); ++q) {
        const PointRows of = mortar_rows(face, q, first_row);
        for (std::size_t k = 0; k < of.n; ++k)
            for (int part : face.part)
                rows.turning[static_cast<std::size_t>(part)].arm[of.row[k]] -= 0.5 * of.share[k] * face.points[q].gap;
    }
}

void add_softness(Rows& rows, const std::vector<Interface>& interfaces, const std::vector<int>& first_row) {
    const auto is_penalty = [](const Interface& face) { return !face.penalty.empty(); };
    if (std::none_of(interfaces.begin(), interfaces.end(), is_penalty)) return;
    rows.softness = Eigen::VectorXd::Zero(rows.n);
    for (std::size_t f = 0; f < interfaces.size(); ++f)
        for (std::size_t q = 0; q < interfaces[f].penalty.size(); ++q) {
            const Index row = first_row[f] + static_cast<Index>(q);
            rows.softness[row] = rows.weight[row] / interfaces[f].penalty[q];
        }
}

/// Values at the points of a polyline with its two ends: the neighbouring piece continued, without tension.
Eigen::VectorXd continued(const Interface& face, const Eigen::VectorXd& at_points) {
    const std::vector<double>& s = face.pressure.breakpoints;
    const Index n = at_points.size();
    Eigen::VectorXd all(n + 2);
    all.segment(1, n) = at_points;
    const auto line = [&](Index a, Index b, double s_a, double s_b, double to) {
        return std::max(0.0, at_points[a] + (to - s_a) / (s_b - s_a) * (at_points[b] - at_points[a]));
    };
    const auto last = static_cast<std::size_t>(n);
    const double first_s = s[1], last_s = s[last];
    if (n == 1) {
        all[0] = all[2] = at_points[0];
    } else if (face.periodic) {
        all[0] = all[n + 1] = line(n - 1, 0, last_s - (s[last + 1] - s[0]), first_s, s[0]);
    } else {
        all[0] = line(0, 1, first_s, s[2], s[0]);
        all[n + 1] = line(n - 1, n - 2, last_s, s[last - 1], s[last + 1]);
    }
    return all;
}

}  // namespace

Rows interface_rows(const std::vector<PartSystem>& parts, const std::vector<Interface>& interfaces, std::vector<int>& first_row,
                    int threads) {
    Rows rows;
    first_row.clear();
    for (const Interface& face : interfaces) {
        for (int part : face.part)
            ENSURE(part >= 0 && static_cast<std::size_t>(part) < parts.size(),
                   "an interface lies between parts of the assembly");
        ENSURE(face.penalty.empty() || face.penalty.size() == face.points.size(), "every point of a penalty interface has one");
        first_row.push_back(rows.n);
        rows.n += n_rows(face);
    }
    rows.by_part.resize(parts.size());
    rows.turning.resize(parts.size());
    rows.gap0 = Eigen::VectorXd::Zero(rows.n);
    rows.weight = Eigen::VectorXd::Zero(rows.n);
    rows.unilateral.assign(static_cast<std::size_t>(rows.n), 1);
    std::vector<std::vector<PointRows>> of_points(interfaces.size());
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> sides_of(parts.size());  // interface and side
    for (std::size_t k = 0; k < interfaces.size(); ++k) {
        of_points[k] = rows_of_points(interfaces[k], first_row[k]);
        add_gaps(rows, parts, interfaces[k], of_points[k]);
        for (const std::size_t side : {0U, 1U})
            sides_of[static_cast<std::size_t>(interfaces[k].part[side])].push_back({k, side});
        if (interfaces[k].friction) add_turnings(parts, interfaces[k], first_row[k], rows);
        if (interfaces[k].bilateral) std::fill_n(rows.unilateral.begin() + first_row[k], n_rows(interfaces[k]), 0);
    }
    add_softness(rows, interfaces, first_row);
    parallel_for(static_cast<int>(parts.size()), threads, [&](int part) {
        const auto i = static_cast<std::size_t>(part);
        for (const auto& [k, side] : sides_of[i]) add_side(rows.by_part[i], parts[i].input, interfaces[k], side, of_points[k]);
        if (!rows.by_part[i].empty()) compress(rows.by_part[i], rows.n, 2 * parts[i].n());
    });
    return rows;
}

KnotVector polyline_knots(const std::vector<InterfacePoint>& points, double begin, double end) {
    std::vector<double> places{begin};
    for (const InterfacePoint& p : points) places.push_back(p.s);
    places.push_back(end);
    return clamped_knots(std::move(places), 1);
}

Eigen::VectorXd all_coefficients(const Interface& face, const Eigen::VectorXd& unknown) {
    ENSURE(unknown.size() == n_rows(face), "an interface has one multiplier a row");
    if (!face.penalty.empty()) return continued(face, unknown);
    Eigen::VectorXd all(face.pressure.n_functions());
    for (Index k = 0; k < all.size(); ++k) all[k] = unknown[k % unknown.size()];
    return all;
}

void begin_touching(const std::vector<PartSystem>& parts, const std::vector<Interface>& interfaces,
                    const std::vector<int>& first_row, Rows& rows) {
    constexpr int resolving = 6;
    const auto is_free = [&](int part) { return parts[static_cast<std::size_t>(part)].modes.cols() > 0; };
    for (std::size_t i = 0; i < interfaces.size(); ++i) {
        const Interface& face = interfaces[i];
        if (face.bilateral || !face.penalty.empty() || (!is_free(face.part[0]) && !is_free(face.part[1]))) continue;
        if (std::count_if(face.expected.begin(), face.expected.end(), [](double l) { return l > 0; }) >= resolving) continue;
        const auto least = std::min_element(face.points.begin(), face.points.end(),
                                            [](const auto& a, const auto& b) { return a.gap < b.gap; });
        auto gap = rows.gap0.segment(first_row[i], n_rows(face));
        const auto weight = rows.weight.segment(first_row[i], n_rows(face));
        const double sunk = gap.cwiseQuotient(weight).minCoeff() - std::max(0.0, least->gap);
        if (sunk > 0) gap -= sunk * weight;
    }
}

int append_mean_constraint(Rows& rows, const PartSystem& system, int part, const FunctionIntegrals& integrals, double area,
                           const Eigen::Vector3d& coefficient, double size, double value) {
    ENSURE(integrals.value.size() == system.n() && area > 0, "means are over this part's functions and its area");
    const int row = rows.n++;
    for (int f = 0; f < system.n(); ++f) {
        const double mean = integrals.value[f] / area, turn = 0.5 * size / area;
        const double x = coefficient[0] * mean - coefficient[2] * turn * integrals.dy[f];
        const double y = coefficient[1] * mean + coefficient[2] * turn * integrals.dx[f];
        if (x != 0) rows.by_part[static_cast<std::size_t>(part)].push_back({row, 2 * f, x});
        if (y != 0) rows.by_part[static_cast<std::size_t>(part)].push_back({row, 2 * f + 1, y});
    }
    rows.gap0.conservativeResize(rows.n);
    rows.weight.conservativeResize(rows.n);
    rows.gap0[row] = -value;
    rows.weight[row] = 1;
    rows.unilateral.push_back(0);
    return row;
}

Eigen::VectorXd rows_times(const std::vector<RowEntry>& entries, const Eigen::VectorXd& u, int n_rows) {
    Eigen::VectorXd v = Eigen::VectorXd::Zero(n_rows);
    for (const RowEntry& e : entries) v[e.row] += e.value * u[e.coefficient];
    return v;
}

Eigen::VectorXd transposed_times(const std::vector<RowEntry>& entries, const Eigen::VectorXd& multipliers, int n_coefficients) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(n_coefficients);
    for (const RowEntry& e : entries) f[e.coefficient] += e.value * multipliers[e.row];
    return f;
}

VectorXd opening_of(const Rows& rows, std::size_t part, const VectorXd& displacement) {
    VectorXd opening = rows_times(rows.by_part[part], displacement, rows.n);
    if (const Turning& t = rows.turning[part]; t.rotation.size() > 0)
        opening.head(t.arm.size()) += t.rotation.dot(displacement) * t.arm;
    return opening;
}

VectorXd load_of(const Rows& rows, std::size_t part, const VectorXd& multipliers, int n_coefficients) {
    VectorXd load = transposed_times(rows.by_part[part], multipliers, n_coefficients);
    if (const Turning& t = rows.turning[part]; t.rotation.size() > 0)
        load += t.arm.dot(multipliers.head(t.arm.size())) * t.rotation;
    return load;
}

double pressure_at(const KnotVector& pressure, const Eigen::VectorXd& coefficients, double s) {
    const int interval = interval_of(pressure, s), first = pressure.first[static_cast<std::size_t>(interval)];
    LocalValues n;
    evaluate(pressure, interval, s, n);
    double sum = 0;
    for (int k = 0; k <= pressure.degree; ++k) sum += n[static_cast<std::size_t>(k)] * coefficients[first + k];
    return sum;
}

}  // namespace abut::solver

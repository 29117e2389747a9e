// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/fold.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <utility>

#include "solver/linear_algebra/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Calls f(row, column, value) for every entry of T'A T with row >= column, places that several entries share several times.
template <class F>
void for_folded(const BlockMatrix& a, const std::vector<int>& number, const std::vector<double>& share, F f) {
    const auto entry = [&](int i, int j, double value) {  // of both triangles where i and j differ
        const int n = number[at(i)], m = number[at(j)];
        if (n < 0 || m < 0) return;
        const double twice = i != j && n == m ? 2 : 1;
        f(std::max(n, m), std::min(n, m), twice * share[at(i)] * share[at(j)] * value);
    };
    for (int r = 0; r < a.n; ++r)
        for (int k = a.first[at(r)]; k < a.first[at(r) + 1]; ++k) {
            const int c = a.column[at(k)];
            const Eigen::Matrix2d& b = a.block[at(k)];
            entry(2 * r, 2 * c, b(0, 0));
            entry(2 * r + 1, 2 * c, b(1, 0));
            entry(2 * r + 1, 2 * c + 1, b(1, 1));
            if (c < r) entry(2 * r, 2 * c + 1, b(0, 1));
        }
}

using Column = std::span<std::pair<int, double>>;  // row, value

/// Rows ascending, those of one place added up in the order in which they came.
void append_column(Column column, SparseSymmetric& s) {
    std::stable_sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t begin = s.row.size();
    for (const auto& [row, value] : column) {
        if (s.row.size() == begin || s.row.back() != row) {
            s.row.push_back(row);
            s.value.push_back(0);
        }
        s.value.back() += value;
    }
    s.first.push_back(static_cast<int>(s.row.size()));
}

bool differ(const VectorXd& a, const VectorXd& b) {
    const double largest = std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
    return (a - b).lpNorm<Eigen::Infinity>() > asymmetry * largest;
}

}  // namespace

PartMirror part_mirror(MirrorRole role, int image, const PlaceImage& place, const std::vector<int>& function) {
    PartMirror mirror{role, image, place, {}, {}};
    for (int f : function)
        for (int c : {0, 1}) {
            mirror.coefficient.push_back(2 * f + c);
            mirror.sign.push_back(c == place.axis ? -1 : 1);
        }
    return mirror;
}

VectorXd mirrored(const PartMirror& mirror, const VectorXd& displacement) {
    VectorXd result(displacement.size());
    for (std::size_t i = 0; i < mirror.coefficient.size(); ++i)
        result[mirror.coefficient[i]] = mirror.sign[i] * displacement[static_cast<Index>(i)];
    return result;
}

bool is_follower(const PartInput& input) {
    return input.mirror && input.mirror->role == MirrorRole::follower;
}

bool is_folded(const PartInput& input) {
    return input.mirror && input.mirror->role == MirrorRole::own_image;
}

void keep_symmetric_motions(PartSystem& s) {
    if (!s.input.mirror) return;
    s.all_free_motions = s.free_motions;
    if (is_follower(s.input)) s.free_motions.clear();
    if (!is_folded(s.input) || s.free_motions.empty()) return;
    // what is free is as symmetric as the supports: the motion along the line is free, or wholly held
    const Vec2 along = s.input.mirror->place.axis == 0 ? Vec2(0, 1) : Vec2(1, 0);
    const RigidMotion motion{along, 0, s.free_motions[0].center};
    double free = 0;
    for (const RigidMotion& m : s.free_motions) free += std::pow(m.translation.dot(along), 2);
    s.free_motions.clear();
    if (free > 0.5) s.free_motions.push_back(motion);
}

void fold_unknowns(PartSystem& s, const std::vector<Index>& pinned) {
    const PartMirror& mirror = *s.input.mirror;
    s.number.assign(s.dropped.size(), -1);
    s.share.assign(s.dropped.size(), 1);
    s.n_kept = 0;
    for (std::size_t i = 0; i < s.dropped.size(); ++i) {
        const std::size_t image = at(mirror.coefficient[i]);
        const auto is_pin = [&](std::size_t dof) {
            return std::find(pinned.begin(), pinned.end(), static_cast<Index>(dof)) != pinned.end();
        };
        if (s.dropped[i] || is_pin(i) || is_pin(image) || image < i) continue;
        if (image == i && mirror.sign[i] < 0) continue;
        s.number[i] = s.number[image] = s.n_kept++;
        if (image == i) continue;
        s.share[i] = std::sqrt(0.5);
        s.share[image] = mirror.sign[i] * s.share[i];
    }
}

SparseSymmetric folded(const BlockMatrix& a, const std::vector<int>& number, const std::vector<double>& share, int n_kept) {
    std::vector<std::size_t> first(at(n_kept) + 1, 0);
    for_folded(a, number, share, [&](int, int column, double) { ++first[at(column) + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::pair<int, double>> entries(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for_folded(a, number, share, [&](int row, int column, double value) { entries[next[at(column)]++] = {row, value}; });
    SparseSymmetric s{n_kept, {0}, {}, {}};
    for (std::size_t c = 0; c + 1 < first.size(); ++c)
        append_column(Column(entries).subspan(first[c], first[c + 1] - first[c]), s);
    return s;
}

VectorXd folded_load(const PartSystem& s, const VectorXd& load) {
    VectorXd b = VectorXd::Zero(s.n_kept);
    for (std::size_t i = 0; i < s.number.size(); ++i)
        if (s.number[i] >= 0) b[s.number[i]] += s.share[i] * load[static_cast<Index>(i)];
    return b;
}

void add_unfolded(const PartSystem& s, const VectorXd& y, VectorXd& u) {
    for (std::size_t i = 0; i < s.number.size(); ++i)
        if (s.number[i] >= 0) u[static_cast<Index>(i)] += s.share[i] * y[s.number[i]];
}

VectorXd test_field(Index n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    return VectorXd::NullaryExpr(n, [&] { return any(random); });
}

std::string asymmetry_of(const PartSystem& part, const PartSystem& image) {
    const PartMirror& mirror = *part.input.mirror;
    for (std::size_t i = 0; i < part.dropped.size(); ++i)
        if (part.dropped[i] != image.dropped[at(mirror.coefficient[i])]) return "its supports are imposed differently there";
    if (differ(mirrored(mirror, part.prescribed), image.prescribed)) return "other displacements are prescribed there";
    const VectorXd u = test_field(2 * part.n(), 0);
    if (differ(mirrored(mirror, stiffness_times(part, u)), stiffness_times(image, mirrored(mirror, u))))
        return "it is not equally stiff there";
    if (differ(mirrored(mirror, part.load), image.load)) return "it is not loaded alike there";
    return "";
}

}  // namespace abut::solver

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/mirrored_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "solver/linear_algebra/index.hpp"
#include "solver/parts/fold.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Fields = std::vector<VectorXd>;  // by part

/// set: 0 or 1.
Fields test_fields(const AssemblyProblem& problem, std::uint64_t set) {
    Fields fields;
    for (const PartSystem& part : problem.parts) fields.push_back(test_field(2 * part.n(), 2 * fields.size() + set));
    return fields;
}

Fields mirrored(const AssemblyProblem& problem, const Fields& fields) {
    Fields images(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const PartMirror& mirror = *problem.parts[i].input.mirror;
        images[at(mirror.image)] = mirrored(mirror, fields[i]);
    }
    return images;
}

VectorXd openings(const Rows& rows, const Fields& fields) {
    VectorXd sum = VectorXd::Zero(rows.n);
    for (std::size_t i = 0; i < fields.size(); ++i) sum += rows_times(rows.by_part[i], fields[i], rows.n);
    return sum;
}

/// Sum of the entries' sizes, by row.
VectorXd sizes_of(const Rows& rows) {
    VectorXd sum = VectorXd::Zero(rows.n);
    for (const std::vector<RowEntry>& entries : rows.by_part)
        for (const RowEntry& e : entries) sum[e.row] += std::abs(e.value);
    return sum;
}

/// Lengths that are rounding.
double rounding_of(const AssemblyProblem& problem) {
    double size = 0;
    for (const Interface& face : problem.interfaces)
        for (const InterfacePoint& p : face.points) size = std::max({size, p.x[0].norm(), p.x[1].norm()});
    return mirrored_place * size;
}

/// Rows under two fields and their images.
class RowMatch {
public:
    RowMatch(const AssemblyProblem& problem, const Rows& rows)
        : rows_(rows), size_(sizes_of(rows)), near_(rounding_of(problem)) {
        for (std::uint64_t set : {0U, 1U}) {
            const Fields fields = test_fields(problem, set);
            own_.push_back(openings(rows, fields));
            images_.push_back(openings(rows, mirrored(problem, fields)));
        }
        order_.resize(at(rows.n));
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(), [&](int a, int b) { return std::abs(own_[0][a]) < std::abs(own_[0][b]); });
    }

    /// -1: there is none.
    RowImage image_of(int row) const {
        const double value = std::abs(images_[0][row]), margin = asymmetry * size_[row];
        auto candidate = std::lower_bound(order_.begin(), order_.end(), value - margin,
                                          [&](int r, double v) { return std::abs(own_[0][r]) < v; });
        for (; candidate != order_.end() && std::abs(own_[0][*candidate]) <= value + margin; ++candidate) {
            const double sign = images_[0][row] * own_[0][*candidate] < 0 ? -1 : 1;
            if (is_image(row, *candidate, sign)) return {*candidate, sign};
        }
        return {-1, 1};
    }

private:
    bool is_image(int row, int other, double sign) const {
        const bool one_sided = rows_.unilateral[at(row)] != 0;
        if (one_sided != (rows_.unilateral[at(other)] != 0) || (one_sided && sign < 0)) return false;
        const double weight = rows_.weight[row];
        return std::abs(images_[1][row] - sign * own_[1][other]) <= asymmetry * size_[row] &&
               std::abs(weight - rows_.weight[other]) <= asymmetry * weight &&
               std::abs(softness(row) - softness(other)) <= asymmetry * softness(row) &&
               std::abs(rows_.gap0[row] - sign * rows_.gap0[other]) <= weight * near_ + asymmetry * std::abs(rows_.gap0[row]);
    }

    double softness(int row) const { return row < rows_.softness.size() ? rows_.softness[row] : 0; }

    const Rows& rows_;
    VectorXd size_;
    double near_;
    std::vector<VectorXd> own_, images_;  // by field
    std::vector<int> order_;              // by |own_[0]|
};

std::array<int, 2> parts_of(const Rows& rows, int row) {
    std::array<int, 2> parts{-1, -1};
    for (std::size_t i = 0; i < rows.by_part.size(); ++i) {
        const auto& entries = rows.by_part[i];
        if (std::none_of(entries.begin(), entries.end(), [&](const RowEntry& e) { return e.row == row; })) continue;
        parts[parts[0] < 0 ? 0 : 1] = static_cast<int>(i);
    }
    return parts;
}

/// Adds one part's entries to those of the part that is solved in its place.
void add_entries(const AssemblyProblem& problem, std::size_t part, const std::vector<RowEntry>& entries,
                 const FoldedRows& folded, const std::vector<RowImage>& image,
                 std::vector<std::map<std::pair<int, int>, double>>& to) {
    const PartMirror& mirror = *problem.parts[part].input.mirror;
    const bool moves = mirror.role == MirrorRole::follower, is_pair = mirror.role != MirrorRole::own_image;
    for (const RowEntry& e : entries) {
        if (!folded.kept[at(e.row)]) continue;
        const double twice = image[at(e.row)].row == e.row ? 1 : 2;
        const int coefficient = moves ? mirror.coefficient[at(e.coefficient)] : e.coefficient;
        const double sign = moves ? mirror.sign[at(e.coefficient)] : 1;
        to[moves ? at(mirror.image) : part][{folded.folded[at(e.row)], coefficient}] +=
            twice * sign * (is_pair ? std::sqrt(0.5) : 1) * e.value;
    }
}

void number_rows(const std::vector<RowImage>& image, FoldedRows& folded) {
    const std::size_t n = image.size();
    folded.folded.assign(n, -1);
    folded.sign.assign(n, 1);
    folded.kept.assign(n, 0);
    for (std::size_t r = 0; r < n; ++r) {
        const auto other = at(image[r].row);
        if (other < r || (other == r && image[r].sign < 0)) continue;
        folded.kept[r] = 1;
        folded.folded[r] = folded.folded[other] = folded.all.rows.n++;
        if (other != r) folded.sign[other] = image[r].sign;
    }
}

/// Values by row of the whole, those of mirrored rows added up; sign: by row of the whole.
VectorXd added_up(const VectorXd& whole, const FoldedRows& folded, const std::vector<double>& sign) {
    VectorXd sum = VectorXd::Zero(whole.size() == 0 ? 0 : folded.all.rows.n);
    for (Index r = 0; r < whole.size(); ++r)
        if (const int row = folded.folded[static_cast<std::size_t>(r)]; row >= 0)
            sum[row] += sign[static_cast<std::size_t>(r)] * whole[r];
    return sum;
}

/// The same of the first of mirrored rows.
VectorXd picked(const VectorXd& whole, const FoldedRows& folded) {
    VectorXd result = VectorXd::Zero(whole.size() == 0 ? 0 : folded.all.rows.n);
    for (Index r = 0; r < whole.size(); ++r)
        if (folded.kept[static_cast<std::size_t>(r)]) result[folded.folded[static_cast<std::size_t>(r)]] = whole[r];
    return result;
}

}  // namespace

RowImages row_images(const AssemblyProblem& problem, const Rows& rows) {
    RowImages result;
    if (rows.n == 0) return result;
    const RowMatch match(problem, rows);
    for (int r = 0; r < rows.n; ++r) result.image.push_back(match.image_of(r));
    for (int r = 0; r < rows.n; ++r) {
        const int other = result.image[at(r)].row;
        if (other >= 0 && result.image[at(other)].row == r) continue;
        result.lonely_parts = parts_of(rows, r);
        break;
    }
    return result;
}

FoldedRows fold_rows(const AssemblyProblem& problem, const AssemblyRows& whole, const std::vector<RowImage>& image) {
    FoldedRows folded;
    Rows& rows = folded.all.rows;
    number_rows(image, folded);
    std::vector<std::map<std::pair<int, int>, double>> entries(problem.parts.size());
    for (std::size_t i = 0; i < problem.parts.size(); ++i)
        add_entries(problem, i, whole.rows.by_part[i], folded, image, entries);
    for (const auto& of_part : entries) {
        rows.by_part.emplace_back();
        for (const auto& [place, value] : of_part) rows.by_part.back().push_back({place.first, place.second, value});
    }
    const std::vector<double> plus(image.size(), 1);
    rows.gap0 = added_up(whole.rows.gap0, folded, folded.sign);
    rows.weight = added_up(whole.rows.weight, folded, plus);
    rows.softness = added_up(whole.rows.softness, folded, plus);
    for (std::size_t r = 0; r < image.size(); ++r)
        if (folded.kept[r]) rows.unilateral.push_back(whole.rows.unilateral[r]);
    folded.all.foundation = picked(whole.foundation, folded);
    folded.all.expected = picked(whole.expected, folded);
    return folded;
}

}  // namespace abut::solver

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/clipped_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "geometry/brep/monotone.hpp"

namespace abut::report {

namespace {

/// Pieces of a patch below this share of it are left out: they are rounding.
constexpr double sliver_of_patch = 1e-9;

FieldSample blended(const FieldSample& a, const FieldSample& b, double t) {
    const auto mix = [t](double x, double y) { return (1 - t) * x + t * y; };
    return {(1 - t) * a.at + t * b.at,
            (1 - t) * a.displacement + t * b.displacement,
            {mix(a.stress.xx, b.stress.xx), mix(a.stress.yy, b.stress.yy), mix(a.stress.xy, b.stress.xy),
             mix(a.stress.zz, b.stress.zz)}};
}

struct BoundaryChord {
    const FieldSample *from, *to;
};

/// The chords of the boundary by horizontal strips: a patch looks at those of its own.
class ChordStrips {
public:
    explicit ChordStrips(const PartField& field) {
        for (const auto& loop : field.boundary)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                chords_.push_back({&loop[i], &loop[(i + 1) % loop.size()]});
                box_.extend(loop[i].at);
            }
        strips_.resize(std::max<std::size_t>(1, chords_.size() / 2));
        for (std::size_t k = 0; k < chords_.size(); ++k) {
            const auto [low, high] = range(std::min(y(k, 0), y(k, 1)), std::max(y(k, 0), y(k, 1)));
            for (std::size_t s = low; s <= high; ++s) strips_[s].push_back(k);
        }
    }

    /// Those whose boxes meet the box, each once.
    std::vector<BoundaryChord> near(const geometry::Box2& box) const {
        std::vector<std::size_t> found;
        const auto [low, high] = range(box.min.y(), box.max.y());
        for (std::size_t s = low; s <= high; ++s)
            for (std::size_t k : strips_[s]) {
                geometry::Box2 own;
                own.extend(chords_[k].from->at);
                own.extend(chords_[k].to->at);
                if (own.overlaps(box, 0)) found.push_back(k);
            }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        std::vector<BoundaryChord> chords;
        for (std::size_t k : found) chords.push_back(chords_[k]);
        return chords;
    }

private:
    double y(std::size_t chord, int end) const { return (end == 0 ? chords_[chord].from : chords_[chord].to)->at.y(); }
    std::pair<std::size_t, std::size_t> range(double low, double high) const {
        const double height = (box_.max.y() - box_.min.y()) / static_cast<double>(strips_.size());
        const auto strip = [&](double at) {
            const double k = height > 0 ? std::floor((at - box_.min.y()) / height) : 0;
            return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(strips_.size() - 1)));
        };
        return {strip(low), strip(high)};
    }

    std::vector<BoundaryChord> chords_;
    std::vector<std::vector<std::size_t>> strips_;
    geometry::Box2 box_;
};

/// A chord in the coordinates of a patch, which are 0 and 1 along its sides.
struct PatchChord {
    Vec2 from, to;
    BoundaryChord of;
    double along(double v) const { return std::clamp((v - from.y()) / (to.y() - from.y()), 0.0, 1.0); }
    double u(double v) const { return from.x() + along(v) * (to.x() - from.x()); }
};

/// One patch that the boundary may cross.
class PatchCutter {
public:
    PatchCutter(const PartField& field, const FieldPatch& patch, const geometry::SlabbedPieces& inside, ClippedCells& out)
        : inside_(inside), out_(out) {
        for (std::size_t i = 0; i < 4; ++i) corner_[i] = &field.samples[static_cast<std::size_t>(patch.corner[i])];
        along_[0] = corner_[1]->at - corner_[0]->at;
        along_[1] = corner_[3]->at - corner_[0]->at;
    }

    void cut(const std::vector<BoundaryChord>& near) {
        std::vector<double> levels{0, 1};
        for (const BoundaryChord& chord : near) add(chord, levels);
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        for (std::size_t i = 0; i + 1 < levels.size(); ++i) cut_strip(levels[i], levels[i + 1]);
    }

private:
    static constexpr int left_side = -1, right_side = -2;

    Vec2 local(const Vec2& p) const {
        const Vec2 d = p - corner_[0]->at;
        return {d.dot(along_[0]) / along_[0].squaredNorm(), d.dot(along_[1]) / along_[1].squaredNorm()};
    }
    Vec2 global(double u, double v) const { return corner_[0]->at + u * along_[0] + v * along_[1]; }

    void add(const BoundaryChord& chord, std::vector<double>& levels) {
        const PatchChord c{local(chord.from->at), local(chord.to->at), chord};
        const auto add_level = [&](double v) {
            if (v > 0 && v < 1) levels.push_back(v);
        };
        if (std::max(c.from.y(), c.to.y()) <= 0 || std::min(c.from.y(), c.to.y()) >= 1) return;
        if (std::max(c.from.x(), c.to.x()) < 0 || std::min(c.from.x(), c.to.x()) > 1) return;
        add_level(c.from.y());
        add_level(c.to.y());
        for (double side : {0.0, 1.0})
            if ((c.from.x() - side) * (c.to.x() - side) < 0)
                add_level(c.from.y() + (side - c.from.x()) / (c.to.x() - c.from.x()) * (c.to.y() - c.from.y()));
        if (c.from.y() != c.to.y()) chords_.push_back(c);
    }

    /// No chord begins or ends between two neighbouring levels: from left to right those that run down enter the part, those
    /// that run up leave it.
    void cut_strip(double low, double high) {
        const double middle = 0.5 * (low + high);
        std::vector<std::pair<double, int>> met;
        for (std::size_t k = 0; k < chords_.size(); ++k) {
            const PatchChord& c = chords_[k];
            if (std::min(c.from.y(), c.to.y()) > middle || std::max(c.from.y(), c.to.y()) < middle) continue;
            const double u = c.u(middle);
            if (u > 0 && u < 1) met.emplace_back(u, static_cast<int>(k));
        }
        std::sort(met.begin(), met.end());
        if (met.empty()) {
            if (geometry::contains(inside_, global(0.5, middle))) add_cell(left_side, right_side, low, high);
            return;
        }
        int begin = left_side;
        for (const auto& [u, k] : met) {
            const PatchChord& c = chords_[static_cast<std::size_t>(k)];
            if (c.to.y() > c.from.y() && begin != right_side) add_cell(begin, k, low, high);
            begin = c.to.y() > c.from.y() ? right_side : k;
        }
        if (begin != right_side) add_cell(begin, right_side, low, high);
    }

    double place(int side, double v) const {
        if (side == left_side) return 0;
        if (side == right_side) return 1;
        return std::clamp(chords_[static_cast<std::size_t>(side)].u(v), 0.0, 1.0);
    }

    void add_cell(int left, int right, double low, double high) {
        const double below = place(right, low) - place(left, low), above = place(right, high) - place(left, high);
        if ((below + above) * (high - low) < sliver_of_patch) return;
        std::vector<int> cell{point_of(left, low)};
        if (below > 0) cell.push_back(point_of(right, low));
        cell.push_back(point_of(right, high));
        if (above > 0) cell.push_back(point_of(left, high));
        out_.cells.push_back(std::move(cell));
    }

    int point_of(int side, double v) {
        const auto [known, is_new] = points_.emplace(std::pair(side, v), static_cast<int>(out_.points.size()));
        if (!is_new) return known->second;
        if (side >= 0) {
            const PatchChord& c = chords_[static_cast<std::size_t>(side)];
            out_.points.push_back(blended(*c.of.from, *c.of.to, c.along(v)));
        } else {
            const std::size_t a = side == left_side ? 0 : 1;
            out_.points.push_back(blended(*corner_[a], *corner_[3 - a], v));
        }
        return known->second;
    }

    const geometry::SlabbedPieces& inside_;
    ClippedCells& out_;
    std::array<const FieldSample*, 4> corner_{};
    std::array<Vec2, 2> along_{};
    std::vector<PatchChord> chords_;
    std::map<std::pair<int, double>, int> points_;
};

}  // namespace

ClippedCells clipped_cells(const PartField& field, const geometry::Part& part) {
    ClippedCells out;
    const ChordStrips strips(field);
    const geometry::SlabbedPieces inside = geometry::slabbed(geometry::monotone_pieces(part));
    std::vector<int> whole(field.samples.size(), -1);  // samples that whole patches have taken
    for (const FieldPatch& patch : field.patches) {
        geometry::Box2 box;
        for (int k : patch.corner) box.extend(field.samples[static_cast<std::size_t>(k)].at);
        const std::vector<BoundaryChord> near = strips.near(box);
        if (!near.empty()) {
            PatchCutter(field, patch, inside, out).cut(near);
            continue;
        }
        if (!geometry::contains(inside, box.center())) continue;
        std::vector<int> cell;
        for (int k : patch.corner) {
            int& own = whole[static_cast<std::size_t>(k)];
            if (own < 0) {
                own = static_cast<int>(out.points.size());
                out.points.push_back(field.samples[static_cast<std::size_t>(k)]);
            }
            cell.push_back(own);
        }
        out.cells.push_back(std::move(cell));
    }
    std::stable_partition(out.cells.begin(), out.cells.end(), [](const auto& cell) { return cell.size() == 3; });
    return out;
}

}  // namespace abut::report

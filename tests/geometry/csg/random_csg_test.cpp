// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of Booleans on random scenes whose edges, corners and tangents coincide often. Bounds: areas are sums of closed
// forms over corners that are exact but for rounding, a few 1e-16 of the size each, and an error along the edges
// changes no area; `area_tolerance` is that with a factor of 1e4 for tangential corners and the Newton iterations on splines.
// Sampling is bounded by its own variance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "geometry/csg/csg.hpp"
#include "geometry/csg/csg_names.hpp"
#include "geometry/csg/primitives.hpp"
#include "tests/geometry/csg/random_csg_scene.hpp"

namespace random_csg_test {

namespace {

using namespace abut::geometry;

/// Of the size squared.
constexpr double area_tolerance = 1e-11;
/// Distance of a result's edges from the edges that they are pieces of, of the size.
constexpr double on_source = 1e-12;
/// Points nearer to any edge are not asked where they lie: fraction of the size. Far above the error of the polygons that stand
/// for splines.
constexpr double away_fraction = 1e-3;
/// Standard deviations that a sampled area may be off: 1 in 5e8.
constexpr double n_deviations = 6;

CsgNode join(std::vector<CsgNode> of) {
    return {Union{std::move(of)}, "", "/union"};
}
CsgNode common(std::vector<CsgNode> of) {
    return {Intersection{std::move(of)}, "", "/intersection"};
}
CsgNode less(std::vector<CsgNode> of) {
    return {Difference{std::move(of)}, "", "/difference"};
}

bool is_empty_only(const CsgResult& result) {
    return result.problems.size() == 1 && result.problems[0].what.find("the part is empty") != std::string::npos;
}

/// All edges of the primitives where they lie, by name.
std::map<std::string, Curve> sources_of(const CsgNode& tree) {
    std::vector<GeometryProblem> problems;
    std::map<std::string, Curve> found;
    for (const PlacedSource& source : placed_sources(primitives_of(tree, problems)))
        found.emplace(source.prefix + "/" + source.name, source.curve);
    return found;
}

double distance_to(const Curve& curve, const Vec2& p) {
    return (point(curve, closest_parameter(curve, p)) - p).norm();
}

/// One scene: what is wrong with it, as text; empty if nothing.
class Checks {
public:
    Checks(unsigned seed, Leaves leaves) : random_(seed) {
        int name = 0;
        a_ = random_tree(random_, leaves, name);
        b_ = random_tree(random_, leaves, name);
        c_ = random_tree(random_, leaves, name);
        if (seed % 2) {
            const double angles[] = {30, 17.3, 90, -121};
            const double angle = angles[seed / 2 % 4];
            for (CsgNode* node : {&a_, &b_, &c_}) *node = turned(std::move(*node), angle, {3.25, -1});
        }
        measure();
    }
    /// Of two given trees.
    Checks(CsgNode a, CsgNode b) : random_(1), a_(a), b_(std::move(b)), c_(std::move(a)) { measure(); }

    /// One of the laws and the result that it is about, or all of them.
    std::string run(int law) {
        const CsgNode both = join({a_, b_}), rest = less({a_, b_}), all = join({a_, b_, c_});
        if (law == 0 || law == n_laws) check(both, "A u B", area_of(a_) + area_of(b_) - area_of(common({a_, b_})));
        if (law == 1 || law == n_laws) check(rest, "A - B", area_of(a_) - area_of(common({a_, b_})));
        if (law == 2 || law == n_laws)
            check(all, "A u B u C",
                  area_of(a_) + area_of(b_) + area_of(c_) - area_of(common({a_, b_})) - area_of(common({a_, c_})) -
                      area_of(common({b_, c_})) + area_of(common({a_, b_, c_})));
        return faults_;
    }
    static constexpr int n_laws = 3;

    /// Is the part what the tree means?
    std::string judge_part(const CsgNode& tree, const Part& part) {
        const CsgNode judge = with_polygons(tree);
        sampled_area(tree, judge, area(part));
        membership(tree, judge, part);
        edges(tree, part);
        return faults_;
    }

private:
    void measure() {
        sources_ = sources_of(join({a_, b_, c_}));
        for (const auto& [name, curve] : sources_) box_.extend(bounding_box(curve));
        size_ = box_.diagonal();
    }
    void fault(const std::string& what, const CsgNode& tree) { faults_ += what + "\n  " + tree_text(tree) + "\n"; }

    CsgResult evaluated(const CsgNode& tree) {
        CsgResult result = evaluate(tree);
        if (!result.problems.empty() && !is_empty_only(result)) fault("problem: " + result.problems[0].what, tree);
        return result;
    }
    double area_of(const CsgNode& tree) { return area(evaluated(tree).part); }

    void check(const CsgNode& tree, const std::string& law, double expected) {
        const Part part = evaluated(tree).part;
        if (!(std::abs(area(part) - expected) <= area_tolerance * size_ * size_))
            fault(law + ": " + std::to_string(area(part)) + " is off by " +
                      std::to_string((area(part) - expected) / (area_tolerance * size_ * size_)) + " tolerances",
                  join({a_, b_, c_}));
        judge_part(tree, part);
    }

    double uniform() { return static_cast<double>(random_()) / 4294967296.0; }

    /// One random point in each cell of a grid. Only cells that the boundary passes through err, each with a variance of at
    /// most 1/4 of its area squared; a curve of length s passes through at most 2 s / h + 4 of them.
    void sampled_area(const CsgNode& tree, const CsgNode& judge, double exact) {
        constexpr int n = 24;
        const Vec2 cell = box_.size() / n;
        int inside = 0;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k) {
                const double x = i + uniform();
                inside += is_member(judge, box_.min + cell.cwiseProduct(Vec2(x, k + uniform())));
            }
        double n_cells = 0;
        for (const auto& [name, curve] : sources_) n_cells += 2 * length(curve) / cell.minCoeff() + 4;
        const double deviation = cell.prod() * std::sqrt(n_cells / 4);
        if (std::abs(inside * cell.prod() - exact) > n_deviations * deviation)
            fault("sampled area " + std::to_string(inside * cell.prod()) + ", by the boundary " + std::to_string(exact), tree);
    }

    void membership(const CsgNode& tree, const CsgNode& judge, const Part& part) {
        constexpr int n = 30;
        for (int k = 0; k < n; ++k) {
            const double x = uniform();
            const Vec2 p = box_.min + box_.size().cwiseProduct(Vec2(x, uniform()));
            const bool is_away = std::ranges::all_of(
                sources_, [&](const auto& source) { return distance_to(source.second, p) > away_fraction * size_; });
            if (!is_away || contains(part, p) == is_member(judge, p)) continue;
            return fault("contains() errs at " + std::to_string(p.x()) + ", " + std::to_string(p.y()), tree);
        }
    }

    void edges(const CsgNode& tree, const Part& part) {
        std::set<std::string> names;
        for (const Edge& edge : part.edges) {
            if (!names.insert(edge.name).second) fault("the name " + edge.name + " is there twice", tree);
            if (!(length(edge.curve) > merge_length(part))) fault(edge.name + " has no length", tree);
            const auto source = sources_.find(edge.source);
            if (source == sources_.end()) return fault("no source " + edge.source, tree);
            for (const double t : {0.0, 0.137, 0.5, 0.771, 1.0})
                if (const double d = distance_to(source->second, point(edge.curve, t)); !(d <= on_source * size_))
                    return fault(edge.name + " is off its source by " + std::to_string(d / size_ / on_source) + " x 1e-12",
                                 tree);
        }
        std::size_t n_used = 0;
        for (const Loop& loop : part.loops)
            for (std::size_t i = 0; i < loop.edges.size(); ++i, ++n_used) {
                const auto here = static_cast<std::size_t>(loop.edges[i]);
                const auto next = static_cast<std::size_t>(loop.edges[(i + 1) % loop.edges.size()]);
                const double gap = (point(part.edges[here].curve, 1) - point(part.edges[next].curve, 0)).norm();
                if (gap > merge_length(part))
                    fault("a gap of " + std::to_string(gap) + " after " + part.edges[here].name, tree);
            }
        if (n_used != part.edges.size()) fault("edges outside all loops", tree);
    }

    std::mt19937 random_;
    CsgNode a_, b_, c_;
    std::map<std::string, Curve> sources_;
    Box2 box_;
    double size_ = 0;
    std::string faults_;
};

/// Each scene with one law after the other in turn, or with all of them.
void run_scenes(unsigned first, unsigned n, Leaves leaves, bool all_laws) {
    int n_failed = 0;
    for (unsigned seed = first; seed < first + n && n_failed < 5; ++seed) {
        const std::string faults =
            Checks(seed, leaves).run(all_laws ? Checks::n_laws : static_cast<int>(seed % Checks::n_laws));
        if (faults.empty()) continue;
        ++n_failed;
        ADD_FAILURE() << "scene " << seed << ": " << faults;
    }
}

}  // namespace

/// Scenes in which the long sweeps once found something: a lost ellipse, an edge without length, a corner's rounding taken for
/// a whole circle.
TEST(RandomCsg, ScenesThatOnceFailed) {
    for (const unsigned seed : {1520U, 3035U, 5417U, 5777U}) run_scenes(seed, 1, Leaves::all, true);
}

TEST(RandomCsg, LinesAndCircles) {
    run_scenes(1, 200, Leaves::lines_and_circles, false);
}
TEST(RandomCsg, AllKinds) {
    run_scenes(1, 100, Leaves::all, false);
}
TEST(LongRandomCsg, LinesAndCircles) {
    run_scenes(1000, 5000, Leaves::lines_and_circles, true);
}
TEST(LongRandomCsg, AllKinds) {
    run_scenes(1000, 5000, Leaves::all, true);
}

/// Each of the checks catches a part that is a little wrong.
TEST(RandomCsg, WrongPartsAreCaught) {
    const CsgNode plate{Rectangle{{0, 0}, {8, 8}}, "a", ""}, hole{Circle{{4, 4}, 2}, "b", ""};
    const CsgNode tree = less({plate, hole});
    const Part right = evaluate(tree).part;
    const auto faults = [&](const Part& part) { return Checks(plate, hole).judge_part(tree, part); };
    EXPECT_EQ(faults(right), "");
    const auto expect_caught = [&](const Part& part, const char* what) {
        EXPECT_NE(faults(part).find(what), std::string::npos) << what << " is not in: " << faults(part);
    };
    expect_caught(evaluate(plate).part, "contains() errs");
    expect_caught(evaluate(hole).part, "sampled area");
    expect_caught(transformed(right, 1, 0, {2e-11, 0}), "off its source");
    Part wrong = right;
    wrong.edges[1].name = wrong.edges[0].name;
    expect_caught(wrong, "is there twice");
    wrong = right;
    std::get<Segment>(wrong.edges[0].curve).to = point(wrong.edges[0].curve, 0.999);
    expect_caught(wrong, "a gap");
    wrong = right;
    wrong.edges[2].source = "elsewhere";
    expect_caught(wrong, "no source");
}

/// The definitions that the scenes are judged by are themselves right: points inside and outside by hand.
TEST(RandomCsg, MembershipByHand) {
    const CsgNode slot{Slot{{0, 0}, {4, 0}, 1}, "s", ""};
    EXPECT_TRUE(is_member(slot, {4.9, 0}));
    EXPECT_FALSE(is_member(slot, {4.8, 0.8}));
    const CsgNode ellipse{Ellipse{{1, 1}, {2, 1}, 90}, "e", ""};
    EXPECT_TRUE(is_member(ellipse, {1, 2.9}));
    EXPECT_FALSE(is_member(ellipse, {2.1, 1}));
    Placed place;
    place.of.push_back({Rectangle{{0, 0}, {2, 1}}, "r", ""});
    place.scale = 2;
    place.mirror = Mirror::x;
    place.rotate = 90;
    place.translate = {10, 0};
    place.about = {1, 0};
    // (2, 1) -> scaled about (1, 0): (3, 2) -> mirrored: (-1, 2) -> turned: (-1, -2) -> moved: (9, -2)
    const CsgNode moved{place, "", ""};
    EXPECT_TRUE(is_member(moved, {9.1, -1.9}));
    EXPECT_FALSE(is_member(moved, {8.9, -1.9}));
    EXPECT_FALSE(is_member(moved, {9.1, -2.1}));
    EXPECT_FALSE(is_member(less({moved, moved}), {9.1, -1.9}));
}

}  // namespace random_csg_test

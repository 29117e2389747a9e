// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/mirrored_grids.hpp"

#include <algorithm>
#include <cmath>

#include "solver/parts/fold.hpp"
#include "solver/parts/mirror.hpp"
#include "src/io/index.hpp"

namespace abut {

namespace {

std::vector<double> mirrored_lines(const std::vector<double>& lines, const solver::PlaceImage& place, int direction) {
    std::vector<double> result;
    for (double v : lines) result.push_back(place.along(direction, v));
    std::sort(result.begin(), result.end());
    return result;
}

/// The outermost lines lie on the part's edges: to the last digit, where they are drawn so.
void symmetrize(std::vector<double>& lines, double twice_center) {
    const std::size_t n = lines.size();
    for (std::size_t k = 1; 2 * k < n; ++k) {  // the middle one, too
        double &a = lines[k], &b = lines[n - 1 - k];
        a = 0.5 * (a + (twice_center - b));
        b = twice_center - a;
    }
}

/// axis -1: the frame is turned against the mirror line.
solver::PlaceImage place_image(const Frame& from, const Frame& to, const MirrorLine& mirror) {
    const auto image = [&](const Vec2& local) { return to.to_local(mirror.image_of(from.to_global(local))); };
    const Vec2 origin = image({0, 0}), x = image({1, 0}) - origin, y = image({0, 1}) - origin;
    for (int axis : {0, 1}) {
        const Vec2 expected_x(axis == 0 ? -1 : 1, 0), expected_y(0, axis == 0 ? 1 : -1);
        if ((x - expected_x).norm() <= solver::mirrored_place && (y - expected_y).norm() <= solver::mirrored_place)
            return {axis, origin};
    }
    return {-1, origin};
}

std::vector<int> inverse(const std::vector<int>& map) {
    std::vector<int> result(map.size());
    for (std::size_t i = 0; i < map.size(); ++i) result[at(map[i])] = static_cast<int>(i);
    return result;
}

using Mirrors = std::vector<std::shared_ptr<const solver::PartMirror>>;

/// Of a part and its image, which is the part itself or comes later. Returns what is wrong.
std::string add_mirrors(const MirrorLine& mirror, int part, int image, const SolvedAssembly& solved, Mirrors& mirrors) {
    const PartOnGrid &own = solved.grids[at(part)], &other = solved.grids[at(image)];
    const solver::PlaceImage place = place_image(own.frame, other.frame, mirror);
    if (place.axis < 0) return "its grid is turned against the mirror line";
    const solver::SpaceImage map = solver::space_image(own.input, other.input, place);
    if (!map.failure.empty()) return map.failure;
    const auto made = [](solver::PartMirror m) { return std::make_shared<const solver::PartMirror>(std::move(m)); };
    const solver::MirrorRole role = part == image ? solver::MirrorRole::own_image : solver::MirrorRole::leader;
    mirrors[at(part)] = made(part_mirror(role, image, place, map.function));
    if (part != image)
        mirrors[at(image)] = made(part_mirror(solver::MirrorRole::follower, part, place.inverse(), inverse(map.function)));
    return "";
}

}  // namespace

void make_symmetric(const MirrorLine& mirror, PartGrid& grid) {
    const solver::PlaceImage place = place_image(grid.frame, grid.frame, mirror);
    if (place.axis < 0) return;
    symmetrize(place.axis == 0 ? grid.grid.x : grid.grid.y, place.shift[place.axis]);
}

PartGrid mirrored_grid(const Scene& scene, int part, const PartOnGrid& image, const MirrorLine& mirror) {
    const ScenePart& source = scene.parts[at(part)];
    PartGrid result;
    result.frame = frame_for(source.part, std::atan2(-image.frame.s, image.frame.c));
    result.local = transformed(source.part, result.frame.c, -result.frame.s, -result.frame.shift);
    const solver::PlaceImage to_own = place_image(image.frame, result.frame, mirror);
    const solver::SplineSpace& space = image.input.space;
    result.grid = {mirrored_lines(space.x.breakpoints, to_own, 0), mirrored_lines(space.y.breakpoints, to_own, 1)};
    result.degree = {space.x.degree, space.y.degree};
    return result;
}

std::string set_mirrors(const Scene& scene, const MirrorLine& mirror, SolvedAssembly& solved) {
    Mirrors mirrors(solved.grids.size());
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const int part = solved.grids[k].part, image = mirror.image[at(part)];
        if (image < part) continue;
        const std::string name = "part " + scene.parts[at(part)].name + ": ";
        if (solved.solver_part[at(image)] < 0) return name + "its mirror image is not solved";
        const std::string wrong = add_mirrors(mirror, static_cast<int>(k), solved.solver_part[at(image)], solved, mirrors);
        if (!wrong.empty()) return name + wrong;
    }
    for (std::size_t k = 0; k < mirrors.size(); ++k)
        if (!mirrors[k]) return "part " + scene.parts[at(solved.grids[k].part)].name + ": its mirror image is not solved";
    for (std::size_t k = 0; k < mirrors.size(); ++k) solved.grids[k].input.mirror = mirrors[k];
    return "";
}

namespace {

constexpr int seam_samples = 64;

/// Of the first chain's point at an arc length of a closed zone.
geometry::FacingPair pair_of(const Scene& scene, const Candidate& c, double s1) {
    const double share = (s1 - c.zone.begin1) / (c.zone.end1 - c.zone.begin1);
    return pair_from_first(scene.parts[at(c.first)].part, scene.parts[at(c.second)].part, c.zone, s1,
                           c.zone.begin2 + share * (c.zone.end2 - c.zone.begin2));
}

void put_seam(const Scene& scene, double s1, Candidate& c) {
    const geometry::FacingPair pair = pair_of(scene, c, s1);
    if (pair.found) begin_at(pair, c.zone);
}

/// Signed distance from the mirror line.
double offset(const MirrorLine& mirror, const Vec2& x) {
    return (x - mirror.point)[mirror.reversed()];
}

/// Where the first chain crosses the mirror line, by bisection.
std::vector<double> crossings(const geometry::Part& part, const geometry::FacingZone& zone, const MirrorLine& mirror) {
    const auto height = [&](double s) { return offset(mirror, at(part, zone.chain1, s).x); };
    std::vector<double> found;
    const double step = zone.chain1.length / seam_samples;
    for (int k = 0; k < seam_samples; ++k) {
        double low = zone.begin1 + k * step, high = low + step;
        const double at_low = height(low);
        if (at_low != 0 && (at_low > 0) == (height(high) > 0)) continue;
        for (double middle = 0.5 * (low + high); low < middle && middle < high && at_low != 0; middle = 0.5 * (low + high))
            ((height(middle) > 0) == (at_low > 0) ? low : high) = middle;
        found.push_back(low);
    }
    return found;
}

/// Arc length of the first chain's point nearest to a place.
double nearest(const geometry::Part& part, const geometry::FacingZone& zone, const Vec2& place) {
    const auto distance = [&](double s) { return (at(part, zone.chain1, s).x - place).norm(); };
    const double step = zone.chain1.length / seam_samples;
    double best = zone.begin1;
    for (int k = 1; k < seam_samples; ++k)
        if (distance(zone.begin1 + k * step) < distance(best)) best = zone.begin1 + k * step;
    // Newton on the tangent: the chain is smooth
    for (int k = 0; k < 20; ++k) {
        const geometry::ChainPoint p = at(part, zone.chain1, best);
        best += (place - p.x).dot(p.tangent) / std::max(0.5, 1 - p.curvature * (place - p.x).dot(geometry::left_of(p.tangent)));
    }
    return best;
}

}  // namespace

void put_seams_on_mirror(const Scene& scene, const MirrorLine& mirror, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        Candidate& c = candidates[k];
        if (!c.zone.closed) continue;
        const int a = mirror.image[at(c.first)], b = mirror.image[at(c.second)];
        if (a == c.first && b == c.second) {
            const std::vector<double> places = crossings(scene.parts[at(c.first)].part, c.zone, mirror);
            if (places.empty()) continue;
            put_seam(scene,
                     *std::max_element(places.begin(), places.end(),
                                       [&](double s, double t) { return pair_of(scene, c, s).gap < pair_of(scene, c, t).gap; }),
                     c);
            continue;
        }
        const Vec2 on_first = mirror.image_of(at(scene.parts[at(c.first)].part, c.zone.chain1, c.zone.begin1).x);
        const Vec2 on_second = mirror.image_of(at(scene.parts[at(c.second)].part, c.zone.chain2, c.zone.begin2).x);
        for (std::size_t other = k + 1; other < candidates.size(); ++other) {
            Candidate& image = candidates[other];
            if (!image.zone.closed || std::minmax(a, b) != std::minmax(image.first, image.second)) continue;
            put_seam(scene, nearest(scene.parts[at(image.first)].part, image.zone, a == image.first ? on_first : on_second),
                     image);
        }
    }
}

}  // namespace abut

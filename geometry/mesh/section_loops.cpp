// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/section_loops.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/mesh/mesh_weld.hpp"

namespace abut::geometry {

namespace {

using std::size_t;

/// Where an edge of the mesh crosses the plane.
struct Node {
    Vec2 at;
    std::vector<int> out;  ///< segments that begin here
    int n_in = 0;
};

struct Link {
    int from, to;  ///< nodes
};

/// Open or closed run of nodes.
struct NodeRun {
    std::vector<int> nodes;
    bool is_closed = false;
};

class Slicer {
public:
    Slicer(const Mesh& body, const SectionPlane& plane) : body_(body), plane_(plane) {
        for (const std::array<int, 3>& t : body.triangles) add(t);
    }
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<Link>& links() const { return links_; }

private:
    double height(int i) const { return body_.vertices[static_cast<size_t>(i)][plane_.axis] - plane_.at; }
    bool is_above(int i) const { return height(i) >= 0; }

    Vec2 in_plane(int i) const { return geometry::in_plane(body_.vertices[static_cast<size_t>(i)], plane_.axis); }

    /// The same point bit for bit from both triangles of the edge.
    int node(int a, int b) {
        if (a > b) std::swap(a, b);
        const auto [found, is_new] = index_.emplace(std::make_pair(a, b), static_cast<int>(nodes_.size()));
        if (is_new) {
            const double ha = height(a), hb = height(b), t = ha / (ha - hb);
            nodes_.push_back({in_plane(a) + t * (in_plane(b) - in_plane(a)), {}, 0});  // exact on walls along an axis
        }
        return found->second;
    }

    /// Seen from outside, the corners of a wall go counter-clockwise: its boundary falls through the plane on the left and
    /// climbs on the right. From left to right the material, behind the wall, is on the left.
    void add(const std::array<int, 3>& t) {
        int climbs = -1, falls = -1;
        for (size_t k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            if (!is_above(a) && is_above(b)) climbs = node(a, b);
            if (is_above(a) && !is_above(b)) falls = node(a, b);
        }
        if (climbs < 0) return;
        // (x, z) is seen against the direction of y.
        const Link link = plane_.axis == 1 ? Link{climbs, falls} : Link{falls, climbs};
        nodes_[static_cast<size_t>(link.from)].out.push_back(static_cast<int>(links_.size()));
        ++nodes_[static_cast<size_t>(link.to)].n_in;
        links_.push_back(link);
    }

    const Mesh& body_;
    SectionPlane plane_;
    std::map<std::pair<int, int>, int> index_;
    std::vector<Node> nodes_;
    std::vector<Link> links_;
};

class Tracer {
public:
    explicit Tracer(const Slicer& slicer) : nodes_(slicer.nodes()), links_(slicer.links()), is_used_(links_.size(), false) {}

    /// Runs that begin where more segments begin than end, then the closed ones.
    std::vector<NodeRun> trace() {
        std::vector<NodeRun> runs;
        for (size_t n = 0; n < nodes_.size(); ++n)
            for (int extra = static_cast<int>(nodes_[n].out.size()) - nodes_[n].n_in; extra > 0; --extra)
                runs.push_back(follow(next_of(static_cast<int>(n), Vec2::Zero())));
        for (size_t k = 0; k < links_.size(); ++k)
            if (!is_used_[k]) runs.push_back(follow(static_cast<int>(k)));
        return runs;
    }

private:
    const Vec2& at(int node) const { return nodes_[static_cast<size_t>(node)].at; }

    /// The free segment that turns farthest to the left: loops that meet in a point stay two loops.
    int next_of(int node, const Vec2& direction) const {
        int best = -1;
        double most = 0;
        for (int k : nodes_[static_cast<size_t>(node)].out) {
            if (is_used_[static_cast<size_t>(k)]) continue;
            const Vec2 way = at(links_[static_cast<size_t>(k)].to) - at(node);
            const double turn = angle_between(direction, way);
            if (best < 0 || turn > most) best = k, most = turn;
        }
        return best;
    }

    NodeRun follow(int link) {
        NodeRun run;
        const int first = links_[static_cast<size_t>(link)].from;
        run.nodes.push_back(first);
        while (link >= 0) {
            is_used_[static_cast<size_t>(link)] = true;
            const Link& step = links_[static_cast<size_t>(link)];
            if (step.to == first) {
                run.is_closed = true;
                break;
            }
            run.nodes.push_back(step.to);
            link = next_of(step.to, at(step.to) - at(step.from));
        }
        return run;
    }

    const std::vector<Node>& nodes_;
    const std::vector<Link>& links_;
    std::vector<bool> is_used_;
};

using Polyline = std::vector<Vec2>;

/// Joins each end to the nearest free beginning within the width, again and again; what closes goes to the loops.
void close_cracks(std::vector<Polyline> open, double width, SectionLoops& found) {
    while (!open.empty()) {
        Polyline run = std::move(open.front());
        open.erase(open.begin());
        while (true) {
            size_t best = open.size();  // its own beginning
            double least = (run.front() - run.back()).norm();
            for (size_t k = 0; k < open.size(); ++k) {
                const double d = (open[k].front() - run.back()).norm();
                if (d < least) best = k, least = d;
            }
            const bool closes = best == open.size();
            const SectionGap gap{run.back(), closes ? run.front() : open[best].front()};
            if (least > width || (closes && run.size() < 3)) {
                found.open.push_back(gap);
                break;
            }
            if (least > 0) found.closed_cracks.push_back(gap);
            if (closes) {
                found.loops.push_back(std::move(run));
                break;
            }
            run.insert(run.end(), open[best].begin(), open[best].end());
            open.erase(open.begin() + static_cast<std::ptrdiff_t>(best));
        }
    }
}

/// Is p, between a and b, nothing but rounding away from the way from a to b?
bool is_within_face(const Vec2& a, const Vec2& p, const Vec2& b, double rounding) {
    const Vec2 u = p - a, v = b - p;
    if (u.dot(v) <= 0) return std::min(u.norm(), v.norm()) <= rounding;
    const double off = std::abs(cross(u, b - a)) / std::max((b - a).norm(), rounding);
    // Between short segments the turn is noise.
    const bool is_short = std::min(u.norm(), v.norm()) <= rounding / flat_turn;
    return off <= rounding && (is_short || std::abs(cross(u, v)) <= flat_turn * u.dot(v));
}

/// Points within plane faces, and points that repeat another, go. Each is judged by the points kept: what is lost does not add
/// up.
Polyline cleaned(const Polyline& loop, double rounding) {
    Polyline kept;
    for (const Vec2& p : loop) {
        if (!kept.empty() && (p - kept.back()).norm() <= rounding) continue;
        while (kept.size() >= 2 && is_within_face(kept[kept.size() - 2], kept.back(), p, rounding)) kept.pop_back();
        kept.push_back(p);
    }
    size_t first = 0;
    for (bool shrinks = true; shrinks && kept.size() - first >= 3;) {
        const Vec2 &last = kept.back(), &head = kept[first];
        shrinks = true;
        if ((last - head).norm() <= rounding || is_within_face(kept[kept.size() - 2], last, head, rounding))
            kept.pop_back();
        else if (is_within_face(last, head, kept[first + 1], rounding))
            ++first;
        else
            shrinks = false;
    }
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
    return kept;
}

double rounding_of(const Box2& box) {
    const double largest = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    return single_rounding * std::max(box.diagonal(), largest);
}

}  // namespace

SectionLoops section_loops(const Mesh& body, const SectionPlane& plane) {
    const Slicer slicer(body, plane);
    SectionLoops found;
    for (const Node& node : slicer.nodes()) found.box.extend(node.at);
    if (found.box.empty()) return found;
    std::vector<Polyline> open;
    for (const NodeRun& run : Tracer(slicer).trace()) {
        Polyline line;
        for (int n : run.nodes) line.push_back(slicer.nodes()[static_cast<size_t>(n)].at);
        (run.is_closed ? found.loops : open).push_back(std::move(line));
    }
    close_cracks(std::move(open), crack_fraction * found.box.diagonal(), found);
    const double rounding = rounding_of(found.box);
    for (Polyline& loop : found.loops) loop = cleaned(loop, rounding);
    std::erase_if(found.loops, [](const Polyline& loop) { return loop.size() < 3; });
    return found;
}

}  // namespace abut::geometry

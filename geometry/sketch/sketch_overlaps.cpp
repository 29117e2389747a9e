// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_overlaps.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/brep/edge_tree.hpp"

namespace abut::geometry {

namespace {

/// Two lines or circles that agree at five points of a stretch, its ends among them, agree on all of it.
bool lies_on(const Curve& curve, const Curve& other, double tolerance) {
    constexpr std::array samples{0.5, 0.0, 1.0, 0.25, 0.75};  // the middle first: it rules out neighbours at once
    return std::all_of(samples.begin(), samples.end(), [&](double t) {
        const Vec2 p = point(curve, t);
        return (point(other, closest_parameter(other, p)) - p).norm() <= tolerance;
    });
}

Repair removal(const SketchPiece& gone, const SketchPiece& kept) {
    return {gone.kind + " " + gone.name + " removed: it lies on " + kept.name, point(gone.curve, 0.5), length(gone.curve),
            Repair::Kind::removed};
}

/// Two segments of one polyline that run against each other: a spur, or the cut from an outline to a hole.
bool is_there_and_back(const SketchPiece& a, const SketchPiece& b) {
    const std::size_t stem = a.source.find('.');
    if (stem == std::string::npos || a.source.compare(0, stem + 1, b.source, 0, stem + 1) != 0) return false;
    const Vec2 begin = point(a.curve, 0);
    return (begin - point(b.curve, 1)).norm() < (begin - point(b.curve, 0)).norm();
}

Repair removal_of_both(const SketchPiece& a, const SketchPiece& b) {
    return {b.kind + " " + b.name + " and " + a.name + " removed: there and back they bound nothing", point(a.curve, 0.5),
            length(a.curve), Repair::Kind::removed};
}

/// Is there any to erase?
bool erase(std::vector<SketchPiece>& entities, const std::vector<bool>& is_gone) {
    std::size_t i = 0;
    return std::erase_if(entities, [&](const SketchPiece&) { return is_gone[i++]; }) > 0;
}

/// Takes out i, and of there and back both, if it covers the earlier j and is covered by it.
bool merge_twins(std::vector<SketchPiece>& entities, std::size_t j, std::size_t i, double tolerance, std::vector<bool>& is_gone,
                 std::vector<Repair>& repairs) {
    if (!lies_on(entities[i].curve, entities[j].curve, tolerance) || !lies_on(entities[j].curve, entities[i].curve, tolerance))
        return false;
    is_gone[i] = true;
    is_gone[j] = is_there_and_back(entities[i], entities[j]);
    repairs.push_back(is_gone[j] ? removal_of_both(entities[i], entities[j]) : removal(entities[i], entities[j]));
    entities[j].times_drawn += entities[i].times_drawn;
    if (entities[i].layer != entities[j].layer) entities[j].also_on.push_back(entities[i].layer);
    entities[j].of.insert(entities[j].of.end(), entities[i].of.begin(), entities[i].of.end());
    entities[j].whole_length = std::max(entities[j].whole_length, entities[i].whole_length);
    return true;
}

/// By entity the first other one that it lies on, -1 if there is none or it is not asked for.
std::vector<int> find_covers(const std::vector<SketchPiece>& entities, const std::vector<bool>& is_asked, double tolerance) {
    std::vector<Box2> boxes;
    for (const SketchPiece& entity : entities) boxes.push_back(bounding_box(entity.curve));
    const EdgeTree tree(boxes);
    const double most_slack = largest_slack(entities);
    std::vector<int> covers(entities.size(), -1);
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (!is_asked[i]) continue;
        Box2 middle;
        middle.extend(point(entities[i].curve, 0.5));
        const double distance = std::max(tolerance, most_slack);
        for (const int j : tree.near(middle, distance)) {
            if (static_cast<std::size_t>(j) == i || !boxes[i].is_within(boxes[static_cast<std::size_t>(j)], distance)) continue;
            const double one = reach_of_line(entities[static_cast<std::size_t>(j)], entities[i], tolerance);
            if (!lies_on(entities[i].curve, entities[static_cast<std::size_t>(j)].curve, one)) continue;
            covers[i] = j;
            break;
        }
    }
    return covers;
}

}  // namespace

bool remove_duplicates(std::vector<SketchPiece>& entities, double tolerance, std::vector<Repair>& repairs) {
    std::vector<Box2> corners(entities.size());  // twins have one box, and so one corner of it; circles one centre without that
    for (std::size_t i = 0; i < entities.size(); ++i) corners[i].extend(bounding_box(entities[i].curve).min);
    const EdgeTree tree(corners);
    std::vector<bool> is_gone(entities.size(), false);
    for (std::size_t i = 0; i < entities.size(); ++i)
        for (const int near : tree.near(corners[i], tolerance)) {
            const auto j = static_cast<std::size_t>(near);
            if (j >= i || (!is_gone[j] && merge_twins(entities, j, i, tolerance, is_gone, repairs))) break;
        }
    return erase(entities, is_gone);
}

bool remove_twins(std::vector<SketchPiece>& entities, const Joints& joints, double tolerance, std::vector<Repair>& repairs) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> between;
    std::vector<bool> is_gone(entities.size(), false);
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (joints.at_begin[i] < 0) continue;
        auto& others = between[std::minmax(joints.at_begin[i], joints.at_end[i])];
        for (const std::size_t j : others)
            if (!is_gone[j] && merge_twins(entities, j, i, tolerance, is_gone, repairs)) break;
        if (!is_gone[i]) others.push_back(i);
    }
    return erase(entities, is_gone);
}

bool remove_covered(std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<bool>& is_loose,
                    double tolerance, std::vector<Repair>& repairs) {
    const std::vector<int> covers = find_covers(entities, is_loose, tolerance);
    std::vector<std::size_t> n_ends;
    for (const Joint& joint : joints.joints) n_ends.push_back(joint.ends.size());
    const auto is_of_no_use = [&](int joint) { return joint >= 0 && n_ends[static_cast<std::size_t>(joint)] != 2; };

    std::vector<bool> is_gone(entities.size(), false);
    for (bool is_change = true; is_change;) {  // of pieces in a row the outer ones leave the next ones without use
        is_change = false;
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const int begin = joints.at_begin[i], end = joints.at_end[i];
            if (is_gone[i] || covers[i] < 0 || (!is_of_no_use(begin) && !is_of_no_use(end))) continue;
            is_gone[i] = is_change = true;
            --n_ends[static_cast<std::size_t>(begin)];
            --n_ends[static_cast<std::size_t>(end)];
            repairs.push_back(removal(entities[i], entities[static_cast<std::size_t>(covers[i])]));
        }
    }
    return erase(entities, is_gone);
}

}  // namespace abut::geometry

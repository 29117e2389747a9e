// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/leads.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "src/base/index.hpp"
#include "src/motion/placement.hpp"
#include "src/plan/support_components.hpp"
#include "src/plan/support_wrenches.hpp"

namespace abut {

namespace {

bool is_zero(const Expression& e) {
    return e.is_constant() && e.constant() == 0;
}

std::set<int> parts_of(const Scene& scene, const Support& s, const std::vector<EdgePortion>& on) {
    std::set<int> parts;
    for (const EdgePortion& portion : on) parts.insert(portion.part);
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (scene.parts[i].name == s.part) parts.insert(static_cast<int>(i));
    return parts;
}

void take_rigid(const Support& s, Lead& lead) {
    const std::array<std::optional<double>, 3> given{s.rigid_x, s.rigid_y, s.rigid_rotation};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!given[c]) continue;
        lead.is_given[c] = true;
        lead.to[static_cast<Eigen::Index>(c)] = *given[c];
    }
}

/// False: it is not the same everywhere, or differs from what is given already.
bool take_displacement(const Support& s, Lead& lead) {
    for (std::size_t c = 0; c < 2; ++c) {
        if (!(c == 0 ? s.x : s.y)) continue;
        const Expression& value = s.value[c];
        const auto k = static_cast<Eigen::Index>(c);
        if (!value.is_constant() || (lead.is_given[c] && lead.to[k] != value.constant())) return false;
        lead.is_given[c] = true;
        lead.to[k] = value.constant();
    }
    lead.is_given[2] = true;
    return true;
}

/// What holds a part, and what does so beside what leads it.
struct Hold {
    std::vector<geometry::Screw> all, others;
};

/// Do the other supports let the part go there, and does nothing let it turn?
bool goes_as_a_whole(const Hold& hold, const Vec2& way, const geometry::ScrewScale& scale) {
    constexpr double across = 1e-9;  // sine
    const std::vector<geometry::Screw> free = twist_space(hold.all, scale);
    return std::all_of(free.begin(), free.end(), [](const geometry::Screw& twist) { return twist[2] == 0; }) &&
           std::all_of(hold.others.begin(), hold.others.end(), [&](const geometry::Screw& wrench) {
               return std::abs(wrench.head<2>().dot(way)) <= across * way.norm() * wrench.head<2>().norm();
           });
}

/// Those parts that supports of edges do not lead as a whole. all: the wrenches of supports, by part.
std::set<int> parts_not_led(const Scene& scene, const ResolvedConditions& conditions, const Leads& leads,
                            const std::set<int>& by_edges, const std::vector<std::vector<geometry::Screw>>& all) {
    std::set<int> parts;
    const auto others = support_wrenches(without_leads(scene, leads), conditions);
    for (const int part : by_edges)
        if (!goes_as_a_whole({all[at(part)], others[at(part)]}, leads.of[at(part)].to.head<2>(), screw_scale(scene)))
            parts.insert(part);
    return parts;
}

/// How far a support displaces the points of edges that it acts on, by some of them.
double farthest(const Scene& scene, const Support& s, const std::vector<EdgePortion>& on) {
    constexpr int looks = 8;
    double far = 0;
    for (const EdgePortion& portion : on)
        for (int k = 0; k <= looks; ++k) {
            const double t = portion.t0 + (portion.t1 - portion.t0) * k / looks;
            const Vec2 x = point(curve_of(part_of(scene, portion.part), portion.edge), t);
            far = std::max(far, Vec2(s.x ? s.value[0](x.x(), x.y()) : 0, s.y ? s.value[1](x.x(), x.y()) : 0).norm());
        }
    return far;
}

/// Parts that a little displacement of their edges deforms, and that supports hold, stay where they are drawn, and others go
/// on. False: it is more than a little, leads other parts as well, or they may move besides. all: likewise.
bool hold_deformed(const Scene& scene, const ResolvedConditions& conditions, const std::set<int>& deformed,
                   const std::vector<std::vector<geometry::Screw>>& all, Leads& leads) {
    const auto is_held = [&](int part) { return twist_space(all[at(part)], screw_scale(scene)).empty(); };
    const auto is_deformed = [&](int part) { return deformed.count(part) > 0; };
    if (!std::all_of(deformed.begin(), deformed.end(), is_held)) return false;
    for (std::size_t k = 0; k < scene.supports.size(); ++k) {
        const Support& s = scene.supports[k];
        const std::set<int> parts = parts_of(scene, s, conditions.supports[k]);
        if (!leads.is_leading[k] || std::none_of(parts.begin(), parts.end(), is_deformed)) continue;
        const double far = farthest(scene, s, conditions.supports[k]);
        const auto is_little = [&](int part) {
            return is_deformed(part) && far <= placed_fraction * bounding_box(part_of(scene, part)).diagonal();
        };
        if (s.kind != Support::Kind::displacement || !std::all_of(parts.begin(), parts.end(), is_little)) return false;
        leads.is_leading[k] = false;
    }
    for (const int part : deformed) leads.of[at(part)] = {};
    return true;
}

}  // namespace

bool prescribes_motion(const Support& s) {
    if (s.kind == Support::Kind::displacement) return (s.x && !is_zero(s.value[0])) || (s.y && !is_zero(s.value[1]));
    return s.rigid_x.value_or(0) != 0 || s.rigid_y.value_or(0) != 0 || s.rigid_rotation.value_or(0) != 0;
}

Leads leads_of(const Scene& scene, const ResolvedConditions& conditions) {
    Leads leads{std::vector<Lead>(scene.parts.size()), {}};
    std::set<int> by_edges, deformed;
    for (std::size_t k = 0; k < scene.supports.size(); ++k) {
        const Support& s = scene.supports[k];
        leads.is_leading.push_back(prescribes_motion(s));
        if (!leads.is_leading.back()) continue;
        for (const int part : parts_of(scene, s, conditions.supports[k])) {
            if (s.kind == Support::Kind::rigid) {
                take_rigid(s, leads.of[at(part)]);
                continue;
            }
            by_edges.insert(part);
            if (!take_displacement(s, leads.of[at(part)])) deformed.insert(part);
        }
    }
    if (!by_edges.empty()) {
        const auto all = support_wrenches(scene, conditions);
        deformed.merge(parts_not_led(scene, conditions, leads, by_edges, all));
        if (!deformed.empty() && !hold_deformed(scene, conditions, deformed, all, leads))
            leads.why_not = "what supports prescribe deforms " + scene.parts[at(*deformed.begin())].name + ", or may turn it";
    }
    for (Lead& lead : leads.of) {
        const Vec2 way = lead.to.head<2>();
        if (way == Vec2(0, 0)) {
            if (lead.to[2] != 0) lead.way = 2;
            continue;
        }
        lead.way = way.x() != 0 ? 0 : 1;
        if (!lead.is_given[0] || !lead.is_given[1]) continue;
        lead.axis = way.normalized();
        lead.to.head<2>() = Vec2(way.norm(), 0);
        lead.way = 0;
    }
    return leads;
}

Scene without_leads(const Scene& scene, const Leads& leads) {
    Scene free = scene;
    for (std::size_t k = 0; k < free.supports.size(); ++k) {
        if (!leads.is_leading[k]) continue;
        Support& s = free.supports[k];
        s.x = s.y = false;
        s.rigid_x = s.rigid_y = s.rigid_rotation = std::nullopt;
    }
    return free;
}

}  // namespace abut

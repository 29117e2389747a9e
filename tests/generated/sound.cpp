// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generated/sound.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/extent.hpp"
#include "geometry/brep/input_error.hpp"

namespace abut::test {

namespace {

/// A force, its moment about the origin.
struct Resultant {
    Vec2 force{0, 0};
    double moment = 0;
    void add(const Vec2& f, double m) { force += f, moment += m; }
};

class Faults {
public:
    std::vector<std::string> lines{};
    void finite(double value, const std::string& what) {
        if (!std::isfinite(value)) lines.push_back(what + " is not finite");
    }
    void at_most(double value, double limit, const std::string& what) {
        if (!(value <= limit)) lines.push_back(what + " is " + std::to_string(value / limit) + " times its limit");
    }
};

void check_numbers(const Result& r, Faults& faults) {
    faults.finite(r.strain_energy, "the energy");
    for (const PartResult& p : r.parts) {
        faults.finite(p.max_displacement.value, p.name + "'s displacement");
        faults.finite(p.max_von_mises.value, p.name + "'s stress");
    }
    for (const ContactResult& c : r.contacts) {
        const std::string name = c.parts[0] + " on " + c.parts[1];
        faults.finite(c.force.sum() + c.moment + c.contact_length, name);
        for (double p : c.profile.pressure) faults.finite(p, name + "'s pressure");
        for (double g : c.profile.gap) faults.finite(g, name + "'s gap");
        const double pull = 1e-9 * std::abs(c.max_pressure.value);
        if (c.kind != "bonded" && !c.profile.pressure.empty() &&
            *std::min_element(c.profile.pressure.begin(), c.profile.pressure.end()) < -pull)
            faults.lines.push_back(name + " pulls");
    }
    for (const Reaction& s : r.reactions) faults.finite(s.force.sum() + s.moment, s.label);
    for (const ProbeResult& p : r.probes) faults.finite(p.displacement.sum() + von_mises(p.stress), "a probe");
}

double size_of(const Scene& scene) {
    geometry::Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    return box.diagonal();
}

std::string part_of(const Selection& on, const std::string& part) {
    if (on.empty()) return part;
    return on.front().part.empty() ? on.front().pattern.substr(0, on.front().pattern.find('/')) : on.front().part;
}

/// Whether the loads on a part are forces spread over its area, or none.
bool only_forces(const Scene& scene, const std::string& part) {
    return std::all_of(scene.loads.begin(), scene.loads.end(), [&](const Load& l) {
        return l.kind == Load::Kind::temperature || (!l.part.empty() && l.part != part && l.part != "*") ||
               (l.kind == Load::Kind::part_force && l.part == part) || (!l.on.empty() && part_of(l.on, "") != part);
    });
}

double thickness_of(const Scene& scene, const ContactResult& c) {
    return std::max(scene.parts[static_cast<std::size_t>(c.part[0])].thickness,
                    scene.parts[static_cast<std::size_t>(c.part[1])].thickness);
}

void check_balance_of_parts(const Scene& scene, const Result& r, double balanced, Faults& faults) {
    std::vector<Resultant> sum(r.parts.size());
    double largest = 0;
    const auto add = [&](std::size_t k, const Vec2& f, double m) {
        sum[k].add(f, m);
        largest = std::max({largest, f.norm(), std::abs(m) / size_of(scene)});
    };
    const auto index_of = [&](const std::string& name) {
        const auto found = std::find_if(r.parts.begin(), r.parts.end(), [&](const PartResult& p) { return p.name == name; });
        return static_cast<std::size_t>(found - r.parts.begin());
    };
    for (const ContactResult& c : r.contacts) {
        add(static_cast<std::size_t>(c.part[0]), c.force, c.moment);
        add(static_cast<std::size_t>(c.part[1]), -c.force, -c.moment);
        largest =
            std::max(largest, c.max_pressure.value * c.contact_length * thickness_of(scene, c));  // press fits: no resultant
    }
    for (const Reaction& s : r.reactions) {
        const Support& support = scene.supports[static_cast<std::size_t>(s.support)];
        add(index_of(part_of(support.on, support.part)), s.force, s.moment);
    }
    for (const Load& l : scene.loads) {
        if (l.kind != Load::Kind::part_force) continue;
        const std::size_t k = index_of(l.part);
        const Vec2 force(l.value[0](0, 0), l.value[1](0, 0));
        add(k, force, geometry::cross(centroid(r.geometry[k]), force));
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
        if (!r.parts[k].solved || !only_forces(scene, r.parts[k].name)) continue;
        faults.at_most(sum[k].force.norm(), balanced * largest, "the force left over on " + r.parts[k].name);
        faults.at_most(std::abs(sum[k].moment), balanced * largest * size_of(scene),
                       "the moment left over on " + r.parts[k].name);
    }
}

}  // namespace

std::vector<std::string> faults_of(const Scene& scene, const Result& r, double balanced) {
    Faults faults;
    check_numbers(r, faults);
    if (r.strain_energy < 0) faults.lines.push_back("the energy is negative");
    faults.at_most(r.equilibrium.relative_residual, balanced, "the residual of forces");
    faults.at_most(r.equilibrium.relative_moment_residual, balanced, "the residual of moments");
    for (std::size_t k = 0; k < r.parts.size(); ++k)
        faults.at_most(r.parts[k].max_displacement.value, geometry::extent(scene.parts[k].part),
                       "the displacement of " + r.parts[k].name);
    check_balance_of_parts(scene, r, balanced, faults);
    return faults.lines;
}

Answer answer_of(const Scene& scene) {
    AnalyzeOptions options;
    options.threads = 1;
    try {
        Answer a;
        a.result = analyze(scene, options);
        a.refused = a.result.status != "ok";
        a.message = a.result.message;
        return a;
    } catch (const InputError& error) { return {{}, true, error.what()}; }
}

}  // namespace abut::test

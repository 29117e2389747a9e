// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/live/live_loads.hpp"

#include <array>
#include <cstddef>

#include "src/scene/load_cases.hpp"

namespace abut {

namespace {

constexpr std::array<const char*, 2> axes{" x", " y"};

}  // namespace

bool is_live_force(const Load& load) {
    return load.kind == Load::Kind::edge_force || load.kind == Load::Kind::part_force;
}

bool keeps_its_sign(const Load& load) {
    return load.kind == Load::Kind::spin || load.kind == Load::Kind::preload;
}

Vec2 live_force(const Load& load, const std::vector<double>& moved) {
    if (moved.size() == 2) return {moved[0], moved[1]};
    return moved[0] * Vec2(load.value[0].constant(), load.value[1].constant());
}

std::vector<std::vector<double>> live_loads(const Scene& scene) {
    return std::vector<std::vector<double>>(scene.loads.size(), {1});
}

std::vector<std::vector<double>> live_loads(const Scene& scene, const LoadCase& load_case) {
    std::vector<std::vector<double>> loads = live_loads(scene);
    for (std::size_t k = 0; k < loads.size(); ++k) {
        if (scene.loads[k].name.empty()) continue;
        const auto own = load_case.factors.find(scene.loads[k].name);
        for (double& number : loads[k]) number *= own == load_case.factors.end() ? 0 : own->second;
    }
    return loads;
}

Scene scene_under(const Scene& scene, const LiveInputs& inputs) {
    Scene numbered = scene;
    LoadCase factors;
    for (std::size_t k = 0; k < scene.loads.size(); ++k) {
        Load& load = numbered.loads[k];
        load.name = std::to_string(k);
        factors.factors[load.name] = is_live_force(load) ? 1 : inputs.loads[k][0];
        const Vec2 force = is_live_force(load) ? live_force(load, inputs.loads[k]) : Vec2(0, 0);
        if (is_live_force(load)) load.value = {Expression(force.x()), Expression(force.y())};
    }
    Scene under = scene_of_case(numbered, factors);
    for (Load& load : under.loads) load.name = scene.loads[std::stoul(load.name)].name;
    under.expect.clear();
    return under;
}

Scene with_unit_loads(const Scene& scene) {
    Scene units = scene;
    units.cases.clear();
    units.expect.clear();
    units.in_steps = false;
    units.loads.clear();
    for (std::size_t k = 0; k < scene.loads.size(); ++k) {
        Load load = scene.loads[k];
        load.name = std::to_string(k);
        if (!is_live_force(load)) {
            units.loads.push_back(load);
            continue;
        }
        for (std::size_t axis = 0; axis < 2; ++axis) {
            Load one = load;
            one.name += axes[axis];
            one.value = {Expression(axis == 0 ? 1 : 0), Expression(axis == 0 ? 0 : 1)};
            units.loads.push_back(std::move(one));
        }
    }
    return units;
}

LoadFactors unit_factors(const Scene& scene, const LiveInputs& inputs) {
    LoadFactors factors;
    for (std::size_t k = 0; k < scene.loads.size(); ++k)
        if (is_live_force(scene.loads[k]))
            for (std::size_t axis = 0; axis < 2; ++axis)
                factors[std::to_string(k) + axes[axis]] =
                    live_force(scene.loads[k], inputs.loads[k])[static_cast<Eigen::Index>(axis)];
        else
            factors[std::to_string(k)] = inputs.loads[k][0];
    return factors;
}

}  // namespace abut

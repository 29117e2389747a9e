// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/load_cases.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

/// The factor of a load in a case: 1 of those without a name.
double factor_of(const Load& load, const LoadCase& c) {
    if (load.name.empty()) return 1;
    const auto factor = c.factors.find(load.name);
    return factor == c.factors.end() ? 0 : factor->second;
}

Load scaled(Load load, double factor) {
    for (Expression& value : load.value) value = value.times(factor);
    if (load.kind == Load::Kind::spin) load.omega *= std::sqrt(factor);  // never negative: the reader has seen to it
    return load;
}

bool acts_in_any(const Load& load, const Scene& scene) {
    return std::any_of(scene.cases.begin(), scene.cases.end(), [&](const LoadCase& c) { return factor_of(load, c) != 0; });
}

/// A part that is let go keeps what friction has locked in: it is solved in the steps, too, in which its loads are none. A cut
/// that is tightened by none is whole.
bool is_let_go(const Load& load, const Scene& scene) {
    return scene.in_steps && load.kind != Load::Kind::preload && acts_in_any(load, scene);
}

}  // namespace

std::string case_word(const Scene& scene) {
    return scene.in_steps ? "step" : "load case";
}

LoadCase between(const LoadCase& from, const LoadCase& to, double fraction) {
    LoadCase c = to;
    for (auto& [name, factor] : c.factors) factor *= fraction;
    for (const auto& [name, factor] : from.factors) c.factors[name] += (1 - fraction) * factor;
    return c;
}

Scene scene_of_case(const Scene& scene, const LoadCase& c) {
    Scene own = scene;
    own.cases.clear();
    own.loads.clear();
    for (const Load& load : scene.loads)
        if (const double factor = factor_of(load, c); factor == 1)
            own.loads.push_back(load);
        else if (factor != 0 || is_let_go(load, scene))
            own.loads.push_back(scaled(load, factor));
    std::erase_if(own.expect, [&](const Expectation& e) { return e.in_case != c.name; });
    return own;
}

std::vector<Load> acting_loads(const Scene& scene) {
    std::vector<Load> loads;
    for (const Load& load : scene.loads)
        if (acts_in_any(load, scene)) loads.push_back(load);
    return loads;
}

const LoadCase& case_named(const Scene& scene, const std::string& name) {
    if (scene.in_steps)
        throw InputError(scene.file + " /steps", "steps follow each other: none is answered alone", "leave the name out");
    std::vector<std::string> known;
    for (const LoadCase& c : scene.cases) {
        if (c.name == name) return c;
        known.push_back(c.name);
    }
    throw InputError(scene.file + " /cases", "there is no " + case_word(scene) + " '" + shortened(name) + "'",
                     known.empty() ? "the scene has none" : nearest_name_hint(name, known));
}

void refuse_cases(const Scene& scene) {
    if (scene.cases.empty()) return;
    throw InputError(scene.file + (scene.in_steps ? " /steps" : " /cases"),
                     "the scene has " + case_word(scene) + "s: which one is meant is not said",
                     "abut analyze answers all of them, or one with --case NAME");
}

}  // namespace abut

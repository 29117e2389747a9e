// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/session/session.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"

namespace abut {

struct Session::State {
    Scene scene;
    AnalyzeOptions options;
    LoadFactors factors = factors_of_loads(scene);
    std::optional<PreparedScene> prepared{};

    PreparedScene& ready() {
        if (!prepared || !prepared->needs_preparing(factors).empty()) prepared.emplace(scene, factors, options);
        return *prepared;
    }
};

Session::Session(const std::string& path, AnalyzeOptions options) : Session(read_scene(path), std::move(options)) {}
Session::Session(Scene scene, AnalyzeOptions options)
    : state_(std::make_unique<State>(State{std::move(scene), std::move(options)})) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

const Scene& Session::scene() const {
    return state_->scene;
}

const LoadFactors& Session::loads() const {
    return state_->factors;
}

void Session::set_load(const std::string& name, double factor) {
    State& s = *state_;
    const std::string where = s.scene.file + " /loads";
    const auto known = s.factors.find(name);
    if (known == s.factors.end()) {
        std::vector<std::string> names;
        for (const auto& [of_load, value] : s.factors) names.push_back(of_load);
        throw InputError(where, "no load has the name '" + shortened(name) + "'",
                         names.empty() ? "give loads a \"name\"" : nearest_name_hint(name, names));
    }
    if (!std::isfinite(factor))
        throw InputError(where, "the factor of load '" + shortened(name) + "' is no number", "give a finite one");
    const auto spins = [&](const Load& load) { return load.name == name && load.kind == Load::Kind::spin; };
    if (factor < 0 && std::any_of(s.scene.loads.begin(), s.scene.loads.end(), spins))
        throw InputError(where, "a spin cannot pull inwards: the factor of load '" + shortened(name) + "' is negative",
                         "the factor is of the load, which grows with the square of the speed");
    known->second = factor;
}

void Session::set_case(const std::string& name) {
    const LoadCase& c = case_named(state_->scene, name);
    for (auto& [load, factor] : state_->factors) {
        const auto own = c.factors.find(load);
        factor = own == c.factors.end() ? 0 : own->second;
    }
}

const Result& Session::prepare() {
    state_->prepared.emplace(state_->scene, state_->factors, state_->options);
    return state_->prepared->result();
}

Answer Session::answer() {
    return state_->ready().answer(state_->factors);
}

const Result& Session::result() {
    State& s = *state_;
    return s.prepared && s.prepared->factors() == s.factors ? s.prepared->result() : prepare();
}

std::vector<PartField> Session::fields() {
    PreparedScene& prepared = state_->ready();
    if (prepared.answer(state_->factors).status != "ok") return {};
    return prepared.fields();
}

}  // namespace abut

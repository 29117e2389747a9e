// SPDX-License-Identifier: GPL-3.0-or-later
// A scene to ask again and again under other loads.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "src/session/prepared_scene.hpp"

namespace abut {

/// A scene with factors of its named loads. What does not depend on the factors is computed once, by prepare() or the first
/// question; answers on it take milliseconds. Grids and interfaces stay those of the factors prepared: answers say where
/// contact goes beyond what they were made for, and prepare() makes new ones. A session belongs to one thread at a time.
class Session {
public:
    /// Reads a scene or a drawing's scene file. Throws InputError with every problem found.
    explicit Session(const std::string& path, AnalyzeOptions options = {});
    explicit Session(Scene scene, AnalyzeOptions options = {});
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    const Scene& scene() const;
    /// The factors by name of load: 1 of each at first. Loads without a name act always.
    const LoadFactors& loads() const;
    /// Sets the factor of all loads of a name. Throws InputError for names that no load has, and for negative factors of a
    /// spin.
    void set_load(const std::string& name, double factor);
    /// Sets the factors to those of one of the scene's load cases: 0 of those that it does not name.
    void set_case(const std::string& name);

    /// Analyses the scene under the present factors, with grids and interfaces of their own. Seconds.
    const Result& prepare();
    /// Answers the present factors. Milliseconds; where nothing is prepared that could answer them, prepares first (a
    /// temperature or preload has another factor, a load acts on a part that nothing acted on). With friction every answer is
    /// one step from where parts are drawn, as `analyze` has it: no answer remembers another.
    Answer answer();
    /// The whole result under the present factors; prepares them if others are prepared.
    const Result& result();
    /// The displacements and stresses under the present factors, by part of the result, on what is prepared. Tenths of seconds.
    /// Empty where the answer has failed.
    std::vector<PartField> fields();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace abut

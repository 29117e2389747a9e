// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that was analysed once, ready to answer its named loads at other factors on the same grids and interfaces.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/analysis/analyze_options.hpp"
#include "src/scene/scene.hpp"
#include "src/session/answer.hpp"

namespace abut {

/// Factors by the names of loads. Loads without a name act always.
using LoadFactors = std::map<std::string, double>;
/// The factors of a scene's named loads: 1 of each.
LoadFactors factors_of_loads(const Scene& scene);

/// The analysis of a scene under given factors, with the answers that it makes cheap.
class PreparedScene {
public:
    /// Analyses the scene as `analyze` does, under these factors of all named loads. Its cases are not read. Throws InputError
    /// as `analyze` does.
    PreparedScene(const Scene& scene, const LoadFactors& factors, const AnalyzeOptions& options);
    PreparedScene(PreparedScene&&) noexcept;
    PreparedScene& operator=(PreparedScene&&) noexcept;
    ~PreparedScene();

    const LoadFactors& factors() const;  ///< that it was prepared under
    const Result& result() const;        ///< under these
    /// Why factors cannot be answered without preparing them; empty: they can. Temperatures are in a part's stiffness
    /// equations, and a part that nothing acted on has no grid.
    std::string needs_preparing(const LoadFactors& factors) const;
    /// Answers factors that need no preparing. Cost: the contact problem alone.
    Answer answer(const LoadFactors& factors);
    /// The displacements and stresses of the last answer, by part of the result; empty of parts that are not computed. Cost: a
    /// solution and a smoothing of the stresses of every part. After an answer that is "ok" only.
    std::vector<PartField> fields() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace abut

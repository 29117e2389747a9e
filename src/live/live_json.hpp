// SPDX-License-Identifier: GPL-3.0-or-later
// What pages are told and what they ask, as JSON text.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "src/live/live_loads.hpp"
#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"
#include "src/scene/parameter_range.hpp"
#include "src/session/answer.hpp"

namespace abut {

/// What a page may move, and what of its scene it is told.
struct LiveControls {
    std::vector<ParameterRange> parameters;
    std::vector<LoadFacts> loads;  ///< as the scene gives them
    std::vector<LiveSetting> settings{};
    double target = 0;       ///< the accuracy asked for
    bool remembers = false;  ///< the scene has steps, which are answered here each by itself
};

/// What can be moved in a scene: parameters with a range, loads, settings.
std::string controls_json(const Scene& scene, const LiveControls& controls);
/// client: who moved them; empty: the scene's file.
std::string inputs_json(const LiveInputs& inputs, const std::string& client, long version);
/// The analysis of a scene; result: with the marks and under the title of the scene as it was drawn.
std::string whole_json(const Result& result, const ModelFacts& model, bool is_draft, const LiveSettings& settings,
                       long version);
std::string answer_json(const Answer& answer, long version);
std::string fields_json(const Result& prepared, const std::vector<PartField>& fields, long version);
/// {"edges", "supports", "loads"}: the edges of all parts with their names, as polylines; supports and loads as the scene's
/// text has them.
std::string edges_json(const Scene& scene, const std::string& text);
std::string problems_json(const std::vector<Problem>& problems);
std::string saved_json(const std::string& path);

/// What a page asks for.
struct LiveRequest {
    std::string client;
    long after = 0;
    LiveInputs inputs;  ///< those before with what was moved
};
/// Reads {"client", "after", "parameters", "loads", "settings"}. Throws InputError where the text is anything else, or where
/// numbers do not fit the scene.
LiveRequest read_live_request(const std::string& text, const Scene& scene, const LiveControls& controls,
                              const LiveInputs& before);
/// Reads {"supports", "loads"}: lists as a scene has them, as changes of its text. Throws InputError where they are no lists.
std::map<std::string, std::string> read_conditions_request(const std::string& text);
/// A text as JSON.
std::string json_text(const std::string& words);
/// Reads {"name"}: a plain file name that ends in .json. Throws InputError.
std::string read_save_request(const std::string& text);

/// The text of the scene's file with other numbers.
std::string scene_text_with(const std::string& text, const Scene& scene, const LiveControls& controls,
                            const LiveInputs& inputs);

}  // namespace abut

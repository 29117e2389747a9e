// SPDX-License-Identifier: GPL-3.0-or-later
// contacts.json, which data/schema/contacts.schema.json describes.
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/contact/detect.hpp"
#include "src/results/functional_json.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    if (!std::isfinite(value)) return nullptr;
    return value == 0 ? 0.0 : value;  // no "-0.0"
}

Json names(const std::vector<std::string>& list) {
    return list.empty() ? Json::array() : Json(list);
}

Json pair_json(const DetectedPair& p, bool near_miss) {
    Json json{{"parts", Json::array({p.parts[0], p.parts[1]})},
              {"between", Json::array({p.between[0], p.between[1]})},
              {"edges", Json::array({names(p.edges[0]), names(p.edges[1])})},
              {"status", p.status},
              {"interface", p.interface},
              {"gap", {{"min", number(p.gap_min)}, {"max", number(p.gap_max)}}},
              {"overlap_area", number(p.overlap_area)},
              {"length", number(p.length)},
              {"shared_length", number(p.shared_length)},
              {"cells_case", p.cells_case},
              {"why", p.why}};
    if (!near_miss) json["functional_interface"] = Json::parse(functional_json(p.functional));
    return json;
}

Json pairs_json(const std::vector<DetectedPair>& pairs, bool near_misses) {
    Json list = Json::array();
    for (const DetectedPair& p : pairs) list.push_back(pair_json(p, near_misses));
    return list;
}

}  // namespace

std::string detection_json(const Scene& scene, const Detection& detection) {
    Json json{{"abut", 1},
              {"unit", scene.length_unit},
              {"pairs", pairs_json(detection.pairs, false)},
              {"near_misses", pairs_json(detection.near_misses, true)},
              {"warnings", names(scene.warnings)}};
    for (const ScenePart& part : scene.parts)
        if (!part.level.empty()) json["levels"][part.name] = part.level;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace abut

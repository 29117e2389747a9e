// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/functional_json.hpp"

#include <nlohmann/json.hpp>

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json components(const Vector& v) {
    Json list = Json::array();
    for (const double value : v) list.push_back(value == 0 ? 0.0 : value);  // no "-0.0"
    return list;
}

Json screws(const std::vector<Screw>& list) {
    Json json = Json::array();
    for (const Screw& s : list) json.push_back(components(s));
    return json;
}

Json part_json(const PartMobility& p) {
    Json free = Json::array();
    for (std::size_t k = 0; k < p.free.size(); ++k)
        free.push_back({{"twist", components(p.free[k])}, {"motion", p.motions[k]}});
    return {{"part", p.part}, {"wrenches", screws(p.wrenches)}, {"twists", screws(p.twists)}, {"free", free}};
}

}  // namespace

std::string functional_json(const FunctionalInterface& f) {
    Json json{{"kind", f.kind}};
    if (f.diameter[0] || f.diameter[1]) {
        json["diameters"] = Json::array();
        for (const auto& d : f.diameter) json["diameters"].push_back(d ? Json(*d) : Json(nullptr));
    }
    if (f.clearance) json["clearance"] = *f.clearance;
    if (f.center) json["center"] = components(*f.center);
    if (f.at) json["at"] = components(*f.at);
    if (f.normal) json["normal"] = components(*f.normal);
    json["wrenches"] = screws(f.wrenches);
    json["twists"] = screws(f.twists);
    return json.dump();
}

std::string mobility_json(const MobilityResult& m) {
    Json parts = Json::array();
    for (const PartMobility& p : m.parts) parts.push_back(part_json(p));
    const Json json{
        {"degrees_of_freedom", m.degrees_of_freedom}, {"gruebler", m.gruebler}, {"redundant", m.redundant}, {"parts", parts}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace abut

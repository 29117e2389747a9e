// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_geometry.hpp"

#include <utility>

#include "src/scene/read_general_edges.hpp"
#include "src/scene/read_loops.hpp"

namespace abut {

namespace {

using geometry::CsgNode;
using Shape = decltype(CsgNode::shape);
using Reader = std::optional<Shape> (*)(SceneReading&, Imports&, const JsonValue&);

std::optional<Shape> read_rectangle(SceneReading& reading, Imports&, const JsonValue& value) {
    if (!check_object(reading, value, {"min", "max"})) return std::nullopt;
    const auto min = required_member(reading, value, "min", read_vector, dimension::length),
               max = required_member(reading, value, "max", read_vector, dimension::length);
    if (!min || !max) return std::nullopt;
    if (min->x() < max->x() && min->y() < max->y()) return geometry::Rectangle{*min, *max};
    report_problem(reading, value, "the rectangle has no area",
                   "both coordinates of 'max' must be greater than those of 'min'");
    return std::nullopt;
}

std::optional<Shape> read_circle(SceneReading& reading, Imports&, const JsonValue& value) {
    if (!check_object(reading, value, {"center", "radius"})) return std::nullopt;
    const auto center = required_member(reading, value, "center", read_vector, dimension::length);
    const auto radius = required_member(reading, value, "radius", read_positive, dimension::length);
    if (!center || !radius) return std::nullopt;
    return geometry::Circle{*center, *radius};
}

std::optional<Shape> read_ellipse(SceneReading& reading, Imports&, const JsonValue& value) {
    if (!check_object(reading, value, {"center", "radii", "angle"})) return std::nullopt;
    const auto center = required_member(reading, value, "center", read_vector, dimension::length),
               radii = required_member(reading, value, "radii", read_radii);
    const double angle = member_or(reading, value, "angle", 0.0, read_number, dimension::angle);
    if (!center || !radii) return std::nullopt;
    return geometry::Ellipse{*center, *radii, angle};
}

std::optional<Shape> read_slot(SceneReading& reading, Imports&, const JsonValue& value) {
    if (!check_object(reading, value, {"from", "to", "radius"})) return std::nullopt;
    const auto from = required_member(reading, value, "from", read_vector, dimension::length),
               to = required_member(reading, value, "to", read_vector, dimension::length);
    const auto radius = required_member(reading, value, "radius", read_positive, dimension::length);
    if (!from || !to || !radius) return std::nullopt;
    if (*from != *to) return geometry::Slot{*from, *to, *radius};
    report_problem(reading, value, "the slot begins where it ends", "move 'from' or 'to', or write a 'circle'");
    return std::nullopt;
}

std::optional<Shape> read_polygon(SceneReading& reading, Imports&, const JsonValue& value) {
    if (!check_list(reading, value, 3, "points")) return std::nullopt;
    geometry::Polygon polygon;
    for (const JsonValue& item : value.items) {
        if (const auto point = read_vector(reading, item, dimension::length)) polygon.points.push_back(*point);
    }
    if (polygon.points.size() != value.items.size()) return std::nullopt;
    return polygon;
}

std::optional<Shape> read_half_plane(SceneReading& reading, Imports&, const JsonValue& value) {
    if (!check_object(reading, value, {"point", "normal"})) return std::nullopt;
    const auto point = required_member(reading, value, "point", read_vector, dimension::length);
    const auto normal = required_member(reading, value, "normal", read_direction);
    if (!point || !normal) return std::nullopt;
    return geometry::HalfPlane{*point, *normal};
}

template <class Operation>
std::optional<Shape> read_operation(SceneReading& reading, Imports& imports, const JsonValue& value) {
    if (!check_list(reading, value, 1, "geometry nodes")) return std::nullopt;
    Operation operation;
    for (const JsonValue& item : value.items) {
        if (auto node = read_geometry(reading, imports, item)) operation.of.push_back(std::move(*node));
    }
    if (operation.of.size() != value.items.size()) return std::nullopt;
    return operation;
}

std::optional<Shape> read_placed(SceneReading& reading, Imports& imports, const JsonValue& value) {
    Words keys = place_keys();
    keys.insert(keys.begin(), "of");
    if (!check_object(reading, value, keys)) return std::nullopt;
    const JsonValue* of = required(reading, value, "of");
    std::optional<CsgNode> child = of ? read_geometry(reading, imports, *of) : std::nullopt;
    // Without a child the rest is still read, for its problems.
    const bool complete = child.has_value();
    std::optional<CsgNode> placed = read_place(reading, value, complete ? std::move(*child) : CsgNode{});
    if (!complete || !placed) return std::nullopt;
    return std::move(placed->shape);
}

std::optional<Shape> read_loops_node(SceneReading& reading, Imports&, const JsonValue& value) {
    auto loops = read_loops(reading, value);
    if (!loops) return std::nullopt;
    return std::move(*loops);
}

std::optional<Shape> read_dxf_node(SceneReading& reading, Imports& imports, const JsonValue& value) {
    auto part = import_part(reading, imports, value);
    if (!part) return std::nullopt;
    return std::move(*part);
}

template <BodiesOf bodies>
std::optional<Shape> read_body_node(SceneReading& reading, Imports& imports, const JsonValue& value) {
    auto part = import_body(reading, imports, value, bodies);
    if (!part) return std::nullopt;
    return std::move(*part);
}

struct NodeKind {
    const char* key;
    Reader read;
};
constexpr NodeKind node_kinds[] = {
    {"rectangle", read_rectangle},
    {"circle", read_circle},
    {"ellipse", read_ellipse},
    {"slot", read_slot},
    {"polygon", read_polygon},
    {"half_plane", read_half_plane},
    {"union", read_operation<geometry::Union>},
    {"intersection", read_operation<geometry::Intersection>},
    {"difference", read_operation<geometry::Difference>},
    {"place", read_placed},
    {"loops", read_loops_node},
    {"dxf", read_dxf_node},
    {"mesh", read_body_node<BodiesOf::mesh>},
    {"step", read_body_node<BodiesOf::step>},
};

std::optional<geometry::Mirror> read_mirror(SceneReading& reading, const JsonValue& value) {
    const auto axis = read_word(reading, value, {"x", "y"});
    if (!axis) return std::nullopt;
    return *axis == "x" ? geometry::Mirror::x : geometry::Mirror::y;
}

std::vector<std::string> node_keys() {
    std::vector<std::string> keys;
    for (const NodeKind& kind : node_kinds) keys.emplace_back(kind.key);
    return keys;
}

}  // namespace

const Words& place_keys() {
    static const Words keys{"scale", "mirror", "rotate", "translate", "about"};
    return keys;
}

std::optional<CsgNode> read_place(SceneReading& reading, const JsonValue& place, CsgNode child) {
    const std::size_t before = reading.problems.size();
    geometry::Placed placed;
    placed.of.push_back(std::move(child));
    placed.scale = member_or(reading, place, "scale", 1.0, read_positive, dimension::none);
    placed.mirror = member_or(reading, place, "mirror", geometry::Mirror::none, read_mirror);
    placed.rotate = member_or(reading, place, "rotate", 0.0, read_number, dimension::angle);
    placed.translate = member_or(reading, place, "translate", Vec2(0, 0), read_vector, dimension::length);
    placed.about = member_or(reading, place, "about", Vec2(0, 0), read_vector, dimension::length);
    if (reading.problems.size() > before) return std::nullopt;
    return CsgNode{std::move(placed), "", place.pointer};
}

std::optional<CsgNode> read_geometry(SceneReading& reading, Imports& imports, const JsonValue& node) {
    static const std::vector<std::string> keys = node_keys();
    Words words = keys;
    words.emplace_back("name");
    const std::size_t before = reading.problems.size();
    if (!check_object(reading, node, words)) return std::nullopt;
    if (reading.problems.size() > before)
        return std::nullopt;  // a misspelt or later node: "nothing says what this is" adds nothing
    const std::string name = read_edge_prefix(reading, node);
    const JsonValue* value = exactly_one(reading, node, keys);
    if (!value) return std::nullopt;
    for (const NodeKind& kind : node_kinds) {
        if (value->key != kind.key) continue;
        std::optional<Shape> shape = kind.read(reading, imports, *value);
        if (!shape || reading.problems.size() > before) return std::nullopt;
        return CsgNode{std::move(*shape), name, value->pointer};
    }
    return std::nullopt;
}

}  // namespace abut

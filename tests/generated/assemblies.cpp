// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generated/assemblies.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

namespace abut::test {

namespace {

using Json = nlohmann::json;
using std::numbers::pi;

/// The standard's distributions differ between libraries; the generator does not.
class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    double unit() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }
    double between(double a, double b) { return a + (b - a) * unit(); }
    double log_between(double a, double b) { return a * std::pow(b / a, unit()); }
    int index(int n) { return static_cast<int>(n * unit()); }
    bool chance(double p) { return unit() < p; }

private:
    std::mt19937_64 bits_;
};

Json point(double x, double y) {
    return Json::array({x, y});
}
Json rectangle(double x0, double y0, double x1, double y1) {
    return {{"rectangle", {{"min", point(x0, y0)}, {"max", point(x1, y1)}}}};
}
Json circle(double x, double y, double r) {
    return {{"circle", {{"center", point(x, y)}, {"radius", r}}}};
}
Json polygon(const std::vector<std::array<double, 2>>& points) {
    Json list = Json::array();
    for (const auto& p : points) list.push_back(point(p[0], p[1]));
    return {{"polygon", list}};
}
Json named(const std::string& name, Json node) {
    node["name"] = name;
    return node;
}
Json difference(const Json& a, const Json& b) {
    return {{"difference", Json::array({a, b})}};
}
Json intersection(const Json& a, const Json& b) {
    return {{"intersection", Json::array({a, b})}};
}
Json ring(double x, double y, double outer, double inner) {
    return difference(named("o", circle(x, y, outer)), named("i", circle(x, y, inner)));
}

/// Kinds draw different numbers from one seed (FNV-1a of the name: a seed gives the same
/// assembly for ever, whatever library hashes otherwise).
std::uint64_t mixed(const std::string& kind, std::uint64_t seed) {
    std::uint64_t h = 14695981039346656037U;
    for (const char c : kind + std::to_string(seed)) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return h;
}

/// A scene in the making, with what all kinds draw alike.
class Draft {
public:
    Draft(const std::string& kind, std::uint64_t seed) : random(mixed(kind, seed)) {
        scene = {{"abut", 1},
                 {"title", kind + " " + std::to_string(seed)},
                 {"analysis", random.chance(0.5) ? "plane_stress" : "plane_strain"},
                 {"thickness", std::round(random.between(1, 20))},
                 {"materials",
                  {{"steel", {{"E", 210000}, {"nu", 0.3}}},
                   {"brass", {{"E", 100000}, {"nu", 0.34}}},
                   {"aluminium", {{"E", 70000}, {"nu", 0.33}}}}},
                 {"parts", Json::array()},
                 {"supports", Json::array()},
                 {"loads", Json::array()},
                 {"output", {{"formats", {"json"}}}}};
    }
    void part(const std::string& name, const Json& geometry) {
        const std::array<const char*, 3> materials{"steel", "brass", "aluminium"};
        const auto material = static_cast<std::size_t>(std::max(0, random.index(5) - 2));  // steel mostly
        scene["parts"].push_back({{"name", name}, {"material", materials[material]}, {"geometry", geometry}});
    }
    void fix(const std::string& on) { scene["supports"].push_back({{"on", on}, {"fix", {"x", "y"}}}); }
    void roller(const std::string& on) { scene["supports"].push_back({{"on", on}, {"symmetry", true}}); }
    void spring(const std::string& on, double k) {
        scene["supports"].push_back({{"on", on}, {"spring", {{"normal", k}, {"tangential", k}}}});
    }
    void upright(const std::string& part) {
        scene["supports"].push_back(
            {{"part", part}, {"rigid", {{"translation", Json::array({nullptr, nullptr})}, {"rotation", 0}}}});
    }
    void centred(const std::string& part) {
        scene["supports"].push_back({{"part", part}, {"rigid", {{"translation", Json::array({0, 0})}, {"rotation", 0}}}});
    }
    void force(const std::string& part, double x, double y) {
        scene["loads"].push_back({{"part", part}, {"force", point(x, y)}});
    }
    void force_on(const std::string& on, double x, double y) { scene["loads"].push_back({{"on", on}, {"force", point(x, y)}}); }
    void press_on(const std::string& on, double pressure) { scene["loads"].push_back({{"on", on}, {"pressure", pressure}}); }
    double thickness() const { return scene["thickness"].get<double>(); }
    /// A force that presses cylinders of this relative radius together to a largest pressure of 0.2 to 2 % of E.
    double force_on_radius(double r) {
        constexpr double e_star = 1e5;  // MPa, of two steel parts about
        const double share = random.log_between(0.002, 0.02);
        return thickness() * pi * r * share * share * e_star;
    }

    Random random;
    Json scene{};
};

void plate_on_rollers(Draft& d) {
    Random& at = d.random;
    const int n = 2 + at.index(3);
    const double r = at.between(5, 20), step = at.between(2.2, 4) * r, half = 0.5 * n * step;
    d.part("plate", rectangle(-half, 0, half, at.between(0.5, 2) * r));
    for (int k = 0; k < n; ++k) {
        const double low = at.chance(0.5) ? 0 : at.between(0, 2e-4) * r;
        const std::string name = "r" + std::to_string(k);
        d.part(name, ring((k - 0.5 * (n - 1)) * step, -r - low, r, 0.4 * r));
        d.fix(name + "/i/circle");
    }
    if (at.chance(0.5))
        d.roller("plate/left");
    else
        d.spring("plate/right", at.log_between(0.1, 10));
    d.force_on("plate/top", 0, -n * d.force_on_radius(r));
}

void plate_on_discs(Draft& d) {
    Random& at = d.random;
    const int n = 2 + at.index(3);
    const double r = at.between(5, 20), step = at.between(2.3, 3.5) * r, half = 0.5 * n * step;
    d.part("base", rectangle(-half, -2 * r, half, 0));
    for (int k = 0; k < n; ++k) {
        const double radius = r * (1 - (k == 0 || at.chance(0.5) ? 0 : at.between(0, 1e-4)));
        d.part("d" + std::to_string(k), circle((k - 0.5 * (n - 1)) * step, radius, radius));
    }
    d.part("plate", rectangle(-half, 2 * r, half, (2 + at.between(0.7, 2)) * r));
    d.fix("base/bottom");
    d.roller("plate/left");
    d.press_on("plate/top", n * d.force_on_radius(r) / (2 * half * d.thickness()));
}

void filleted_block(Draft& d) {
    Random& at = d.random;
    const double w = at.between(5, 20), r = at.log_between(0.05, 0.4) * w, h = r + at.between(0.5, 1.2) * w;
    const double middle = at.chance(0.3) ? 0 : at.between(-0.25, 0.25) * w, reach = at.between(0.2, 0.6) * w;
    d.part("base", rectangle(-4 * w, -3 * w, 4 * w, 0));
    const Json top = polygon({{-w, r}, {w, r}, {w, h}, {middle + reach, h}, {middle - reach, h}, {-w, h}});
    const Json foot = {{"slot", {{"from", point(r - w, r)}, {"to", point(w - r, r)}, {"radius", r}}}};
    d.part("block", {{"union", Json::array({named("t", top), named("s", foot)})}});
    d.fix("base/bottom");
    if (at.chance(0.3)) d.upright("block");
    d.press_on("block/t/e3", at.log_between(20, 300));
}

void crowned_block(Draft& d) {
    Random& at = d.random;
    const double w = at.between(5, 20), r = at.log_between(1.5, 30) * w;
    d.part("base", rectangle(-3 * w, -3 * w, 3 * w, 0));
    d.part("block", intersection(circle(0, r, r), named("b", rectangle(-w, -1, w, 1.5 * w))));
    d.fix("base/bottom");
    if (at.chance(0.5))
        d.roller("block/b/left");
    else
        d.upright("block");
    d.force_on("block/b/top", 0, -std::min(d.force_on_radius(r), 200 * w * d.thickness()));
}

void pin_in_hole(Draft& d) {
    Random& at = d.random;
    const double r = at.between(5, 20), clearance = at.log_between(1e-4, 0.1) * r, size = at.between(1.8, 4) * r;
    const double drawn = at.chance(0.3) ? 0 : clearance * at.between(0, 0.999), towards = at.between(0, 2 * pi);
    const double loaded = at.between(0, 2 * pi);
    d.part("plate", difference(named("b", rectangle(-size, -size, size, size)), named("h", circle(0, 0, r))));
    d.part("pin", circle(drawn * std::cos(towards), drawn * std::sin(towards), r - clearance));
    d.fix("plate/b/bottom");
    const double force = std::min(d.force_on_radius(r * r / clearance), 40 * r * d.thickness());
    d.force("pin", force * std::cos(loaded), force * std::sin(loaded));
}

void ring_between_plates(Draft& d) {
    Random& at = d.random;
    const double r = at.between(5, 20);
    d.part("base", rectangle(-3 * r, -2 * r, 3 * r, 0));
    d.part("ring", ring(0, r, r, at.between(0.3, 0.75) * r));
    d.part("plate", rectangle(-2 * r, 2 * r, 2 * r, 3 * r));
    d.fix("base/bottom");
    d.roller("plate/left");
    d.force_on("plate/top", 0, -0.1 * d.force_on_radius(r));
}

/// Below y = 0, opening upwards with this half angle, its tip cut off.
Json groove(double half_width, double depth, double half_angle, double floor) {
    const double t = std::tan(half_angle);
    return polygon({{-half_width, -2 * half_width},
                    {half_width, -2 * half_width},
                    {half_width, 0},
                    {floor + depth * t, 0},
                    {floor, -depth},
                    {-floor, -depth},
                    {-floor - depth * t, 0},
                    {-half_width, 0}});
}

void wedge_in_groove(Draft& d) {
    Random& at = d.random;
    const double w = at.between(10, 30), half_angle = at.between(20, 45) * pi / 180, t = std::tan(half_angle);
    const double depth = at.between(0.4, 0.7) * w, floor = at.between(0.05, 0.2) * w, tip = 0.8 * depth, up = 0.5 * w;
    d.part("base", groove(3 * w, depth, half_angle, floor));
    const double low = floor + (depth - tip) * t, high = floor + (depth + up) * t;
    d.part("wedge", polygon({{-low, -tip}, {low, -tip}, {high, up}, {-high, up}}));
    d.fix("base/e0");
    d.force_on("wedge/e2", 0, -at.log_between(10, 100) * w * d.thickness());
}

void disc_in_groove(Draft& d) {
    Random& at = d.random;
    const double r = at.between(5, 20), half_angle = at.between(25, 60) * pi / 180, t = std::tan(half_angle);
    // touches both sides where the normals through the centre meet them, half way up
    const double floor = 0.2 * r, half_way = r * std::cos(half_angle), depth = 2 * (half_way - floor) / t;
    const double centre = -depth - floor / t + r / std::sin(half_angle);
    d.part("base", groove(4 * r + depth * t, depth, half_angle, floor));
    d.part("disc", circle(0, centre, r));
    d.fix("base/e0");
    const double force = d.force_on_radius(r), lean = at.between(-0.6, 0.6) * (0.5 * pi - half_angle);
    d.force("disc", force * std::sin(lean), -force * std::cos(lean));
}

void disc_in_box(Draft& d) {
    Random& at = d.random;
    const double r = at.between(5, 20), play = at.chance(0.4) ? 0 : at.log_between(1e-5, 1e-2) * r,
                 wall = at.between(0.6, 1.5) * r;
    const double in = r + play, out = in + wall, top = at.between(1.5, 2.5) * r;
    d.part("box", polygon({{-out, -r}, {out, -r}, {out, top}, {in, top}, {in, 0}, {-in, 0}, {-in, top}, {-out, top}}));
    d.part("disc", circle(0, r, r));
    d.fix("box/e0");
    const double force = d.force_on_radius(r);
    d.force("disc", at.between(0.1, 0.8) * force * (at.chance(0.5) ? 1 : -1), -force);
}

/// Two discs on the floor of a box, at its walls, and one on top of them.
void pile(Draft& d) {
    Random& at = d.random;
    const double r1 = at.between(8, 15), r2 = at.between(8, 15), gap = at.between(0.3, 1.2) * std::min(r1, r2);
    const double width = 2 * r1 + gap + 2 * r2, wall = 10, x1 = r1, x2 = width - r2;
    const double r3 = at.between(8, 15);
    // the third one's centre, from its distances to the others'
    const double dx = x2 - x1, dy = r2 - r1, apart = std::hypot(dx, dy), a = r1 + r3, b = r2 + r3;
    const double along = (a * a - b * b + apart * apart) / (2 * apart), across = std::sqrt(a * a - along * along);
    const double x3 = x1 + (along * dx - across * dy) / apart, y3 = r1 + (along * dy + across * dx) / apart;
    d.part("box", polygon({{-wall, -wall},
                           {width + wall, -wall},
                           {width + wall, 30},
                           {width, 30},
                           {width, 0},
                           {0, 0},
                           {0, 30},
                           {-wall, 30}}));
    d.part("d1", circle(x1, r1, r1));
    d.part("d2", circle(x2, r2, r2));
    d.part("d3", circle(x3, y3, r3));
    d.fix("box/e0");
    d.force("d3", 0, -d.force_on_radius(10));
}

void punch(Draft& d) {
    Random& at = d.random;
    const double w = at.between(5, 20), h = at.between(0.6, 2) * w, middle = at.between(-0.2, 0.2) * w, reach = 0.3 * w;
    d.part("base", rectangle(-4 * w, -3 * w, 4 * w, 0));
    d.part("punch", polygon({{-w, 0}, {w, 0}, {w, h}, {middle + reach, h}, {middle - reach, h}, {-w, h}}));
    d.fix("base/bottom");
    d.press_on("punch/e3", at.log_between(20, 300));
}

void stack(Draft& d) {
    Random& at = d.random;
    const int n = 2 + at.index(3);
    double w = at.between(15, 30), y = 0;
    d.part("base", rectangle(-2 * w, -w, 2 * w, 0));
    d.fix("base/bottom");
    for (int k = 0; k < n; ++k) {
        w *= at.between(0.6, 0.9);
        const double h = at.between(0.3, 0.8) * w, shift = k == 0 ? 0 : at.between(-0.1, 0.1) * w;
        d.part("s" + std::to_string(k), rectangle(shift - w, y, shift + w, y + h));
        y += h;
    }
    d.force("s" + std::to_string(n - 1), 0, -at.log_between(10, 100) * w * d.thickness());
}

void beam_on_stops(Draft& d) {
    Random& at = d.random;
    const int n = 1 + at.index(3);
    const double length = at.between(60, 150), h = length / at.between(8, 20), r = at.between(5, 20);
    const double sag = at.log_between(0.02, 0.5), load = sag * 210000 * d.thickness() * std::pow(h / length, 3) / 4;
    d.part("beam", rectangle(0, 0, length, h));
    d.fix("beam/left");
    for (int k = 0; k < n; ++k) {
        const double x = length * (k + at.between(0.7, 1)) / n * 0.95, s = x / length;
        const double gap = at.between(0.1, 0.7) * 0.5 * sag * s * s * (3 - s), top = -gap;
        const std::string name = "stop" + std::to_string(k);
        d.part(name,
               intersection(circle(x, top - r, r), named("b", rectangle(x - 0.5 * r, top - 0.6 * r, x + 0.5 * r, top + r))));
        d.fix(name + "/b/bottom");
    }
    d.force_on("beam/right", 0, -load);
}

void press_fit(Draft& d) {
    Random& at = d.random;
    const bool three = at.chance(0.5);
    const double r = at.between(5, 20), bore = at.between(0.2, 0.6) * r;
    double outer = r, inner = bore;
    d.part("shaft", ring(0, 0, outer, inner));
    for (int k = 0; k < (three ? 2 : 1); ++k) {
        inner = outer - at.log_between(1e-4, 2e-3) * r;
        outer = inner + at.between(0.2, 0.6) * r;
        const bool is_last = k == (three ? 1 : 0);
        const double half = outer + 0.3 * r;
        d.part("ring" + std::to_string(k),
               is_last && at.chance(0.4) ? difference(rectangle(-half, -half, half, half), named("i", circle(0, 0, inner)))
                                         : ring(0, 0, outer, inner));
    }
    d.centred("shaft");
    d.scene["contacts"] = {{"overlap", "press_fit"}};
}

/// A pin that stands still, a lever on it, a stop, a load on the lever.
void lever(Draft& d) {
    Random& at = d.random;
    const double r = at.between(3, 6), clearance = at.log_between(1e-3, 2e-2) * r, h = at.between(2.2, 3) * r;
    const double reach = at.between(60, 120), stop = 0.9 * reach, nose = at.between(3, 10);
    d.part("pin", ring(0, 0, r - clearance, 0.4 * r));
    d.part("lever", difference(rectangle(-h, -h, reach, h), named("h", circle(0, 0, r))));
    d.part("stop", intersection(circle(stop, -h - nose, nose),
                                named("b", rectangle(stop - 0.5 * nose, -h - 0.6 * nose, stop + 0.5 * nose, 0))));
    d.fix("pin/i/circle");
    d.fix("stop/b/bottom");
    d.force("lever", 0, -at.log_between(1, 10) * h * d.thickness());
}

const std::map<std::string, std::function<void(Draft&)>> makers{{"plate_on_rollers", plate_on_rollers},
                                                                {"plate_on_discs", plate_on_discs},
                                                                {"filleted_block", filleted_block},
                                                                {"crowned_block", crowned_block},
                                                                {"pin_in_hole", pin_in_hole},
                                                                {"ring_between_plates", ring_between_plates},
                                                                {"wedge_in_groove", wedge_in_groove},
                                                                {"disc_in_groove", disc_in_groove},
                                                                {"disc_in_box", disc_in_box},
                                                                {"pile", pile},
                                                                {"punch", punch},
                                                                {"stack", stack},
                                                                {"beam_on_stops", beam_on_stops},
                                                                {"press_fit", press_fit},
                                                                {"lever", lever}};

/// Numbers of a scene that are lengths to this power; stresses are forces per length^2.
void scale(Json& value, double unit, int power) {
    const double factor = std::pow(unit, -power);
    if (value.is_number()) value = value.get<double>() * factor;
}

void turn_vector(Json& v, const Change& change) {
    const double a = change.turn * pi / 180, x = (change.mirror ? -1 : 1) * v[0].get<double>(), y = v[1].get<double>();
    v = point(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y);
}

}  // namespace

const std::vector<std::string>& assembly_kinds() {
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> names;
        for (const auto& [name, make] : makers) names.push_back(name);
        return names;
    }();
    return kinds;
}

std::string random_scene(const std::string& kind, std::uint64_t seed) {
    Draft draft(kind, seed);
    makers.at(kind)(draft);
    return draft.scene.dump();
}

std::string changed(const std::string& text, const Change& change) {
    Json scene = Json::parse(text);
    for (Json& part : scene["parts"]) {
        Json place = Json::object();
        if (change.unit != 1) place["scale"] = 1 / change.unit;
        if (change.mirror) place["mirror"] = "x";
        if (change.turn != 0) place["rotate"] = change.turn;
        if (!place.empty()) part["place"] = place;
    }
    scale(scene["thickness"], change.unit, 1);
    for (auto& [name, material] : scene["materials"].items()) scale(material["E"], change.unit, -2);
    for (Json& support : scene["supports"])
        if (support.contains("spring"))
            for (auto& [direction, stiffness] : support["spring"].items()) scale(stiffness, change.unit, -3);
    for (Json& load : scene["loads"]) {
        if (load.contains("pressure")) scale(load["pressure"], change.unit, -2);
        if (load.contains("force")) turn_vector(load["force"], change);
    }
    if (change.order) {
        std::mt19937_64 bits(*change.order);
        Json& parts = scene["parts"];
        for (std::size_t k = parts.size() - 1; k > 0; --k) std::swap(parts[k], parts[bits() % (k + 1)]);
    }
    return scene.dump();
}

}  // namespace abut::test

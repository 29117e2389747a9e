// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generated/friction_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

namespace abut::test {

namespace friction_drawn {

namespace {

using Json = nlohmann::json;
using std::numbers::pi;

constexpr double young = 1e5;  // of the softer body
constexpr double beyond = 1.0 / 16, given_grids = 0.85;
constexpr double coarse = 0.4;  // cases are to be many

/// What is drawn for every kind; the contact lies at the origin, the upper body above it.
class Draw {
public:
    Draw(const std::string& kind, std::uint64_t seed) : bits_(seed) {
        for (char c : kind) bits_.discard(static_cast<unsigned char>(c));
        mu = chance(0.1) ? log_between(1e-4, 0.1) : between(0, 2);
        rests = !chance(beyond);
        share = chance(0.3) ? between(0.9, 0.99) : log_between(0.01, 0.9);
        way = chance(0.5) ? 1 : -1;
        ratio = std::array{1.0, 10.0, 1000.0, 0.0}[static_cast<std::size_t>(4 * unit())];
        is_upper_stiffer = chance(0.5);
        angle = between(0, 2 * pi);
    }

    double unit() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }
    double between(double a, double b) { return a + (b - a) * unit(); }
    double log_between(double a, double b) { return a * std::pow(b / a, unit()); }
    bool chance(double p) { return unit() < p; }

    /// Of both bodies together, as Hertz has it in plane stress.
    double contact_modulus() const { return ratio == 0 ? young : young / (1 + 1 / ratio); }
    Json turned(double x, double y) const {
        return {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)};
    }

    double mu = 0, share = 0, way = 1, angle = 0;
    double ratio = 1;  ///< of the moduli; 0: the stiffer body is rigid
    bool rests = true, is_upper_stiffer = false;

private:
    std::mt19937_64 bits_;
};

/// Bodies and loads of a kind: a force P down, a force Q across, a moment.
struct Bodies {
    Json upper, lower;
    double P, Q = 0, moment = 0;
    bool is_turning_held = true;
    double size;  ///< half the length that may touch
};

Json rectangle(double x0, double y0, double x1, double y1) {
    return {{"rectangle", {{"min", {x0, y0}}, {"max", {x1, y1}}}}};
}

Json half_disc(double r) {
    return {{"intersection", {{{"circle", {{"center", {0, r}}, {"radius", r}}}}, rectangle(-r, 0, r, r)}}};
}

/// Q over mu P: below 1 what rests, and what does not by a twentieth and more.
double load_share(Draw& d) {
    return d.way * (d.rests ? d.share : d.between(1.05, 1.5));
}

Bodies cylinder(Draw& d) {
    const double r = d.between(0.5, 3), a = r * d.log_between(0.01, 0.1), P = pi * a * a * d.contact_modulus() / (4 * r);
    return {half_disc(r), rectangle(-2 * r, -2 * r, 2 * r, 0), P, load_share(d) * d.mu * P, 0, true, 2 * a};
}

Bodies punch(Draw& d) {
    const double b = d.between(0.1, 0.5), r = d.between(0.3, 5), w = std::min(d.between(0.2, 0.5), 0.6 * r);
    const double up = r - std::sqrt(r * r - w * w), top = up + 1;
    const Json upper{{"loops",
                      {{{{"line", {{"from", {-b, 0}}, {"to", {b, 0}}}}},
                        {{"arc", {{"from", {b, 0}}, {"to", {b + w, up}}, {"center", {b, r}}, {"ccw", true}}}},
                        {{"line", {{"from", {b + w, up}}, {"to", {b + w, top}}}}},
                        {{"line", {{"from", {b + w, top}}, {"to", {-b - w, top}}}}},
                        {{"line", {{"from", {-b - w, top}}, {"to", {-b - w, up}}}}},
                        {{"arc", {{"from", {-b - w, up}}, {"to", {-b, 0}}, {"center", {-b, r}}, {"ccw", true}}}}}}}};
    const double P = 2 * b * young * d.log_between(1e-4, 3e-3);
    return {upper, rectangle(-2, -2, 2, 0), P, load_share(d) * d.mu * P, 0, true, 1.3 * b};
}

/// Where it may tip, the force meets the face within half of its half width.
Bodies block(Draw& d) {
    const double w = d.between(0.4, 1), h = d.between(0.5, 2), P = 2 * w * young * d.log_between(1e-5, 1e-3);
    const double Q = load_share(d) * d.mu * P, at = d.between(-0.5, 0.5) * w;
    const bool is_held = d.chance(0.5);
    return {rectangle(-w, 0, w, h), rectangle(-2, -2, 2, 0), P, Q, is_held ? 0 : Q * h / 2 - at * P, is_held, w};
}

/// A force on a turning pin passes its middle at r sin(atan mu), or beyond where it presses along an arc; along no arc below
/// half a circle at twice that.
Bodies pin(Draw& d) {
    const double clearance = d.log_between(1e-3, 2e-2), P = young * d.log_between(1e-6, 1e-3);
    const double lever = std::sin(std::atan(d.mu)), share = d.way * (d.rests ? d.share : d.between(2, 3));
    const Json hole{
        {"difference", {rectangle(-3, -2, 3, 4), {{"circle", {{"center", {0, 1 + clearance}}, {"radius", 1 + clearance}}}}}}};
    return {{{"circle", {{"center", {0, 1}}, {"radius", 1}}}}, hole, P, 0, share * lever * P, false, 0.5};
}

using Kind = Bodies (*)(Draw&);
const std::map<std::string, Kind> kinds{{"cylinder", cylinder}, {"punch", punch}, {"block", block}, {"pin", pin}};

Json loads_of(const Draw& d, const Bodies& b) {
    Json loads = Json::array({{{"name", "press"}, {"part", "upper"}, {"force", d.turned(0, -b.P)}}});
    if (b.Q != 0) loads.push_back({{"name", "shear"}, {"part", "upper"}, {"force", d.turned(b.Q, 0)}});
    if (b.moment != 0) loads.push_back({{"name", "shear"}, {"part", "upper"}, {"moment", b.moment}});
    return loads;
}

Json grid(Draw& d, double size) {
    const double cell = d.between(0.3, 0.6);
    return {{"cells", {static_cast<int>(4 / cell), static_cast<int>(4 / cell)}},
            {"angle", d.between(0, 90)},
            {"offset", {d.between(0, cell), d.between(0, cell)}},
            {"refine",
             {{{"from", {-1.5 * size, -1.5 * size}},
               {"to", {1.5 * size, 1.5 * size}},
               {"levels", std::clamp(static_cast<int>(std::ceil(std::log2(4 * cell / size))), 1, 7)}}}}};
}

FrictionCase drawn(const std::string& kind, std::uint64_t seed) {
    Draw d(kind, seed);
    const Bodies b = kinds.at(kind)(d);
    const Json soft{{"E", young}, {"nu", d.between(0, 0.45)}}, stiff{{"E", d.ratio * young}, {"nu", d.between(0, 0.45)}};
    const std::string stiff_name = d.ratio == 0 ? "rigid" : "stiff";
    Json scene{{"abut", 1}, {"materials", {{"soft", soft}}}, {"contacts", {{"friction", d.mu}}}};
    if (d.ratio != 0) scene["materials"]["stiff"] = stiff;
    const auto part = [&](const std::string& name, const Json& geometry, bool is_stiff) {
        return Json{{"name", name},
                    {"material", is_stiff ? stiff_name : "soft"},
                    {"geometry", geometry},
                    {"place", {{"rotate", d.angle * 180 / pi}}}};
    };
    scene["parts"] = {part("lower", b.lower, !d.is_upper_stiffer), part("upper", b.upper, d.is_upper_stiffer)};
    scene["supports"] = Json::array({{{"part", "lower"}, {"rigid", {{"translation", {0, 0}}, {"rotation", 0}}}}});
    if (b.is_turning_held) scene["supports"].push_back({{"part", "upper"}, {"rigid", {{"rotation", 0}}}});
    scene["loads"] = loads_of(d, b);
    const double history = d.unit();
    if (history > 0.5)
        scene["steps"] = {{{"name", "press"}, {"loads", {{"press", 1}}}},
                          {{"name", "shear"}, {"loads", {{"press", 1}, {"shear", 1}}}}};
    if (history > 0.75) {
        if (d.rests) scene["steps"].push_back({{"name", "back"}, {"loads", {{"press", 1}, {"shear", -1}}}});
    }
    scene["accuracy"] = {{"target", coarse}};
    if (d.chance(given_grids)) {
        Json& grids = scene["accuracy"]["grids"] = Json::object();
        if (d.ratio != 0 || d.is_upper_stiffer) grids["lower"] = grid(d, b.size);
        if (d.ratio != 0 || !d.is_upper_stiffer) grids["upper"] = grid(d, b.size);
    }
    return {scene.dump(), d.rests, d.mu};
}

}  // namespace

}  // namespace friction_drawn

const std::vector<std::string>& friction_kinds() {
    static const std::vector<std::string> names{"cylinder", "punch", "block", "pin"};
    return names;
}

FrictionCase friction_case(const std::string& kind, std::uint64_t seed) {
    return friction_drawn::drawn(kind, seed);
}

}  // namespace abut::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/mirror_symmetry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/io/index.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/loads.hpp"
#include "src/plan/support_components.hpp"

namespace abut {

namespace {

/// Of the whole model's size: points nearer than this are one (drawings are symmetric to their last digits).
constexpr double place_fraction = 1e-9;
/// Of the largest value there: supports and loads that differ by less are equal.
constexpr double value_fraction = 1e-9;
/// Where an edge is compared: near its ends, since a support may begin anywhere along it.
constexpr std::array<double, 5> samples{0.003, 0.21, 0.5, 0.83, 0.997};

class Mirror {
public:
    Mirror(const Scene& scene, const ResolvedConditions& conditions, const Vec2& point, const Vec2& along)
        : scene_(scene), conditions_(conditions) {
        found_.line.point = point;
        found_.line.along = along;
        geometry::Box2 box;
        for (const ScenePart& p : scene.parts) box.extend(bounding_box(p.part));
        near_ = place_fraction * box.diagonal();
    }

    MirrorSymmetry result() {
        found_.found = parts_match() && supports_match() && loads_match() && rules_match();
        return found_;
    }

private:
    Vec2 turned(const Vec2& v) const { return found_.line.turned(v); }
    Vec2 image(const Vec2& p) const { return found_.line.image_of(p); }
    bool fails(const std::string& why) {
        found_.why_not = why;
        return false;
    }
    std::string place(const Vec2& p) const { return "(" + number_text(p.x(), 6) + ", " + number_text(p.y(), 6) + ")"; }

    // Parts

    bool alike(const ScenePart& a, const ScenePart& b) const {
        const double length = perimeter(a.part);
        return a.material == b.material && a.thickness == b.thickness &&
               std::abs(perimeter(b.part) - length) <= near_ * static_cast<double>(1 + a.part.edges.size()) &&
               std::abs(area(a.part) - area(b.part)) <= near_ * length &&
               (image(centroid(a.part)) - centroid(b.part)).norm() <= near_;
    }

    bool lies_on(const geometry::Part& part, const Vec2& p) const {
        return std::any_of(part.edges.begin(), part.edges.end(), [&](const geometry::Edge& e) {
            return (point(e.curve, closest_parameter(e.curve, p)) - p).norm() <= near_;
        });
    }

    bool is_image(const ScenePart& a, const ScenePart& b) const {
        if (!alike(a, b)) return false;
        for (const geometry::Edge& e : a.part.edges)
            for (double t : samples)
                if (!lies_on(b.part, image(point(e.curve, t)))) return false;
        return true;
    }

    bool parts_match() {
        for (const ScenePart& a : scene_.parts) {
            const auto b = std::find_if(scene_.parts.begin(), scene_.parts.end(),
                                        [&](const ScenePart& other) { return is_image(a, other); });
            if (b == scene_.parts.end()) return fails("part " + a.name + " has no mirror image");
            found_.line.image.push_back(static_cast<int>(b - scene_.parts.begin()));
        }
        return true;
    }

    // Supports: what is held at a point and at its image

    /// direction . u = value; springs: traction = -stiffness (direction . u), with no value.
    struct Held {
        Vec2 direction;
        double value, stiffness;
    };

    bool covers(const EdgePortion& portion, int part, const Vec2& p) const {
        if (portion.part != part) return false;
        const geometry::Curve& curve = scene_.parts[at(part)].part.edges[at(portion.edge)].curve;
        const double t = closest_parameter(curve, p);
        return t >= portion.t0 && t <= portion.t1 && (point(curve, t) - p).norm() <= near_;
    }

    Vec2 normal_at(const EdgePortion& portion, const Vec2& p) const {
        const geometry::Curve& curve = scene_.parts[at(portion.part)].part.edges[at(portion.edge)].curve;
        return outward_normal(curve, closest_parameter(curve, p));
    }

    std::vector<Held> held_at(int part, const Vec2& p) const {
        std::vector<Held> held;
        for (std::size_t k = 0; k < scene_.supports.size(); ++k)
            for (const EdgePortion& portion : conditions_.supports[k]) {
                if (!covers(portion, part, p)) continue;
                const Support& s = scene_.supports[k];
                const Vec2 n = normal_at(portion, p);
                for (const HeldComponent& c : components_of(s))
                    held.push_back({c.direction.value_or(n), c.value ? (*c.value)(p.x(), p.y()) : 0.0, 0});
                if (s.kind != Support::Kind::spring) continue;
                held.push_back({n, 0, s.spring_normal});
                held.push_back({geometry::left_of(n), 0, s.spring_tangential});
            }
        return held;
    }

    bool same_hold(const Held& a, const Held& b) const {
        const Vec2 d = turned(a.direction);
        const double sign = d.dot(b.direction) < 0 ? -1 : 1;
        return (d - sign * b.direction).norm() <= value_fraction && a.stiffness == b.stiffness &&
               std::abs(a.value - sign * b.value) <= value_fraction * std::max(std::abs(a.value), near_);
    }

    bool has_image(const std::vector<Held>& held, const std::vector<Held>& images) const {
        return held.size() == images.size() && std::all_of(held.begin(), held.end(), [&](const Held& a) {
                   return std::any_of(images.begin(), images.end(), [&](const Held& b) { return same_hold(a, b); });
               });
    }

    bool motion_matches(const Support& s) const {
        const auto answers = [&](const Support& other) {
            const auto opposite = [](const std::optional<double>& a, const std::optional<double>& b, double sign) {
                return a.has_value() == b.has_value() && (!a || *a == sign * *b);
            };
            const bool upright = found_.line.reversed() == 0;
            return other.kind == Support::Kind::rigid && other.part == image_name(s.part) &&
                   opposite(s.rigid_x, other.rigid_x, upright ? -1 : 1) &&
                   opposite(s.rigid_y, other.rigid_y, upright ? 1 : -1) && opposite(s.rigid_rotation, other.rigid_rotation, -1);
        };
        return std::any_of(scene_.supports.begin(), scene_.supports.end(), answers);
    }

    bool points_match(const Support& s) const {
        const auto held = [&](const Vec2& p) {
            return std::any_of(scene_.supports.begin(), scene_.supports.end(), [&](const Support& other) {
                return other.kind == Support::Kind::points && other.part == image_name(s.part) && other.x == s.x &&
                       other.y == s.y &&
                       std::any_of(other.at.begin(), other.at.end(), [&](const Vec2& q) { return (q - p).norm() <= near_; });
            });
        };
        return std::all_of(s.at.begin(), s.at.end(), [&](const Vec2& p) { return held(image(p)); });
    }

    std::string image_name(const std::string& part) const {
        for (std::size_t i = 0; i < scene_.parts.size(); ++i)
            if (scene_.parts[i].name == part) return scene_.parts[at(found_.line.image[i])].name;
        return "";
    }

    bool supports_match() {
        for (std::size_t k = 0; k < scene_.supports.size(); ++k) {
            const Support& s = scene_.supports[k];
            const std::string label = "support " + std::to_string(k) + " (" + support_label(scene_, static_cast<int>(k)) + ")";
            if (s.kind == Support::Kind::rigid && !motion_matches(s)) return fails(label + " has no mirror image");
            if (s.kind == Support::Kind::points && !points_match(s)) return fails(label + " has no mirror image");
            for (const EdgePortion& portion : conditions_.supports[k])
                for (double t : samples) {
                    const Vec2 p = on(portion, t);
                    if (!has_image(held_at(portion.part, p), held_at(found_.line.image[at(portion.part)], image(p))))
                        return fails(label + " has no mirror image at " + place(image(p)));
                }
        }
        return true;
    }

    // Loads: their sum at a point and at its image

    Vec2 on(const EdgePortion& portion, double t) const {
        const geometry::Curve& curve = scene_.parts[at(portion.part)].part.edges[at(portion.edge)].curve;
        return point(curve, portion.t0 + t * (portion.t1 - portion.t0));
    }

    Vec2 traction(int part, const Vec2& p) const {
        Vec2 sum(0, 0);
        for (std::size_t k = 0; k < scene_.loads.size(); ++k)
            if (is_edge_load(scene_.loads[k]))
                for (const EdgePortion& portion : conditions_.loads[k])
                    if (covers(portion, part, p))
                        sum +=
                            traction_at(scene_.loads[k], p, normal_at(portion, p), selected_area(scene_, conditions_.loads[k]));
        return sum;
    }

    Vec2 volume_force(int part, const Vec2& p) const {
        const ScenePart& own = scene_.parts[at(part)];
        Vec2 sum(0, 0);
        for (const Load& load : scene_.loads) {
            if (is_edge_load(load) || load.kind == Load::Kind::temperature || !acts_on_volume_of(scene_, load, part)) continue;
            sum += abut::volume_force(scene_, load, part, area(own.part), p);
        }
        return sum;
    }

    bool same(const Vec2& a, const Vec2& b) const {
        return (turned(a) - b).norm() <= value_fraction * std::max(a.norm(), b.norm());
    }

    double temperature(int part, const Vec2& p) const {
        double sum = 0;
        for (const Load& load : scene_.loads)
            if (load.kind == Load::Kind::temperature && acts_on_volume_of(scene_, load, part))
                sum += load.value[0](p.x(), p.y());
        return sum;
    }

    bool same_temperature(int part, const Vec2& p) const {
        const double here = temperature(part, p), there = temperature(found_.line.image[at(part)], image(p));
        return std::abs(here - there) <= value_fraction * std::max(std::abs(here), std::abs(there));
    }

    bool loads_match() {
        for (std::size_t k = 0; k < scene_.loads.size(); ++k)
            for (const EdgePortion& portion : conditions_.loads[k])
                for (double t : samples) {
                    const Vec2 p = on(portion, t);
                    if (!same(traction(portion.part, p), traction(found_.line.image[at(portion.part)], image(p))))
                        return fails("load " + std::to_string(k) + " has no mirror image at " + place(image(p)));
                }
        for (std::size_t i = 0; i < scene_.parts.size(); ++i)
            for (const geometry::Edge& e : scene_.parts[i].part.edges) {
                const Vec2 p = point(e.curve, samples[1]);
                if (!same(volume_force(static_cast<int>(i), p), volume_force(found_.line.image[i], image(p))))
                    return fails("the forces in part " + scene_.parts[i].name + " have no mirror image");
                if (!same_temperature(static_cast<int>(i), p))
                    return fails("the temperature of part " + scene_.parts[i].name + " has no mirror image");
            }
        return true;
    }

    // Rules for pairs

    using Portions = std::vector<EdgePortion>;
    bool covered(const Portions& portions, const Portions& by) const {
        return std::all_of(portions.begin(), portions.end(), [&](const EdgePortion& p) {
            return std::all_of(samples.begin(), samples.end(), [&](double t) {
                return std::any_of(by.begin(), by.end(), [&](const EdgePortion& q) {
                    return covers(q, found_.line.image[at(p.part)], image(on(p, t)));
                });
            });
        });
    }

    bool rules_match() {
        std::vector<std::array<Portions, 2>> sides;
        for (const PairRule& rule : scene_.contacts.pairs)
            sides.push_back({select(scene_, {rule.between[0]}), select(scene_, {rule.between[1]})});
        for (std::size_t k = 0; k < sides.size(); ++k) {
            bool has_image = false;
            for (std::size_t j = 0; j < sides.size() && !has_image; ++j) {
                const PairRule &own = scene_.contacts.pairs[k], &other = scene_.contacts.pairs[j];
                if (own.kind != other.kind || own.interference != other.interference) continue;
                has_image = (covered(sides[k][0], sides[j][0]) && covered(sides[k][1], sides[j][1])) ||
                            (covered(sides[k][0], sides[j][1]) && covered(sides[k][1], sides[j][0]));
            }
            if (!has_image) return fails("rule " + std::to_string(k) + " of contacts.pairs has no mirror image");
        }
        return true;
    }

    const Scene& scene_;
    const ResolvedConditions& conditions_;
    MirrorSymmetry found_;
    double near_ = 0;
};

/// An axis of coordinates where it is that but for rounding.
Vec2 common_centroid(const Scene& scene) {
    Vec2 sum(0, 0);
    double total = 0;
    geometry::Box2 box;
    for (const ScenePart& p : scene.parts) {
        const double a = area(p.part);
        sum += a * centroid(p.part);
        total += a;
        box.extend(bounding_box(p.part));
    }
    Vec2 center = sum / total;
    for (double& c : center)
        if (std::abs(c) <= place_fraction * box.diagonal()) c = 0;
    return center;
}

}  // namespace

MirrorSymmetry find_mirror_symmetry(const Scene& scene, const ResolvedConditions& conditions) {
    const Vec2 center = common_centroid(scene);
    const bool around_axis = scene.analysis == Analysis::axisymmetric;
    MirrorSymmetry upright = around_axis ? MirrorSymmetry{} : Mirror(scene, conditions, center, {0, 1}).result();
    if (upright.found) return upright;
    MirrorSymmetry level = Mirror(scene, conditions, center, {1, 0}).result();
    if (level.found) return level;
    if (around_axis) {
        level.why_not = "about y = " + number_text(center.y(), 6) + ": " + level.why_not;
        return level;
    }
    upright.why_not = "about x = " + number_text(center.x(), 6) + ": " + upright.why_not +
                      "; about y = " + number_text(center.y(), 6) + ": " + level.why_not;
    return upright;
}

std::string symmetry_text(const MirrorSymmetry& s, bool folded) {
    if (!s.found) return "not mirror symmetric " + s.why_not;
    const bool upright = s.line.reversed() == 0;
    return "mirror symmetric about " + std::string(upright ? "x = " : "y = ") +
           number_text(upright ? s.line.point.x() : s.line.point.y(), 6) + " in parts, supports and loads; " +
           (folded ? "half of it is solved" : "solved as drawn (\"symmetry\": \"auto\" solves half of it)");
}

void set_symmetry(bool on, const std::string& why, std::vector<Effect>& plan) {
    for (Effect& effect : plan) {
        if (effect.name != "symmetry") continue;
        effect.on = on;
        effect.why = why;
    }
}

MirrorSymmetry plan_symmetry(const Scene& scene, const ResolvedConditions& conditions, std::vector<Effect>& plan) {
    MirrorSymmetry symmetry = find_mirror_symmetry(scene, conditions);
    set_symmetry(symmetry.found && scene.fold_symmetry, symmetry_text(symmetry, scene.fold_symmetry), plan);
    return symmetry;
}

}  // namespace abut

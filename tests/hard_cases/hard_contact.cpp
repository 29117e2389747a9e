// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/hard_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/io/number_text.hpp"
#include "src/report/svg.hpp"
#include "tests/hard_cases/curve_plot.hpp"
#include "tests/hard_cases/pin_sweep.hpp"

namespace abut::test {

namespace {

constexpr double degree = std::numbers::pi / 180;
const std::vector<double> moduli{1e-4, 1e-2, 1, 1e2, 1e4};
const std::vector<double> lengths{1e-12, 1e-9, 1e-6, 1e-3, 1e-1};
const std::vector<double> angles{0, 11, 29, 45};
const std::vector<double> slivers{1e-1, 1e-4, 1e-7, 1e-10};
constexpr double far_search = 3;  // gaps of a tenth are beyond the first search distance
constexpr double pressure = 1e-3;

std::string text(const std::string& name, double value) {
    return " " + name + " " + number_text(value, 3);
}

/// Largest relative difference of the pressure of all closed contacts from the exact uniform one.
double uniform_error(const SolvedAssembly& solved, std::size_t contact, double exact) {
    const solver::KnotVector& k = solved.contacts[contact].face.pressure;
    double worst = 0;
    constexpr int samples = 40;
    for (int i = 0; i <= samples; ++i) {
        const double s = k.breakpoints.front() + (k.breakpoints.back() - k.breakpoints.front()) * i / samples;
        worst = std::max(worst, std::abs(solver::pressure_at(k, pressure_of(solved, contact), s) / exact - 1));
    }
    return worst;
}

HardAnswer judged(const ContactCase& c, const std::string& family, const std::string& what, SolvedAssembly& solved,
                  double size) {
    solved = solve_case(c, far_search);
    HardAnswer a = judge(solved, size);
    a.family = family;
    a.what = what;
    return a;
}

struct TwoBlocks {
    double modulus = 1, gap = 0, tilt = 0, angle = 0, sliver = 0.5;
    bool held = false;
};

constexpr double side = 2;  // so that an overlap of 0.1 is within a twentieth of the diagonal

/// Contact acts along the normal of the middle curve, half as tilted as the block: something has to take that sideways.
void hold_mean_x(ContactCase& c, int part) {
    Support support;
    support.kind = Support::Kind::rigid;
    support.part = c.scene.parts[static_cast<std::size_t>(part)].name;
    support.rigid_x = 0;
    support.where = "/supports/" + std::to_string(c.scene.supports.size());
    c.scene.supports.push_back(support);
    c.conditions.supports.emplace_back();
}

ContactCase two_blocks(const TwoBlocks& t) {
    ContactCase c;
    c.scene.contacts.overlap = "press_fit";
    const int lower = add_part(c, rectangle({0, 0}, {side, side}), 1, 0);
    const Vec2 corner(0, side + t.gap), along = side * Vec2(std::cos(t.tilt), std::sin(t.tilt)), up(-along.y(), along.x());
    const int upper = add_part(c, polygon({corner, corner + along, corner + along + up, corner + up}), t.modulus, 0);
    constexpr double h = 0.46;
    const double angle = t.angle * degree;
    const Vec2 joint = Frame{std::cos(angle), std::sin(angle), {0, 0}}.turned(Vec2(0, side));
    set_even_grid(c, lower, h, joint - h * Vec2(0.37, t.sliver), angle);
    set_even_grid(c, upper, 0.8 * h, joint + 0.8 * h * Vec2(0.21, t.sliver + t.gap), angle);
    clamp(c, lower, 0);
    if (t.held)
        clamp(c, upper, 2);
    else
        push(c, upper, {0, -side * pressure * std::min(1.0, t.modulus)});
    if (t.tilt != 0) hold_mean_x(c, upper);
    return c;
}

HardAnswer solve_blocks(const TwoBlocks& t, const std::string& family) {
    SolvedAssembly solved;
    const std::string what = text("modulus", t.modulus) + text("gap", t.gap) + text("tilt", t.tilt) + text("angle", t.angle) +
                             text("sliver", t.sliver);
    HardAnswer a = judged(two_blocks(t), family, what, solved, side);
    if (!a.failure.empty()) return a;
    const double overlap = -((side + t.gap) - side);  // as it is drawn
    const double exact = t.held ? overlap / side / (1 + 1 / t.modulus) : pressure * std::min(1.0, t.modulus);
    if (t.held && overlap <= 0)
        a.error = solved.contacts.empty() ? 0.0 : peak_pressure(solved, 0);
    else
        a.error = solved.contacts.size() == 1 ? uniform_error(solved, 0, exact) : 1;
    if (t.tilt != 0) a.error /= std::abs(t.tilt);
    return a;
}

double table_at(const std::vector<Vec2>& table, double x) {
    const auto after = std::lower_bound(table.begin(), table.end(), x, [](const Vec2& a, double v) { return a.x() < v; });
    if (after == table.begin() || after == table.end()) return 0;
    const Vec2 &a = *(after - 1), &b = *after;
    return a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
}

/// (x, pressure) along the middle curve, ascending.
std::vector<Vec2> pressure_over_x(const ContactCase& c, const SolvedAssembly& solved) {
    std::vector<Vec2> table;
    const solver::KnotVector& k = solved.contacts[0].face.pressure;
    constexpr int samples = 4;
    for (std::size_t i = 0; i + 1 < k.breakpoints.size(); ++i)
        for (int q = 0; q < samples; ++q) {
            const double s = k.breakpoints[i] + (k.breakpoints[i + 1] - k.breakpoints[i]) * (q + 0.5) / samples;
            const geometry::FacingPair pair = pair_at(c.scene, solved.contacts[0], s);
            table.emplace_back(0.5 * (pair.on1.x + pair.on2.x).x(), solver::pressure_at(k, pressure_of(solved, 0), s));
        }
    std::sort(table.begin(), table.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    return table;
}

/// Relative L2 difference over [-1.5, 1.5] half widths about the middle.
double l2_difference(const std::vector<Vec2>& table, const std::vector<Vec2>& reference, double half_width) {
    double difference = 0, norm = 0;
    constexpr int samples = 2000;
    for (int i = 0; i <= samples; ++i) {
        const double x = 1.5 * half_width * (2.0 * i / samples - 1), r = table_at(reference, x);
        difference += std::pow(table_at(table, x) - r, 2);
        norm += r * r;
    }
    return std::sqrt(difference / norm);
}

}  // namespace

HardAnswer judge(const SolvedAssembly& solved, double size) {
    constexpr double tolerance = 1e-9;
    HardAnswer a;
    a.failure = solved.failure;
    if (a.failure.empty() && !solved.solution.mechanism.empty()) a.failure = "mechanism";
    if (!a.failure.empty()) return a;
    a.iterations = solved.solution.iterations;
    a.fallback = solved.solution.used_fallback;
    a.residual = solved.solution.residual;
    a.unbalance = unbalance(solved, size);
    if (!solved.solution.converged) a.failure = "not converged";
    if (a.failure.empty() && !(a.residual < tolerance)) a.failure = "residual " + number_text(a.residual, 3);
    if (a.failure.empty() && !(a.unbalance < tolerance)) a.failure = "unbalanced " + number_text(a.unbalance, 3);
    return a;
}

HardAnswers floating_blocks() {
    HardAnswers all;
    for (double modulus : moduli) {
        for (double length : lengths)
            for (double sign : {-1, 1}) all.push_back(solve_blocks({modulus, sign * length}, "floating blocks"));
        for (double angle : angles)
            for (double sliver : slivers) all.push_back(solve_blocks({modulus, 0, 0, angle, sliver}, "floating blocks"));
    }
    return all;
}

HardAnswers held_blocks() {
    HardAnswers all;
    for (double modulus : moduli)
        for (double length : lengths) {
            for (double sign : {-1, 1}) all.push_back(solve_blocks({modulus, sign * length, 0, 0, 0.5, true}, "held blocks"));
            for (double sliver : slivers) all.push_back(solve_blocks({modulus, -length, 0, 0, sliver, true}, "held blocks"));
        }
    return all;
}

HardAnswers tilted_blocks() {
    HardAnswers all;
    for (double modulus : moduli)
        for (double tilt : {1e-10, 1e-8, 1e-6, 1e-4, 1e-2})
            for (double sign : {-1, 1}) all.push_back(solve_blocks({modulus, 0, sign * tilt}, "tilted blocks"));
    return all;
}

HardAnswers many_pairs() {
    HardAnswers all;
    for (int n : {1, 2, 5, 10, 16}) {
        ContactCase c;
        const int base = add_part(c, rectangle({0, 0}, {static_cast<double>(n), 1}), 1, 0);
        set_even_grid(c, base, 0.31, {0.1, 0.07});
        clamp(c, base, 0);
        for (int k = 0; k < n; ++k) {
            const int block = add_part(c, rectangle({static_cast<double>(k), 1}, {k + 1.0, 2}), k % 2 ? 10 : 0.1, 0);
            set_even_grid(c, block, 0.27, {0.05, 1.09});
            press(c, block, 2, pressure);
        }
        SolvedAssembly solved;
        HardAnswer a = judged(c, "many pairs", text("pairs", 2 * n - 1), solved, n);
        for (std::size_t k = 0; k < solved.contacts.size() && a.failure.empty(); ++k)
            if (solved.contacts[k].part[0] == base) a.error = std::max(a.error, uniform_error(solved, k, pressure));
        all.push_back(a);
    }
    return all;
}

HardAnswers stacks() {
    HardAnswers all;
    for (int n : {2, 10, 50})
        for (double angle : {0.0, 17.0}) {
            ContactCase c;
            for (int k = 0; k <= n; ++k) {
                const double y = 0.5 * k;
                const int block = add_part(c, rectangle({0, y}, {1, y + 0.5}), k % 3 ? 1 : 30, 0);
                set_even_grid(c, block, 0.26, {0.07, y + 0.11}, angle * degree);
            }
            clamp(c, 0, 0);
            press(c, n, 2, pressure);
            SolvedAssembly solved;
            HardAnswer a = judged(c, "stacks", text("blocks", n) + text("angle", angle), solved, 1);
            for (std::size_t k = 0; k < solved.contacts.size() && a.failure.empty(); ++k)
                if (solved.contacts[k].part[1] == solved.contacts[k].part[0] + 1)
                    a.error = std::max(a.error, uniform_error(solved, k, pressure));
            all.push_back(a);
        }
    return all;
}

double hertz_peak(const DiscOnBlock& d) {
    const double modulus = 1 / (1 + 1 / d.modulus);
    return 0.5 * modulus * d.half_width;
}

ContactCase disc_on_block(const DiscOnBlock& d) {
    ContactCase c;
    const auto add_block = [&] { return add_part(c, rectangle({-2.1, -2}, {1.9, 0}), 1); };
    const auto add_disc = [&] { return add_part(c, disc({0, 1 + d.gap}, 1), d.modulus); };
    const int first = d.disc_first ? add_disc() : add_block(), second = d.disc_first ? add_block() : add_disc();
    const int block = d.disc_first ? second : first, round = d.disc_first ? first : second;
    const double h = d.half_width / d.cells;
    const auto place = [&](int part, double angle, double sliver) {
        const Vec2 x = Frame{std::cos(angle), std::sin(angle), {0, 0}}.turned(Vec2(0, 0));
        geometry::Box2 box;
        box.extend(Vec2(x - Vec2::Constant(1.5 * d.half_width)));
        box.extend(Vec2(x + Vec2::Constant(1.5 * d.half_width)));
        set_graded_grid(c, part, box, h, angle, {x, {0.37, sliver}});
    };
    place(block, d.angle * degree, d.sliver);
    place(round, 0.7 * d.angle * degree, -d.sliver);
    clamp(c, block, 0);
    push(c, round, {0, d.direction * 0.5 * std::numbers::pi * d.half_width * hertz_peak(d)});
    return c;
}

HardAnswers discs(const std::vector<double>& of_moduli) {
    HardAnswers all;
    for (double modulus : of_moduli) {
        DiscOnBlock fine{modulus};
        fine.cells = 24;
        const ContactCase fine_case = disc_on_block(fine);
        const std::vector<Vec2> reference = pressure_over_x(fine_case, solve_case(fine_case));
        const auto add = [&](const DiscOnBlock& d) {
            const ContactCase c = disc_on_block(d);
            SolvedAssembly solved;
            const std::string what =
                text("modulus", d.modulus) + text("gap", d.gap) + text("angle", d.angle) + text("sliver", d.sliver);
            all.push_back(judged(c, "discs", what, solved, 1));
            if (all.back().failure.empty())
                all.back().error = l2_difference(pressure_over_x(c, solved), reference, d.half_width);
        };
        for (double angle : angles)
            for (double sliver : slivers) add({modulus, 0, 0.1, 6, angle, sliver});
        for (double gap : lengths) add({modulus, gap});
    }
    return all;
}

HardAnswers conforming_discs() {
    HardAnswers all;
    for (double modulus : moduli)
        for (double sliver : slivers) {
            PinSetup setup{0.2, 0, modulus};
            setup.grid_angle = {0.3, 0.1};
            setup.sliver = {Vec2(sliver, sliver), Vec2(0.5, sliver)};
            const PinAnswer pin = solve_pin(setup, {1e-5}).front();
            all.push_back({"conforming discs", text("modulus", modulus) + text("sliver", sliver), pin.failure, 0, pin.residual,
                           pin.unbalance, pin.iterations, pin.fallback});
        }
    return all;
}

void write_hard_contacts(const std::vector<HardAnswers>& families) {
    Table table{{"solved", "error", "residual", "unbalance", "iterations", "fallback"}, {}, {}};
    for (const HardAnswers& family : families)
        for (const HardAnswer& a : family) {
            table.labels.push_back(a.family + a.what + (a.failure.empty() ? "" : " (" + a.failure + ")"));
            table.rows.push_back({a.failure.empty() ? 1.0 : 0.0, a.error, a.residual, a.unbalance,
                                  static_cast<double>(a.iterations), a.fallback ? 1.0 : 0.0});
        }
    write_csv("hard_contact", table);
}

}  // namespace abut::test

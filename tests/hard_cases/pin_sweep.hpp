// SPDX-License-Identifier: GPL-3.0-or-later
// A pin in the hole of a ring that is clamped outside: nothing but contact holds the pin, a uniform body force loads it.
#pragma once
#include <string>
#include <vector>

#include "tests/hard_cases/contact_case.hpp"

namespace abut::test {

/// Of the pin as it is drawn in its hole.
enum class Drawn { concentric, half_way, wrong_side };

struct PinSetup {
    double cell = 0.1;     ///< of the hole's radius, which is 1
    double clearance = 0;  ///< hole's radius less the pin's
    double modulus = 1;    ///< the pin's; the ring's is 1
    Drawn drawn = Drawn::concentric;
    double outer = 1.7;                                          ///< the ring's
    double load_angle = 0.3;                                     ///< radians from straight down
    std::array<double, 2> grid_angle{0, 0};                      ///< ring, pin
    std::array<Vec2, 2> sliver{Vec2(0.5, 0.5), Vec2(0.5, 0.5)};  ///< cells between a grid line and the extreme point
};
/// Loaded by a force of 1.
ContactCase pin_case(const PinSetup& setup);

struct PinAnswer {
    double load;          ///< Q / (E R)
    bool solved = false;  ///< converged, balanced, force within 1e-9 of the load
    std::string failure{};
    double residual = 0;  ///< of the contact conditions, scaled
    double unbalance = 0;
    double force_error = 0;  ///< contact force against the load
    double peak = 0;         ///< R p0 / Q
    double half_angle = 0;   ///< degrees
    int iterations = 0;
    bool fallback = false;
};

/// The answers to all loads on the same grids.
std::vector<PinAnswer> solve_pin_case(const ContactCase& c, const std::vector<double>& loads);
std::vector<PinAnswer> solve_pin(const PinSetup& setup, const std::vector<double>& loads);

struct PinCase {
    PinSetup setup;
    PinAnswer answer;
};
/// Six decades of load.
std::vector<double> pin_loads();
/// Every cell size, clearance, place drawn and ratio of moduli, `variants` times with grid angles and slivers of its own.
std::vector<PinSetup> pin_setups(const std::vector<double>& cells, const std::vector<double>& moduli, int variants);
std::vector<PinCase> sweep_pins(const std::vector<PinSetup>& setups);

/// pin_sweep.csv with every case, and a picture of residual and iterations against the load.
void write_pins(const std::string& name, const std::vector<PinCase>& cases);

}  // namespace abut::test

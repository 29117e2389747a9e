// SPDX-License-Identifier: GPL-3.0-or-later
// A cantilever beam for the tests.
#pragma once
#include "solver/beam/beam.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::test {

/// Of length 1 and rigidity 1, clamped at its beginning.
inline Beam cantilever(double begin, const KnotVector& knots) {
    Beam beam;
    beam.knots = knots;
    beam.begin = begin;
    beam.end = begin + 1;
    beam.holds[0].end = BeamEnd::clamped;
    beam.rule = gauss(knots.degree + 3);  // exact whatever the ends hold
    return beam;
}

inline BeamLoad force_at(double x, double force) {
    return {{}, {{x, force}}};
}
inline BeamLoad tip_force(const Beam& beam) {
    return force_at(beam.end, -1);
}

}  // namespace abut::solver::test

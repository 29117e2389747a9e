# SPDX-License-Identifier: GPL-3.0-or-later
"""The problem that all programs solve, data/verification/hertz_001.json, and the one measure of their errors.

Two quarters of discs (the half model of two half discs, radius 1) touch at the origin; x = 0 is the line of symmetry, the lower
one stands on y = -1, the upper one is pressed at y = 1. Plane stress, thickness 1.
"""
import math

RADIUS = 1.0
MODULUS = 1e5
POISSON = 0.3
HALF_WIDTH = 0.01  # a of Hertz' closed form
PEAK = MODULUS * HALF_WIDTH / (2 * RADIUS)  # p0
PRESSURE = math.pi * HALF_WIDTH * PEAK / 4 / RADIUS  # on the top, of width RADIUS
APPROACH = HALF_WIDTH**2 / RADIUS  # a^2 / (2 R*), R* = R / 2
START_OVERLAP = 0.1 * APPROACH  # of the peers' meshes: a start that does not know the answer


def exact(x):
    """Hertz' pressure at a distance from the middle."""
    return PEAK * math.sqrt(max(0.0, 1 - (x / HALF_WIDTH) ** 2))


def interpolated(profile, x):
    """Of points (x, pressure) in ascending order, linear between them; that of the first before it, 0 beyond the last."""
    if x <= profile[0][0]:
        return profile[0][1]
    for (x0, p0), (x1, p1) in zip(profile, profile[1:]):
        if x <= x1:
            return p0 + (p1 - p0) * (x - x0) / (x1 - x0) if x1 > x0 else p1
    return 0.0


def errors(profile, points=2000):
    """Relative L2 error over the true contact [0, a], and relative error of the largest pressure there.

    Midpoint rule in the angle of x = a sin(angle), which is dense where the pressure ends like a square root.
    """
    profile = sorted(profile)
    wrong = norm = 0.0
    for k in range(points):
        angle = (k + 0.5) / points * math.pi / 2
        x, weight = HALF_WIDTH * math.sin(angle), math.cos(angle)
        wrong += weight * (interpolated(profile, x) - exact(x)) ** 2
        norm += weight * exact(x) ** 2
    largest = max(p for x, p in profile if x <= HALF_WIDTH)
    return math.sqrt(wrong / norm), abs(largest / PEAK - 1)

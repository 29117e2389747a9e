# SPDX-License-Identifier: GPL-3.0-or-later
"""The problems that all programs solve, scenes of data/verification, and the one measure of their errors.

Two half discs of radius 1 touch at the origin. The lower one stands on y = -1; the top of the upper one, y = 1, is pressed and
sheared, and moves without turning or straining: one of them is the other turned by half a turn. Plane stress, thickness 1.
"""
import dataclasses
import math
import typing

RADIUS = 1.0
MODULUS = 1e5
POISSON = 0.3
HALF_WIDTH = 0.01  # a of Hertz' closed form
PEAK = MODULUS * HALF_WIDTH / (2 * RADIUS)  # p0
FORCE = math.pi * HALF_WIDTH * PEAK / 2  # P
APPROACH = HALF_WIDTH**2 / RADIUS  # a^2 / (2 R*), R* = R / 2
START_OVERLAP = 0.1 * APPROACH  # of the peers' meshes: a start that does not know the answer
FRICTION = 0.3  # mu
SHEAR_FORCE = 0.5 * FRICTION * FORCE  # Q
STICK_HALF_WIDTH = HALF_WIDTH * math.sqrt(1 - SHEAR_FORCE / (FRICTION * FORCE))  # c of Cattaneo and Mindlin


def half_ellipse(x, half_width):
    """Of height half_width / a."""
    return math.sqrt(max(0.0, half_width**2 - x**2)) / HALF_WIDTH


def hertz_pressure(x):
    """At a distance from the middle."""
    return PEAK * half_ellipse(x, HALF_WIDTH)


def cattaneo_shear(x):
    """[Johnson85, chapter 7]: what slips all over, less the same of the part that sticks."""
    return FRICTION * PEAK * (half_ellipse(x, HALF_WIDTH) - half_ellipse(x, STICK_HALF_WIDTH))


@dataclasses.dataclass(frozen=True)
class Problem:
    name: str
    scene: str
    full: bool  # both sides of x = 0, or that of x > 0 with the line of symmetry
    friction: float
    steps: tuple  # forces (x, y) on the whole top, one after the other; the last one's answer is compared
    quantity: str  # pressure or shear: of the upper part on the lower one, downwards or along x
    exact: typing.Callable  # of x
    largest: float  # of its values

    def begin(self):
        """Of the true contact, which ends at a."""
        return -HALF_WIDTH if self.full else 0.0


PROBLEMS = {problem.name: problem for problem in (
    Problem("hertz", "hertz_001.json", False, 0.0, ((0.0, -FORCE),), "pressure", hertz_pressure, PEAK),
    Problem("cattaneo", "cattaneo.json", True, FRICTION, ((0.0, -FORCE), (SHEAR_FORCE, -FORCE)), "shear", cattaneo_shear,
            cattaneo_shear(STICK_HALF_WIDTH)))}


def interpolated(profile, x):
    """Of points (x, value) in ascending order, linear between them; that of the first before it, 0 beyond the last."""
    if x <= profile[0][0]:
        return profile[0][1]
    for (x0, v0), (x1, v1) in zip(profile, profile[1:]):
        if x <= x1:
            return v0 + (v1 - v0) * (x - x0) / (x1 - x0) if x1 > x0 else v1
    return 0.0


def errors(problem, profile, points=2000):
    """Relative L2 error over the true contact, and relative error of the largest value there.

    Midpoint rule in the angle of x = a sin(angle), which is dense where the tractions end like a square root.
    """
    profile = sorted(profile)
    first = math.asin(problem.begin() / HALF_WIDTH)
    wrong = norm = 0.0
    for k in range(points):
        angle = first + (k + 0.5) / points * (math.pi / 2 - first)
        x, weight = HALF_WIDTH * math.sin(angle), math.cos(angle)
        wrong += weight * (interpolated(profile, x) - problem.exact(x)) ** 2
        norm += weight * problem.exact(x) ** 2
    largest = max(v for x, v in profile if abs(x) <= HALF_WIDTH)
    return math.sqrt(wrong / norm), abs(largest / problem.largest - 1)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the two half discs, or of their quarters x > 0, by gmsh: small at the contact, growing away from it."""
import dataclasses
import os

import measured_process
from contact_problem import HALF_WIDTH, RADIUS

UPPER, LOWER = 1, 2  # physical surfaces
UPPER_ARC, LOWER_ARC, UPPER_LEFT, LOWER_LEFT, TOP, BOTTOM = 11, 12, 13, 14, 15, 16  # physical lines; no left of full models

GEO = """
SetFactory("Built-in");
R = {radius};
// upper: arc to the right of its lowest point, middle of the disc
Point(1) = {{0, {shift}, 0}}; Point(2) = {{R, R + {shift}, 0}}; Point(3) = {{0, R + {shift}, 0}};
Circle(1) = {{1, 3, 2}};
// lower
Point(4) = {{0, 0, 0}}; Point(5) = {{R, -R, 0}}; Point(6) = {{0, -R, 0}};
Circle(4) = {{4, 6, 5}};
If ({full})
  Point(7) = {{-R, R + {shift}, 0}}; Circle(7) = {{7, 3, 1}}; Line(2) = {{2, 7}};
  Point(8) = {{-R, -R, 0}}; Circle(8) = {{8, 6, 4}}; Line(5) = {{5, 8}};
  Curve Loop(1) = {{7, 1, 2}}; Curve Loop(2) = {{-4, -8, -5}};
  Physical Curve(11) = {{7, 1}}; Physical Curve(12) = {{8, 4}};
Else
  Line(2) = {{2, 3}}; Line(3) = {{3, 1}};
  Line(5) = {{5, 6}}; Line(6) = {{6, 4}};
  Curve Loop(1) = {{1, 2, 3}}; Curve Loop(2) = {{-4, -6, -5}};
  Physical Curve(11) = {{1}}; Physical Curve(12) = {{4}}; Physical Curve(13) = {{3}}; Physical Curve(14) = {{6}};
EndIf
Plane Surface(1) = {{1}}; Plane Surface(2) = {{2}};
Physical Surface(1) = {{1}}; Physical Surface(2) = {{2}}; Physical Curve(15) = {{2}}; Physical Curve(16) = {{5}};
Field[1] = MathEval;
Field[1].F = "Min({largest}, {cell} + {growth} * Sqrt(Max(0, Abs(x) - {flat})^2 + y^2))";
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0; Mesh.MeshSizeFromCurvature = 0;
Mesh.Algorithm = 6;
Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;
{recombine}
Mesh.MshFileVersion = 2.2;
"""


@dataclasses.dataclass
class MeshSettings:
    cells_in_a: float  # elements in the half contact width
    growth: float = 0.5  # of the size per distance from the stretch of the surface
    flat: float = 1.5 * HALF_WIDTH  # that ends here: somewhat beyond the contact
    largest: float = 0.12 * RADIUS
    quads: bool = False


@dataclasses.dataclass
class Mesh:
    nodes: dict  # number: (x, y)
    triangles: dict  # physical surface: [nodes of an element], of second order, corners first
    quads: dict
    lines: dict  # physical line: [(end, end, middle)]


def geo_text(settings, full, shift):
    kind = "Mesh.RecombineAll = 1;" if settings.quads else ""
    return GEO.format(radius=RADIUS, shift=repr(-shift), largest=settings.largest, growth=settings.growth, flat=settings.flat,
                      cell=HALF_WIDTH / settings.cells_in_a, recombine=kind, full=int(full))


def make(settings, full, shift, folder):
    """shift: of the upper part, downwards. Writes mesh.msh; returns what gmsh took."""
    with open(os.path.join(folder, "mesh.geo"), "w") as file:
        file.write(geo_text(settings, full, shift))
    usage, _ = measured_process.run(["gmsh", "-2", "-nt", "1", "mesh.geo", "-o", "mesh.msh"], folder)
    return usage


def read(path):
    """Of gmsh's format 2.2 in text."""
    mesh = Mesh({}, {UPPER: [], LOWER: []}, {UPPER: [], LOWER: []}, {tag: [] for tag in range(UPPER_ARC, BOTTOM + 1)})
    with open(path) as file:
        lines = iter(file.read().split("\n"))
    for line in lines:
        if line == "$Nodes":
            for _ in range(int(next(lines))):
                number, x, y, _ = next(lines).split()
                mesh.nodes[int(number)] = (float(x), float(y))
        elif line == "$Elements":
            for _ in range(int(next(lines))):
                add_element(mesh, [int(word) for word in next(lines).split()])
    return mesh


def add_element(mesh, numbers):
    line, triangle, quad = 8, 9, 16
    kind, n_tags, physical = numbers[1], numbers[2], numbers[3]
    nodes = numbers[3 + n_tags:]
    groups = {line: mesh.lines, triangle: mesh.triangles, quad: mesh.quads}
    if kind in groups:
        groups[kind][physical].append(nodes)

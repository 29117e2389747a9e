# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies as FreeCAD writes them: STEP, the drawing of the same outlines, and what OpenCASCADE measures between the parts.

    freecadcmd tests/geometry/step/assemblies/freecad_assemblies.py    (FreeCAD 0.20, Debian's freecad-python3)

writes NAME.step and NAME.dxf of each, contact_truth.json and areas.json of all, into the working folder.
Lengths in mm. A part's outlines are a list of edges in any order and direction.
"""
import json
import math
import os

import FreeCAD

# Curves on surfaces follow from the others, and are half of a file. The module asks for this as it is loaded.
FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Part/General").SetInt("WriteSurfaceCurveMode", 0)

import Import  # noqa: E402
import Part  # noqa: E402
from FreeCAD import Placement, Rotation, Vector  # noqa: E402

SKETCHES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "..", "data", "sketches")
NEAR = 2.0  # pairs farther apart are not listed
Z = Vector(0, 0, 1)


# ---- edges ----


def line(x0, y0, x1, y1):
    return Part.makeLine(Vector(x0, y0, 0), Vector(x1, y1, 0))


def polygon(*points):
    return [line(*p, *q) for p, q in zip(points, points[1:] + points[:1])]


def circle(x, y, radius, begin=0, end=360):
    return Part.makeCircle(radius, Vector(x, y, 0), Z, begin, end)


def ellipse(x, y, major, minor):
    return Part.Ellipse(Vector(x, y, 0), major, minor).toShape()


def spline(points, tangents=None, closed=False):
    curve = Part.BSplineCurve()
    keys = {"PeriodicFlag": True} if closed else {"InitialTangent": tangents[0], "FinalTangent": tangents[1]}
    curve.interpolate(Points=[Vector(x, y, 0) for x, y in points], **keys)
    return curve.toShape()


# ---- drawings: the few entities that the sketches have ----


def entities_of(path):
    with open(path) as file:
        lines = [text.strip() for text in file]
    pairs = list(zip(lines[0::2], lines[1::2]))
    begin = next(i for i, pair in enumerate(pairs) if pair == ("2", "ENTITIES"))
    entities = []
    for code, value in pairs[begin + 1:]:
        if code == "0":
            entities.append((value, {}))
        elif entities:
            entities[-1][1].setdefault(code, []).append(value)
    return entities


def edge_of(kind, codes):
    one = lambda code: float(codes[code][0])
    if kind == "LINE":
        return line(one("10"), one("20"), one("11"), one("21"))
    if kind == "ARC":
        return circle(one("10"), one("20"), one("40"), one("50"), one("51"))
    if kind == "CIRCLE":
        return circle(one("10"), one("20"), one("40"))
    raise ValueError(kind)


def drawn(name):
    parts = {}
    for kind, codes in entities_of(os.path.join(SKETCHES, name)):
        if "8" in codes and kind in ("LINE", "ARC", "CIRCLE"):
            parts.setdefault(codes["8"][0], []).append(edge_of(kind, codes))
    return parts


# ---- outlines ----


def on_circle(radius, angle):
    return (radius * math.cos(angle), radius * math.sin(angle))


def arc_between(radius, begin, end):
    p, q, r = (Vector(*on_circle(radius, a), 0) for a in (begin, 0.5 * (begin + end), end))
    return Part.Arc(p, q, r).toShape()


def gear(n_teeth, module, tooth_shift, thinner, bore):
    """Involute flanks (20 degrees) as splines, radial lines below the base circle, round tips and roots."""
    pressure = math.radians(20)
    pitch, tip, root = 0.5 * n_teeth * module, (0.5 * n_teeth + 1) * module, (0.5 * n_teeth - 1.25) * module
    base = pitch * math.cos(pressure)
    involute = lambda a: math.tan(a) - a
    half_at = lambda a: (0.5 * math.pi * module - thinner) / (2 * pitch) + involute(pressure) - involute(a)
    last = math.acos(base / tip)
    edges = []
    for tooth in range(n_teeth):
        middle = 2 * math.pi * (tooth + tooth_shift) / n_teeth
        ends = {}
        for side in (-1, 1):
            points = []
            for k in range(9):
                a = last * k / 8
                points.append(on_circle(base / math.cos(a), middle + side * half_at(a)))
            last_angle = middle + side * half_at(last)
            # an involute leaves its base circle radially, and runs along its radius turned by the pressure angle there
            tangents = Vector(*on_circle(1, middle + side * half_at(0)), 0), Vector(*on_circle(1, last_angle - side * last), 0)
            edges.append(spline(points, tangents))
            foot = on_circle(root, middle + side * half_at(0))
            edges.append(line(*foot, *points[0]))
            ends[side] = last_angle
        edges.append(arc_between(tip, ends[-1], ends[1]))
        next_foot = 2 * math.pi * (tooth + 1 + tooth_shift) / n_teeth - half_at(0)
        edges.append(arc_between(root, middle + half_at(0), next_foot))
    return edges + [circle(0, 0, bore)]


def gears():
    """Two gears of module 6 whose teeth have 0.05 of backlash, one on a shaft that fits, one on a shaft with play."""
    return {
        "pinion": gear(10, 6, 0, 0.025, 10),
        "wheel": [edge.translated(Vector(72, 0, 0)) for edge in gear(14, 6, 0.5, 0.025, 15)],
        "shaft1": [circle(0, 0, 10)],
        "shaft2": [circle(72, 0, 14.98)],
    }


def rocker():
    """Splines and ellipses: a rocker of free form with an elliptic eye, on its pin; its roller on an elliptic cam."""
    return {
        "rocker": [spline([(-8, 0), (0, -9), (12, -7), (30, -5), (36, 2), (30, 7), (12, 8), (0, 9)], closed=True),
                   circle(0, 0, 5), ellipse(14, 0.5, 5, 2.5), circle(29, 1, 3)],
        "pin": [circle(0, 0, 4.98)],
        "roller": [circle(29, 1, 3)],
        "cam": [ellipse(14, 18, 14, 10), circle(14, 18, 4)],
        "shaft": [circle(14, 18, 4)],
    }


def dovetail():
    """A slider drawn up to 0.1 into one wall of its dovetail, a knob on it, a pin of the same size as its hole."""
    return {
        "bed": polygon((-40, 0), (40, 0), (40, 32), (19.4, 32), (26, 10), (-26, 10), (-19.4, 32), (-40, 32)),
        "slider": polygon((-25.9, 10), (25.9, 10), (20.1, 30), (-19.9, 30)),
        "knob": [line(-6, 34, -6, 30), line(-6, 30, 6, 30), line(6, 30, 6, 34), circle(0, 34, 6, 0, 180), circle(0, 34, 2.5)],
        "pin": [circle(0, 34, 2.5)],
    }


#: by name: the outlines of the parts, and how the whole assembly is placed
ASSEMBLIES = {
    "pin_bracket": (lambda: drawn("pin_bracket_r14.dxf"), Placement()),
    "vise_clamp": (lambda: drawn("vise_clamp_r14.dxf"), Placement()),
    "gears": (gears, Placement()),
    "rocker": (rocker, Placement(Vector(100, -50, 7), Rotation(Z, 17))),
    "dovetail": (dovetail, Placement(Vector(0, 0, -5), Rotation(Z, -35))),
}


# ---- what is written ----


def face_of(edges):
    wires = [Part.Wire(sorted_edges) for sorted_edges in Part.sortEdges(edges)]
    if not all(wire.isClosed() for wire in wires):
        raise ValueError("an outline is open")
    return Part.makeFace(wires, "Part::FaceMakerBullseye")


def write_step(path, faces, placement):
    document = FreeCAD.newDocument()
    root = document.addObject("App::Part", "root")
    assembly = document.addObject("App::Part", "assembly")
    assembly.Placement = placement
    root.addObject(assembly)
    for k, (name, face) in enumerate(faces.items()):
        solid = document.addObject("Part::Feature", name)
        solid.Label = name
        solid.Shape = face.extrude(Vector(0, 0, 8 + 2 * (k % 3)))
        assembly.addObject(solid)
    document.recompute()
    Import.export([root], path)
    FreeCAD.closeDocument(document.Name)


def entity_of(edge, layer):
    curve, (begin, end) = edge.Curve, edge.ParameterRange
    rows = []

    def put(*pairs):
        rows.extend(f"{code}\n{value!r}" if isinstance(value, float) else f"{code}\n{value}" for code, value in pairs)

    def start(kind):
        put((0, kind), (8, layer))

    if isinstance(curve, Part.Line):
        p, q = edge.valueAt(begin), edge.valueAt(end)
        start("LINE")
        put((10, p.x), (20, p.y), (11, q.x), (21, q.y))
    elif isinstance(curve, Part.Circle):
        is_whole = abs(end - begin - 2 * math.pi) < 1e-12
        start("CIRCLE" if is_whole else "ARC")
        put((10, curve.Center.x), (20, curve.Center.y), (40, curve.Radius))
        if not is_whole:
            turn = math.atan2(curve.XAxis.y, curve.XAxis.x)
            angles = [turn + begin, turn + end] if curve.Axis.z > 0 else [turn - end, turn - begin]
            put(*zip((50, 51), map(math.degrees, angles)))
    elif isinstance(curve, Part.Ellipse):
        start("ELLIPSE")
        put((10, curve.Center.x), (20, curve.Center.y), (11, curve.XAxis.x * curve.MajorRadius),
            (21, curve.XAxis.y * curve.MajorRadius), (40, curve.MinorRadius / curve.MajorRadius), (41, begin), (42, end))
    else:
        if curve.isPeriodic():
            curve.setNotPeriodic()
        knots = [k for k, n in zip(curve.getKnots(), curve.getMultiplicities()) for _ in range(n)]
        poles = curve.getPoles()
        start("SPLINE")
        put((70, 8), (71, curve.Degree), (72, len(knots)), (73, len(poles)), *((40, k) for k in knots))
        for p in poles:
            put((10, p.x), (20, p.y))
    return rows


def write_dxf(path, faces, placement):
    rows = ["0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES"]
    for name, face in faces.items():
        for edge in face.Edges:
            there = edge.copy()
            there.Placement = placement.multiply(there.Placement)
            rows += entity_of(there, name)
    with open(path, "w") as file:
        file.write("\n".join(rows + ["0\nENDSEC\n0\nEOF\n"]))


# Gauss-Legendre, ten points
GAUSS = ((0.1488743389816312, 0.2955242247147529), (0.4333953941292472, 0.2692667193099963),
         (0.6794095682990244, 0.2190863625159820), (0.8650633666889845, 0.1494513491505806),
         (0.9739065285171717, 0.0666713443086881))


def area_of(face):
    """Green's theorem span by span: what the kernel says itself is 5e-4 off where there are splines."""
    twice = 0
    for edge in face.Edges:
        begin, end = edge.ParameterRange
        inner = edge.Curve.getKnots() if isinstance(edge.Curve, Part.BSplineCurve) else ()
        places = [begin] + [t for t in inner if begin < t < end] + [end]
        places = [t + (u - t) * k / 8 for t, u in zip(places, places[1:]) for k in range(8)] + [end]
        along = 0
        for t, u in zip(places, places[1:]):
            for x, weight in GAUSS:
                for place in (-x, x):
                    at = 0.5 * (t + u + (u - t) * place)
                    p, d = edge.valueAt(at), edge.derivative1At(at)
                    along += 0.5 * (u - t) * weight * (p.x * d.y - p.y * d.x)
        twice += -along if edge.Orientation == "Reversed" else along
    return abs(0.5 * twice)


def contacts_of(faces):
    names = list(faces)
    boundary = {name: Part.makeCompound(face.Edges) for name, face in faces.items()}
    pairs = []
    for i, a in enumerate(names):
        for b in names[i + 1:]:
            distance = boundary[a].distToShape(boundary[b])[0]
            if distance > NEAR:
                continue
            pairs.append({"a": a, "b": b, "min_boundary_distance": distance,
                          "overlap_area": faces[a].common(faces[b]).Area,
                          "shared_boundary_length": boundary[a].common(boundary[b]).Length})
    return pairs


def main():
    contacts, areas = {}, {}
    for name, (outlines, placement) in ASSEMBLIES.items():
        faces = {part: face_of(edges) for part, edges in outlines().items()}
        write_step(os.path.abspath(name + ".step"), faces, placement)
        write_dxf(name + ".dxf", faces, placement)
        contacts[name] = contacts_of(faces)
        areas[name] = {part: area_of(face) for part, face in faces.items()}
    for file_name, truth in (("contact_truth.json", contacts), ("areas.json", areas)):
        with open(file_name, "w") as file:
            json.dump(truth, file, indent=1)


main()

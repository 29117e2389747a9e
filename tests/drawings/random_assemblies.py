#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies made up from seeds, drawn seven ways with ezdxf, and what the program makes of them.

random_assemblies.py PROGRAM [N] [SEED]: draws N assemblies (default 20) in each way, asks `PROGRAM contacts` for contacts and
`PROGRAM inspect --json` for parts, and compares with the list of the one who drew them: areas of the parts, and pairs of parts
that touch (shapely). Prints a line for each that differs and a table. Status 1 where one in twenty or more differ although it was
told, or any differs without a warning; 77 where ezdxf or shapely are missing."""
import collections
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import ezdxf
    from shapely.geometry import Point, Polygon, box
except ImportError:
    print("ezdxf and shapely are needed")
    sys.exit(77)

NEAR = 0.11  # beyond the clearances of pins, below those of bolts
WAYS = ["bare", "annotated", "sheet", "iso", "parts", "twice", "hatched"]


class Assembly:
    """Parts as shells with holes: lists of ("poly", points) or ("circle", center, radius)."""

    def __init__(self):
        self.parts = []   # (name, shell, holes)
        self.threads = []  # open lines within parts

    def add(self, name, shell, holes=()):
        self.parts.append((name, shell, list(holes)))


def rect(x0, y0, x1, y1):
    return ("poly", [(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def circle(x, y, r):
    return ("circle", (x, y), r)


def bolted(rng):
    """Plates on each other, and bolts through clearance holes."""
    a, width, y = Assembly(), rng.randint(60, 160), 0
    n_plates, x = rng.randint(2, 3), rng.randint(20, 30)
    d, gap = rng.choice([8, 10, 12]), rng.choice([0.5, 0.75, 1])
    heights = [rng.randint(8, 20) for _ in range(n_plates)]
    for k, h in enumerate(heights):
        a.add(f"P{k}L", rect(0, y, x - d / 2 - gap, y + h))
        a.add(f"P{k}R", rect(x + d / 2 + gap, y, width, y + h))
        y += h
    head, foot = d * 0.7, d * 0.8
    a.add("BOLT", ("poly", [(x - d / 2, y), (x - d, y), (x - d, y + head), (x + d, y + head), (x + d, y), (x + d / 2, y),
                            (x + d / 2, -foot - 4), (x - d / 2, -foot - 4)]))
    a.add("NUTL", rect(x - d, -foot, x - d / 2, 0))
    a.add("NUTR", rect(x + d / 2, -foot, x + d, 0))
    a.threads = [((x - d * 0.42, -foot - 3), (x - d * 0.42, y / 3))]
    return a


def stack(rng):
    """Blocks on a table, some beside each other."""
    a, y, width = Assembly(), 0, rng.randint(60, 120)
    a.add("TABLE", rect(-10, -20, width + 10, 0))
    for k in range(rng.randint(1, 3)):
        h = rng.randint(8, 30)
        if rng.random() < 0.4:
            cut = rng.randint(10, width - 10)
            a.add(f"B{k}A", rect(0, y, cut, y + h))
            a.add(f"B{k}B", rect(cut, y, width, y + h))
        else:
            a.add(f"B{k}", rect(0, y, width, y + h))
        y += h
    return a


def pins(rng):
    """Pins with clearance, some in bushes, in a plate."""
    a, n = Assembly(), rng.randint(1, 4)
    holes, bushes = [], []
    for k in range(n):
        x, r = 30 + 50 * k, rng.randint(5, 12)
        if rng.random() < 0.4:
            holes.append(circle(x, 25, r + 4))
            bushes.append((f"BUSH{k}", circle(x, 25, r + 4), [circle(x, 25, r)]))
            a.add(f"PIN{k}", circle(x, 25, r - 0.05))
        else:
            holes.append(circle(x, 25, r))
            a.add(f"PIN{k}", circle(x, 25, r - 0.05))
    a.add("PLATE", rect(0, 0, 60 + 50 * (n - 1), 50), holes)
    for bush in bushes:
        a.add(*bush)
    return a


def rollers(rng):
    """Rollers on a flat, or between two."""
    a, n, r = Assembly(), rng.randint(1, 4), rng.randint(5, 15)
    width = n * (2 * r + 6) + 10
    a.add("BASE", rect(0, -15, width, 0))
    for k in range(n):
        a.add(f"ROLLER{k}", circle(r + 5 + k * (2 * r + 6), r, r))
    if rng.random() < 0.5:
        a.add("TOP", rect(0, 2 * r, width, 2 * r + 12))
    return a


def slot(rng):
    """A tongue in a groove with a nominal bottom and clearance beside it."""
    a, w, h, c = Assembly(), rng.randint(20, 40), rng.randint(10, 20), rng.choice([0, 0.1])
    a.add("GROOVE", ("poly", [(0, 0), (100, 0), (100, 50), (50 + w, 50), (50 + w, 50 - h), (50 - w, 50 - h), (50 - w, 50), (0, 50)]))
    a.add("TONGUE", rect(50 - w + c, 50 - h, 50 + w - c, 70))
    return a


KINDS = [bolted, stack, pins, rollers, slot]


def shape(part):
    def one(s):
        return Polygon(s[1]) if s[0] == "poly" else Point(s[1]).buffer(s[2], 512)
    result = one(part[1])
    for hole in part[2]:
        result = result.difference(one(hole))
    return result


def exact_area(part):
    def one(s):
        return Polygon(s[1]).area if s[0] == "poly" else math.pi * s[2] ** 2
    return one(part[1]) - sum(one(h) for h in part[2])


def near_pairs(assembly, within):
    shapes = [shape(p) for p in assembly.parts]
    return sorted(tuple(sorted((round(exact_area(assembly.parts[i]), 2), round(exact_area(assembly.parts[k]), 2))))
                  for i in range(len(shapes)) for k in range(i) if shapes[i].distance(shapes[k]) <= within)


def hatch_angles(assembly):
    """Angles by part, so that parts that touch look different, as ISO 128-3 has it."""
    shapes, angles = [shape(p) for p in assembly.parts], []
    for i, own in enumerate(shapes):
        taken = {angles[k] for k in range(i) if shapes[k].distance(own) <= NEAR}
        angles.append(next(angle for angle in range(0, 180, 15) if angle not in taken))
    return angles


class Drawer:
    def __init__(self, way, rng):
        self.way, self.rng = way, rng
        self.doc = ezdxf.new("R2010", setup=True)
        self.doc.header["$INSUNITS"] = 4
        self.space = self.doc.modelspace()
        self.drawn = set()

    def layer(self, kind, part=None):
        if self.way == "parts" and part:
            return part
        if self.way == "iso":
            return {"outline": "Visible (ISO)", "thin": "Thin", "center": "Centerline (ISO)", "text": "Text", "border": "Border (ISO)",
                    "hatch": "Hatch (ISO)"}[kind]
        return "0"

    def line(self, p, q, **attributes):
        self.space.add_line(p, q, dxfattribs=attributes)

    def outline(self, s, name):
        attributes = {"layer": self.layer("outline", name)}
        keep = self.way in ("twice", "parts")  # each part whole
        if s[0] == "circle":
            key = ("c", s[1], s[2])
            if keep or key not in self.drawn:
                self.space.add_circle(s[1], s[2], dxfattribs=attributes)
            self.drawn.add(key)
            return
        points = s[1]
        for p, q in zip(points, points[1:] + points[:1]):
            key = ("l",) + tuple(sorted((p, q)))
            if keep or key not in self.drawn:
                self.line(p, q, **attributes)
            self.drawn.add(key)

    def draw(self, assembly):
        for name, shell, holes in assembly.parts:
            self.outline(shell, name)
            for hole in holes:
                self.outline(hole, name)
        if self.way == "hatched":
            for part, angle in zip(assembly.parts, hatch_angles(assembly)):
                self.hatch(part, angle)
                if not part[2] and len(part[1][1]) == 4 and self.rng.random() < 0.3:
                    self.cross(part[1][1])
        if self.way in ("annotated", "sheet", "iso"):
            self.annotate(assembly)
        if self.way in ("sheet", "iso"):
            self.sheet(assembly)

    def hatch(self, part, angle):
        hatch = self.space.add_hatch(dxfattribs={"layer": self.layer("hatch")})
        hatch.set_pattern_fill("ANSI31", scale=1, angle=angle)
        for s in [part[1]] + part[2]:
            if s[0] == "poly":
                hatch.paths.add_polyline_path(s[1], is_closed=True)
            else:
                hatch.paths.add_edge_path().add_arc(s[1], s[2], 0, 360)

    def cross(self, corners):
        """An edge seen on a rectangle: a line across, under its hatch."""
        (x0, y0), (x1, y1) = corners[0], corners[2]
        x = x0 + self.rng.uniform(0.3, 0.7) * (x1 - x0)
        self.line((x, y0), (x, y1))

    def annotate(self, assembly):
        boxes = [shape(p).bounds for p in assembly.parts]
        x0, y0 = min(b[0] for b in boxes), min(b[1] for b in boxes)
        x1, y1 = max(b[2] for b in boxes), max(b[3] for b in boxes)
        self.line(((x0 + x1) / 2, y0 - 8), ((x0 + x1) / 2, y1 + 8), layer=self.layer("center"), linetype="CENTER")
        for p, q in assembly.threads:
            self.line(p, q, layer=self.layer("thin"))
        for k, part in enumerate(assembly.parts):
            inside = shape(part).representative_point()
            end = (x1 + 30, y0 + 12 * k)
            d = math.hypot(end[0] - inside.x, end[1] - inside.y)
            on = (end[0] - 4 * (end[0] - inside.x) / d, end[1] - 4 * (end[1] - inside.y) / d)
            self.line((inside.x, inside.y), on, layer=self.layer("thin"))
            self.space.add_circle(end, 4, dxfattribs={"layer": self.layer("thin")})
            self.space.add_circle((inside.x, inside.y), 0.5, dxfattribs={"layer": self.layer("thin")})
            self.space.add_text(str(k + 1), dxfattribs={"layer": self.layer("text"), "height": 3.5, "insert": (end[0] - 1.2, end[1] - 1.7)})

    def sheet(self, assembly):
        boxes = [shape(p).bounds for p in assembly.parts]
        x0, y0 = min(b[0] for b in boxes) - 60, min(b[1] for b in boxes) - 80
        x1, y1 = max(b[2] for b in boxes) + 60, max(b[3] for b in boxes) + 120
        width = max(x1 - x0, 250, 1.4142 * (y1 - y0))
        height = width / math.sqrt(2)
        border = {"layer": self.layer("border")}
        for low, high in (((x0, y0), (x0 + width, y0 + height)), ((x0 + 20, y0 + 10), (x0 + width - 10, y0 + height - 10))):
            self.space.add_lwpolyline([low, (high[0], low[1]), high, (low[0], high[1])], close=True, dxfattribs=border)
        right, bottom = x0 + width - 10, y0 + 10
        left, top = right - 120, bottom + 32
        self.line((left, bottom), (left, top), **border)
        for k in range(1, 5):
            self.line((left, bottom + 8 * k), (right, bottom + 8 * k), **border)
        for x in (30, 60, 90):
            self.line((left + x, bottom), (left + x, top), **border)
        for k, text in enumerate(("ASSEMBLY", "Scale 1:1", "ISO 2768-m", "A4")):
            self.space.add_text(text, dxfattribs={"layer": self.layer("text"), "height": 3, "insert": (left + 2 + 30 * k, bottom + 2)})


def ask(program, file):
    """The program's answer: refused (the error), or areas, pairs of areas that are near, and warnings."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "contacts", file, "-o", folder], capture_output=True, text=True, errors="replace", timeout=120)
        if done.returncode != 0:
            return done.stderr.strip() or "no message", None, None, None
        contacts = json.loads((pathlib.Path(folder) / "contacts.json").read_text())
        seen = json.loads(subprocess.run([program, "inspect", file, "--json"], capture_output=True, text=True, errors="replace",
                                         timeout=120).stdout)
    area = {p["name"]: round(p["area"], 2) for p in seen["parts"]}
    pairs = {tuple(sorted(p["parts"])) for p in contacts["pairs"] if (p["gap"]["min"] or 0) <= NEAR}
    return "", sorted(area.values()), sorted(tuple(sorted((area[a], area[b]))) for a, b in pairs), contacts["warnings"]


def is_same(found, expected):
    flat = lambda items: [x for item in items for x in (item if isinstance(item, tuple) else (item,))]
    a, b = flat(found), flat(expected)
    return len(a) == len(b) and all(abs(x - y) <= 0.011 + 1e-6 * abs(y) for x, y in zip(a, b))


def main():
    program = sys.argv[1]
    n, seed = int(sys.argv[2]) if len(sys.argv) > 2 else 20, int(sys.argv[3]) if len(sys.argv) > 3 else 1
    sums = collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder:
        for k in range(n):
            for way in WAYS:
                rng = random.Random(1000 * seed + k)
                kind = rng.choice(KINDS)
                assembly = kind(rng)
                drawer = Drawer(way, rng)
                drawer.draw(assembly)
                file = str(pathlib.Path(folder) / f"{kind.__name__}_{k}_{way}.dxf")
                drawer.doc.saveas(file)
                why, areas, pairs, warnings = ask(program, file)
                expected = sorted(round(exact_area(p), 2) for p in assembly.parts)
                if why:
                    state = "refused"
                elif is_same(areas, expected) and is_same(pairs, near_pairs(assembly, NEAR)):
                    state = "right"
                else:
                    state = "wrong, told" if warnings else "SILENTLY WRONG"
                sums[way][state] += 1
                if state != "right":
                    print(f"{kind.__name__} {k} {way}: {state}; parts {areas} not {expected}; pairs {pairs} not {near_pairs(assembly, NEAR)} "
                          f"{why[:200] or (warnings or [''])[0][:200]}")
    total = collections.Counter()
    for way in WAYS:
        print(way, dict(sums[way]))
        total.update(sums[way])
    print("all", dict(total))
    bad = sum(total.values()) - total["right"]
    sys.exit(1 if total["SILENTLY WRONG"] or 20 * bad >= sum(total.values()) else 0)


if __name__ == "__main__":
    main()

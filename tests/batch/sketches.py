#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes many different drawings for abut batch: sketches.py FOLDER [--count N] [--seed S] [--two-parts].

FOLDER/drawings/*.dxf   pins in lugs, pins in plates, rollers on blocks, blocks on blocks (layers BODY, PIN, PIN_2, ...)
FOLDER/jobs.csv         a row for each: file, name, P (the load), for --template FOLDER/template.json
FOLDER/template.json    BODY held along its bottom, PIN pushed down by P; draft, result.json only
FOLDER/expect.csv       the pairs that touch or nearly do, for --only contacts --expect

The same seed gives the same files, on any machine: sizes are rounded to a thousandth.
"""
import argparse
import csv
import json
import pathlib
import random


class Drawing:
    """DXF R12 of lines, arcs and circles."""

    def __init__(self):
        self.entities = []

    def _entity(self, kind, layer, *groups):
        self.entities.append(f"0\n{kind}\n8\n{layer}\n" + "".join(f"{code}\n{value:.9g}\n" for code, value in groups))

    def line(self, layer, a, b):
        self._entity("LINE", layer, (10, a[0]), (20, a[1]), (11, b[0]), (21, b[1]))

    def polygon(self, layer, points):
        for a, b in zip(points, points[1:] + points[:1]):
            self.line(layer, a, b)

    def rectangle(self, layer, x0, y0, x1, y1):
        self.polygon(layer, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)])

    def circle(self, layer, center, radius):
        self._entity("CIRCLE", layer, (10, center[0]), (20, center[1]), (40, radius))

    def arc(self, layer, center, radius, start, end):
        self._entity("ARC", layer, (10, center[0]), (20, center[1]), (40, radius), (50, start), (51, end))

    def text(self):
        head = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"
        return head + "0\nSECTION\n2\nENTITIES\n" + "".join(self.entities) + "0\nENDSEC\n0\nEOF\n"


def size(rng, low, high):
    return round(rng.uniform(low, high), 3)


def pin_in_hole(rng, drawing, pin, center, radius):
    """A hole with its pin: neat, resting on the bottom with clearance, or concentric with clearance."""
    clearance = rng.choice([0, round(radius * rng.uniform(2e-4, 5e-3), 4)])
    drop = clearance if rng.random() < 0.7 else 0
    drawing.circle("BODY", center, radius)
    drawing.circle(pin, (center[0], center[1] - drop), radius - clearance)


def lug(rng, drawing):
    """A plate with a round head and a pin in it."""
    radius = size(rng, 4, 12)
    wall, height = size(rng, 0.6 * radius, 2 * radius), size(rng, 2 * radius, 6 * radius)
    outer = radius + wall
    drawing.line("BODY", (-outer, height), (-outer, 0))
    drawing.line("BODY", (-outer, 0), (outer, 0))
    drawing.line("BODY", (outer, 0), (outer, height))
    drawing.arc("BODY", (0, height), outer, 0, 180)
    pin_in_hole(rng, drawing, "PIN", (0, height), radius)
    return [("BODY", "PIN")]


def plate(rng, drawing):
    """A plate with a row of pins of one size, or of several."""
    n, radius = rng.randint(2, 4), size(rng, 3, 8)
    pitch, height = size(rng, 3, 5) * radius, size(rng, 4, 7) * radius
    drawing.rectangle("BODY", 0, 0, round((n + 0.5) * pitch, 3), height)
    pairs = []
    for k in range(n):
        pin = "PIN" if k == 0 else f"PIN_{k + 1}"
        pin_in_hole(rng, drawing, pin, (round((k + 0.75) * pitch, 3), height / 2), round(radius * rng.uniform(0.7, 1), 3))
        pairs.append(("BODY", pin))
    return pairs


def roller(rng, drawing):
    """A roller on a block."""
    radius, height = size(rng, 5, 20), size(rng, 8, 30)
    width = size(rng, 2.5 * radius, 5 * radius)
    drawing.rectangle("BODY", -width / 2, 0, width / 2, height)
    drawing.circle("PIN", (0, height + radius), radius)
    return [("BODY", "PIN")]


def blocks(rng, drawing):
    """A small block on a large one, its edges chamfered or not."""
    width, height, foot = size(rng, 30, 60), size(rng, 10, 30), size(rng, 8, 20)
    top, cut = size(rng, 6, 20), rng.choice([0, size(rng, 0.5, 2)])
    drawing.rectangle("BODY", -width / 2, 0, width / 2, height)
    half = foot / 2
    points = [(-half, height + cut), (-half + cut, height), (half - cut, height), (half, height + cut), (half, height + top), (-half, height + top)]
    drawing.polygon("PIN", [p for i, p in enumerate(points) if p not in points[:i]])
    return [("BODY", "PIN")]


TEMPLATE = {
    "abut": 1,
    "title": "A pin pushed into its body",
    "units": {"length": "mm", "force": "N"},
    "thickness": 10,
    "parameters": {"P": 1000},
    "materials": {"steel": {"E": 210000, "nu": 0.3}},
    "assembly": {"file": "*", "parts_by": "layer", "material": "steel"},
    "supports": [
        {"on": {"part": "BODY", "facing": [0, -1]}, "fix": ["x", "y"]},
        {"part": "PIN", "rigid": {"translation": [0, None], "rotation": 0}},
    ],
    "loads": [{"part": "PIN", "force": [0, "-P"]}],
    "accuracy": {"level": "draft"},
    "output": {"formats": ["json"]},
}


def write(folder, count, seed, two_parts):
    rng = random.Random(seed)
    kinds = [lug, roller, blocks] if two_parts else [lug, plate, roller, blocks]
    (folder / "drawings").mkdir(parents=True, exist_ok=True)
    jobs, expected = [], []
    for k in range(count):
        kind, drawing = kinds[k % len(kinds)], Drawing()
        pairs = kind(rng, drawing)
        name = f"{kind.__name__}_{k:04d}"
        (folder / "drawings" / f"{name}.dxf").write_text(drawing.text())
        jobs.append([f"drawings/{name}.dxf", name, round(10 ** rng.uniform(2, 4))])
        expected += [[f"{name}.dxf", *pair] for pair in pairs]
    for file, head, rows in [("jobs.csv", ["file", "name", "P"], jobs), ("expect.csv", ["file", "part_1", "part_2"], expected)]:
        with open(folder / file, "w", newline="") as stream:
            csv.writer(stream, lineterminator="\n").writerows([head, *rows])
    (folder / "template.json").write_text(json.dumps(TEMPLATE, indent=2) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--two-parts", action="store_true", help="leave out the plates with several pins")
    arguments = parser.parse_args()
    write(arguments.folder, arguments.count, arguments.seed, arguments.two_parts)


if __name__ == "__main__":
    main()

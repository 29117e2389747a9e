# SPDX-License-Identifier: GPL-3.0-or-later
"""Field files: vtu_test.py ABUT SOURCES. Read by a few lines here, and by meshio where that is installed."""
import base64
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

try:
    import meshio
except ImportError:
    meshio = None

ABUT, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2])
FORMATS = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}


def read_vtu(path):
    """Arrays by name, as tuples of their components."""
    root = ElementTree.parse(path).getroot()
    assert root.attrib["type"] == "UnstructuredGrid" and root.attrib["byte_order"] == "LittleEndian"
    arrays = {}
    for array in root.iter("DataArray"):
        data = base64.b64decode(array.text)
        (n,) = struct.unpack_from("<Q", data)
        assert n == len(data) - 8
        code = FORMATS[array.attrib["type"]]
        values = struct.unpack_from(f"<{n // struct.calcsize(code)}{code}", data, 8)
        width = int(array.attrib.get("NumberOfComponents", 1))
        arrays[array.attrib["Name"]] = values if width == 1 else list(zip(*[iter(values)] * width))
    return arrays


def cells_of(arrays):
    begin = 0
    for end, kind in zip(arrays["offsets"], arrays["types"]):
        assert end - begin == {5: 3, 9: 4}[kind]
        yield arrays["connectivity"][begin:end]
        begin = end


def area_of(points):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1])) / 2


class VtuTest(unittest.TestCase):
    def analyzed(self, name, *options):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        out = pathlib.Path(place.name)
        subprocess.run([ABUT, "analyze", str(SOURCES / "data/scenes" / name), "-o", str(out), "--quiet", "--accuracy", "draft", *options], check=True)
        return out

    def check(self, path, result):
        arrays = read_vtu(path)
        area = [0.0] * len(result["parts"])
        for cell, part in zip(cells_of(arrays), arrays["part"]):
            own = area_of([arrays["Points"][k] for k in cell])
            self.assertGreater(own, 0)
            area[part - 1] += own
        for own, part in zip(area, result["parts"]):
            self.assertAlmostEqual(own, part["area"], delta=1e-3 * part["area"])  # chords of 0.06 leave (0.06)^2 / 6
        largest = max(part["max_displacement"]["value"] for part in result["parts"])
        self.assertAlmostEqual(max((x * x + y * y) ** 0.5 for x, y, _ in arrays["displacement"]), largest, delta=1e-3 * largest)
        for (xx, yy, zz, xy, yz, xz), mises in zip(arrays["stress"], arrays["von Mises stress"]):
            squared = ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy * xy
            self.assertAlmostEqual(squared ** 0.5, mises, delta=1e-9 * (1 + mises))
            self.assertEqual((yz, xz), (0, 0))
        if meshio is not None:
            mesh = meshio.read(path)
            self.assertEqual(len(mesh.points), len(arrays["Points"]))
            self.assertEqual(sum(len(block.data) for block in mesh.cells), len(arrays["types"]))
            self.assertEqual({block.type for block in mesh.cells}, {"triangle", "quad"})
            self.assertEqual([tuple(u) for u in mesh.point_data["displacement"]], arrays["displacement"])
            self.assertEqual([int(p) for block in mesh.cell_data["part"] for p in block], list(arrays["part"]))

    def test_fills_the_parts(self):
        out = self.analyzed("pin_bracket.json", "--format", "vtu")
        self.check(out / "fields.vtu", json.loads((out / "result.json").read_text()))

    def test_steps_are_a_series(self):
        out = self.analyzed("clamped_strip.json", "--format", "vtu")
        sets = list(ElementTree.parse(out / "fields.pvd").getroot().iter("DataSet"))
        names = [case["name"] for case in json.loads((out / "cases.json").read_text())["cases"]]
        self.assertEqual([(s.attrib["timestep"], s.attrib["name"]) for s in sets], [(str(k + 1), name) for k, name in enumerate(names)])
        for k, one in enumerate(sets):
            path = out / one.attrib["file"]
            self.assertTrue(path.is_file())
            if k == 0:
                self.check(path, json.loads((path.parent / "result.json").read_text()))
        # what is not asked for again goes
        subprocess.run([ABUT, "analyze", str(SOURCES / "data/scenes/clamped_strip.json"), "-o", str(out), "--quiet", "--accuracy", "draft"], check=True)
        self.assertEqual(list(out.rglob("*.vtu")) + list(out.rglob("*.pvd")), [])


if __name__ == "__main__":
    print("with meshio" if meshio else "without meshio")
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=1)

# SPDX-License-Identifier: GPL-3.0-or-later
"""The schema of scenes against the scenes of data/, and against wrong ones. Skipped where the module jsonschema is missing."""
import json
import pathlib
import re
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMENT = re.compile(r'("(?:[^"\\]|\\.)*")|//[^\n]*|/\*.*?\*/', re.DOTALL)


def scene(path):
    """JSON with comments; those that look like one inside a text stay."""
    return json.loads(COMMENT.sub(lambda match: match.group(1) or "", path.read_text()))


def block(**more):
    """The smallest scene, with changes."""
    geometry = {"rectangle": {"min": [0, 0], "max": [1, 1]}}
    part = {"name": "block", "material": "steel", "geometry": geometry}
    return {"abut": 1, "materials": {"steel": {"E": 1, "nu": 0.3}}, "parts": [part]} | more


WRONG = {
    "no version": {"parts": block()["parts"]},
    "no part": {"abut": 1},
    "unknown key": block(suports=[]),
    "unknown analysis": block(analysis="plane"),
    "a material without nu": block(materials={"steel": {"E": 1}}),
    "two shapes in a node": block(parts=[{"name": "a", "material": "steel", "geometry": {"circle": {"center": [0, 0], "radius": 1}, "polygon": [[0, 0], [1, 0], [0, 1]]}}]),
    "a point of three numbers": block(supports=[{"on": {"part": "block", "near": [0, 0, 0]}, "fix": ["x"]}]),
    "a support without a kind": block(supports=[{"on": "block/left"}]),
    "a load of two kinds": block(loads=[{"on": "block/top", "pressure": 1, "force": [0, 1]}]),
    "a radius below zero": block(parts=[{"name": "a", "material": "steel", "geometry": {"circle": {"center": [0, 0], "radius": -1}}}]),
    "a name with a slash": block(parts=[block()["parts"][0] | {"name": "a/b"}]),
}


@unittest.skipIf(jsonschema is None, "the Python module jsonschema is missing")
class SceneSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        schema = json.loads((ROOT / "data/schema/scene.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        cls.validator = jsonschema.Draft202012Validator(schema)

    def faults(self, instance):
        return [error.json_path + ": " + error.message for error in self.validator.iter_errors(instance)]

    def test_every_scene_of_the_project(self):
        paths = sorted(path for folder in ["scenes", "verification", "batch"] for path in (ROOT / "data" / folder).glob("*.json"))
        self.assertGreater(len(paths), 40)
        for path in paths:
            with self.subTest(path.name):
                self.assertEqual(self.faults(scene(path)), [])

    def test_the_smallest_scene(self):
        self.assertEqual(self.faults(block()), [])

    def test_wrong_scenes(self):
        for what, instance in WRONG.items():
            with self.subTest(what):
                self.assertNotEqual(self.faults(instance), [])


if __name__ == "__main__":
    unittest.main()

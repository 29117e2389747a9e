# SPDX-License-Identifier: GPL-3.0-or-later
"""The schema of scenes against the scenes of data/, and against wrong ones; examples and defaults of all schemas against what they are
examples of. Skipped where the module jsonschema is missing; tests/src/reference and tests/apps/outputs_test check keys without it."""
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
    "friction below zero": block(contacts={"friction": -0.3}),
    "steps without any": block(steps=[]),
    "a load that is a moment and a force": block(loads=[{"on": "block/top", "moment": 3, "force": [0, 1]}]),
    "a format that is not known": block(output={"formats": ["pdf"]}),
    "a schema that is no text": block(**{"$schema": 1}),
    "a known answer without a tolerance": block(expect=[{"quantity": "reactions[0].force[1]", "value": 1}]),
    "a level that is no whole number": block(parts=[block()["parts"][0] | {"level": 1.5}]),
    "a level below 1": block(parts=[block()["parts"][0] | {"level": [1, 0]}]),
    "no level in a list": block(parts=[block()["parts"][0] | {"level": []}]),
    "a level twice": block(parts=[block()["parts"][0] | {"level": [2, 2]}]),
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


def instances(node, place=""):
    """Every example and default in a schema, with the node that it belongs to."""
    if isinstance(node, list):
        for k, item in enumerate(node):
            yield from instances(item, f"{place}/{k}")
    if not isinstance(node, dict):
        return
    if "properties" in node or "$ref" in node or "type" in node or "anyOf" in node or "enum" in node:
        own = {key: value for key, value in node.items() if key not in ("examples", "default")}
        for value in node.get("examples", []) + [node[key] for key in ["default"] if key in node]:
            yield place, own, value
    for key, value in node.items():
        if key not in ("examples", "default"):
            yield from instances(value, f"{place}/{key}")


@unittest.skipIf(jsonschema is None, "the Python module jsonschema is missing")
class Examples(unittest.TestCase):
    def test_every_example_and_default_is_one(self):
        for path in sorted((ROOT / "data/schema").glob("*.schema.json")):
            schema = json.loads(path.read_text())
            jsonschema.Draft202012Validator.check_schema(schema)
            found = list(instances(schema))
            self.assertGreater(len(found), 0)
            for place, own, value in found:
                with self.subTest(path.name + place):
                    validator = jsonschema.Draft202012Validator(own | {"$defs": schema.get("$defs", {})})
                    self.assertEqual([error.message for error in validator.iter_errors(value)], [])

    def test_a_wrong_default_is_noticed(self):
        (place, own, value), = instances({"type": "integer", "default": "two"})
        self.assertNotEqual(list(jsonschema.Draft202012Validator(own).iter_errors(value)), [])


if __name__ == "__main__":
    unittest.main()

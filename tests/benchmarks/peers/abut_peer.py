# SPDX-License-Identifier: GPL-3.0-or-later
"""A problem through abut: the scene of data/verification, as many of its steps as the peers take, written out as JSON only."""
import dataclasses
import json
import os
import re

import measured_process

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../data/verification")
PROGRAM = "abut"  # side_by_side.py --abut


@dataclasses.dataclass
class Settings:
    accuracy: str = "standard"  # a level, or an error to aim at; "" for the scene's own
    options: dict = dataclasses.field(default_factory=dict)  # of the scene's "accuracy"

    def text(self):
        words = [f"--accuracy {self.accuracy}"] if self.accuracy else []
        return ", ".join(words + [f"{name} {json.dumps(value)}" for name, value in self.options.items()])


def missing():
    return [] if os.access(PROGRAM, os.X_OK) else [f"abut ({PROGRAM})"]


def scene(problem, settings):
    with open(os.path.join(SCENES, problem.scene)) as file:
        found = json.loads(re.sub("//.*", "", file.read()))
    if "steps" in found:
        found["steps"] = found["steps"][:len(problem.steps)]
    found["output"] = {"formats": ["json"]}
    found["accuracy"] = {**found.get("accuracy", {}), **settings.options}
    return found


def command(settings):
    words = [PROGRAM, "analyze", "scene.json", "-o", "out", "--quiet", "--threads", "1"]
    return words + (["--accuracy", settings.accuracy] if settings.accuracy else [])


def solve(problem, settings, folder):
    """(profile, unknowns, usage of abut, no usage of a mesher)."""
    with open(os.path.join(folder, "scene.json"), "w") as file:
        json.dump(scene(problem, settings), file)
    usage, _ = measured_process.run(command(settings), folder)
    last = f"case_{len(problem.steps)}" if len(problem.steps) > 1 else ""
    with open(os.path.join(folder, "out", last, "result.json")) as file:
        answer = json.load(file)
    profile = answer["contacts"][0]["profile"]
    return list(zip(profile["x"], profile[problem.quantity])), answer["unknowns"], usage, measured_process.Usage()

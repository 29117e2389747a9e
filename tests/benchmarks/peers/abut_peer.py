# SPDX-License-Identifier: GPL-3.0-or-later
"""The problem through abut: the scene as it is in data/verification, written out as JSON only."""
import dataclasses
import json
import os

import measured_process

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../data/verification/hertz_001.json")
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


def scene_text(settings):
    with open(SCENE) as file:
        text = file.read().rstrip().removesuffix("}")
    more = {"output": {"formats": ["json"]}, "accuracy": settings.options}
    return text + ", " + json.dumps(more).removeprefix("{") + "\n"


def command(settings):
    words = [PROGRAM, "analyze", "hertz.json", "-o", "out", "--quiet", "--threads", "1"]
    return words + (["--accuracy", settings.accuracy] if settings.accuracy else [])


def solve(settings, folder):
    """(profile, unknowns, usage of abut, no usage of a mesher)."""
    with open(os.path.join(folder, "hertz.json"), "w") as file:
        file.write(scene_text(settings))
    usage, _ = measured_process.run(command(settings), folder)
    with open(os.path.join(folder, "out", "result.json")) as file:
        answer = json.load(file)
    profile = answer["contacts"][0]["profile"]
    return list(zip(profile["x"], profile["pressure"])), answer["unknowns"], usage, measured_process.Usage()

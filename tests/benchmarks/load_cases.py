#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What load cases cost: processor time of `abut analyze` for n cases over that for one, the loads between 0.2 and 2 of the scene's.

load_cases.py ABUT [RUNS]: the program, and how many runs each median is of (5)."""
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data/scenes")


def scene_with(name, n):
    """The scene as it is (n = 0), or with n cases of its loads."""
    with open(os.path.join(SCENES, name)) as file:
        scene = json.loads(re.sub(r"^\s*//.*$", "", file.read(), flags=re.M))
    scene["assembly"]["file"] = os.path.join(SCENES, scene["assembly"]["file"])
    if n:
        for load in scene["loads"]:
            load["name"] = "all"
        scene["cases"] = [{"name": str(k), "loads": {"all": 0.2 + 1.8 * k / (n - 1)}} for k in range(n)]
    return scene


def seconds(abut, scene, folder):
    path = os.path.join(folder, "scene.json")
    with open(path, "w") as file:
        json.dump(scene, file)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([abut, "analyze", path, "-o", os.path.join(folder, "out"), "--threads", "1", "--quiet"],
                   stderr=subprocess.DEVNULL, env=dict(os.environ, OPENBLAS_NUM_THREADS="1"))
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    abut, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5
    for name, n in (("pin_bracket.json", 10), ("vise_clamp.json", 10), ("vise_clamp.json", 100)):
        with tempfile.TemporaryDirectory() as folder:
            one = statistics.median(seconds(abut, scene_with(name, 0), folder) for _ in range(runs))
            all_cases = statistics.median(seconds(abut, scene_with(name, n), folder) for _ in range(runs))
        print(f"{name}: one {one:.2f} s, {n} cases {all_cases:.2f} s, {all_cases / one:.1f} times as much")


main()

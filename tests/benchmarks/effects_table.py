#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each effect costs: one plate of more than 50 thousand unknowns, effects switched on one after the other.

    effects_table.py ABUT [--size H] [--runs N]

Every row is the scene of the row before with one effect more. Seconds are the processor time of the whole run on one thread,
the least of N runs; memory is the process's largest; "of plate" compares with the first row. `own s` is the wall time that the
result gives for the effect itself, `items` what it worked on.
"""
import argparse
import json
import os
import subprocess
import tempfile

PLATE = {"name": "plate", "material": "m", "geometry": {"difference": [
    {"rectangle": {"min": [0, 0], "max": [4, 2]}}, {"circle": {"center": [2.1, 0.9], "radius": 0.4}}]}}
BLOCK = {"name": "block", "material": "m", "geometry": {"rectangle": {"min": [4, 0.5], "max": [4.5, 1.5]}}}
STRIP = {"name": "strip", "material": "m", "geometry": {"rectangle": {"min": [-0.5, 0.5], "max": [0, 1.5]}}}
PUNCH = {"name": "punch", "material": "rigid", "geometry": {"rectangle": {"min": [1, 2], "max": [1.5, 2.5]}}}


def base_scene(size):
    """A plate held at its bottom under pressure: elasticity and edge loads, nothing else."""
    return {"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 1e-3}}, "parts": [PLATE],
            "supports": [{"on": "plate/bottom", "fix": ["x", "y"]}], "loads": [{"on": "plate/top", "pressure": 10}],
            "contacts": {"detect": True, "pairs": []}, "accuracy": {"cell_size": size}, "output": {"formats": ["json"]}}


def with_body_force(s):
    s["loads"].append({"part": "plate", "body_force": [1, "x"]})


def with_gravity(s):
    s["loads"].append({"gravity": [0, -9.81]})


def with_springs(s):
    s["supports"].append({"on": "plate/left", "spring": {"normal": 1e3, "tangential": 10}})


def with_rigid_support(s):
    s["supports"].append({"part": "plate", "rigid": {"translation": [None, None], "rotation": 0}})


def with_contact(s):
    s["parts"].append(BLOCK)
    s["supports"].append({"on": "block/right", "fix": ["x", "y"]})


def with_interference(s):
    s["contacts"]["pairs"].append({"between": ["plate/right", "block/left"], "interference": 1e-5})


def with_bonding(s):
    s["parts"].append(STRIP)
    s["contacts"]["pairs"].append({"between": ["strip/right", "plate/left"], "kind": "bonded"})


def with_rigid_part(s):
    s["parts"].append(PUNCH)
    s["supports"].append({"on": "punch/left", "symmetry": True})
    s["loads"].append({"on": "punch/top", "pressure": 10})


STEPS = [("elasticity", lambda s: None), ("body force", with_body_force), ("gravity", with_gravity),
         ("springs", with_springs), ("rigid supports", with_rigid_support), ("contact", with_contact),
         ("interference", with_interference), ("bonding", with_bonding), ("rigid parts", with_rigid_part)]


def run_once(program, scene):
    """The result, the processor time in seconds, and the largest memory of the process in MB."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(scene, file)
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
        process = subprocess.Popen([program, "analyze", path, "-o", folder, "--quiet", "--threads", "1"], env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            raise SystemExit(f"{program} failed on {path}")
        with open(os.path.join(folder, "result.json"), encoding="utf-8") as file:
            return json.load(file), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measured(program, scene, runs):
    results = [run_once(program, scene) for _ in range(runs)]
    best = min(results, key=lambda r: r[1])
    return best[0], best[1], min(memory for _, _, memory in results)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("abut")
    parser.add_argument("--size", type=float, default=0.0171, help="cell size; the default gives 50 thousand unknowns")
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args()
    scene, first = base_scene(options.size), None
    print("| with | unknowns | multipliers | s | of plate | own s | items | MB | of plate |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for name, add in STEPS:
        add(scene)
        result, seconds, memory = measured(options.abut, scene, options.runs)
        first = first or (seconds, memory)
        effect = next((e for e in result["effects"] if e["name"] == name), {})
        print(f"| {name} | {result['unknowns']} | {result['multipliers']} | {seconds:.3f} | {seconds / first[0]:.2f} | "
              f"{effect.get('seconds', 0):.4f} | {effect.get('items', 0)} | {memory:.0f} | {memory / first[1]:.2f} |", flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `abut contacts` over folders of drawings and meshes with two builds of the program, and compares: accepted, refused
(why), warned; numbers of parts and of pairs.

compare_inputs.py BEFORE AFTER FOLDER...: prints a table of what differs, and the sums. BEFORE and AFTER are programs."""
import json
import pathlib
import subprocess
import sys
import tempfile

KINDS = {".dxf", ".stl", ".obj", ".3mf", ".ply", ".gltf", ".glb", ".dae"}


def run(program, file):
    with tempfile.TemporaryDirectory() as folder:
        try:
            done = subprocess.run([program, "contacts", file, "-o", folder], capture_output=True, text=True, errors="replace", timeout=120)
        except subprocess.TimeoutExpired:
            return {"state": "timeout", "why": "", "parts": 0, "pairs": 0, "warnings": 0}
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [""]
            return {"state": "refused", "why": lines[0], "parts": 0, "pairs": 0, "warnings": 0}
        contacts = json.loads((pathlib.Path(folder) / "contacts.json").read_text())
        seen = subprocess.run([program, "inspect", file, "--json"], capture_output=True, text=True, errors="replace", timeout=120)
        parts = len(json.loads(seen.stdout)["parts"]) if seen.stdout.startswith("{") else 0
        warnings = contacts.get("warnings", [])
        return {"state": "warned" if warnings else "accepted", "why": "; ".join(warnings), "parts": parts,
                "pairs": len(contacts["pairs"]), "warnings": len(warnings)}


def main():
    before, after, *folders = sys.argv[1:]
    files = sorted(f for folder in folders for f in pathlib.Path(folder).rglob("*") if f.suffix.lower() in KINDS)
    sums = {}
    for file in files:
        old, new = run(before, file), run(after, file)
        sums[old["state"], new["state"]] = sums.get((old["state"], new["state"]), 0) + 1
        if (old["state"] == "refused") != (new["state"] == "refused") or old["parts"] != new["parts"] or old["pairs"] != new["pairs"]:
            print(f"{file}: {old['state']} {old['parts']} parts {old['pairs']} pairs -> {new['state']} {new['parts']} parts "
                  f"{new['pairs']} pairs {new['why'][:200]}")
    for (old, new), n in sorted(sums.items()):
        print(f"{n} files: {old} -> {new}")


if __name__ == "__main__":
    main()

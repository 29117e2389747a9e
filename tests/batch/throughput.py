#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs per second of abut batch, and whether answers depend on the number of workers: throughput.py ABUT [--count N] [--workers N].

For contact detection alone and for whole analyses of two parts (draft, result.json only): wall time and processor time for one
worker and for several, in a folder of its own. The answers are compared by same_answers.py.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent


def timed(words):
    before, start = os.times(), time.perf_counter()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = os.times()
    cpu = after.children_user - before.children_user + after.children_system - before.children_system
    return time.perf_counter() - start, cpu


def measure(what, words, count, workers, folder):
    walls = {}
    for j in [1, workers]:
        out = folder / f"{what.replace(' ', '_')}_{j}"
        walls[j], cpu = timed([*words, "-o", str(out), "-j", str(j), "--quiet"])
        print(f"{what}, -j {j}: {walls[j]:.2f} s, {count / walls[j]:.1f} jobs/s; processor {1e3 * cpu / count:.1f} ms a job", flush=True)
    print(f"{what}: {walls[1] / walls[workers]:.2f} times as fast with {workers} workers", flush=True)
    outs = [str(folder / f"{what.replace(' ', '_')}_{j}") for j in [1, workers]]
    return subprocess.run([sys.executable, str(HERE / "same_answers.py"), *outs]).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("abut")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=2)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for kind, more in [("varied", []), ("two", ["--two-parts"])]:
            generate = [sys.executable, str(HERE / "sketches.py"), str(folder / kind), "--count", str(arguments.count), *more]
            subprocess.run(generate, check=True)
        batch = [arguments.abut, "batch"]
        contacts = [*batch, str(folder / "varied/drawings"), "--only", "contacts", "--accuracy", "draft"]
        analyses = [*batch, str(folder / "two/jobs.csv"), "--template", str(folder / "two/template.json")]
        sizes = arguments.count, arguments.workers, folder
        return measure("contacts only", contacts, *sizes) | measure("whole analyses", analyses, *sizes)


if __name__ == "__main__":
    sys.exit(main())

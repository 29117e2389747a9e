#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same contact problem through abut, CalculiX and GetFEM, alternating, with time, memory, unknowns and error of each."""
import argparse
import dataclasses
import json
import os
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True

import abut_peer
import contact_problem
import error_curve
from settings import ERROR_LEVELS, EXPECTED, PROGRAMS, SETTINGS


@dataclasses.dataclass
class Case:
    program: str
    setting: object
    runs: list = dataclasses.field(default_factory=list)  # (usage of the program, usage of gmsh)
    unknowns: int = 0
    error: float = 0.0
    peak_error: float = 0.0
    failure: str = ""

    def median(self, field, meshing_only=False):
        return statistics.median(getattr(mesh if meshing_only else own + mesh, field) for own, mesh in self.runs)


def run_once(case, problem, solve):
    if case.failure:
        return
    try:
        with tempfile.TemporaryDirectory() as folder:
            profile, case.unknowns, own, meshing = solve(problem, case.setting, folder)
    except (RuntimeError, OSError, KeyError, IndexError, ValueError) as problem:
        case.failure = str(problem).replace("\n", " ")[-160:]
        return
    case.error, case.peak_error = contact_problem.errors(problem, profile)
    case.runs.append((own, meshing))


def measure(problem, programs, repeats):
    """All cases in turns: what the machine does besides falls on all of them."""
    cases = [Case(name, setting) for name in programs for setting in SETTINGS[problem.name][name]]
    for repeat in range(repeats):
        for case in cases:
            print(f"\r{repeat + 1}/{repeats} {case.program:10}", end="", file=sys.stderr, flush=True)
            run_once(case, problem, PROGRAMS[case.program].solve)
    print("\r" + 30 * " ", end="\r", file=sys.stderr)
    return cases


def print_table(cases):
    width = max(len(case.setting.text()) for case in cases)
    print(f"{'program':9} {'settings':{width}} {'unknowns':>8} {'error %':>8} {'peak %':>7} {'wall s':>8} {'CPU s':>8} "
          f"{'MiB':>5}   gmsh: {'wall s':>6} {'CPU s':>6}")
    for case in cases:
        begin = f"{case.program:9} {case.setting.text():{width}}"
        if case.failure:
            print(f"{begin} failed: {case.failure}")
            continue
        gmsh = [case.median(field, meshing_only=True) for field in ("wall", "cpu")]
        print(f"{begin} {case.unknowns:8} {100 * case.error:8.3f} {100 * case.peak_error:7.3f} {case.median('wall'):8.3f} "
              f"{case.median('cpu'):8.3f} {case.median('memory'):5.0f}         {gmsh[0]:6.3f} {gmsh[1]:6.3f}")


def cost(cases, program, error, field):
    pairs = [(case.error, case.median(field)) for case in cases if case.program == program and case.runs]
    return error_curve.cost_of(error, pairs)


def ratio_text(own, other):
    if own is None or other is None:
        return "not reached by " + ("abut" if own is None else "it")
    # where abut is more accurate than asked, it is at least so much faster; where the other one is, at most
    sign = {(True, False): ">= ", (False, True): "<= ", (True, True): "~ "}.get((own.is_bound, other.is_bound), "")
    return f"{sign}{other.seconds / own.seconds:.1f} ({other.seconds:.2f} s / {own.seconds:.3f} s)"


def print_ratios(cases, programs, levels):
    for field, words in (("wall", "whole-process time"), ("cpu", "CPU time")):
        print(f"\n{words} of the other program over abut's, mesh generation included:")
        for error in levels:
            own = cost(cases, "abut", error, field)
            texts = [f"{name} {ratio_text(own, cost(cases, name, error, field))} [aim {EXPECTED[name]}]"
                     for name in programs if name != "abut"]
            print(f"  at {100 * error:g} %: " + "; ".join(texts))


def as_json(cases):
    return [{"program": c.program, "settings": c.setting.text(), "unknowns": c.unknowns, "error": c.error,
             "peak_error": c.peak_error, "failure": c.failure,
             "runs": [{"program": dataclasses.asdict(own), "gmsh": dataclasses.asdict(mesh)} for own, mesh in c.runs]}
            for c in cases]


def parsed(words):
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problem", choices=list(contact_problem.PROBLEMS), default="hertz", help="the one solved (hertz)")
    parser.add_argument("--abut", default=os.path.join(here, "../../../build/apps/abut"), help="the program (build/apps/abut)")
    parser.add_argument("--repeats", type=int, default=5, help="of every case; medians are shown (5)")
    parser.add_argument("--only", nargs="*", choices=list(PROGRAMS), default=list(PROGRAMS), help="programs to run")
    parser.add_argument("--json", help="file for every single run")
    return parser.parse_args(words)


def main(words):
    options = parsed(words)
    abut_peer.PROGRAM = os.path.abspath(options.abut)
    programs = []
    for name in options.only:
        absent = PROGRAMS[name].missing()
        if absent:
            print(f"{name} is left out: not installed: {', '.join(absent)}")
        else:
            programs.append(name)
    if not programs:
        return 1
    cases = measure(contact_problem.PROBLEMS[options.problem], programs, options.repeats)
    print_table(cases)
    if "abut" in programs and len(programs) > 1:
        print_ratios(cases, programs, ERROR_LEVELS[options.problem])
    if options.json:
        with open(options.json, "w") as file:
            json.dump(as_json(cases), file, indent=1)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

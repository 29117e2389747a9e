# SPDX-License-Identifier: GPL-3.0-or-later
"""A problem through GetFEM: getfem_program.py as a process of its own."""
import dataclasses
import functools
import json
import os
import shutil
import subprocess

import gmsh_mesh
import measured_process
from contact_problem import START_OVERLAP

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "getfem_program.py")


@dataclasses.dataclass
class Settings:
    mesh: gmsh_mesh.MeshSettings
    augmentation: float = 3.0  # times E / a
    residual: float = 1e-8

    def text(self):
        mesh = f"a/{self.mesh.cells_in_a:g}, growth {self.mesh.growth:g}"
        return f"P2, {mesh}, augmented Lagrangian {self.augmentation:g} E/a, MUMPS"


@functools.cache
def python():
    """The first Python that has GetFEM; apt's belongs to /usr/bin/python3."""
    for candidate in ("/usr/bin/python3", shutil.which("python3")):
        if candidate and os.path.exists(candidate):
            if subprocess.run([candidate, "-c", "import getfem"], capture_output=True).returncode == 0:
                return candidate
    return None


def missing():
    return ([] if python() else ["getfem (for Python)"]) + ([] if shutil.which("gmsh") else ["gmsh"])


def solve(problem, settings, folder):
    """(profile, unknowns, usage of GetFEM, usage of gmsh)."""
    meshing = gmsh_mesh.make(settings.mesh, problem.full, START_OVERLAP, folder)
    options = json.dumps({"problem": problem.name, "augmentation": settings.augmentation, "residual": settings.residual})
    usage, _ = measured_process.run([python(), PROGRAM, folder, options], folder)
    with open(os.path.join(folder, "result.json")) as file:
        answer = json.load(file)
    if not answer["converged"]:
        raise RuntimeError(f"GetFEM: no convergence in {answer['iterations']} iterations")
    return answer["profile"], answer["unknowns"], usage, meshing

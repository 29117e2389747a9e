# SPDX-License-Identifier: GPL-3.0-or-later
"""A problem as a deck for CalculiX, and the contact stress from its nodal stresses.

Plane stress elements of second order. CalculiX expands them to solids of one layer; the thickness is a small share of the
contact's width so that nothing varies across it. Contact is a penalty, surface to surface unless the settings say otherwise.
"""
import dataclasses
import os
import shutil

import gmsh_mesh
import measured_process
from contact_problem import HALF_WIDTH, MODULUS, POISSON, START_OVERLAP

THICKNESS = HALF_WIDTH / 100


@dataclasses.dataclass
class Settings:
    mesh: gmsh_mesh.MeshSettings
    penalty: float = 50.0  # times E / a
    stick_slope: float = 0.0  # of friction, times E / a; 0: as the penalty
    formulation: str = "SURFACE TO SURFACE"  # or NODE TO SURFACE, MORTAR
    first_increment: float = 1.0
    source: str = "nodal stress"  # or "contact stress"

    def text(self):
        kind = "CPS8" if self.mesh.quads else "CPS6"
        stick = f", sticking {self.stick_slope:g} E/a" if self.stick_slope else ""
        return f"{kind}, a/{self.mesh.cells_in_a:g}, {self.formulation.lower()}, {self.penalty:g} E/a{stick}, {self.source}"


def missing():
    return [name for name in ("ccx", "gmsh") if shutil.which(name) is None]


def rows(numbers, per_line=12):
    numbers = [str(n) for n in numbers]
    return ",\n".join(", ".join(numbers[k:k + per_line]) for k in range(0, len(numbers), per_line)) + "\n"


def used_nodes(mesh):
    elements = [e for group in (mesh.triangles, mesh.quads) for part in group.values() for e in part]
    return sorted({n for e in elements for n in e})


def numbered_elements(mesh):
    """(number, CalculiX' type, nodes), those of the lower part after those of the upper one."""
    found, number = [], 0
    for part in (gmsh_mesh.UPPER, gmsh_mesh.LOWER):
        for kind, group in (("CPS6", mesh.triangles), ("CPS8", mesh.quads)):
            for nodes in group[part]:
                number += 1
                found.append((number, kind, nodes))
    return found


def faces(elements, lines):
    """(element, face) of each line: face k lies between the corners k and k + 1."""
    wanted = {frozenset(line[:2]) for line in lines}
    found = []
    for number, kind, nodes in elements:
        n = 3 if kind == "CPS6" else 4
        for k in range(n):
            if frozenset((nodes[k], nodes[(k + 1) % n])) in wanted:
                found.append((number, k + 1))
    return found


def on(mesh, line):
    return sorted({n for nodes in mesh.lines[line] for n in nodes})


def near_contact(mesh, line, reach):
    """Lines of an arc from which contact can be expected."""
    return [nodes for nodes in mesh.lines[line] if min(abs(mesh.nodes[n][0]) for n in nodes) < reach]


def held(mesh, problem):
    """Sets of nodes, supports, and equations: the top moves as a whole. Also the node that its force acts on."""
    left = on(mesh, gmsh_mesh.UPPER_LEFT) + on(mesh, gmsh_mesh.LOWER_LEFT)
    first, *others = on(mesh, gmsh_mesh.TOP)
    text = "*NSET, NSET=BOTTOM\n" + rows(on(mesh, gmsh_mesh.BOTTOM))
    text += "" if problem.full else "*NSET, NSET=MIDDLE\n" + rows(left + [first, *others])
    for direction in (1, 2) if problem.full else (2,):
        text += "".join(f"*EQUATION\n2\n{n}, {direction}, 1., {first}, {direction}, -1.\n" for n in others)
    return text + "*BOUNDARY\nBOTTOM, 1, 2\n" + ("" if problem.full else "MIDDLE, 1, 1\n"), first


def deck(mesh, problem, settings):
    elements = numbered_elements(mesh)
    text = ["*NODE, NSET=ALL\n"]
    text += [f"{n}, {mesh.nodes[n][0]:.13g}, {mesh.nodes[n][1]:.13g}, 0\n" for n in used_nodes(mesh)]
    for kind in ("CPS6", "CPS8"):
        of_kind = [e for e in elements if e[1] == kind]
        if of_kind:
            text.append(f"*ELEMENT, TYPE={kind}, ELSET=ALL\n")
            text += [f"{number}, {', '.join(map(str, nodes))}\n" for number, _, nodes in of_kind]
    supports, loaded = held(mesh, problem)
    reach = 4 * HALF_WIDTH
    for name, line in (("SLAVE", gmsh_mesh.UPPER_ARC), ("MASTER", gmsh_mesh.LOWER_ARC)):
        if name == "SLAVE" and settings.formulation == "NODE TO SURFACE":
            nodes = sorted({n for nodes in near_contact(mesh, line, reach) for n in nodes})
            text.append("*SURFACE, NAME=SLAVE, TYPE=NODE\n" + "".join(f"{n}\n" for n in nodes))
            continue
        text.append(f"*SURFACE, NAME={name}, TYPE=ELEMENT\n")
        text += [f"{e}, S{face}\n" for e, face in faces(elements, near_contact(mesh, line, reach))]
    text.append(f"*MATERIAL, NAME=M\n*ELASTIC\n{MODULUS:g}, {POISSON:g}\n"
                f"*SOLID SECTION, ELSET=ALL, MATERIAL=M\n{THICKNESS:.13g}\n" + supports)
    stiffness = settings.penalty * MODULUS / HALF_WIDTH
    behaviour = "HARD" if settings.formulation == "MORTAR" else "LINEAR"
    text.append(f"*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={behaviour}\n")
    text.append(f"{stiffness:.13g}\n" if behaviour == "LINEAR" else "")
    if problem.friction:
        text.append(f"*FRICTION\n{problem.friction:g}, {(settings.stick_slope or settings.penalty) * MODULUS / HALF_WIDTH:.13g}\n")
    text.append(f"*CONTACT PAIR, INTERACTION=I, TYPE={settings.formulation}\nSLAVE, MASTER\n")
    share = 1 if problem.full else 0.5
    for force in problem.steps:
        text.append(f"*STEP\n*STATIC\n{settings.first_increment:g}, 1.\n*CLOAD\n")
        text += [f"{loaded}, {k + 1}, {share * THICKNESS * value:.13g}\n" for k, value in enumerate(force) if value]
        text.append("*EL FILE, OUTPUT=2D, FREQUENCY=1000\nS\n")
        text.append("*CONTACT FILE, FREQUENCY=1000\nCDIS, CSTR\n" if settings.source == "contact stress" else "")
        text.append("*END STEP\n")
    return "".join(text)


def last_block(path, name, components):
    """{node: values} of the last block of results called so in a .frd file; {} where there is none."""
    found, inside = {}, False
    with open(path) as file:
        for line in file:
            if line.startswith(" -4"):
                inside = line.split()[1] == name
                found = {} if inside else found
            elif inside and line.startswith(" -1"):
                found[int(line[3:13])] = [float(line[13 + 12 * k:25 + 12 * k]) for k in range(components)]
            elif line.startswith(" -3"):
                inside = False
    return found


def profile(mesh, problem, settings, path):
    """(x, traction) at the nodes of the upper arc: from its stress and its normal n, or CalculiX' contact stress."""
    stress = last_block(path, "STRESS", 6)
    contact = last_block(path, "CONTACT", 6) if settings.source == "contact stress" else {}
    points = []
    for n in on(mesh, gmsh_mesh.UPPER_ARC):
        x = mesh.nodes[n][0]
        if settings.source == "contact stress":
            points.append((x, contact[n][3 if problem.quantity == "pressure" else 4] if n in contact else 0.0))
            continue
        sxx, syy, _, sxy = stress[n][:4]
        nx, ny = x, -((1 - x * x) ** 0.5) if abs(x) < 1 else 0.0
        tx, ty = nx * sxx + ny * sxy, nx * sxy + ny * syy
        points.append((x, max(0.0, -(nx * tx + ny * ty)) if problem.quantity == "pressure" else -tx))
    return sorted(points)


def solve(problem, settings, folder):
    """(profile, unknowns, usage of CalculiX, usage of gmsh)."""
    meshing = gmsh_mesh.make(settings.mesh, problem.full, START_OVERLAP, folder)
    mesh = gmsh_mesh.read(os.path.join(folder, "mesh.msh"))
    with open(os.path.join(folder, "deck.inp"), "w") as file:
        file.write(deck(mesh, problem, settings))
    usage, output = measured_process.run(["ccx", "-i", "deck"], folder)
    if "Job finished" not in output:
        raise RuntimeError("CalculiX: " + output.strip().split("\n")[-1])
    points = profile(mesh, problem, settings, os.path.join(folder, "deck.frd"))
    return points, 2 * len(used_nodes(mesh)), usage, meshing

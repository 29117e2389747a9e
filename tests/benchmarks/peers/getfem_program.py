# SPDX-License-Identifier: GPL-3.0-or-later
"""The program of a GetFEM user: reads mesh.msh, solves, writes the contact traction to result.json.

A process of its own, run by the Python that has GetFEM. Arguments: folder, and the settings as JSON (getfem_peer.py).

Displacements of second order; contact by GetFEM's augmented Lagrangian with ray tracing, symmetric version, with a multiplier
of first order on the upper arc. (Its integral brick for meshes that do not match finds no partner across an open gap; elements
of second order for the multiplier oscillate; the multiplier's values at the nodes are the tractions that are compared.)
Friction: each step's displacements less those of the step before it are what has slid.
"""
import json
import os
import sys

import getfem
import numpy

from gmsh_mesh import BOTTOM, LOWER, LOWER_ARC, LOWER_LEFT, TOP, UPPER, UPPER_ARC, UPPER_LEFT
from contact_problem import HALF_WIDTH, MODULUS, POISSON, PROBLEMS, RADIUS

CONTACT = 100  # the region from which contact can be expected
REACH = 4 * HALF_WIDTH
ALIVE = []  # GetFEM crashes or complains where a mesh or a space that others were made of is gone


def body(whole, tag, arc):
    """The mesh of one part, with its contact region."""
    mesh = getfem.Mesh("clone", whole)
    mesh.del_convex(numpy.setdiff1d(mesh.cvid(), whole.region(tag)[0]))
    near = [face for face in mesh.region(arc).T if abs(mesh.pts_from_cvid(face[0])[0][0]).min() < REACH]
    mesh.set_region(CONTACT, numpy.array(near).T)
    return mesh


def vector_functions(mesh, degree):
    fem = getfem.MeshFem(mesh, 2)
    fem.set_fem(getfem.Fem(f"FEM_PK(2,{degree})"))
    return fem


def part_of(fem, kept):
    ALIVE.append(fem)
    return getfem.MeshFem("partial", fem, kept)


def displacements(mesh, held, moving):
    """Functions without those that are held, those of a moving region in one: (region, component) each."""
    fem = vector_functions(mesh, 2)

    def of(region, component):
        return [dof for dof in fem.basic_dof_on_region(region) if dof % 2 == component]

    groups = [of(*place) for place in moving]
    gone = {dof for place in held for dof in of(*place)} | {dof for first, *others in groups for dof in others}
    kept = sorted(set(range(fem.nbdof())) - gone)
    every, one = range(fem.nbdof()), getfem.Spmat("identity", fem.nbdof())
    extension = getfem.Spmat("copy", one, every, kept)
    for first, *others in groups:
        for dof in others:
            extension[dof, kept.index(first)] = 1.0
    fem.reduction_matrices(getfem.Spmat("copy", one, kept, every), extension)
    return fem


def multipliers(mesh):
    """Functions of the nodes on the contact region, whose coefficients are tractions there; x of these nodes."""
    fem = vector_functions(mesh, 1)
    nodes = fem.basic_dof_on_region(CONTACT)
    return part_of(fem, nodes), fem.basic_dof_nodes(nodes)[0][::2]


def add_contact(model, meshes, integrations, friction, settings):
    """x of the multiplier's nodes."""
    functions, x = multipliers(meshes[0])
    model.add_fem_variable("traction", functions)
    model.add_initialized_data("augmentation", [settings["augmentation"] * MODULUS / HALF_WIDTH])
    model.add_initialized_data("friction", [friction])
    model.add_initialized_data("rate", [1.0])
    symmetric = 1
    brick = model.add_integral_large_sliding_contact_brick_raytracing("augmentation", HALF_WIDTH, "friction", "rate",
                                                                      symmetric)
    along = getfem.MeshIm(meshes[0], getfem.Integ("IM_TRIANGLE(6)"))
    ALIVE.append(along)
    model.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, along, CONTACT, "u1", "traction", "before1")
    model.add_master_contact_boundary_to_large_sliding_contact_brick(brick, integrations[1], CONTACT, "u2", "before2")
    return x


def build(folder, problem, settings):
    whole = getfem.Mesh("import", "gmsh", os.path.join(folder, "mesh.msh"))
    meshes = body(whole, UPPER, UPPER_ARC), body(whole, LOWER, LOWER_ARC)
    model = getfem.Model("real")
    model.add_initialized_data("lambda", [MODULUS * POISSON / (1 - POISSON**2)])  # plane stress
    model.add_initialized_data("mu", [MODULUS / (2 * (1 + POISSON))])
    integrations = [getfem.MeshIm(mesh, getfem.Integ("IM_TRIANGLE(4)")) for mesh in meshes]
    ALIVE.extend([*meshes, *integrations])
    held = ([], []) if problem.full else ([(UPPER_LEFT, 0), (TOP, 0)], [(LOWER_LEFT, 0)])
    held[1].extend([(BOTTOM, 0), (BOTTOM, 1)])
    moving = [(TOP, 0), (TOP, 1)] if problem.full else [(TOP, 1)], []
    for k, (mesh, integration) in enumerate(zip(meshes, integrations)):
        functions = displacements(mesh, held[k], moving[k])
        model.add_fem_variable(f"u{k + 1}", functions)
        model.add_initialized_fem_data(f"before{k + 1}", functions, numpy.zeros(functions.nbdof()))
        model.add_isotropic_linearized_elasticity_brick(integration, f"u{k + 1}", "lambda", "mu")
        ALIVE.append(functions)
    model.add_initialized_data("top", [0.0, 0.0])
    model.add_source_term_brick(integrations[0], "u1", "top", TOP)
    return model, add_contact(model, meshes, integrations, problem.friction, settings)


def main(folder, settings):
    problem = PROBLEMS[settings["problem"]]
    model, x = build(folder, problem, settings)
    taken = []
    for force in problem.steps:
        model.set_variable("top", [value / (2 * RADIUS) for value in force])
        taken.append(model.solve("max_res", settings["residual"], "max_iter", 60, "lsolver", "mumps"))
        for k in (1, 2):
            model.set_variable(f"before{k}", model.variable(f"u{k}"))
    traction = model.variable("traction")  # on the upper part
    values = traction[1::2] if problem.quantity == "pressure" else -traction[::2]
    answer = {"profile": sorted(zip(x.tolist(), values.tolist())), "unknowns": int(model.nbdof()),
              "iterations": [int(n) for n, _ in taken], "converged": all(converged for _, converged in taken)}
    with open(os.path.join(folder, "result.json"), "w") as file:
        json.dump(answer, file)


if __name__ == "__main__":
    main(sys.argv[1], json.loads(sys.argv[2]))

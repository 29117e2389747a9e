# SPDX-License-Identifier: GPL-3.0-or-later
"""What the comparison rests on, without any of the programs: python3 -B -m unittest discover -s tests/benchmarks/peers."""
import math
import tempfile
import unittest

import abut_peer
import calculix
import contact_problem
import error_curve
import gmsh_mesh
import measured_process
from contact_problem import FORCE, FRICTION, HALF_WIDTH, MODULUS, PEAK, PROBLEMS, SHEAR_FORCE, STICK_HALF_WIDTH

HERTZ, CATTANEO = PROBLEMS["hertz"], PROBLEMS["cattaneo"]


def sampled(problem, values, points=2000):
    """From the beginning of the contact to its width beyond its end."""
    step = (2 * HALF_WIDTH - problem.begin()) / points
    return [(problem.begin() + k * step, values(problem.begin() + k * step)) for k in range(points + 1)]


class Exact(unittest.TestCase):
    def force(self, values, points=100000):
        return sum(values(HALF_WIDTH * (2 * k + 1 - points) / points) for k in range(points)) * 2 * HALF_WIDTH / points

    def test_tractions_carry_the_forces(self):
        self.assertAlmostEqual(self.force(HERTZ.exact) / FORCE, 1, places=6)
        self.assertAlmostEqual(self.force(CATTANEO.exact) / SHEAR_FORCE, 1, places=6)
        self.assertEqual(CATTANEO.steps, ((0, -FORCE), (SHEAR_FORCE, -FORCE)))

    def test_shear_is_at_its_bound_where_it_slips_only(self):
        for share in (0.75, 0.9, 0.99):
            self.assertAlmostEqual(CATTANEO.exact(share * HALF_WIDTH), FRICTION * HERTZ.exact(share * HALF_WIDTH), places=9)
        for share in (0, 0.4, 0.7):
            self.assertLess(CATTANEO.exact(share * HALF_WIDTH), 0.99 * FRICTION * HERTZ.exact(share * HALF_WIDTH))
        self.assertAlmostEqual(max(v for _, v in sampled(CATTANEO, CATTANEO.exact)) / CATTANEO.largest, 1, delta=1e-2)

    def test_scenes_are_these_problems(self):
        for problem in PROBLEMS.values():
            scene = abut_peer.scene(problem, abut_peer.Settings())
            self.assertEqual(len(scene.get("steps", [1])), len(problem.steps))
            self.assertAlmostEqual(scene["parameters"]["P"] * (1 if problem.full else 2), FORCE, places=12)
            self.assertEqual(scene["parameters"].get("mu", 0), problem.friction)
            sheared = scene["parameters"].get("share", 0) * problem.friction * FORCE
            self.assertAlmostEqual(sheared, problem.steps[-1][0], places=12)


class Errors(unittest.TestCase):
    def test_none_of_the_exact_values(self):
        for problem in PROBLEMS.values():
            error, peak = contact_problem.errors(problem, sampled(problem, problem.exact))
            self.assertLess(error, 3e-3)  # what linear interpolation leaves where the slope has no limit
            self.assertLess(peak, 1e-2 if problem.full else 1e-12)

    def test_of_scaled_values_their_factor(self):
        for problem in PROBLEMS.values():
            error, peak = contact_problem.errors(problem, sampled(problem, lambda x: 1.03 * problem.exact(x)))
            self.assertAlmostEqual(error, 0.03, delta=2e-4)
            self.assertAlmostEqual(peak, 0.03, delta=1e-2 if problem.full else 1e-12)

    def test_of_one_side_only(self):
        half = [(x, v) for x, v in sampled(CATTANEO, CATTANEO.exact) if x > 0]
        error, _ = contact_problem.errors(CATTANEO, [(-HALF_WIDTH, 0.0), (0.0, 0.0), *half])
        self.assertAlmostEqual(error, math.sqrt(0.5), delta=2e-3)

    def test_of_a_constant_pressure(self):
        # the integral of (1 - root)^2 over that of root^2, root = sqrt(1 - x^2) on [0, 1]
        error, _ = contact_problem.errors(HERTZ, sampled(HERTZ, lambda x: PEAK))
        self.assertAlmostEqual(error, math.sqrt((5 / 3 - math.pi / 2) / (2 / 3)), delta=1e-3)

    def test_nothing_beyond_the_last_point(self):
        error, _ = contact_problem.errors(HERTZ, [(0.0, PEAK), (0.1 * HALF_WIDTH, PEAK)])
        self.assertGreater(error, 0.9)

    def test_order_of_points_does_not_matter(self):
        points = sampled(HERTZ, HERTZ.exact, 40)
        self.assertEqual(contact_problem.errors(HERTZ, points), contact_problem.errors(HERTZ, points[::-1]))


class Curve(unittest.TestCase):
    pairs = [(0.04, 1.0), (0.01, 2.0), (0.0025, 4.0), (0.02, 9.0)]  # the last one is beaten by the second

    def test_front(self):
        self.assertEqual(error_curve.front(self.pairs), self.pairs[:3])

    def test_time_follows_a_power_of_the_error(self):
        cost = error_curve.cost_of(0.02, self.pairs)
        self.assertAlmostEqual(cost.seconds, math.sqrt(2), places=12)
        self.assertFalse(cost.is_bound)

    def test_coarser_than_any(self):
        self.assertEqual(error_curve.cost_of(0.1, self.pairs), error_curve.Cost(1.0, True))

    def test_not_reached(self):
        self.assertIsNone(error_curve.cost_of(0.001, self.pairs))
        self.assertIsNone(error_curve.cost_of(0.01, []))


class Deck(unittest.TestCase):
    def test_faces_of_both_kinds_of_elements(self):
        elements = [(1, "CPS6", [1, 2, 3, 4, 5, 6]), (2, "CPS8", [11, 12, 13, 14, 15, 16, 17, 18])]
        self.assertEqual(calculix.faces(elements, [[3, 1, 6], [12, 13, 16]]), [(1, 3), (2, 2)])
        self.assertEqual(calculix.faces(elements, [[4, 1, 6]]), [])

    def test_last_block_of_results(self):
        text = "".join([" -4  STRESS      6    1\n", f" -1{7:10}" + "".join(f"{v:12.5E}" for v in range(6)) + "\n", " -3\n",
                        " -4  STRESS      6    1\n", f" -1{7:10}" + "".join(f"{-v:12.5E}" for v in range(6)) + "\n", " -3\n",
                        " -4  ERROR       1    1\n", f" -1{7:10}{5:12.5E}\n", " -3\n"])
        with tempfile.NamedTemporaryFile("w", suffix=".frd") as file:
            file.write(text)
            file.flush()
            self.assertEqual(calculix.last_block(file.name, "STRESS", 6), {7: [0, -1, -2, -3, -4, -5]})
            self.assertEqual(calculix.last_block(file.name, "CONTACT", 6), {})

    def decks(self):
        settings = calculix.Settings(gmsh_mesh.MeshSettings(5), stick_slope=50)
        for problem in PROBLEMS.values():
            lines = {line: [] for line in range(gmsh_mesh.UPPER_ARC, gmsh_mesh.BOTTOM + 1)}
            lines[gmsh_mesh.TOP] = [[1, 2, 4]]
            mesh = gmsh_mesh.Mesh({n: (-math.pi * 1e-5 / n, math.e / n) for n in range(1, 7)},
                                  {gmsh_mesh.UPPER: [[1, 2, 3, 4, 5, 6]], gmsh_mesh.LOWER: []},
                                  {gmsh_mesh.UPPER: [], gmsh_mesh.LOWER: []}, lines)
            yield problem, calculix.deck(mesh, problem, settings).split("\n")

    def test_numbers_fit_their_fields(self):
        for _, deck in self.decks():
            longest = max(len(field.strip()) for line in deck if not line.startswith("*") for field in line.split(","))
            self.assertLessEqual(longest, 20)  # CalculiX reads no more

    def test_friction_and_forces(self):
        for problem, deck in self.decks():
            if problem.friction:
                coefficient, slope = deck[deck.index("*FRICTION") + 1].split(",")
                self.assertEqual((float(coefficient), float(slope)), (problem.friction, 50 * MODULUS / HALF_WIDTH))
            self.assertEqual("*FRICTION" in deck, problem.friction > 0)
            self.assertEqual(deck.count("*STEP"), len(problem.steps))
            forces = [line.split(",") for line in deck[deck.index("*STEP"):] if line.startswith("1, ") and line.count(",") == 2]
            pressed = sum(float(value) for _, direction, value in forces if int(direction) == 2)
            sides = 1 if problem.full else 0.5
            self.assertAlmostEqual(pressed, -sides * len(problem.steps) * FORCE * calculix.THICKNESS, places=12)
            sheared = sum(float(value) for _, direction, value in forces if int(direction) == 1)
            self.assertAlmostEqual(sheared, SHEAR_FORCE * calculix.THICKNESS if problem.friction else 0, places=12)


class Process(unittest.TestCase):
    def test_usage_and_failure(self):
        with tempfile.TemporaryDirectory() as folder:
            usage, output = measured_process.run(["sh", "-c", "echo done; i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done"],
                                                 folder)
            self.assertEqual(output, "done\n")
            self.assertGreater(usage.cpu, 0)
            self.assertGreater(usage.memory, 0)
            with self.assertRaisesRegex(RuntimeError, "status 3"):
                measured_process.run(["sh", "-c", "exit 3"], folder)
            with self.assertRaises(RuntimeError):
                measured_process.run(["sleep", "20"], folder, time_limit=0.2)


if __name__ == "__main__":
    unittest.main()

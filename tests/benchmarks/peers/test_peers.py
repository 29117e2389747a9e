# SPDX-License-Identifier: GPL-3.0-or-later
"""What the comparison rests on, without any of the programs: python3 -B -m unittest discover -s tests/benchmarks/peers."""
import math
import tempfile
import unittest

import calculix
import error_curve
import gmsh_mesh
import hertz_problem
import measured_process
from hertz_problem import HALF_WIDTH, PEAK, exact


def sampled(pressure, points=1000):
    return [(2 * HALF_WIDTH * k / points, pressure(2 * HALF_WIDTH * k / points)) for k in range(points + 1)]


class Errors(unittest.TestCase):
    def test_none_of_the_exact_pressure(self):
        error, peak = hertz_problem.errors(sampled(exact))
        self.assertLess(error, 1e-3)  # what linear interpolation leaves at the end of the contact
        self.assertLess(peak, 1e-12)

    def test_of_a_scaled_pressure_its_factor(self):
        error, peak = hertz_problem.errors(sampled(lambda x: 1.03 * exact(x)))
        self.assertAlmostEqual(error, 0.03, delta=1e-4)
        self.assertAlmostEqual(peak, 0.03, delta=1e-12)

    def test_of_a_constant_pressure(self):
        # the integral of (1 - root)^2 over that of root^2, root = sqrt(1 - x^2) on [0, 1]
        error, _ = hertz_problem.errors(sampled(lambda x: PEAK))
        self.assertAlmostEqual(error, math.sqrt((5 / 3 - math.pi / 2) / (2 / 3)), delta=1e-3)

    def test_nothing_beyond_the_last_point(self):
        error, _ = hertz_problem.errors([(0.0, PEAK), (0.1 * HALF_WIDTH, PEAK)])
        self.assertGreater(error, 0.9)

    def test_order_of_points_does_not_matter(self):
        points = sampled(exact, 40)
        self.assertEqual(hertz_problem.errors(points), hertz_problem.errors(points[::-1]))


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

    def test_numbers_fit_their_fields(self):
        mesh = gmsh_mesh.Mesh({n: (-math.pi * 1e-5 / n, math.e / n) for n in range(1, 7)},
                              {gmsh_mesh.UPPER: [[1, 2, 3, 4, 5, 6]], gmsh_mesh.LOWER: []},
                              {gmsh_mesh.UPPER: [], gmsh_mesh.LOWER: []},
                              {line: [] for line in range(gmsh_mesh.UPPER_ARC, gmsh_mesh.BOTTOM + 1)})
        deck = calculix.deck(mesh, calculix.Settings(gmsh_mesh.MeshSettings(5)))
        longest = max(len(field.strip()) for line in deck.split("\n") if not line.startswith("*") for field in line.split(","))
        self.assertLessEqual(longest, 20)  # CalculiX reads no more


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

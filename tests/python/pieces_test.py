import csv
import unittest

import numpy as np

import floe
from support import PLATE, ROOT, InFolder


def reference(name):
    with open(ROOT / "tests/data" / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Wavenumber(unittest.TestCase):
    def test_satisfies_the_dispersion_relation(self):
        omega, depth = np.geomspace(0.01, 10.0, 50), np.array([[1.0], [58.5], [1000.0]])
        k = floe.wavenumber(omega, depth)
        self.assertEqual(k.shape, (3, 50))
        np.testing.assert_allclose(k * np.tanh(k * depth), np.broadcast_to(omega**2 / 9.81, k.shape), rtol=1e-14)
        np.testing.assert_allclose(floe.angular_frequency(k, depth), np.broadcast_to(omega, k.shape), rtol=1e-14)

    def test_is_a_number_for_a_number_and_deep_by_default(self):
        self.assertIsInstance(floe.wavenumber(1.0), float)
        self.assertAlmostEqual(floe.wavenumber(1.0), 1.0 / 9.81, delta=1e-16)

    def test_gives_the_group_velocity(self):
        step = 1e-5
        slope = 2 * step / (floe.wavenumber(0.6 + step, 20.0) - floe.wavenumber(0.6 - step, 20.0))
        self.assertAlmostEqual(floe.group_velocity(0.6, 20.0), slope, delta=1e-7 * slope)

    def test_needs_a_positive_frequency(self):
        with self.assertRaisesRegex(floe.CaseError, "omega"):
            floe.wavenumber(-1.0)


class GreenFunction(unittest.TestCase):
    def test_is_that_of_the_reference(self):
        rows = reference("green_finite_depth.csv")[::7]
        self.assertGreater(len(rows), 10)
        depth = 20.0
        for row in rows:
            omega = np.sqrt(9.81 * float(row["nu_h"]) / depth)
            value = floe.green_function(depth * float(row["R_over_h"]), omega, depth)
            expected = complex(float(row["re_hG"]), float(row["im_hG"])) / depth
            # The header promises 1e-11; νh is rounded here, which turns the phase kR
            rounded = 4e-16 * float(row["k_h"]) * float(row["R_over_h"])
            self.assertLess(abs(value - expected), (1e-11 + rounded) * abs(expected))

    def test_takes_arrays(self):
        distance = np.array([[1.0, 2.0], [3.0, 4.0]])
        values = floe.green_function(distance, 0.8, 20.0)
        self.assertEqual(values.shape, (2, 2))
        self.assertEqual(values[1, 0], floe.green_function(3.0, 0.8, 20.0))


class Spectra(unittest.TestCase):
    def test_hold_the_energy_of_their_height(self):
        omega = np.linspace(1e-3, 60.0, 200_001)
        for values, height in (
            (floe.jonswap(omega, 2.0, 8.0), 2.0),
            (floe.jonswap(omega, 2.0, 8.0, gamma=1.0), 2.0),
            (floe.bretschneider(omega, 2.0, 6.3), 4.0 * np.sqrt(0.257 / 1.03)),  # m0 = 0.257 H²/(4 · 1.03)
        ):
            self.assertAlmostEqual(4.0 * np.sqrt(np.trapz(values, omega)), height, delta=1e-5)


class Mesh(InFolder):
    def test_survives_a_file(self):
        mesh = floe.rectangle(40.0, 20.0, 4, 2, grading=3.0)
        mesh.write(self.folder / "plate.msh")
        again = floe.read_mesh(self.folder / "plate.msh")
        np.testing.assert_array_equal(again.nodes[again.elements], mesh.nodes[mesh.elements])
        self.assertAlmostEqual(again.area, 800.0, delta=1e-9)
        self.assertEqual(again.pieces, 1)

    def test_is_made_of_arrays(self):
        mesh = floe.rectangle(40.0, 20.0, 4, 2)
        again = floe.Mesh(mesh.nodes, mesh.elements)
        np.testing.assert_array_equal(again.nodes, mesh.nodes)
        self.assertIn("37 nodes, 8 elements", repr(again))

    def test_is_checked(self):
        mesh = floe.rectangle(40.0, 20.0, 4, 2)
        elements = mesh.elements
        elements[0, 0] = 1000
        for nodes, connected in ((mesh.nodes, elements), (mesh.nodes[:, :1], mesh.elements), (mesh.nodes, elements[:, :4])):
            with self.assertRaises(floe.MeshError):
                floe.Mesh(nodes, connected)


class DryModes(unittest.TestCase):
    def test_are_those_of_the_reference(self):
        expected = [float(row["omega_rad_s"]) for row in reference("table1_dry_modes_mindlin.csv")]
        modes = floe.dry_modes(floe.rectangle(300.0, 60.0, 30, 6), **PLATE, count=13)
        self.assertEqual((modes.rigid_count, modes.shape.shape), (3, (13, 613, 3)))
        np.testing.assert_array_equal(modes.omega[:3], 0.0)
        elastic = [omega for omega in expected if omega > 1e-9][:10]
        # The estimate is right to a factor of 0.5 … 4.5, as its header says
        np.testing.assert_allclose(modes.omega[3:], elastic, rtol=2.0 * modes.estimated_frequency_error)
        self.assertLess(modes.estimated_frequency_error, 1e-2)

    def test_need_a_plate(self):
        with self.assertRaisesRegex(floe.CaseError, "thickness"):
            floe.dry_modes(floe.rectangle(300.0, 60.0, 4, 2), **(PLATE | {"thickness": -2.0}))


if __name__ == "__main__":
    unittest.main()

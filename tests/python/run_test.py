import csv
import ctypes
import os
import signal
import subprocess
import threading
import time
import unittest

import numpy as np

import floe
from support import CASE, PROGRAM, InFolder, case, small_result


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class ADictionary(InFolder):
    def test_gives_what_the_program_gives_for_the_same_case(self):
        (self.folder / "case.toml").write_text(floe.case_text(CASE), encoding="utf-8")
        subprocess.run([PROGRAM, "run", "case.toml", "-o", "out"], cwd=self.folder, check=True, capture_output=True)
        result = small_result()
        table = {
            (float(row["omega"]), float(row["heading_deg"]), row["point"]): complex(float(row["re_w"]), float(row["im_w"]))
            for row in rows(self.folder / "out/rao_points.csv")
        }
        self.assertEqual(len(table), 12)
        for f, omega in enumerate(result.omega):
            for h, heading in enumerate(result.heading_deg):
                for p, point in enumerate(result.points):
                    self.assertEqual(table[omega, heading, point], result.point_deflection[f, h, p])
        for row in rows(self.folder / "out/hydro_coefficients.csv"):
            f = list(result.omega).index(float(row["omega"]))
            i, j = int(row["mode_i"]) - 1, int(row["mode_j"]) - 1
            self.assertEqual(float(row["added_mass"]), result.added_mass[f, i, j])
            self.assertEqual(float(row["damping"]), result.damping[f, i, j])
        for row in rows(self.folder / "out/exciting_force.csv"):
            f = list(result.omega).index(float(row["omega"]))
            h = list(result.heading_deg).index(float(row["heading_deg"]))
            force = result.exciting_force[f, h, int(row["mode"]) - 1]
            self.assertEqual(complex(float(row["re"]), float(row["im"])), force)

    def test_takes_numpy_and_keeps_the_order_of_points(self):
        result = floe.run(case(waves={"omega": np.array([0.6, 0.5]), "heading_deg": np.float64(30).reshape(1)}))
        self.assertEqual(list(result.points), ["stern", "bow"])
        np.testing.assert_array_equal(result.omega, [0.5, 0.6])
        # Fewer headings at a time, so sums are rounded in another order
        np.testing.assert_allclose(result.point_deflection[0, 0], small_result().point_deflection[1, 1], rtol=1e-12)

    def test_reads_a_mesh_relative_to_the_current_folder(self):
        floe.rectangle(300.0, 60.0, 10, 2).write(self.folder / "plate.msh")
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        changed = case(waves={"omega": [0.5], "heading_deg": [0]})
        changed["mesh"] = {"file": "plate.msh"}
        np.testing.assert_allclose(
            floe.run(changed).point_deflection[0, 0], small_result().point_deflection[1, 0], rtol=1e-9
        )


class AResult(unittest.TestCase):
    def test_has_the_shapes_that_it_says(self):
        result = small_result()
        self.assertEqual(result.added_mass.shape, (3, 8, 8))
        self.assertEqual(result.exciting_force.shape, (3, 2, 8))
        self.assertEqual(result.mode_shape.shape, (8, len(result.mesh.nodes), 3))
        self.assertEqual(result.lines["across"].deflection.shape, (3, 2, 3))
        self.assertEqual(result.wave_elevation.shape, (3, 2, 1))
        self.assertEqual(list(result.quantities), ["deflection", "bending_moment_x"])
        self.assertEqual([report.omega for report in result.reports], list(result.omega))
        self.assertEqual({check.status for check in result.checks} - {"good", "attention", "bad"}, set())

    def test_satisfies_the_modal_equation(self):
        result = small_result()
        stiffness = np.diag(result.mode_omega**2)
        nodes, elements = result.mesh.nodes, result.mesh.elements
        heave = ballast(nodes, elements, result.mode_shape[:, :, 0])
        for f, omega in enumerate(result.omega):
            matrix = (
                stiffness
                + 1025.0 * 9.81 * heave
                - omega**2 * (np.eye(8) + result.added_mass[f])
                - 1j * omega * result.damping[f]
            )
            left = result.amplitudes[f] @ matrix.T
            error = np.abs(left - result.exciting_force[f]).max() / np.abs(result.exciting_force[f]).max()
            self.assertLess(error, 1e-9)

    def test_deflects_along_lines_as_at_nodes(self):
        result = small_result()
        line = result.lines["along"]
        for s, position in enumerate(line.stations):
            node = np.flatnonzero(np.linalg.norm(result.mode_mesh.nodes - position, axis=1) < 1e-9)
            self.assertEqual(len(node), 1)
            np.testing.assert_allclose(result.deflection()[:, :, node[0]], line.deflection[:, :, s], rtol=1e-12, atol=1e-14)


def ballast(nodes, elements, shapes):
    """∫ w_i w_j dS with 3 × 3 Gauss points, on elements whose edges lie along x and y."""
    points, weights = np.polynomial.legendre.leggauss(3)
    total = np.zeros((len(shapes), len(shapes)))
    for element in elements:
        half = np.ptp(nodes[element], axis=0) / 2
        for x, a in zip(points, weights):
            for y, b in zip(points, weights):
                values = shapes[:, element] @ q8(x, y)
                total += a * b * half[0] * half[1] * np.outer(values, values)
    return total


def q8(x, y):
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    sides = [(0, -1), (1, 0), (0, 1), (-1, 0)]
    at_corners = [0.25 * (1 + x * a) * (1 + y * b) * (x * a + y * b - 1) for a, b in corners]
    at_sides = [0.5 * (1 - x * x) * (1 + y * b) if a == 0 else 0.5 * (1 + x * a) * (1 - y * y) for a, b in sides]
    return np.array(at_corners + at_sides)


class Output(InFolder):
    def test_is_what_the_program_writes_and_can_be_loaded(self):
        result = floe.run(CASE, self.folder / "out")
        self.assertTrue((self.folder / "out/run.json").is_file())
        loaded = floe.load(self.folder / "out")
        np.testing.assert_array_equal(loaded.point_deflection, result.point_deflection)
        np.testing.assert_array_equal(loaded.mode_shape, result.mode_shape)
        np.testing.assert_array_equal(loaded.lines["along"].deflection, result.lines["along"].deflection)
        self.assertEqual(loaded.case_text, floe.case_text(CASE))

    def test_is_refused_replaced_or_gone_on_with(self):
        floe.run(CASE, self.folder / "out")
        with self.assertRaises(floe.StoreError):
            floe.run(CASE, self.folder / "out")
        again = floe.run(CASE, self.folder / "out", resume=True)
        np.testing.assert_array_equal(again.amplitudes, small_result().amplitudes)
        floe.run(case(waves={"omega": [0.5]}), self.folder / "out", fresh=True)
        self.assertEqual(len(floe.load(self.folder / "out").omega), 1)


class Progress(InFolder):
    def test_rises_from_0_to_1(self):
        told = []
        floe.run(CASE, progress=lambda share, now: told.append((share, now)))
        shares = [share for share, _ in told]
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0.0, 1.0))
        self.assertIn("frequency 2 of 3", [now for _, now in told])

    def test_may_raise_to_stop(self):
        def stop(share, now):
            if "2 of" in now:
                raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            floe.run(CASE, self.folder / "out", progress=stop)
        self.assertEqual(len(floe.load(self.folder / "out").omega), 1)
        resumed = floe.run(CASE, self.folder / "out", resume=True)
        np.testing.assert_array_equal(resumed.amplitudes, small_result().amplitudes)


class CtrlC(InFolder):
    def test_stops_a_run_and_keeps_what_was_finished(self):
        def interrupt(share, now):
            if "2 of" in now:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            floe.run(CASE, self.folder / "out", progress=interrupt)
        self.assertEqual(len(floe.load(self.folder / "out").omega), 1)

    def test_is_heeded_without_progress(self):
        many = case(waves={"omega": {"from": 0.3, "to": 0.7, "count": 2000}})
        timer = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            floe.run(many)
        self.assertLess(time.monotonic() - start, 30.0)


class Threads(unittest.TestCase):
    def test_change_no_bit_and_other_threads_of_python_go_on(self):
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        try:
            for threads in (1, 3):
                result = floe.run(CASE, threads=threads)
                np.testing.assert_array_equal(result.amplitudes, small_result().amplitudes)
        finally:
            done.set()
            thread.join()
        self.assertGreater(counted[0], 10)

    def test_of_the_blas_are_given_back(self):
        try:
            blas = ctypes.CDLL("libopenblas.so.0")
            before = blas.openblas_get_num_threads()
        except (OSError, AttributeError):
            self.skipTest("no OpenBLAS")
        blas.openblas_set_num_threads(2)
        self.addCleanup(blas.openblas_set_num_threads, before)
        seen = []
        floe.run(CASE, progress=lambda share, now: seen.append(blas.openblas_get_num_threads()))
        self.assertEqual(seen[-1], 1)  # one thread while floe works
        self.assertEqual(blas.openblas_get_num_threads(), 2)


if __name__ == "__main__":
    unittest.main()

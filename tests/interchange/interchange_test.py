"""Runs floe and reads its result.nc and WAMIT files as other programs do; values, not only names.
usage: interchange_test.py FLOE DATA   (needs xarray and netCDF4)
"""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import xarray

import readers

FLOE, DATA = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])

# The plate of the reference tables; elements of 12 m
CASE = """title = "interchange"
[water]
depth = 58.5
[plate]
thickness = 2.0
youngs_modulus = 1.19e10
poisson_ratio = 0.13
density = 256.25
loss_factor = 0.02
[mesh]
rectangle = { length = 300.0, width = 60.0, nx = 24, ny = 5 }
[modes]
count = 8
[waves]
omega = [0.42, 1.01]
heading_deg = [0, 60]
[output]
points = { corner = [-150, -30], middle = [0, 0] }
lines = { centreline = { from = [-150, 0], to = [150, 0], count = 5 } }
wave_points = { lee = [200, 0] }
quantities = ["deflection", "bending_moment_x", "pressure"]
fields = [{ omega = 0.42, heading_deg = 60 }]
"""

SEA = """[sea_grid]
omega = { from = 0.4, to = 0.8 }
[[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 10.0
spreading = "cos2"
mean_heading_deg = [0, 40]
allow_truncation = true
"""


def run(folder, *arguments):
    done = subprocess.run([FLOE, *arguments], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "LC_ALL": "C.UTF-8"}, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout


def table(path):
    with open(path, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def two_plates(path, count=2, nx=3, ny=2, length=30.0, width=20.0, gap=10.0):
    """A Gmsh 2.2 file of `count` equal plates beside each other along x."""
    nodes, elements = {}, []
    for plate in range(count):
        def node(i, j):
            return nodes.setdefault((plate, i, j), len(nodes) + 1)
        for a in range(nx):
            for b in range(ny):
                i, j = 2 * a, 2 * b
                elements.append([node(*c) for c in ((i, j), (i + 2, j), (i + 2, j + 2), (i, j + 2), (i + 1, j),
                                                    (i + 2, j + 1), (i + 1, j + 2), (i, j + 1))])
    with open(path, "w", encoding="ascii") as out:
        out.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(nodes)}\n")
        for (plate, i, j), number in nodes.items():
            out.write(f"{number} {plate * (length + gap) + i * length / nx / 2} {j * width / ny / 2} 0\n")
        out.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for number, corners in enumerate(elements, 1):
            out.write(f"{number} 16 2 1 1 {' '.join(map(str, corners))}\n")
        out.write("$EndElements\n")


class Results(unittest.TestCase):
    """One run for all tests."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        (cls.path / "plate.toml").write_text(CASE)
        run(cls.path, "run", "plate.toml", "--allow-coarse")
        cls.out = cls.path / "plate.out"
        run(cls.path, "export", "plate.out", "--format", "netcdf", "--rigid-only")
        run(cls.path, "export", "plate.out", "--format", "netcdf", "--all-dofs")
        run(cls.path, "export", "plate.out", "--format", "wamit")
        cls.full = xarray.open_dataset(cls.out / "result.nc")
        cls.rigid = xarray.open_dataset(cls.out / "result_rigid.nc")

    @classmethod
    def tearDownClass(cls):
        cls.full.close()
        cls.rigid.close()
        cls.folder.cleanup()

    def close(self, actual, expected, relative, what=""):
        """Relative to the largest expected magnitude."""
        actual, expected = np.asarray(actual), np.asarray(expected)
        self.assertEqual(actual.shape, expected.shape, what)
        self.assertLessEqual(np.abs(actual - expected).max(), relative * np.abs(expected).max(), what)

    # Names, order and attributes as capytaine 3 writes them

    def test_dimensions_are_those_of_capytaine(self):
        full = self.full
        matrices = ("omega", "influenced_dof", "radiating_dof")
        forces = ("complex", "omega", "wave_direction", "influenced_dof")
        for name in ("added_mass", "radiation_damping"):
            self.assertEqual(full[name].dims, matrices)
        for name in ("diffraction_force", "Froude_Krylov_force", "excitation_force", "RAO"):
            self.assertEqual(full[name].dims, forces)
        for name in ("inertia_matrix", "hydrostatic_stiffness", "structural_stiffness", "structural_damping"):
            self.assertEqual(full[name].dims, matrices[1:])
        self.assertEqual(list(full.complex.values), ["re", "im"])
        self.assertEqual(list(full.influenced_dof.values),
                         ["Heave", "Roll", "Pitch"] + [f"Elastic_{n}" for n in range(4, 9)])
        self.assertEqual(list(full.radiating_dof.values), list(full.influenced_dof.values))
        self.assertEqual(list(self.rigid.influenced_dof.values), ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"])
        self.assertEqual(full.body_name.item(), "plate")
        self.assertEqual(full.rotation_center.dims, ("body", "space_coordinate"))

    def test_attributes_are_those_of_capytaine(self):
        known = {"omega": ("Angular frequency", "rad/s"), "freq": ("Frequency", "Hz"), "period": ("Period", "s"),
                 "wavenumber": ("Angular wavenumber", "rad/m"), "wavelength": ("Wave length", "m"),
                 "wave_direction": ("Wave direction", "rad"), "radiating_dof": ("Radiating DOF", None),
                 "influenced_dof": ("Influenced DOF", None), "added_mass": ("Added mass", None),
                 "radiation_damping": ("Radiation damping", None), "diffraction_force": ("Diffraction force", None),
                 "Froude_Krylov_force": ("Froude Krylov force", None)}
        for name, (words, unit) in known.items():
            self.assertEqual(self.full[name].attrs["long_name"], words)
            self.assertEqual(self.full[name].attrs.get("units"), unit)
        for name in ("freq", "period", "wavenumber", "wavelength", "g", "rho", "water_depth", "forward_speed"):
            self.assertIn(name, self.full.coords)
        for name, value in (("g", 9.81), ("rho", 1025.0), ("water_depth", 58.5), ("forward_speed", 0.0)):
            self.assertEqual(self.full[name].dtype, np.float64)
            self.assertEqual(self.full[name].item(), value)
        self.assertIn("exp(-i omega t)", self.full.attrs["conventions"])
        self.assertRegex(self.full.attrs["source"], r"^floe \d")

    def test_frequencies_and_directions(self):
        full = self.full
        self.close(full.omega, [0.42, 1.01], 0)
        self.close(full.freq * 2 * math.pi, full.omega, 1e-15)
        self.close(full.period * full.freq, [1, 1], 1e-15)
        self.close(full.wavenumber * np.tanh(full.wavenumber * 58.5) * 9.81, full.omega**2, 1e-14)
        self.close(full.wavenumber * full.wavelength, [2 * math.pi] * 2, 1e-15)
        self.close(full.wave_direction, [0, math.pi / 3], 1e-15)

    # Values against the tables of the same run

    def scale(self):
        """Unit motions in the mass-normalised modes of the tables: 1/sqrt of the inertia of each."""
        return np.sqrt(np.diag(self.full.inertia_matrix))

    def test_coefficients_are_those_of_the_tables(self):
        scale = self.scale()
        rows = table(self.out / "hydro_coefficients.csv")
        self.assertEqual(len(rows), 2 * 8 * 8)
        for name, column in (("added_mass", "added_mass"), ("radiation_damping", "damping")):
            expected = np.array([float(row[column]) for row in rows]).reshape(2, 8, 8) * np.outer(scale, scale)
            for f in range(2):
                scaled = np.outer(scale, scale) * np.abs(expected[f] / np.outer(scale, scale)).max()
                self.assertLess(np.abs((self.full[name][f] - expected[f]) / scaled).max(), 1e-12)

    def test_forces_are_those_of_the_tables(self):
        rows = table(self.out / "exciting_force.csv")
        expected = np.array([complex(float(row["re"]), float(row["im"])) for row in rows]).reshape(2, 2, 8)
        force = readers.merge_complex(self.full, "excitation_force").values
        self.close(force / self.scale(), expected, 1e-13)
        parts = self.full.Froude_Krylov_force + self.full.diffraction_force
        self.assertTrue((parts == self.full.excitation_force).all())

    def test_motions_give_the_deflections_of_the_tables(self):
        motion = readers.merge_complex(self.full, "RAO")
        deflection = (motion * self.full.mode_shape.sel(displacement="w")).sum("influenced_dof")
        at = self.full.node_coordinates
        for row in table(self.out / "rao_points.csv"):
            there = [float(row["x"]), float(row["y"]), 0.0]
            node = int(np.argmin(((at.values - there)**2).sum(axis=1)))
            f, b = [0.42, 1.01].index(float(row["omega"])), [0, 60].index(float(row["heading_deg"]))
            expected = complex(float(row["re_w"]), float(row["im_w"]))
            if row["point"] == "corner":  # the middle is no node
                self.assertLess(abs(deflection[f, b, node].item() - expected), 1e-12)
        field = readers.merge_complex(self.full, "deflection_rao")
        self.close(field[0], deflection.transpose("omega", "wave_direction", "node")[0, 1], 1e-12)
        self.assertEqual(self.full.field_omega.item(), 0.42)
        self.assertAlmostEqual(self.full.field_wave_direction.item(), math.pi / 3)

    def test_points_lines_and_waves_are_those_of_the_tables(self):
        full = self.full
        for name, file, keys in (
                ("point_rao", "rao_quantities.csv", ("point", "quantity")),
                ("line_deflection_rao", "rao_lines.csv", ("station",)),
                ("wave_elevation_rao", "wave_points.csv", ("wave_point",))):
            values = readers.merge_complex(full, name)
            rows = table(self.out / file)
            values = values.transpose("omega", "wave_direction", *keys).values.ravel()
            prefix = "_w" if "re_w" in rows[0] else ""
            expected = [complex(float(row["re" + prefix]), float(row["im" + prefix])) for row in rows]
            np.testing.assert_array_equal(values, expected, err_msg=name)
        self.assertEqual(list(full.quantity.values), ["deflection", "bending_moment_x", "pressure"])
        self.assertEqual(list(full.quantity_units.values), ["m", "N m/m", "Pa"])

    # Physics: what the file says of itself, and independent references

    def test_motions_obey_the_equation_of_motion(self):
        for data, motions in ((self.full, "RAO"),):
            a, b, m = data.added_mass.values, data.radiation_damping.values, data.inertia_matrix.values
            stiffness = (data.hydrostatic_stiffness + data.structural_stiffness -
                         1j * data.structural_damping).values
            force = readers.merge_complex(data, "excitation_force").values
            expected = readers.merge_complex(data, motions).values
            scale = self.scale()
            for f, omega in enumerate(data.omega.values):
                matrix = -omega**2 * (m + a[f]) - 1j * omega * b[f] + stiffness
                actual = np.linalg.solve(matrix / np.outer(scale, scale), force[f].T / scale[:, None]) / scale[:, None]
                self.close(actual.T * scale, expected[f] * scale, 1e-11)

    def test_inertia_and_stiffness_of_a_rectangle(self):
        length, width, thickness, weight = 300.0, 60.0, 2.0, 1025.0 * 9.81
        mass = 256.25 * thickness * length * width
        self.close(np.diag(self.rigid.inertia_matrix),
                   mass * np.array([1, 1, 1, (width**2 + thickness**2) / 12, (length**2 + thickness**2) / 12,
                                    (length**2 + width**2) / 12]), 1e-12)
        self.close(np.diag(self.rigid.hydrostatic_stiffness),
                   weight * length * width * np.array([0, 0, 1, width**2 / 12, length**2 / 12, 0]), 1e-12)
        self.assertEqual(self.rigid.disp_mass.item(), self.full.disp_mass.item())
        self.close(self.full.disp_mass, [mass], 1e-12)
        elastic = self.full.mode_frequency[3:]
        rows = table(self.out / "dry_modes.csv")
        self.close(elastic, [float(row["omega"]) for row in rows[3:]], 1e-15)
        self.close(np.diag(self.full.structural_stiffness)[3:], elastic**2, 1e-15)
        self.close(self.full.structural_damping, 0.02 * self.full.structural_stiffness, 1e-15)

    # The references are for heave w = 1, pitchx w = x/150, rolly w = y/30: floe's pitch is w = -x.
    # Elements of 12 m are coarse, 2 % of the largest: enough to tell a sign, a conjugate or a factor
    REFERENCE = {"heave": ("Heave", 1.0), "pitchx": ("Pitch", -150.0), "rolly": ("Roll", 30.0)}

    def test_coefficients_of_a_rigid_plate(self):
        rows = table(DATA / "rigid_rectangle_radiation.csv")
        self.assertEqual(len(rows), 6)
        for row in rows:
            name, scale = self.REFERENCE[row["mode_i"]]
            here = {"influenced_dof": name, "radiating_dof": name}
            omega = float(row["omega"])
            added_mass = scale**2 * float(row["added_mass"])
            damping = scale**2 * float(row["damping"])
            size = abs(complex(omega * added_mass, damping))
            at = self.rigid.sel(omega=omega, **here)
            self.assertLess(abs(at.added_mass.item() - added_mass) * omega, 0.02 * size)
            self.assertLess(abs(at.radiation_damping.item() - damping), 0.02 * size)

    def test_forces_on_a_rigid_plate(self):
        force = readers.merge_complex(self.rigid, "excitation_force")
        rows = table(DATA / "rigid_rectangle_excitation.csv")
        largest = {}
        for row in rows:
            size = math.hypot(float(row["X_over_rho_g_A_re"]), float(row["X_over_rho_g_A_im"]))
            largest[row["mode"]] = max(size, largest.get(row["mode"], 0.0))
        for row in rows:
            name, scale = self.REFERENCE[row["mode"]]
            at = force.sel(omega=float(row["omega"]), influenced_dof=name)[[0, 60].index(int(row["heading_deg"]))]
            expected = complex(float(row["X_over_rho_g_A_re"]), float(row["X_over_rho_g_A_im"]))
            self.assertLess(abs(at.item() / 1025.0 / 9.81 / scale - expected), 0.02 * largest[row["mode"]])

    def test_froude_krylov_forces_are_the_integral_of_the_wave(self):
        force = readers.merge_complex(self.rigid, "Froude_Krylov_force")
        x = (np.polynomial.legendre.leggauss(60))
        px, wx = 150 * x[0], 150 * x[1]
        py, wy = 30 * x[0], 30 * x[1]
        for f in range(2):
            k = self.rigid.wavenumber[f].item()
            for b, beta in enumerate(self.rigid.wave_direction.values):
                along_x, along_y = np.exp(1j * k * px * math.cos(beta)), np.exp(1j * k * py * math.sin(beta))
                expected = 1025 * 9.81 * np.array([
                    (wx @ along_x) * (wy @ along_y), (wx @ along_x) * (wy @ (py * along_y)),
                    -(wx @ (px * along_x)) * (wy @ along_y)])
                actual = force[f, b].sel(influenced_dof=["Heave", "Roll", "Pitch"]).values
                size = 1025 * 9.81 * 300 * 60 * np.array([1, 30, 150])
                self.assertLess(np.abs((actual - expected) / size).max(), 1e-9)

    # Other programs' readers

    def test_rigid_file_has_zeros_for_surge_sway_yaw(self):
        flat = ["Surge", "Sway", "Yaw"]
        for name in ("added_mass", "radiation_damping", "hydrostatic_stiffness"):
            self.assertTrue((self.rigid[name].sel(influenced_dof=flat) == 0).all())
            self.assertTrue((self.rigid[name].sel(radiating_dof=flat) == 0).all())
        for name in ("excitation_force", "diffraction_force", "Froude_Krylov_force", "RAO"):
            self.assertTrue((self.rigid[name].sel(influenced_dof=flat) == 0).all())
        kept = ["Heave", "Roll", "Pitch"]
        for name in ("excitation_force", "RAO"):
            np.testing.assert_array_equal(self.rigid[name].sel(influenced_dof=kept),
                                          self.full[name].sel(influenced_dof=kept))

    def test_bemrosetta_reads_the_rigid_file(self):
        read = readers.BemRosetta(self.out / "result_rigid.nc")
        self.assertEqual((read.bodies, read.names), (1, ["plate"]))
        self.close(read.heading, [0, 60], 1e-15)
        np.testing.assert_array_equal(read.added_mass, self.rigid.added_mass)
        expected = np.conj(readers.merge_complex(self.rigid, "RAO"))
        np.testing.assert_array_equal(read.forces["RAO"], expected)
        with self.assertRaises(AssertionError):
            readers.BemRosetta(self.out / "result.nc")  # it has no room for elastic modes

    def test_wecsim_reads_both_files(self):
        rigid = readers.WecSim(self.out / "result_rigid.nc")
        self.assertEqual(rigid.modes, [0])
        everything = readers.WecSim(self.out / "result_all.nc")
        self.assertEqual(everything.dof, readers.WecSim.STANDARD + [f"elastic_{n}" for n in range(4, 9)])
        self.assertEqual(everything.modes, [5])
        for name, axes in (("added_mass", (2, 0, 1)), ("radiation_damping", (2, 0, 1))):
            values = np.transpose(everything.coefficients[name], axes)
            np.testing.assert_array_equal(values[:, :6, :6], self.rigid[name])
            np.testing.assert_array_equal(values[:, 6:, 6:], self.full[name][:, 3:, 3:])
        force = np.transpose(everything.coefficients["Froude_Krylov_force"], (2, 1, 0))
        expected = np.conj(readers.merge_complex(self.full, "Froude_Krylov_force"))
        np.testing.assert_array_equal(force[:, :, 6:], expected[:, :, 3:])

    def wamit_round_trip(self, read, length):
        rotation = np.array([0, 0, 0, 1, 1, 1])
        powers = rotation[:, None] + rotation[None, :]
        rho, weight = 1025.0, 1025.0 * 9.81
        coefficients = read.coefficients()
        self.assertEqual(len(coefficients), 2)
        for omega, (added_mass, damping) in coefficients.items():
            f = int(np.argmin(np.abs(np.asarray(self.rigid.omega - omega))))
            self.assertAlmostEqual(omega, self.rigid.omega[f].item(), 8)
            unit = rho * length**(3.0 + powers)
            self.close(added_mass * unit, self.rigid.added_mass[f], 1e-9)
            self.close(damping * unit * omega, self.rigid.radiation_damping[f], 1e-8)
        for suffix, name, unit in (("3", "excitation_force", weight * length**(2.0 + rotation)),
                                   ("3fk", "Froude_Krylov_force", weight * length**(2.0 + rotation)),
                                   ("3sc", "diffraction_force", weight * length**(2.0 + rotation)),
                                   ("4", "RAO", length**(-1.0 * rotation))):
            found = read.amplitudes(suffix)
            self.assertEqual(len(found), 4)
            expected = readers.merge_complex(self.rigid, name)
            for (omega, heading), values in found.items():
                f, b = int(np.argmin(np.abs(np.asarray(self.rigid.omega - omega)))), [0, 60].index(heading)
                self.close(np.conj(values) * unit, expected[f, b].values, 1e-9, f"{suffix} {omega} {heading}")
        self.close(read.stiffness() * weight * length**(2.0 + powers), self.rigid.hydrostatic_stiffness, 1e-9)

    def test_wamit_files_give_the_same(self):
        self.wamit_round_trip(readers.Wamit(self.out / "result"), 1.0)

    def test_wamit_files_with_a_length_give_the_same(self):
        run(self.path, "export", "plate.out", "--format", "wamit", "--length", "300", "-o", "scaled")
        self.wamit_round_trip(readers.Wamit(self.path / "scaled"), 300.0)

    def test_wamit_files_say_their_conventions(self):
        for suffix in ("1", "3", "3fk", "3sc", "4", "hst"):
            first = (self.out / f"result.{suffix}").read_text().splitlines()[0]
            for words in ("# floe", "exp(+i omega t)", "rho = 1025", "L = 1 m", "centre of mass"):
                self.assertIn(words, first)

    def test_wamit_files_of_all_modes_number_them_after_the_rigid_ones(self):
        run(self.path, "export", "plate.out", "--format", "wamit", "--all-dofs", "-o", "all")
        read = readers.Wamit(self.path / "all")
        for omega, (added_mass, _) in read.coefficients().items():
            f = int(np.argmin(np.abs(np.asarray(self.full.omega - omega))))
            self.assertEqual(added_mass.shape, (11, 11))
            self.close(added_mass[6:, 6:] * 1025.0, self.full.added_mass[f, 3:, 3:], 1e-9)

    # The same bits

    def test_equal_runs_differ_in_no_variable(self):
        run(self.path, "run", "plate.toml", "--allow-coarse", "--threads", "1", "-o", "again.out")
        run(self.path, "export", "again.out", "--format", "netcdf")
        with xarray.open_dataset(self.path / "again.out" / "result.nc") as again:
            self.assertEqual(set(again.variables), set(self.full.variables))
            for name in self.full.variables:
                first, second = self.full[name].values, again[name].values
                if first.dtype == object:  # texts
                    self.assertEqual(first.tolist(), second.tolist(), name)
                else:
                    self.assertEqual(first.tobytes(), second.tobytes(), name)


class Seas(unittest.TestCase):
    def test_statistics_are_those_of_the_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "sea.toml").write_text(CASE.replace("nx = 24, ny = 5", "nx = 4, ny = 2").replace(
                "omega = [0.42, 1.01]", "omega = [0.42, 0.5]") + SEA)
            run(path, "run", "sea.toml", "--allow-coarse")
            with xarray.open_dataset(path / "sea.out" / "result.nc") as data:
                self.assertEqual(list(data.sea_name.values), ["design"] * 2)
                np.testing.assert_allclose(data.sea_wave_direction, np.radians([0, 40]), rtol=1e-15)
                self.assertEqual(list(data.sea_quantity.values), ["deflection", "bending_moment_x"])
                rows = table(path / "sea.out" / "statistics_points.csv")
                for name in ("m0", "m1", "m2", "m4"):
                    values = data[name].transpose("sea_state", "point", "sea_quantity").values.ravel()
                    np.testing.assert_array_equal(values, [float(row[name]) for row in rows])
                rows = table(path / "sea.out" / "design_values.csv")
                values = data.Tz.transpose("sea_state", "point", "sea_quantity").values.ravel()
                np.testing.assert_allclose(values, [float(row["zero_crossing_period"]) for row in rows], rtol=1e-14)
                rows = table(path / "sea.out" / "spectra_points.csv")
                values = data.response_psd.transpose("sea_state", "point", "sea_quantity", "sea_omega")
                np.testing.assert_array_equal(values.values.ravel(), [float(row["spectrum"]) for row in rows])
                corner = int(np.argmin(((data.node_coordinates - [-150, -30, 0])**2).sum("space_coordinate").values))
                np.testing.assert_allclose(data.response_std[:, corner], np.sqrt(data.m0[:, 0, 0]), rtol=1e-9)


class SeveralPlates(unittest.TestCase):
    def test_every_plate_is_a_body(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            two_plates(path / "two.msh")
            (path / "two.toml").write_text(
                CASE.replace("rectangle = { length = 300.0, width = 60.0, nx = 24, ny = 5 }", 'file = "two.msh"')
                .split("[output]")[0].replace("count = 8", "count = 10"))
            run(path, "run", "two.toml", "--allow-coarse")
            run(path, "export", "two.out", "--format", "netcdf", "--rigid-only")
            run(path, "export", "two.out", "--format", "netcdf", "--all-dofs")
            run(path, "export", "two.out", "--format", "wamit")
            read = readers.BemRosetta(path / "two.out" / "result_rigid.nc")
            self.assertEqual((read.bodies, read.names), (2, ["plate_1", "plate_2"]))
            sim = readers.WecSim(path / "two.out" / "result_all.nc")
            self.assertEqual(sum(sim.modes), 4)
            self.assertEqual(len(sim.dof), 12 + 4)
            with xarray.open_dataset(path / "two.out" / "result.nc") as data:
                self.assertEqual(data.body_name.item(), "plate_1+plate_2")
                self.assertEqual(list(data.influenced_dof.values[:6]),
                                 [f"plate_{p}__{d}" for p in (1, 2) for d in ("Heave", "Roll", "Pitch")])
                np.testing.assert_allclose(data.rotation_center, [[15, 10, 0], [55, 10, 0]], rtol=1e-12)
                # Equal plates on a line along x: what one does to the other is mutual
                mass = data.added_mass.values
                np.testing.assert_allclose(mass[:, 0, 3], mass[:, 3, 0], rtol=1e-2)
                np.testing.assert_allclose(mass[:, 0, 0], mass[:, 3, 3], rtol=1e-9)
            wamit = readers.Wamit(path / "two.out" / "result")
            for omega, (added_mass, _) in wamit.coefficients().items():
                f = int(np.argmin(np.abs(np.asarray(read.omega - omega))))
                np.testing.assert_allclose(added_mass * 1025, read.added_mass[f], rtol=1e-8, atol=1e-6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

"""result.nc as capytaine's users read it; values, not only names."""

import math
import sys
import unittest

import numpy as np
import xarray

import readers
from one_run import DATA, OneRun, run, table


class ResultFile(OneRun):
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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

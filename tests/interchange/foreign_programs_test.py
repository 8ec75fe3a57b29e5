"""Files for BEMRosetta, WEC-Sim, WAMIT's readers and ParaView, read as these programs do."""

import math
import sys
import unittest

import numpy as np

import readers
from one_run import OneRun, run, table


class ForeignPrograms(OneRun):
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

    # ParaView

    def test_animation_and_water_are_those_of_the_field(self):
        told = run(self.path, "export", "plate.out", "--format", "paraview", "--phases", "8", "--margin", "50",
                   "--step", "10")
        self.assertIn("(11 files)", told)
        folder = self.out / "paraview"
        field = readers.Vtk(self.out / "fields" / "omega_0.42_heading_60.vtu")
        w = field["w_re"] + 1j * field["w_im"]
        p = field["p_re"] + 1j * field["p_im"]

        # The plate, one period of it
        frames = readers.collection(folder / "plate_omega_0.42_heading_60.pvd")
        self.assertEqual(len(frames), 8)
        for i, (time, file) in enumerate(frames):
            self.assertAlmostEqual(time, i / 8 * 2 * math.pi / 0.42)
            frame = readers.Vtk(folder / file)
            self.close(frame["w"], (w * np.exp(-1j * 0.42 * time)).real, 1e-14)
            self.close(frame["p"], (p * np.exp(-1j * 0.42 * time)).real, 1e-14)
            np.testing.assert_array_equal(frame["displacement"][:, 2], frame["w"])
            self.assertTrue((frame["types"] == 23).all())

        # The water: as at the wave point, and under the plate as (B.1) says
        self.assertEqual(readers.collection(folder / "water.pvd"), [(0.42, "water_omega_0.42_heading_60.vti")])
        water = readers.Vtk(folder / "water_omega_0.42_heading_60.vti")
        image = water.root.find("ImageData")
        self.assertEqual(image.get("Origin"), "-200 -80 0")
        self.assertEqual(image.get("WholeExtent"), "0 40 0 16 0 0")
        zeta = (water["zeta_re"] + 1j * water["zeta_im"]).reshape(17, 41)
        self.close(np.abs(zeta).ravel(), water["zeta_abs"], 1e-15)
        row = next(r for r in table(self.out / "wave_points.csv") if r["omega"] == "0.42" and r["heading_deg"] == "60")
        self.assertLess(abs(zeta[8, 40] - complex(float(row["re"]), float(row["im"]))), 1e-9)
        corner = int(np.argmin(((field["Points"] - [-150, -30, 0])**2).sum(axis=1)))
        self.assertLess(abs(zeta[5, 5] - (w[corner] + p[corner] / 1025 / 9.81)), 1e-6)
        under = water["on_plate"].reshape(17, 41)
        self.assertEqual(under.sum(), 31 * 7)
        self.assertTrue(under[5:12, 5:36].all())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

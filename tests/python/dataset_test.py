import unittest

import numpy as np
import xarray

import floe
from support import CASE, InFolder, case, small_result


class TheDataSet(unittest.TestCase):
    def test_has_the_names_and_axes_of_capytaine(self):
        data = small_result().to_xarray()
        self.assertEqual(data["added_mass"].dims, ("omega", "influenced_dof", "radiating_dof"))
        self.assertEqual(data["radiation_damping"].dims, ("omega", "influenced_dof", "radiating_dof"))
        self.assertEqual(data["excitation_force"].dims, ("omega", "wave_direction", "influenced_dof"))
        self.assertEqual(list(data["influenced_dof"].values[:4]), ["Heave", "Roll", "Pitch", "Elastic_4"])
        np.testing.assert_allclose(data["wave_direction"], np.radians([0, 30]))
        np.testing.assert_allclose(data["period"] * data["omega"], 2 * np.pi)

    def test_tells_rigid_motions_by_metre_and_radian(self):
        data = small_result().to_xarray()
        x, y = small_result().mesh.nodes.T
        shape = data["mode_shape"].sel(displacement="w")
        np.testing.assert_allclose(shape.sel(influenced_dof="Heave"), 1.0, rtol=1e-12)
        np.testing.assert_allclose(shape.sel(influenced_dof="Roll"), y, atol=1e-9)
        np.testing.assert_allclose(shape.sel(influenced_dof="Pitch"), -x, atol=1e-9)

    def test_keeps_force_times_motion(self):
        result, data = small_result(), small_result().to_xarray()
        np.testing.assert_allclose(
            (data["excitation_force"] * data["RAO"]).sum("influenced_dof"),
            (result.exciting_force * result.amplitudes).sum(axis=2),
            rtol=1e-12,
        )
        unit = data["RAO"].values / result.amplitudes
        power = np.einsum("fhi,fij,fhj->fh", data["RAO"].conj().values, data["radiation_damping"].values, data["RAO"].values)
        expected = np.einsum("fhi,fij,fhj->fh", result.amplitudes.conj(), result.damping, result.amplitudes)
        np.testing.assert_allclose(power, expected, rtol=1e-12)
        self.assertTrue(np.isfinite(unit).all())

    def test_gives_deflection_as_sum_of_motions(self):
        data = small_result().to_xarray()
        deflection = (data["RAO"] * data["mode_shape"].sel(displacement="w")).sum("influenced_dof")
        np.testing.assert_allclose(deflection, small_result().deflection(), rtol=1e-10, atol=1e-13)

    def test_has_points_lines_and_wave_points(self):
        data, result = small_result().to_xarray(), small_result()
        bow = data["point_rao"].sel(point="bow", quantity="deflection")
        np.testing.assert_array_equal(bow, result.point_deflection[:, :, 1])
        across = data["line_deflection_rao"][:, :, data["station_line"].values == "across"]
        np.testing.assert_array_equal(across, result.lines["across"].deflection)
        np.testing.assert_array_equal(data["wave_elevation_rao"].sel(wave_point="lee"), result.wave_elevation[:, :, 0])


class ResultNc(InFolder):
    def test_holds_the_same_under_the_same_names(self):
        try:
            import netCDF4  # noqa: F401
        except ImportError:
            self.skipTest("no netCDF4 (scripts/setup installs it)")
        mine = floe.run(CASE, self.folder / "out").to_xarray()
        with xarray.open_dataset(self.folder / "out/result.nc") as opened:
            file = opened.load()
        self.assertEqual([str(name) for name in file["influenced_dof"].values], list(mine["influenced_dof"].values))
        compared = 0
        for name in mine.variables:
            if name not in file.variables or not np.issubdtype(mine[name].dtype, np.number):
                continue
            values = file[name]
            if "complex" in values.dims:
                values = values.isel(complex=0) + 1j * values.isel(complex=1)
            self.assertEqual(values.dims, mine[name].dims, name)
            largest = abs(values.values).max()
            np.testing.assert_allclose(mine[name].values, values.values, rtol=1e-9, atol=1e-12 * largest, err_msg=name)
            compared += 1
        self.assertGreater(compared, 18)


class TheDirectRoute(InFolder):
    def test_gives_the_same_without_modes(self):
        result = floe.run(case(solver={"route": "direct"}, modes={"count": 60}), self.folder / "out")
        self.assertEqual(result.added_mass.shape, (3, 0, 0))
        names = {check.name for check in result.checks}
        expected = {"residual", "exact residual", "Green function", "reciprocity", "energy", "nodes a wavelength"}
        self.assertEqual(names, expected)
        # It knows all modes: the more of them the other route has, the nearer they are
        few, many = (
            abs(floe.run(case(modes={"count": count})).point_deflection - result.point_deflection).max()
            for count in (8, 60)
        )
        self.assertLess(many, 0.5 * few)
        self.assertLess(many, 0.01 * abs(result.point_deflection).max())
        data = result.to_xarray()
        self.assertNotIn("added_mass", data)
        np.testing.assert_array_equal(data["wave_elevation_rao"][:, :, 0], result.wave_elevation[:, :, 0])
        with self.assertRaisesRegex(floe.CaseError, "no modes"):
            result.deflection()
        loaded = floe.load(self.folder / "out")
        np.testing.assert_array_equal(loaded.point_deflection, result.point_deflection)


class Seas(unittest.TestCase):
    def test_are_in_the_result_and_in_the_data_set(self):
        sea = {
            "name": "swell",
            "spectrum": "jonswap",
            "significant_height": 2.0,
            "peak_period": 14.0,
            "spreading": "cos2",
            "mean_heading_deg": [0, 90],
            "allow_truncation": True,
        }
        relations = {
            "cross_spectra": [["bow", "deflection", "stern", "deflection"]],
            "combinations": {"tilt": {"terms": [["bow", "deflection", 1.0], ["stern", "deflection", -1.0]]}},
        }
        grid = {"omega": {"from": 0.35, "to": 0.7}}
        result = floe.run(case(waves={"omega": [0.5]}, sea_grid=grid, output=relations) | {"sea": [sea]})
        self.assertEqual([found.mean_heading_deg for found in result.seas], [0.0, 90.0])
        beam = result.sea("swell", 90.0)
        deviation = beam.standard_deviation()
        self.assertEqual(deviation.shape, (2,))
        for point, position in enumerate(result.points.values()):  # points of the case are nodes
            node = np.argmin(np.linalg.norm(result.mesh.nodes - position, axis=1))
            self.assertAlmostEqual(deviation[point], beam.node_deviation[node], delta=1e-9 * deviation[point])
        # Var(a - b) = Var a + Var b - 2 Cov(a, b)
        pair, tilt = beam.pairs[0], beam.combinations["tilt"]
        self.assertEqual((pair.first, pair.second), (("bow", "deflection"), ("stern", "deflection")))
        variance = (deviation**2).sum() - 2 * pair.covariance
        self.assertAlmostEqual(tilt.moments[0], variance, delta=1e-9 * (deviation**2).sum())
        data = result.to_xarray()
        np.testing.assert_array_equal(data["response_std"][1], beam.node_deviation)
        np.testing.assert_array_equal(data["m0"].sel(sea_quantity="deflection")[1], beam.moments["deflection"][:, 0])
        with self.assertRaises(KeyError):
            result.sea("calm")


if __name__ == "__main__":
    unittest.main()

"""result.nc of seas and of several plates."""

import pathlib
import sys
import tempfile
import unittest

import numpy as np
import xarray

import readers
from one_run import CASE, run, table

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
                self.assertEqual(list(data.sea_quantity.values), ["deflection", "bending_moment_x", "pressure"])
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

"""One run of floe and its exports, which the tests of this folder read.
Their usage: NAME_test.py FLOE DATA   (needs xarray and netCDF4)
"""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import xarray

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

def run(folder, *arguments):
    done = subprocess.run([FLOE, *arguments], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "LC_ALL": "C.UTF-8"}, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout


def table(path):
    with open(path, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


class OneRun(unittest.TestCase):
    """One run for all tests of a class."""

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

"""What the tests of the Python module share."""

import copy
import functools
import pathlib
import os
import tempfile
import unittest

import floe

ROOT = pathlib.Path(os.environ["FLOE_SOURCE_DIR"])
PROGRAM = os.environ["FLOE_PROGRAM"]

PLATE = {"thickness": 2.0, "youngs_modulus": 1.19e10, "poisson_ratio": 0.13, "density": 256.25}
CASE = {
    "title": "Plate of Table 1",
    "water": {"depth": 58.5},
    "plate": PLATE,
    "mesh": {"rectangle": {"length": 300.0, "width": 60.0, "nx": 10, "ny": 2}},
    "modes": {"count": 8},
    "waves": {"omega": [0.4, 0.5, 0.6], "heading_deg": [0, 30]},
    "output": {
        "points": {"stern": [150, 0], "bow": [-150, 0]},
        "lines": {
            "along": {"from": [-150, 0], "to": [150, 0], "count": 5},
            "across": {"from": [0, -30], "to": [0, 30], "count": 3},
        },
        "wave_points": {"lee": [200, 0]},
        "quantities": ["deflection", "bending_moment_x"],
    },
}


def case(**sections):
    """The case with keys of sections replaced: case(waves={"omega": [0.5]})."""
    changed = copy.deepcopy(CASE)
    for section, keys in sections.items():
        changed[section] = changed.get(section, {}) | keys
    return changed


@functools.cache
def small_result():
    return floe.run(CASE)


class InFolder(unittest.TestCase):
    """A folder of its own for each test, as `self.folder`."""

    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

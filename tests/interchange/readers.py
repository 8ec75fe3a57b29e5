"""Look-alikes of the programs that read what floe writes: they demand what those demand and fail where those fail.
Written from the behaviour of BEMRosetta (capytaine.cpp, wamit.cpp) and WEC-Sim (readCAPYTAINE.m), not copied.
"""

import math

import netCDF4
import numpy as np


def merge_complex(dataset, name):
    """As capytaine does when it loads a data set."""
    values = dataset[name]
    return values.sel(complex="re") + 1j * values.sel(complex="im")


def characters(file, name):
    """Texts of a variable of characters, as MATLAB's ncread and BEMRosetta take them."""
    variable = file.variables[name]
    assert variable.dtype == np.dtype("S1"), f"{name} is not an array of characters"
    variable.set_auto_chartostring(False)
    variable.set_auto_mask(False)
    rows = np.atleast_2d(variable[...])
    return [b"".join(row.tolist()).rstrip(b"\0").decode("utf-8") for row in rows]


class BemRosetta:
    """One body after the other with six degrees of freedom each; forces conjugated."""

    def __init__(self, path):
        file = netCDF4.Dataset(path)
        self.g = self.scalar(file, "g")
        self.rho = self.scalar(file, "rho")
        self.depth = self.scalar(file, "water_depth")
        self.heading = np.degrees(self.array(file, "wave_direction"))
        self.omega = self.array(file, "omega")
        assert self.omega[0] > 1e-7 and not math.isinf(self.omega[-1]), "omega = 0 or infinite has its own place"
        count, headings = len(self.omega), len(self.heading)
        self.added_mass = self.array(file, "added_mass")
        self.damping = self.array(file, "radiation_damping")
        self.bodies = self.added_mass.shape[1] // 6
        six = 6 * self.bodies
        for name, values in (("added_mass", self.added_mass), ("radiation_damping", self.damping)):
            assert values.shape == (count, six, six), f"Wrong dimension in {name}: {values.shape}"
        self.forces = {}
        for name in ("diffraction_force", "Froude_Krylov_force", "RAO"):
            values = self.array(file, name)
            assert values.shape == (2, count, headings, six), f"Wrong dimension in {name}: {values.shape}"
            self.forces[name] = values[0] - 1j * values[1]  # to follow WAMIT
        self.inertia = self.array(file, "inertia_matrix")
        self.stiffness = self.array(file, "hydrostatic_stiffness")
        assert self.inertia.shape == self.stiffness.shape == (six, six)
        for name in ("rotation_center", "center_of_mass"):
            assert self.array(file, name).shape == (self.bodies, 3), f"Wrong dimension in {name}"
        self.names = characters(file, "body_name")[0].split("+")
        assert len(self.names) == self.bodies
        file.close()

    @staticmethod
    def scalar(file, name):
        assert file.variables[name].dtype == np.float64, f"{name} is not a double"
        assert file.variables[name].ndim == 0, f"{name} is not scalar"
        return float(file.variables[name][...])

    @staticmethod
    def array(file, name):
        variable = file.variables[name]
        variable.set_auto_mask(False)
        assert variable.dtype == np.float64, f"{name} is not of doubles"
        values = np.array(variable[...])
        assert not np.isnan(values).any(), f"NaN in {name}"
        return values


class WecSim:
    """Sorts degrees of freedom by body and standard name; what is not standard becomes a generalised body mode."""

    STANDARD = ["surge", "sway", "heave", "roll", "pitch", "yaw"]
    REQUIRED = ["complex", "body_name", "g", "rho", "water_depth", "influenced_dof", "radiating_dof", "omega",
                "wave_direction", "added_mass", "radiation_damping", "diffraction_force", "Froude_Krylov_force"]

    def __init__(self, path):
        file = netCDF4.Dataset(path)
        missing = [name for name in self.REQUIRED if name not in file.variables]
        assert not missing, f"Capytaine output does not contain: {missing}"
        bodies = characters(file, "body_name")[0].split("+")
        names = [name.lower() for name in characters(file, "radiating_dof")]
        assert names == [name.lower() for name in characters(file, "influenced_dof")]
        assert characters(file, "complex") == ["re", "im"]
        for name in ("g", "rho"):
            assert np.issubdtype(file.variables[name].dtype, np.floating), f"integer {name} breaks MATLAB's products"

        # One body: no prefix; several: body__dof. Bodies are found by parts of names
        prefixes = [""] if len(bodies) == 1 else [body.lower() for body in bodies]
        mark = "" if len(bodies) == 1 else "__"
        order, self.modes = [], []
        for prefix in prefixes:
            own = [name for name in names if prefix in name]
            standard = [prefix + mark + name for name in self.STANDARD]
            extra = [name for name in own if not any(part in name for part in standard)]
            order += standard + extra
            self.modes.append(len(extra))
        place = [names.index(name) if name in names else None for name in order]
        used = [p for p in place if p is not None]
        assert len(used) == len(set(used)) == len(names), "degrees of freedom are lost or taken twice"
        self.dof = order
        self.bodies = bodies

        def dimension(variable, name):
            return file.variables[variable].dimensions.index(name)

        def pick(values, axes):
            for axis in axes:
                shape = list(values.shape)
                shape[axis] = len(order)
                sorted_values = np.zeros(shape)
                for i, p in enumerate(place):
                    if p is not None:
                        index = [slice(None)] * values.ndim
                        index[axis] = i
                        sorted_values[tuple(index)] = np.take(values, p, axis=axis)
                values = sorted_values
            return values

        self.coefficients = {}
        for name in ("added_mass", "radiation_damping"):
            axes = [dimension(name, d) for d in ("influenced_dof", "radiating_dof", "omega")]
            self.coefficients[name] = pick(np.transpose(file.variables[name][...].data, axes), [0, 1])
        for name in ("diffraction_force", "Froude_Krylov_force"):
            axes = [dimension(name, d) for d in ("influenced_dof", "wave_direction", "omega", "complex")]
            values = pick(np.transpose(file.variables[name][...].data, axes), [0])
            self.coefficients[name] = values[..., 0] - 1j * values[..., 1]
        file.close()


class Wamit:
    """Reads STEM.1, .3, .3fk, .3sc, .4 and .hst by columns; lines that begin with no number are headers."""

    def __init__(self, stem):
        self.rows = {suffix: self.table(f"{stem}.{suffix}") for suffix in ("1", "3", "3fk", "3sc", "4", "hst")}

    @staticmethod
    def table(path):
        rows = []
        with open(path, encoding="utf-8") as lines:
            for line in lines:
                try:
                    rows.append([float(word) for word in line.split()])
                except ValueError:
                    assert not rows, f"a header in the middle of {path}"
        return np.array(rows)

    def coefficients(self):
        """{omega: (A, B)} without dimensions."""
        table = self.rows["1"]
        count = int(table[:, 1].max())
        found = {}
        for period, i, j, added_mass, damping in table:
            a, b = found.setdefault(2.0 * math.pi / period, np.full((2, count, count), np.nan))
            a[int(i) - 1, int(j) - 1], b[int(i) - 1, int(j) - 1] = added_mass, damping
        return found

    def amplitudes(self, suffix):
        """{(omega, heading): vector} from real and imaginary parts; magnitude and phase must say the same."""
        table = self.rows[suffix]
        count = int(table[:, 2].max())
        found = {}
        for period, heading, i, magnitude, phase, real, imaginary in table:
            assert math.isclose(magnitude, math.hypot(real, imaginary), rel_tol=1e-8, abs_tol=1e-300)
            turned = magnitude * complex(math.cos(math.radians(phase)), math.sin(math.radians(phase)))
            assert abs(turned - complex(real, imaginary)) <= 1e-7 * magnitude
            values = found.setdefault((2.0 * math.pi / period, heading), np.full(count, np.nan, complex))
            values[int(i) - 1] = complex(real, imaginary)
        return found

    def stiffness(self):
        table = self.rows["hst"]
        count = int(table[:, 0].max())
        matrix = np.full((count, count), np.nan)
        for i, j, value in table:
            matrix[int(i) - 1, int(j) - 1] = value
        return matrix

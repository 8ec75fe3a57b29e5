"""Results as an xarray data set, with the names of capytaine and of result.nc."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

if TYPE_CHECKING:
    from ._results import Result

_RIGID = ("Heave", "Roll", "Pitch")
_WAVE = ("omega", "wave_direction")


def _dofs(result: Result) -> tuple[list[str], np.ndarray]:
    """Names, and how much of each mode is one unit: 1 m or 1 rad of rigid motion, else the mode."""
    bodies = result.rigid_count // 3
    names, unit = [], np.ones(len(result.mode_omega))
    for mode, shape in enumerate(result.mode_shape):
        if mode >= result.rigid_count:
            names.append(f"Elastic_{mode + 1}")
            continue
        body, motion = divmod(mode, 3)
        component = shape[:, motion]  # w of heave, θx of roll, θy of pitch: equal all over the body
        unit[mode] = 1.0 / component[np.argmax(abs(component))]
        names.append(_RIGID[motion] if bodies == 1 else f"plate_{body + 1}__{_RIGID[motion]}")
    return names, unit


def _waves(result: Result) -> dict[str, Any]:
    two_pi = 2.0 * np.pi
    return {
        "omega": ("omega", result.omega, {"long_name": "Angular frequency", "units": "rad/s"}),
        "freq": ("omega", result.omega / two_pi, {"long_name": "Frequency", "units": "Hz"}),
        "period": ("omega", two_pi / result.omega, {"long_name": "Period", "units": "s"}),
        "wavenumber": ("omega", result.wavenumber, {"long_name": "Angular wavenumber", "units": "rad/m"}),
        "wavelength": ("omega", two_pi / result.wavenumber, {"long_name": "Wave length", "units": "m"}),
        "wave_direction": (
            "wave_direction",
            np.radians(result.heading_deg),
            {"long_name": "Wave direction", "units": "rad"},
        ),
        "g": ((), result.water["gravity"], {"long_name": "Gravity", "units": "m/s^2"}),
        "rho": ((), result.water["density"], {"long_name": "Density of water", "units": "kg/m^3"}),
        "water_depth": ((), result.water["depth"], {"long_name": "Water depth", "units": "m"}),
    }


def _modes(result: Result, names: list[str], unit: np.ndarray) -> dict[str, Any]:
    matrix = unit[:, np.newaxis] * unit
    pair = ("omega", "influenced_dof", "radiating_dof")
    wave = (*_WAVE, "influenced_dof")
    incident = result.froude_krylov_force * unit
    return {
        "influenced_dof": ("influenced_dof", names),
        "radiating_dof": ("radiating_dof", names),
        "added_mass": (pair, result.added_mass * matrix, {"long_name": "Added mass"}),
        "radiation_damping": (pair, result.damping * matrix, {"long_name": "Radiation damping"}),
        "excitation_force": (wave, result.exciting_force * unit, {"long_name": "Excitation force"}),
        "Froude_Krylov_force": (wave, incident, {"long_name": "Froude Krylov force"}),
        "diffraction_force": (wave, result.exciting_force * unit - incident, {"long_name": "Diffraction force"}),
        "RAO": (wave, result.amplitudes / unit, {"long_name": "Response amplitude operator"}),
        "mode_frequency": (
            "influenced_dof",
            result.mode_omega,
            {"long_name": "Natural frequency of the dry plate, 0 for rigid motions", "units": "rad/s"},
        ),
        "displacement": ("displacement", ["w", "rotation_x", "rotation_y"]),
        "mode_shape": (
            ("influenced_dof", "node", "displacement"),
            result.mode_shape * unit[:, np.newaxis, np.newaxis],
            {"long_name": "Shapes of the degrees of freedom"},
        ),
        "node_coordinates": (("node", "space_coordinate"), _in_space(result.mode_mesh.nodes), {"units": "m"}),
        "space_coordinate": ("space_coordinate", ["x", "y", "z"]),
    }


def _in_space(points: Any) -> np.ndarray:
    flat = np.asarray(list(points), dtype=float).reshape(-1, 2)
    return np.column_stack([flat, np.zeros(len(flat))])


def _places(result: Result) -> dict[str, Any]:
    found: dict[str, Any] = {}
    if result.points:
        found["point"] = ("point", list(result.points))
        found["point_coordinates"] = (("point", "space_coordinate"), _in_space(result.points.values()), {"units": "m"})
        found["quantity"] = ("quantity", list(result.quantities))
        stacked = np.stack(list(result.quantities.values()), axis=2)
        found["point_rao"] = ((*_WAVE, "quantity", "point"), stacked, {"long_name": "Quantities at points"})
    if result.lines:
        lines = result.lines.values()
        found["station_line"] = ("station", np.repeat(list(result.lines), [len(line.distance) for line in lines]))
        stations = np.concatenate([line.stations for line in lines])
        found["station_coordinates"] = (("station", "space_coordinate"), _in_space(stations), {"units": "m"})
        deflection = np.concatenate([line.deflection for line in lines], axis=2)
        found["line_deflection_rao"] = ((*_WAVE, "station"), deflection, {"units": "m/m"})
    if result.wave_points:
        found["wave_point"] = ("wave_point", list(result.wave_points))
        found["wave_elevation_rao"] = ((*_WAVE, "wave_point"), result.wave_elevation, {"units": "m/m"})
    return found


def _seas(result: Result) -> dict[str, Any]:
    seas = result.seas
    if not seas:
        return {}
    found: dict[str, Any] = {
        "sea_name": ("sea_state", [sea.sea for sea in seas]),
        "sea_wave_direction": ("sea_state", np.radians([sea.mean_heading_deg for sea in seas]), {"units": "rad"}),
        "significant_height": ("sea_state", [sea.significant_height for sea in seas], {"units": "m"}),
        "sea_omega": ("sea_omega", seas[0].omega, {"units": "rad/s"}),
        "response_std": (
            ("sea_state", "fluid_node"),
            np.stack([sea.node_deviation for sea in seas]),
            {"long_name": "Standard deviation of the deflection", "units": "m"},
        ),
    }
    if result.points and seas[0].moments:
        names = list(seas[0].moments)
        found["sea_quantity"] = ("sea_quantity", names)
        moments = np.stack([[sea.moments[name] for name in names] for sea in seas])
        for place, name in enumerate(("m0", "m1", "m2", "m4")):
            found[name] = (("sea_state", "sea_quantity", "point"), moments[..., place])
        spectra = np.stack([[sea.spectra[name] for name in names] for sea in seas])
        found["response_psd"] = (("sea_state", "sea_quantity", "point", "sea_omega"), spectra)
    return found


def dataset(result: Result) -> xarray.Dataset:
    """All of a result; complex variables are complex (capytaine's files have re and im apart)."""
    names, unit = _dofs(result)
    modes = _modes(result, names, unit) if names else {}
    variables = _waves(result) | modes | _places(result) | _seas(result)
    coordinates = {"freq", "period", "wavenumber", "wavelength", "g", "rho", "water_depth"}
    return xarray.Dataset(variables, attrs={"title": result.title}).set_coords(coordinates)

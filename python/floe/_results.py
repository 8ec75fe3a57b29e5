"""What a run gives, as numpy arrays."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Callable

import numpy as np

from . import _core
from ._errors import CaseError

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray


@dataclasses.dataclass(frozen=True, eq=False)
class Line:
    """A line on the plate and the deflection along it."""

    stations: NDArray[np.float64]
    """Positions [m], stations × 2."""
    distance: NDArray[np.float64]
    """Distance from the beginning [m], stations."""
    deflection: NDArray[np.complex128]
    """Per metre of wave [m/m], frequencies × headings × stations."""


@dataclasses.dataclass(frozen=True, eq=False)
class Field:
    """Deflection, rotations and pressure of one wave at the nodes of the fluid's mesh."""

    omega: float
    """[rad/s]"""
    heading_deg: float
    deflection: NDArray[np.complex128]
    """[m/m]"""
    rotation_x: NDArray[np.complex128]
    """[rad/m]"""
    rotation_y: NDArray[np.complex128]
    """[rad/m]"""
    pressure: NDArray[np.complex128]
    """Total pressure on the underside [Pa/m]."""


@dataclasses.dataclass(frozen=True, eq=False)
class Combination:
    """Several quantities as one, in a sea."""

    spectrum: NDArray[np.float64]
    """[unit² s/rad]"""
    moments: NDArray[np.float64]
    """m0, m1, m2, m4."""
    most_probable_maximum: float
    """Of the storm."""


@dataclasses.dataclass(frozen=True, eq=False)
class Pair:
    """Two quantities in a sea, each as (point, quantity)."""

    first: tuple[str, str]
    second: tuple[str, str]
    spectrum: NDArray[np.complex128]
    """Cross-spectrum [product of the units, s/rad]."""
    covariance: float
    correlation: float


@dataclasses.dataclass(frozen=True, eq=False)
class Sea:
    """Statistics of one sea from one mean heading."""

    sea: str
    """Name of the sea."""
    mean_heading_deg: float
    omega: NDArray[np.float64]
    """Frequencies of the spectra [rad/s]."""
    spectra: dict[str, NDArray[np.float64]]
    """Of each quantity, points × frequencies [unit² s/rad], one-sided over omega."""
    moments: dict[str, NDArray[np.float64]]
    """Of each quantity, points × (m0, m1, m2, m4)."""
    line_deviation: NDArray[np.float64]
    """Standard deviation of the deflection at the stations of all lines in order [m]."""
    node_moments: NDArray[np.float64]
    """Of the deflection, nodes of the fluid's mesh × (m0, m1, m2, m4)."""
    duration: float
    """Of the storm [s]."""
    significant_height: float
    """4 √m0 of the waves [m]."""
    share_outside: float
    """Share of the sea's m0 beyond the computed frequencies."""
    grid_error: float
    """Estimated relative error of m0 at the points from the frequencies."""
    combinations: dict[str, Combination]
    """By name, as in the case."""
    pairs: list[Pair]
    """As in the case."""

    def standard_deviation(self, quantity: str = "deflection") -> NDArray[np.float64]:
        """√m0 of a quantity at the points."""
        return np.sqrt(self.moments[quantity][:, 0])

    @property
    def node_deviation(self) -> NDArray[np.float64]:
        """Standard deviation of the deflection at the nodes of the fluid's mesh [m]."""
        return np.sqrt(self.node_moments[:, 0])


@dataclasses.dataclass(frozen=True, eq=False)
class Report:
    """What the solution of one frequency is worth."""

    omega: float
    method: str
    """dense, lattice, pfft or fmm."""
    iterations: int
    """0 for a direct solution."""
    applications: int
    true_residual: float
    kernel_error: float
    reciprocity_error: float
    energy_error: float
    exact_residual: float
    """By the exact integrals on 50 rows."""
    residual_between_nodes: float
    """In the middles of elements: what the mesh costs."""
    mode_change: float
    """Of the deflection without the highest quarter of the elastic modes; 0 by the direct route."""
    seconds: float
    failure: str
    """Why there is no result; empty where there is one."""


@dataclasses.dataclass(frozen=True, eq=False)
class Check:
    """An identity that the exact solution satisfies, and how well this one does."""

    name: str
    value: float
    limit: float
    omega: float
    """Where it is worst [rad/s]."""
    status: str
    """good, attention (up to ten times the limit) or bad."""
    meaning: str


@dataclasses.dataclass(frozen=True, eq=False)
class Result:
    """All that a run gives: complex amplitudes per metre of wave amplitude.

    Time factor exp(-i omega t), phases relative to the wave at the origin, deflection positive up.
    Arrays run over frequency, then heading, then place or mode.
    """

    title: str
    case_text: str
    """The case file (TOML)."""
    water: dict[str, float]
    """depth [m], density [kg/m³], gravity [m/s²]."""
    omega: NDArray[np.float64]
    """Frequencies [rad/s]."""
    wavenumber: NDArray[np.float64]
    """Of the incident waves [rad/m]."""
    heading_deg: NDArray[np.float64]
    """Where the waves travel to, from +x towards +y [deg]."""
    mesh: _core.Mesh
    """The fluid's mesh."""
    mode_mesh: _core.Mesh
    """The mesh of the modes: the plate's own, or else the fluid's; on the direct route there are no modes."""
    mode_omega: NDArray[np.float64]
    """Natural frequencies of the dry plate [rad/s], 0 for rigid modes."""
    mode_shape: NDArray[np.float64]
    """Mass-normalised shapes, modes × nodes × (w, θx, θy)."""
    rigid_count: int
    """The first modes are heave, roll and pitch of each plate."""
    added_mass: NDArray[np.float64]
    """Frequencies × influenced mode × radiating mode; the plate's own mass is 1."""
    damping: NDArray[np.float64]
    """[1/s], likewise."""
    exciting_force: NDArray[np.complex128]
    """Frequencies × headings × modes [N/(m √kg)]."""
    froude_krylov_force: NDArray[np.complex128]
    """The share of the incident waves in it."""
    amplitudes: NDArray[np.complex128]
    """Of the modes, frequencies × headings × modes [√kg]."""
    points: dict[str, tuple[float, float]]
    """Names and positions [m] of the points of the case."""
    point_deflection: NDArray[np.complex128]
    """Frequencies × headings × points [m/m]."""
    quantities: dict[str, NDArray[np.complex128]]
    """The quantities of the case, each frequencies × headings × points."""
    lines: dict[str, Line]
    """The lines of the case."""
    wave_points: dict[str, tuple[float, float]]
    """Names and positions [m] of the points on the water."""
    wave_elevation: NDArray[np.complex128]
    """Of the whole wave, frequencies × headings × wave points [m/m]."""
    fields: list[Field]
    """Node fields of the waves that the case asks for; empty for a loaded run."""
    seas: list[Sea]
    """Statistics, one a sea and mean heading."""
    reports: list[Report]
    """One a frequency."""
    checks: list[Check]
    """The worst of each identity over all frequencies."""
    notices: list[str]
    warnings: list[str]

    def deflection(self) -> NDArray[np.complex128]:
        """Deflection at the nodes of `mode_mesh` [m/m], frequencies × headings × nodes; not of the direct route."""
        if not len(self.mode_omega):
            raise CaseError("no modes (must be solved with solver.route = modal; `fields` have the deflection)")
        return self.amplitudes @ self.mode_shape[:, :, 0]

    def sea(self, name: str, mean_heading_deg: float | None = None) -> Sea:
        """The statistics of a sea; of its first mean heading unless one is given."""
        for sea in self.seas:
            if sea.sea == name and mean_heading_deg in (None, sea.mean_heading_deg):
                return sea
        raise KeyError((name, mean_heading_deg))

    def to_xarray(self) -> xarray.Dataset:
        """A data set with the names of capytaine; needs xarray."""
        from ._dataset import dataset

        return dataset(self)


def _line(name: str, begin: Any, end: Any, count: int) -> Line:
    share = np.linspace(0.0, 1.0, count)[:, np.newaxis]
    stations = (1.0 - share) * np.asarray(begin) + share * np.asarray(end)
    distance = np.linspace(0.0, float(np.hypot(*(np.asarray(end) - np.asarray(begin)))), count)
    return Line(stations=stations, distance=distance, deflection=np.empty(0, complex))


def _sea(**fields: Any) -> Sea:
    fields["combinations"] = {name: Combination(**entry) for name, entry in fields["combinations"].items()}
    fields["pairs"] = [Pair(**entry) for entry in fields["pairs"]]
    return Sea(**fields)


def result_of(fields: dict[str, Any]) -> Result:
    """A result from the dictionary that the compiled part returns."""
    lines: dict[str, Line] = {}
    deflection, first = fields.pop("_line_deflection"), 0
    for name, begin, end, count in fields.pop("_lines"):
        part = deflection[:, :, first : first + count]
        lines[name] = dataclasses.replace(_line(name, begin, end, count), deflection=part)
        first += count
    kinds: dict[str, Callable[..., Any]] = {"fields": Field, "seas": _sea, "reports": Report, "checks": Check}
    for key, kind in kinds.items():
        fields[key] = [kind(**entry) for entry in fields[key]]
    return Result(lines=lines, **fields)

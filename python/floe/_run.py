"""Running cases, reading stored runs, dry modes."""

from __future__ import annotations

import dataclasses
import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Callable

import numpy as np

from . import _case, _core
from ._errors import AccuracyWarning, CaseError, ConvergenceError
from ._results import Result, result_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

_MOST_THREADS = 1024


def run(
    case: _case.CaseLike,
    output: str | os.PathLike[str] | None = None,
    *,
    threads: int | None = None,
    memory: float | None = None,
    progress: Callable[[float, str], object] | None = None,
    resume: bool = False,
    fresh: bool = False,
    allow_coarse: bool = False,
) -> Result:
    """Runs a case and returns its results.

    case: path of a case file, or a dictionary with its keys.
    output: folder for the files that `floe run` writes; without one results stay in memory.
    threads: 1 to 1024; as many as there are processors if not given.
    memory: limit [byte]; what the machine allows if not given.
    progress: is called with the share that is done, 0 to 1, and what runs now.
    resume, fresh: go on with, or replace, what an earlier run left in `output`.
    allow_coarse: go on with fewer than 2 nodes a wavelength.

    Ctrl-C (KeyboardInterrupt) and an exception of `progress` stop the run after the step of the solution
    that is being taken; what was finished is kept in `output`. What may make the results worse is in
    `warnings` of the result and issued as AccuracyWarning. Raises floe.CaseError, MeshError,
    SeaError, BudgetError, FileError, ConvergenceError, StoreError, BusyError, all floe.Error. Where
    only some frequencies could not be solved, `result` of the ConvergenceError has the others, with
    NaN for those.
    """
    if threads is not None and not 1 <= threads <= _MOST_THREADS:
        raise CaseError(f"invalid threads = {threads} (must be 1 to {_MOST_THREADS})")
    if memory is not None and not 0 < memory < float("inf"):
        raise CaseError(f"invalid memory = {memory} bytes (must be positive)")
    if output is None and (resume or fresh):
        raise CaseError("missing output (resume and fresh need one)")
    fields = _core.run(
        _case.read(case),
        None if output is None else Path(output),
        threads or 0,
        memory or 0.0,
        resume,
        fresh,
        allow_coarse,
        progress,
    )
    failure = fields.pop("failure")
    result = result_of(fields)
    for text in result.warnings:
        warnings.warn(text, AccuracyWarning, stacklevel=2)
    if failure:
        error = ConvergenceError(failure)
        error.result = result
        raise error
    return result


def load(directory: str | os.PathLike[str]) -> Result:
    """The results that a run (of this module or of the program `floe`) left in a folder."""
    return result_of(_core.load(Path(directory)))


@dataclasses.dataclass(frozen=True, eq=False)
class DryModes:
    """The lowest modes of a free plate without water, mass-normalised."""

    omega: NDArray[np.float64]
    """Natural frequencies [rad/s], 0 for the rigid modes."""
    shape: NDArray[np.float64]
    """Modes × nodes × (w, θx, θy)."""
    rigid_count: int
    """The first modes are heave, roll about x and pitch about y of each plate."""
    estimated_frequency_error: float
    """Largest relative error of a frequency, estimated."""


def dry_modes(
    mesh: _core.Mesh,
    *,
    thickness: float,
    youngs_modulus: float,
    poisson_ratio: float,
    density: float,
    shear_correction: float = 5.0 / 6.0,
    count: int = 30,
) -> DryModes:
    """The lowest dry modes of a free Mindlin plate.

    thickness [m], youngs_modulus [N/m²], density [kg/m³]; count includes the three rigid modes of
    every plate.
    """
    parts = _core.dry_modes(mesh, thickness, youngs_modulus, poisson_ratio, density, shear_correction, count)
    return DryModes(*parts)

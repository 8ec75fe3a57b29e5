"""floe: hydroelastic response of very large floating structures in waves.

    import floe
    result = floe.run({"water": {"depth": 58.5}, "plate": {...}, "mesh": {...}, "waves": {...}})
    abs(result.point_deflection)      # frequencies × headings × points

A case is a file or a dictionary with the keys of one; numbers are in SI units, degrees only under
keys that end in `_deg`. Complex results are amplitudes per metre of wave amplitude, time factor
exp(-i omega t).
"""

from ._core import (
    Mesh,
    __version__,
    angular_frequency,
    bretschneider,
    green_function,
    group_velocity,
    jonswap,
    read_mesh,
    rectangle,
    wavenumber,
)
from ._case import case_text
from ._errors import (
    AccuracyWarning,
    BudgetError,
    BusyError,
    CaseError,
    ConvergenceError,
    Error,
    FileError,
    MeshError,
    SeaError,
    StoreError,
)
from ._results import Check, Combination, Field, Line, Pair, Report, Result, Sea
from ._run import DryModes, dry_modes, load, run

__all__ = [name for name in dir() if not name.startswith("_")] + ["__version__"]

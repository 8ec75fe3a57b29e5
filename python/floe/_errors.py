"""What can go wrong, one class a cause, with the exit code that the program `floe` would give."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._results import Result


class Error(Exception):
    """Base of every error that floe raises on purpose."""

    exit_code = 1


class CaseError(Error, ValueError):
    """A case or an argument is wrong."""

    exit_code = 3


class MeshError(CaseError):
    """A mesh or geometry cannot be used."""

    exit_code = 4


class SeaError(CaseError):
    """A sea state or another data file is wrong."""

    exit_code = 5


class BudgetError(Error, MemoryError):
    """The case would exceed memory, disk or time."""

    exit_code = 6


class FileError(Error, OSError):
    """Reading or writing a file failed during the run."""

    exit_code = 7


class ConvergenceError(Error, ArithmeticError):
    """A solution did not converge or is not finite."""

    exit_code = 8
    result: Result | None = None
    """All other frequencies, with NaN for those that have no result; None where nothing was solved."""


class StoreError(Error):
    """A result directory cannot be used: it holds other results, or none."""

    exit_code = 9


class BusyError(StoreError):
    """Another run holds the result directory."""

    exit_code = 10


class AccuracyWarning(UserWarning):
    """Something may make the results worse."""

"""Cases as dictionaries: the keys of a case file, numpy numbers and arrays, paths."""

import os
import re
from pathlib import Path
from typing import Any, Mapping, Union

import tomli_w

from . import _core
from ._errors import CaseError

CaseLike = Union[str, "os.PathLike[str]", Mapping[str, Any]]

_PLACE = re.compile(r"^case:\d+:\d+: ")


def _plain(value: Any, name: str) -> Any:
    """The value in the types that TOML knows; nested tables keep their order."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item, f"{name}.{key}" if name else str(key)) for key, item in value.items()}
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):  # numpy's arrays and numbers
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(item, f"{name}[{place}]") for place, item in enumerate(value)]
    if isinstance(value, (bool, int, float, str)):
        return value
    raise CaseError(f"invalid {name} = {value!r} (must be a number, a text, a list or a dictionary)")


def case_text(case: Mapping[str, Any]) -> str:
    """The case file (TOML) that says the same as a dictionary."""
    return tomli_w.dumps(_plain(case, ""))


def read(case: CaseLike) -> _core.CaseFile:
    """A case from a file or a dictionary; paths in a dictionary are relative to the current folder."""
    if not isinstance(case, Mapping):
        return _core.read_case(Path(case))
    try:
        return _core.read_case_text(case_text(case), "case", Path())
    except CaseError as error:  # places in a text that nobody has seen help nobody
        raise type(error)(_PLACE.sub("", str(error))) from None

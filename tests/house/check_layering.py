"""Levels of the modules: a file includes only its own module and modules on strictly lower levels,
and private headers (those in src/) only of its own module. The levels are explained in
docs/architecture.md; `check_layering.py ROOT --show` prints what each module includes now.
"""

import os
import pathlib
import re
import sys

import house

LEVELS = {
    "numeric": 0,
    "krylov": 1, "mesh": 1, "wave": 1, "fmm": 1,
    "plate": 2, "green": 2,
    "bem": 3,
    "hydro": 4,
    "coupling": 5,
    "response": 6,
    "analysis": 7,
    "io": 8,
    "program": 9,
}
SOURCE_ROOTS = ["src", "fmm/src"]
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def top_module(path):
    """Files at the top of include/floe and src tell the story, but for the program's main."""
    return "program" if pathlib.PurePath(path).stem == "main" else "analysis"


def module_of(path):
    """The module of a source file (path relative to the root)."""
    parts = path.parts
    if parts[0] == "fmm":
        return "fmm"
    inner = parts[2:] if parts[:2] == ("include", "floe") else parts[1:]
    return inner[0] if len(inner) > 1 else top_module(inner[0])


def included_module(root, path, quote, name):
    """(module, is private) of an included header of ours, or None for headers of others."""
    if quote == "<":
        parts = pathlib.PurePath(name).parts
        if parts[0] != "floe":
            return None
        return (parts[1] if len(parts) > 2 else top_module(name)), False
    for base in [path.parent, *map(pathlib.PurePath, SOURCE_ROOTS)]:
        if (root / base / name).is_file():
            return module_of(pathlib.PurePath(os.path.normpath(base / name))), True
    return f'"{name}" (not found)', True


def includes(root):
    """All includes of our own headers: (file, line, module, included module, is private)."""
    for path in house.files_under(root, ["include", "src", "fmm"], house.SOURCE_SUFFIXES):
        module = module_of(path)
        if path.parts[:2] == ("fmm", "tests"):
            continue
        for number, line in enumerate(house.read_lines(root, path), 1):
            found = INCLUDE.match(line)
            target = found and included_module(root, path, *found.groups())
            if target:
                yield path, number, module, *target
        if module not in LEVELS:
            yield path, 1, module, module, False


def check(root):
    complaints = []
    for path, number, module, target, private in includes(root):
        place = f"{path}:{number}"
        if module not in LEVELS or target not in LEVELS:
            unknown = module if module not in LEVELS else target
            complaints.append(f"{place}: unknown module {unknown} (add it to LEVELS and docs/architecture.md)")
        elif target == module:
            continue
        elif LEVELS[target] >= LEVELS[module]:
            complaints.append(f"{place}: {module} (level {LEVELS[module]}) includes {target} "
                              f"(level {LEVELS[target]}, must be lower)")
        elif private:
            complaints.append(f"{place}: {module} includes a private header of {target}")
    return complaints


def show(root):
    found = {}
    for _, _, module, target, _ in includes(root):
        found.setdefault(module, set()).update({target} - {module})
    for module in sorted(found, key=lambda m: (LEVELS.get(m, 99), m)):
        print(f"{LEVELS.get(module, '?')} {module}: {', '.join(sorted(found[module])) or '-'}")


GOOD = {
    "include/floe/numeric/types.hpp": "#pragma once\n#include <vector>\n",
    "include/floe/mesh/q8_mesh.hpp": "#include <floe/numeric/types.hpp>\n",
    "include/floe/hydro/radiation.hpp": "#include <floe/mesh/q8_mesh.hpp>\n",
    "include/floe/analysis.hpp": "#include <floe/hydro/radiation.hpp>\n",
    "include/floe/estimate.hpp": "#include <floe/analysis.hpp>\n",
    "src/mesh/geometry.hpp": "",
    "src/mesh/q8_mesh.cpp": '#include "mesh/geometry.hpp"\n#include "geometry.hpp"\n',
    "src/analysis_stages.hpp": "#include <floe/hydro/radiation.hpp>\n",
    "src/analysis.cpp": '#include "analysis_stages.hpp"\n#include <floe/estimate.hpp>\n',
    "src/main.cpp": "#include <floe/analysis.hpp>\n",
    "fmm/include/floe/fmm/kernel_sum.hpp": "#include <floe/numeric/types.hpp>\n",
    "fmm/tests/kernel_sum_test.cpp": "#include <floe/fmm/kernel_sum.hpp>\n",
}
BAD = [
    ({"src/mesh/q8_mesh.cpp": "#include <floe/hydro/radiation.hpp>\n"}, "mesh (level 1) includes hydro"),
    ({"include/floe/mesh/q8_mesh.hpp": "#include <floe/wave/water.hpp>\n"}, "mesh (level 1) includes wave"),
    ({"fmm/src/direct_sum.cpp": "#include <floe/analysis.hpp>\n"}, "fmm (level 1) includes analysis"),
    ({"src/hydro/radiation.cpp": '#include "mesh/geometry.hpp"\n'}, "private header of mesh"),
    ({"src/hydro/radiation.cpp": '#include "../mesh/geometry.hpp"\n'}, "private header of mesh"),
    ({"src/hydro/radiation.cpp": '#include "hydro/missing.hpp"\n'}, "not found"),
    ({"src/weather/wind.cpp": "\n"}, "unknown module weather"),
    ({"src/estimate.cpp": "#include <floe/io/case_file.hpp>\n"}, "analysis (level 7) includes io"),
]

if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[2] == "--show":
        show(pathlib.Path(sys.argv[1]))
    else:
        house.main(check, GOOD, BAD)

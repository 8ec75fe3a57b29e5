"""The program runs on every x86-64 processor, and tells there what it tells here.

    check_baseline.py FLOE FOLDER

Runs small cases under qemu as a processor that knows SSE2 and SSE3 only (no SSSE3, SSE4, AVX, FMA),
and compares all tables with those of this processor. Without qemu the exit code is 77 (skipped).
"""

import csv
import os
import pathlib
import shutil
import subprocess
import sys

# Of the largest value in a column. Same work in another order of rounding, on a tolerance at which the
# fast sums work in double precision
TOLERANCE = 1e-10
CASE = """
[water]
depth = 58.5
[plate]
thickness = 2.0
youngs_modulus = 1.19e10
poisson_ratio = 0.13
density = 256.25
[mesh]
rectangle = {{ length = 300.0, width = 60.0, nx = {nx}, ny = {ny}, grading = {grading} }}
[modes]
count = 6
[waves]
omega = [0.5]
heading_deg = [0, 30]
[solver]
method = "{method}"
tolerance = 1e-8
[output]
points = {{ P1 = [-150, -30], P5 = [0, 0] }}
wave_points = {{ lee = [200, 0] }}
quantities = ["deflection", "bending_moment_x", "shear_force_x", "pressure"]
"""
CASES = {
    "dense": {"method": "dense", "nx": 10, "ny": 2, "grading": 2.0},
    "lattice": {"method": "lattice", "nx": 10, "ny": 2, "grading": 1.0},
    "pfft": {"method": "pfft", "nx": 10, "ny": 2, "grading": 2.0},
    "fmm": {"method": "fmm", "nx": 10, "ny": 2, "grading": 2.0},
}
# NOTE: qemu64 calls itself an AMD processor; the kernels that OpenBLAS has for old ones of AMD use
# 3DNow!, which qemu does not know
BASELINE = ["qemu-x86_64", "-cpu", "qemu64"]
ENVIRONMENT = os.environ | {"OPENBLAS_CORETYPE": "Prescott"}


def run(folder, name, output, before=(), environment=None):
    command = [*before, *PROGRAM, "run", f"{name}.toml", "-o", output, "--threads", "1", "--progress", "none"]
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{name}: {' '.join(command)}: exit code {result.returncode}\n{result.stderr}")


def columns(path):
    with open(path, encoding="utf-8", newline="") as file:
        header, *rows = csv.reader(line for line in file if not line.startswith("#"))
    return dict(zip(header, zip(*rows)))


def difference(here, there):
    """Largest difference of two columns over the largest value; texts must be equal."""
    try:
        pairs = [(float(a), float(b)) for a, b in zip(here, there, strict=True)]
    except ValueError:
        return 0.0 if here == there else float("inf")
    return max(abs(a - b) for a, b in pairs) / (max(abs(a) for a, _ in pairs) or 1.0)


def compare(here, there):
    """{table: largest difference}, and the number of values compared."""
    worst, count = {}, 0
    for path in sorted(here.glob("*.csv")):
        mine, theirs = columns(path), columns(there / path.name)
        for name in mine:
            worst[path.name] = max(worst.get(path.name, 0.0), difference(mine[name], theirs[name]))
            count += len(mine[name])
    return worst, count


def main(program, folder):
    if not shutil.which(BASELINE[0]):
        print("no qemu-x86_64 (scripts/setup installs it)")
        sys.exit(77)
    PROGRAM.append(program)
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, values in CASES.items():
        (folder / f"{name}.toml").write_text(CASE.format(**values), encoding="utf-8")
        run(folder, name, f"{name}.here")
        run(folder, name, f"{name}.there", BASELINE, ENVIRONMENT)
        worst, count = compare(folder / f"{name}.here", folder / f"{name}.there")
        print(f"{name}: {count} values, largest difference {max(worst.values()):.1e}")
        if count < 100 or not max(worst.values()) <= TOLERANCE:
            sys.exit(f"{name}: {worst} (at most {TOLERANCE})")


PROGRAM = []

if __name__ == "__main__":
    main(*sys.argv[1:])

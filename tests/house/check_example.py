"""The example on the library prints what the reference table says.

    check_example.py PROGRAM ROOT

Deflections at two corners of the plate of Table 1, against tests/data/table1_rao_points.csv. Its
mesh of 6 m elements is good to 0.005, as verification_Table1Plate claims.
"""

import csv
import pathlib
import subprocess
import sys

TOLERANCE = 0.005
POINTS = ["P1", "P2"]  # the columns of the program
HEADING = 0.0


def reference(root):
    """{omega: [amplitude of each point]} of the solution with 30 modes."""
    found = {}
    with open(root / "tests/data/table1_rao_points.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["theory"] == "mindlin_30modes" and float(row["heading_deg"]) == HEADING:
                found.setdefault(float(row["omega"]), {})[row["point"]] = float(row["abs_w"])
    return {omega: [at[point] for point in POINTS] for omega, at in found.items()}


def main(program, root):
    output = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    rows = [[float(word) for word in line.split()] for line in output.splitlines()[1:]]
    expected = reference(pathlib.Path(root))
    errors = [abs(value - wanted) for omega, _, *values in rows for value, wanted in zip(values, expected[omega])]
    if len(errors) != 6 or max(errors) > TOLERANCE:
        sys.exit(f"{output}expected {expected}: errors {errors} (at most {TOLERANCE})")
    print(f"largest error {max(errors):.1e} m/m")


if __name__ == "__main__":
    main(*sys.argv[1:])

"""Runs every case of a folder; long ones on coarser meshes or with fewer waves. Each must end well, and its report too.

    run_cases.py FLOE CASES
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

# What is changed to make a case short: (what stands there, once, what stands there instead)
SHORTER = {
    "table1_seas.toml": [("nx = 100, ny = 20", "nx = 30, ny = 6"), ("from = 0.4, to = 3.0", "from = 0.4, to = 1.6"),
                         ('spreading = "cos2"', 'spreading = "cos2"\nallow_truncation = true')],
    "runway.toml": [("nx = 480, ny = 12", "nx = 240, ny = 4"), ("omega = [0.4, 0.5, 0.6, 0.8]", "omega = [0.4, 0.5]"),
                    *[(f"  {{ omega = {omega}, heading_deg = 0 }}, {{ omega = {omega}, heading_deg = 30 }}, "
                       f"{{ omega = {omega}, heading_deg = 60 }},\n", "") for omega in (0.6, 0.8)]],
    "lshape.toml": [("count = 9", "count = 2"), ("tolerance = 1e-2", "tolerance = 5e-2\nomega = { from = 0.7, to = 1.8 }"),
                    ('spreading = "cos2"', 'spreading = "cos2"\nallow_truncation = true')],
    "ring.toml": [("count = 8", "count = 2")],
    "modules.toml": [("period = [5.0, 6.0, 7.0, 8.0, 10.0, 12.0]", "period = [8.0]")],
    "ice_floe.toml": [("period = [5, 6, 7, 8, 10, 12, 14]", "period = [8, 10]")],
}


def shortened(path):
    text = path.read_text(encoding="utf-8")
    for old, new in SHORTER.get(path.name, []):
        if text.count(old) != 1:
            sys.exit(f"{path.name}: {old!r} stands there {text.count(old)} times: mend SHORTER in run_cases.py")
        text = text.replace(old, new)
    return text


def numbers_of(folder):
    with open(folder / "rao_points.csv", encoding="utf-8", newline="") as file:
        return [float(row["abs_w"]) for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def run_case(floe, path, folder):
    """What went wrong, or nothing."""
    case = folder / path.name
    case.write_text(shortened(path), encoding="utf-8")
    results = folder / path.stem
    for command in ([floe, "run", case, "-o", results], [floe, "report", results]):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return f"exit code {done.returncode}: {done.stderr.strip()}"
    account = json.loads((results / "run.json").read_text(encoding="utf-8"))
    if account["status"] != "complete":
        return f"status is {account['status']}"
    amplitudes = numbers_of(results)
    if not amplitudes or not all(math.isfinite(w) and w < 10.0 for w in amplitudes):
        return f"deflections at the points are {amplitudes}"
    worst = max(max(f["reciprocity_error"], f["energy_error"]) for f in account["frequencies"])
    return "" if worst < 1e-2 else f"energy or reciprocity is off by {worst}"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, cases = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    complaints = []
    with tempfile.TemporaryDirectory() as name:
        (pathlib.Path(name) / "meshes").symlink_to(cases.parent / "meshes")
        inside = pathlib.Path(name) / "cases"
        inside.mkdir()
        for toml in sorted(cases.glob("*.toml")):
            complaint = run_case(program, toml, inside)
            if complaint:
                complaints.append(f"{toml.name}: {complaint}")
    print("\n".join(complaints) or "in order")
    sys.exit(1 if complaints else 0)

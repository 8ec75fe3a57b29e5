"""Whole cases by `floe run`: mesh, modes, waves and files, as a user has them."""

import csv
import json
import pathlib
import subprocess
import sys

# Of every case: the water and the plate of the paper
WATER_AND_PLATE = """\
[water]
depth = 58.5
density = 1025.0
gravity = 9.81
[plate]
thickness = 2.0
youngs_modulus = 1.19e10
poisson_ratio = 0.13
density = 256.25
"""
CASE = """\
title = "{title}"
""" + WATER_AND_PLATE + """\
mesh = {{ rectangle = {{ length = {length}, width = {width}, nx = {plate_nx}, ny = {plate_ny} }} }}
[mesh]
rectangle = {{ length = {length}, width = {width}, nx = {nx}, ny = {ny} }}
[modes]
count = 30
[waves]
omega = [{omega}]
heading_deg = [0, 30, 60, 90]
[solver]
method = "{method}"
[output]
points = {{ P1 = [{x}, {y}], P5 = [0.0, 0.0] }}
"""


def points_of(folder):
    """Complex deflection of each point and heading."""
    with open(folder / "rao_points.csv", encoding="utf-8", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {(row["point"], row["heading_deg"]): complex(float(row["re_w"]), float(row["im_w"]))
                for row in rows}


def run_program(floe, case):
    """run.json of `floe run` on two threads."""
    output = case.with_suffix(".out")
    done = subprocess.run([floe, "run", case, "-o", output, "--fresh", "--progress", "none",
                           "--threads", "2"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"benchmarks: {case.stem} failed:\n{done.stdout}{done.stderr}")
    return json.loads((output / "run.json").read_text(encoding="utf-8"))


def row_of(name, account):
    """What every whole case tells, and how far off the program's own estimates were."""
    stage = {entry["stage"]: entry["seconds"] for entry in account["stages"]}
    total = sum(stage.values())
    frequency = account["frequencies"][-1]
    fluid = sum(stage.get(key, 0.0) for key in ("geometry", "Green function", "operator",
                                                "radiation", "coupled equation"))
    row = {"name": name, "N": account["nodes"], "threads": 2, "tolerance": 1e-6, "seconds": fluid,
           "error": frequency["true_residual"], "bytes": account["peak_memory"], "total_s": total,
           "modes_s": stage.get("dry modes", 0.0) + stage.get("plate", 0.0),
           "radiation_s": stage.get("radiation", stage.get("coupled equation")),
           "gmres_steps": frequency["iterations"], "applications": frequency["applications"],
           "energy_error": frequency["energy_error"],
           "between_nodes": frequency.get("residual_between_nodes"),
           "exact_residual": frequency.get("exact_residual"),
           "estimated_time_ratio": account["plan"]["estimated_seconds"] / total,
           "estimated_memory_ratio": account["plan"]["estimated_memory"] / account["peak_memory"]}
    print(f"benchmarks:   {name}: N {row['N']}, fluid {fluid:.3g} s, all {total:.3g} s, "
          f"{row['bytes'] / 1e6:.0f} MB; estimated / measured: time "
          f"{row['estimated_time_ratio']:.2f}, memory {row['estimated_memory_ratio']:.2f}", flush=True)
    return row


def run_case(floe, folder, name, method, nx, length=300.0, omega=1.01):
    """One row, and the deflection at its points."""
    width, ny = length / 5.0, nx // 5
    plate_nx = min(nx, round(100 * max(1.0, length / 1500.0)))
    case = folder / f"{name.replace('/', '_')}.toml"
    case.write_text(CASE.format(title=name, length=length, width=width, nx=nx, ny=ny,
                                plate_nx=plate_nx, plate_ny=plate_nx // 5, omega=omega,
                                method=method, x=-0.5 * length, y=-0.5 * width), encoding="utf-8")
    row = row_of(name, run_program(floe, case))
    row.update({"length": length, "omega": omega,
                "applications_a_mode": row["applications"] / 30.0})
    return row, points_of(case.with_suffix(".out"))


def add_differences(measured):
    """How far the points of each case are from those of the finest one of its plate."""
    rows = [row for row, _ in measured]
    for row, points in measured:
        same = [(other["N"], values) for other, values in measured
                if (other["length"], other["omega"]) == (row["length"], row["omega"])]
        finest = max(same, key=lambda pair: pair[0])[1]
        row["deflection_difference"] = max(abs(points[key] - finest[key]) for key in finest)
    return rows


def measure(floe, folder, full):
    """Time and memory against N by every method, and with a plate that grows."""
    sizes = {"lattice": [50, 75, 100, 120, 200, 400, 690], "dense": [50, 75],
             "pfft": [50, 100, 200, 400], "fmm": [50, 100, 200, 400]}
    if full:
        sizes["lattice"] += [1290]
        sizes["dense"] += [100, 120]
        sizes["pfft"] += [690]
        sizes["fmm"] += [690]
    cases = folder / "cases"
    pathlib.Path(cases).mkdir(exist_ok=True)
    measured = [run_case(floe, cases, f"case_wall/{method}/nx={nx}", method, nx)
                for method, counts in sizes.items() for nx in counts]
    # Elements of 3.75 m, the plate grows; kL grows with it
    for nx in [80, 160, 320] + ([400, 690, 1280] if full else []):
        measured.append(run_case(floe, cases, f"case_wall/growing/nx={nx}", "lattice", nx,
                                 length=3.75 * nx, omega=0.7))
    return add_differences(measured)

"""Runs at full size, as a user starts them: mesh, modes, seven headings and files."""

import subprocess
import sys

import whole_cases

CASE = """\
title = "{title}"
""" + whole_cases.WATER_AND_PLATE + """\
{plate_mesh}
[mesh]
{mesh}
[modes]
count = {modes}
[waves]
omega = [{omega}]
heading_deg = [0, 15, 30, 45, 60, 75, 90]
[solver]
method = "{method}"
route = "{route}"
[output]
points = {{ P1 = {point} }}
"""
# Meshes of more than 200,000 nodes; ring and modules fill less than a sixth of their boxes
MESHES = {
    "disc": ["disc", "--radius", "150", "--element-size", "1.32"],
    "disc_plate": ["disc", "--radius", "150", "--element-size", "3"],
    "ring": ["ring", "--inner-radius", "270", "--outer-radius", "300", "--element-size", "0.95"],
    "ring_plate": ["ring", "--inner-radius", "270", "--outer-radius", "300", "--element-size", "3"],
    "modules": ["modules", "--module-length", "100", "--module-width", "20", "--gap", "80",
                "--modules-x", "8", "--modules-y", "5", "--element-size", "1.1"],
    "modules_plate": ["modules", "--module-length", "100", "--module-width", "20", "--gap", "80",
                      "--modules-x", "8", "--modules-y", "5", "--element-size", "5"],
}


def rectangle(length, nx):
    return (f"rectangle = {{ length = {length}, width = {length / 5.0}, nx = {nx}, "
            f"ny = {nx // 5} }}")


def plate(length, nx, plate_nx, omega):
    return {"mesh": rectangle(length, nx), "omega": omega,
            "plate_mesh": f"mesh = {{ {rectangle(length, plate_nx)} }}",
            "point": f"[{-length / 2.0}, {-length / 10.0}]", "method": "lattice"}


def outline(mesh, point):
    return {"mesh": f'file = "{mesh}.msh"', "omega": 1.01, "point": point,
            "plate_mesh": f'mesh = {{ file = "{mesh}_plate.msh" }}'}


def cases():
    disc, ring = outline("disc", "[-150.0, 0.0]"), outline("ring", "[-285.0, 0.0]")
    modules = outline("modules", "[-675.0, -200.0]")
    return {
        "plate_300": plate(300.0, 690, 150, 1.01),
        "plate_300/direct": {**plate(300.0, 690, 150, 1.01), "route": "direct"},
        "plate_4800": plate(4800.0, 1290, 320, 0.7),
        "disc/pfft": {**disc, "method": "pfft"},
        "disc/fmm": {**disc, "method": "fmm"},
        "ring/fmm": {**ring, "method": "fmm"},
        # Forty plates have 120 rigid modes: all motions of stiff modules
        "modules/fmm": {**modules, "method": "fmm", "modes": 120},
        "modules/fmm/direct": {**modules, "method": "fmm", "route": "direct"},
    }


def measure(floe, folder):
    folder.mkdir(exist_ok=True)
    for name, arguments in MESHES.items():
        done = subprocess.run([floe, "mesh", *arguments, "-o", folder / f"{name}.msh"],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"benchmarks: mesh {name} failed:\n{done.stdout}{done.stderr}")
    rows = []
    for name, given in cases().items():
        case = folder / f"large_{name.replace('/', '_')}.toml"
        case.write_text(CASE.format(**{"title": name, "modes": 30, "route": "modal", **given}),
                        encoding="utf-8")
        rows.append(whole_cases.row_of(f"large_wall/{name}", whole_cases.run_program(floe, case)))
    return rows


def table(rows):
    """Markdown: one line a run."""
    text = ("| run | nodes | steps | applications | wall s | of it modes or factor, solution | "
            "peak GB | true residual | exact rows | between nodes | estimated time, memory |\n"
            + "|---" * 11 + "|\n")
    for row in rows:
        if not row["name"].startswith("large_wall/"):
            continue
        shown = ["–" if row.get(key) is None else f"{row[key]:.1e}"
                 for key in ("error", "exact_residual", "between_nodes")]
        text += (f"| {row['name'].removeprefix('large_wall/')} | {row['N']:,} | "
                 f"{row['gmres_steps']} | {row['applications']} | {row['total_s']:.1f} | "
                 f"{row['modes_s']:.1f}, {row['radiation_s']:.1f} | {row['bytes'] / 1e9:.1f} | "
                 f"{' | '.join(shown)} | {row['estimated_time_ratio']:.2f}, "
                 f"{row['estimated_memory_ratio']:.2f} |\n")
    return text

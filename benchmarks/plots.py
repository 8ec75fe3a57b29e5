"""The plots of a set of measurements, by gnuplot."""

import math
import subprocess

STYLE = """\
set terminal svg size 760,480 font "DejaVu Sans,13" background "#ffffff" enhanced
set output "{path}"
set title "{title}"
set xlabel "{x}"
set ylabel "{y}"
set grid
set logscale {log}
set key {key}
"""
COLOURS = {"lattice": "#0072b2", "dense": "#d55e00", "pfft": "#009e73", "fmm": "#cc79a7"}


def gnuplot(script):
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def data_block(name, points):
    lines = "\n".join(f"{x:.8g} {y:.8g}" for x, y in points)
    return f"${name} << EOD\n{lines}\nEOD\n"


def fitted(points):
    """Exponent over the two largest sizes."""
    if len(points) < 2:
        return ""
    (x1, y1), (x2, y2) = points[-2:]
    return f" ~ N^{{{math.log(y2 / y1) / math.log(x2 / x1):.2f}}}"


def draw_curves(path, title, x, y, curves, log="xy", key="left top"):
    """curves: (label, colour, [(x, y)])"""
    curves = [curve for curve in curves if curve[2]]
    if not curves:
        return
    blocks = "".join(data_block(f"d{i}", sorted(points)) for i, (_, _, points) in enumerate(curves))
    plots = ", ".join(f"$d{i} with linespoints pt 7 ps 0.7 lw 2 lc rgb '{colour}' title \"{label}\""
                      for i, (label, colour, _) in enumerate(curves))
    gnuplot(STYLE.format(path=path, title=title, x=x, y=y, log=log, key=key) + blocks
            + f"plot {plots}\n")


def draw_against_size(rows, folder):
    for column, title, y in (("seconds", "Fluid of the paper's plate, 30 modes, one frequency",
                              "wall time on two threads [s]"),
                             ("bytes", "Peak memory of the same", "memory [byte]")):
        curves = []
        for method, colour in COLOURS.items():
            points = sorted((row["N"], row[column]) for row in rows
                            if row["name"].startswith(f"case_wall/{method}/"))
            name = "dense LU" if method == "dense" else method
            curves.append((name + fitted(points), colour, points))
        draw_curves(folder / f"{'time' if column == 'seconds' else 'memory'}_against_size.svg",
                    title, "nodes", y, curves)


def draw_iterations(rows, folder):
    curves = []
    for kind, colour, label in (("damped", "#0072b2", "preconditioned"),
                                ("none", "#d55e00", "without preconditioner")):
        points = [(row["kL"], row["applications_a_mode"]) for row in rows
                  if row["name"].startswith("T9/gmres_wall/rectangle") and
                  row["name"].endswith("/" + kind)]
        curves.append((label, colour, points))
    draw_curves(folder / "iterations.svg", "Block GMRES to 1e-6, 30 modes, infinite depth",
                "plate length in radians of wave, {/Symbol n}L", "operator applications a mode",
                curves)


def draw_time_against_error(rows, folder):
    curves = [(label, colour,
               [(row["error"], row["ratio"]) for row in rows
                if start in row["name"] and row.get("ratio") and row["error"] > 0.0])
              for start, colour, label in (("pfft_sum/nx=690", COLOURS["pfft"], "pFFT sum"),
                                           ("fmm_sum/tol", COLOURS["fmm"], "FMM sum"),
                                           ("_operator/nx=690", "#000000", "whole operators"))]
    draw_curves(folder / "time_against_error.svg", "287 thousand nodes, one thread",
                "measured relative error", "time over FFTW's padded convolution (F1)", curves,
                key="right top")


def draw_spectral_stage(rows, folder):
    curves = []
    for kind, colour, label in (("conventional", "#d55e00", "conventional: two matrix products"),
                                ("full_matrix", "#0072b2", "pseudo-excitation, full matrix"),
                                ("auto_spectra", "#009e73", "pseudo-excitation, auto-spectra")):
        points = sorted((row["N"], row["seconds"]) for row in rows
                        if row["name"].startswith(f"table2/{kind}_wall/"))
        curves.append((label + fitted(points), colour, points))
    draw_curves(folder / "spectral_stage.svg", "Response spectra of one wave, one thread", "nodes",
                "time [s]", curves)


def draw(rows, folder):
    for picture in (draw_against_size, draw_iterations, draw_time_against_error,
                    draw_spectral_stage):
        picture(rows, folder)

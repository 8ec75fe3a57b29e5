#!/usr/bin/python3
"""Figures 2 to 5 of Li, Wang, Zong, Sun and Liang (2014), Applied Ocean Research 48, 202-213.

    paper_figures.py [FOLDER] [--coarse]

The deflection along the centreline of a plate of 300 × 60 m in waves of five lengths from four
directions, computed by floe and held against published values. Pictures figure_2.png to
figure_5.png go to FOLDER (the current one if not given). --coarse: a coarse mesh, for a quick look.
The cells, each begun by a line `# %%`, run one after the other in Spyder, VS Code or Jupyter too.
"""

# %% Read what was asked for, and the published values
import argparse
import csv
from pathlib import Path

import matplotlib
import numpy as np

import floe

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

parser = argparse.ArgumentParser(description="Figures 2 to 5 of the paper.")
parser.add_argument("folder", nargs="?", default=".", type=Path)
parser.add_argument("--coarse", action="store_true", help="elements of 15 m instead of 6 m")
options = parser.parse_args()

CASES = Path(__file__).resolve().parents[2] / "cases"
with open(CASES / "table1.measured.csv", encoding="utf-8", newline="") as file:
    published = list(csv.DictReader(line for line in file if not line.startswith("#")))

# %% Describe the plate of Table 1 and the waves of section 4.1.1
LENGTH = 300.0
OMEGA = {0.2: 1.01, 0.4: 0.72, 0.6: 0.58, 0.8: 0.48, 1.0: 0.42}  # of wavelength / length
HEADINGS = [0, 30, 60, 90]
nx, ny = (20, 4) if options.coarse else (50, 10)
case = {
    "title": "Plate of Table 1",
    "water": {"depth": 58.5, "density": 1025.0, "gravity": 9.81},
    "plate": {"thickness": 2.0, "youngs_modulus": 1.19e10, "poisson_ratio": 0.13, "density": 256.25},
    "mesh": {"rectangle": {"length": LENGTH, "width": 60.0, "nx": nx, "ny": ny}},
    "modes": {"count": 30},
    "waves": {"omega": sorted(OMEGA.values()), "heading_deg": HEADINGS},
    "output": {"lines": {"centreline": {"from": [-150, 0], "to": [150, 0], "count": 121}}},
}

# %% Solve plate and water together
result = floe.run(case, progress=lambda share, now: print(f"{100 * share:3.0f} %  {now}", flush=True))
line = result.lines["centreline"]
amplitude = abs(line.deflection)  # frequencies × headings × stations
for check in result.checks:
    print(f"{check.name}: {check.value:.1e} (limit {check.limit:.0e}), {check.status}")


# %% Draw a figure a heading, a panel a wavelength
def published_values(omega: float, heading: float) -> tuple[str, np.ndarray, np.ndarray]:
    """Source, distance [m] and amplitude of what was published for one wave."""
    rows = [row for row in published if float(row["omega"]) == omega and float(row["heading_deg"]) == heading]
    source = rows[0]["source"] if rows else ""
    return source, np.array([float(row["s"]) for row in rows]), np.array([float(row["abs_w"]) for row in rows])


def draw(number: int, heading: float) -> Path:
    """Figure 2, 3, 4 or 5."""
    figure, axes = plt.subplots(2, 3, figsize=(10.5, 5.6), sharex=True, sharey=True, layout="constrained")
    h = list(result.heading_deg).index(heading)
    for panel, (ratio, omega) in zip(axes.flat, OMEGA.items()):
        f = list(result.omega).index(omega)
        panel.plot(line.distance / LENGTH, amplitude[f, h], color="#0072b2", label="floe")
        source, distance, values = published_values(omega, heading)
        panel.plot(distance / LENGTH, values, "o", color="#d55e00", markersize=4.5, label=source or None)
        panel.set_title(f"λ/L = {ratio:g}", fontsize=10)
        panel.grid(color="#dddddd", linewidth=0.6)
        panel.set_axisbelow(True)
        if len(values):
            difference = np.interp(distance, line.distance, amplitude[f, h]) - values
            print(f"heading {heading:2g}, wavelength {ratio:g} L: rms difference {np.sqrt(np.mean(difference**2)):.3f}")
    axes.flat[-1].axis("off")
    handles, labels = max((panel.get_legend_handles_labels() for panel in axes.flat[:-1]), key=lambda found: len(found[1]))
    axes.flat[-1].legend(handles, labels, loc="center", frameon=False)
    axes.flat[2].tick_params(labelbottom=True)
    axes[0, 0].set_ylim(0, 1.6)
    axes[0, 0].set_xlim(0, 1)
    figure.supxlabel("distance from the weather end x/L", fontsize=10)
    figure.supylabel("amplitude |w|/A", fontsize=10)
    figure.suptitle(f"Fig. {number}: deflection along the centreline, heading {heading:g}°", fontsize=11)
    path: Path = options.folder / f"figure_{number}.png"
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return path


options.folder.mkdir(parents=True, exist_ok=True)
for number, heading in enumerate(HEADINGS, start=2):
    print(draw(number, heading))

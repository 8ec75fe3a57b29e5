"""The table of targets T1 … T15 from the rows that were measured."""

import math


class Rows:
    """Looks rows up by the start of their names."""

    def __init__(self, rows):
        self.rows = {row["name"]: row for row in rows}

    def starting(self, start):
        return [row for name, row in self.rows.items() if name.startswith(start)]

    def value(self, name, key):
        return self.rows.get(name, {}).get(key)

    def extremes(self, start, key):
        values = [row[key] for row in self.starting(start) if row.get(key) is not None]
        return (min(values), max(values)) if values else None


def exponent(rows, key):
    """Slope of log key over log N from 1e5 nodes on, or of the two largest sizes."""
    rows = sorted(rows, key=lambda row: row["N"])
    large = [row for row in rows if row["N"] >= 9e4]
    first, last = (large[0], large[-1]) if len(large) > 1 else (rows[-2], rows[-1])
    return math.log(last[key] / first[key]) / math.log(last["N"] / first["N"])


def show(value, form="{:.2g}"):
    return "not measured" if value is None else form.format(value)


def span(pair, form="{:.2g}"):
    if pair is None:
        return "not measured"
    low, high = form.format(pair[0]), form.format(pair[1])
    return low if low == high else f"{low} – {high}"


def fluid_against_lu(rows, nx):
    """How many times the fluid of the paper's case goes into LAPACK's factorisation."""
    factor = rows.value(f"T7/fluid/nx={nx}", "factor")
    return "not measured" if factor is None else f"1/{factor:.3g}"


def large_against_lu(rows):
    """(factor, the size that was factored): scaled by N³ from the largest one."""
    fluid = rows.rows.get("case_wall/lattice/nx=690")
    factored = rows.starting("table2/factorisation_wall")
    if not fluid or not factored:
        return None, None
    largest = max(factored, key=lambda row: row["N"])
    scaled = largest["seconds"] * (fluid["N"] / largest["N"]) ** 3
    return scaled / fluid["seconds"], largest["N"]


def growth(rows, start):
    cases = rows.starting(start)
    if len(cases) < 2:
        return "not measured"
    return f"time {exponent(cases, 'seconds'):.2f}, memory {exponent(cases, 'bytes'):.2f}"


def table(measured):
    """Markdown: id, what, must / stretch, measured."""
    rows = Rows(measured)
    t8, factored = large_against_lu(rows)
    lattice = "T1/lattice/"
    t2, t3 = "T2/pfft_operator/nx=690/tolerance=1e-4", "T3/pfft_operator/nx=690/tolerance=1e-6"
    fmm = "fmm_operator/nx=690/tolerance=1e-4"
    masked = [row for row in rows.starting(lattice) if "rectangle" not in row["name"]
              and "nx=690" in row["name"]]
    per_node = {name: (rows.value(name, "bytes") or math.nan) / (rows.value(name, "N") or math.nan)
                for name in (lattice + "rectangle/nx=690", t2, fmm)}
    applications = [rows.value(f"T9/gmres_wall/rectangle/kL={kl}/kh=inf/damped",
                               "applications_a_mode") for kl in (31, 122, 240)]
    outlines = [rows.value(f"T9b/gmres_wall/{outline}/kL=122/kh=1.0/damped", "applications_a_mode")
                for outline in ("rectangle", "L", "ring")]
    lines = [
        ("T1", "lattice application, rectangle, N = 287k, in F1", "4.5 / 2.6",
         f"{show(rows.value(lattice + 'rectangle/nx=690', 'ratio'))}, "
         f"error {show(rows.value(lattice + 'rectangle/nx=690', 'error'), '{:.0e}')}"),
        ("", "masked outlines", "7",
         span((min(r["ratio"] for r in masked), max(r["ratio"] for r in masked))
              if masked else None)),
        ("", "N = 1M", "3.2 / 1.8", show(rows.value(lattice + "rectangle/nx=1290", "ratio"))),
        ("T2", "pFFT application, general mesh, error ≤ 1e-4, in F1", "12 / 7",
         f"{show(rows.value(t2, 'ratio'))}, error {show(rows.value(t2, 'error'), '{:.1e}')}"),
        ("T3", "the same, ≤ 1e-6", "20 / 14",
         f"{show(rows.value(t3, 'ratio'))}, error {show(rows.value(t3, 'error'), '{:.1e}')}"),
        ("T4", "FMM application, ≤ 1e-4, N = 287k, kL = 150, in F1", "31 / 16",
         f"{show(rows.value('T4/fmm_sum/tolerance=1e-4', 'ratio'))}, error "
         f"{show(rows.value('T4/fmm_sum/tolerance=1e-4', 'error'), '{:.1e}')}"),
        ("T5", "the same, ≤ 3e-6", "40 / 24",
         f"{show(rows.value('T5/fmm_sum/tolerance=3e-6', 'ratio'))}, error "
         f"{show(rows.value('T5/fmm_sum/tolerance=3e-6', 'error'), '{:.1e}')}"),
        ("T6", "eight columns at once, one column, over one alone: pFFT, FMM operator at 1e-4",
         "0.55 / 0.4", f"{show(rows.value(t2, 'of_eight_share'))}, "
         f"{show(rows.value(fmm, 'of_eight_share'))}"),
        ("T7", "fluid of the paper's case, 30 modes, against LAPACK's LU alone: N = 1621, 8929",
         "1/2, 1/50 / 1/5, 1/200",
         f"{fluid_against_lu(rows, 50)}, {fluid_against_lu(rows, 120)}"),
        ("", "N = 3556", "", fluid_against_lu(rows, 75)),
        ("T8", "fluid at N = 287k, wall, two threads, against one-thread LU scaled by N³"
         + (f" from {factored:.0f}" if factored else ""), "1/20,000 / 1/60,000",
         "not measured" if t8 is None else f"1/{t8:,.0f}"),
        ("T9", "applications a mode to 1e-6, 30 modes, νL = 31, 122, 240",
         "15, 40, 55 / 7, 20, 28", ", ".join(show(v, "{:.3g}") for v in applications)),
        ("T9b", "kL = 122, kh = 1: rectangle, L, ring", "60, 100, 240",
         ", ".join(show(v, "{:.3g}") for v in outlines)),
        ("T10", "set-up at a frequency in own applications: lattice, pFFT, FMM at 1e-4",
         "10, 30, 30 / 5, 15, 15",
         ", ".join(show(rows.value(name, "setup_applications"))
                   for name in (lattice + "rectangle/nx=690", t2, fmm))),
        ("T11", "Green function by table against Boost's J0 + Y0", "1/8 / 1/20",
         "1/" + span(None if rows.extremes("T11", "ratio") is None else tuple(
             1.0 / v for v in reversed(rows.extremes("T11", "ratio"))), "{:.3g}")
         + f", error {span(rows.extremes('T11', 'error'), '{:.0e}')}"),
        ("T12", "one wave by pseudo-excitation against two zgemm, N = 1621: auto-spectra, matrix",
         "1e-5, 1e-3 / 1e-6, 7e-4",
         f"{show(rows.value('T12/auto_spectra_wall/N=1621', 'ratio'), '{:.1e}')}, "
         f"{show(rows.value('T12/full_matrix_wall/N=1621', 'ratio'), '{:.1e}')}"),
        ("T13", "growth with N, exponents: (a) one plate refined", "1.15 / 1.05",
         growth(rows, "case_wall/lattice")),
        ("", "(b) the plate grows", "1.3 / 1.15", growth(rows, "case_wall/growing")),
        ("T14", "two threads over one: wall", "1/1.5 / 1/1.8",
         "1/" + span(None if rows.extremes("T14", "ratio") is None else tuple(
             1.0 / v for v in reversed(rows.extremes("T14", "ratio"))))),
        ("", "CPU", "1.15", span(rows.extremes("T14", "cpu_ratio"))),
        ("T15", "bytes a node: lattice, pFFT, FMM operator at 1e-4", "1000, 4000, 4000 / 400, 2500, 2500",
         ", ".join("not measured" if math.isnan(v) else f"{v:.0f}" for v in per_node.values())),
    ]
    head = "| id | what | must / stretch | measured |\n|---|---|---|---|\n"
    return head + "".join(f"| {' | '.join(line)} |\n" for line in lines)

"""Table 2 of Li, Wang, Zong, Sun and Liang (2014): its figures, and what was measured here."""

SIZES = [1621, 3556, 6241, 8929]
# One core of an AMD Opteron 6272, 2.1 GHz [s]
PAPER = {"LU factorisation": [6, 59, 318, 984],
         "spectra by pseudo-excitation": [1, 5, 16, 41],
         "spectra by matrix products": [294, 2940, 16560, 46080]}
PROGRAMS = {"LU factorisation": "factorisation",
            "spectra by pseudo-excitation": "full_matrix",
            "… auto-spectra alone": "auto_spectra",
            "spectra by matrix products": "conventional"}
FAST = {287317: 690, 1001557: 1290}  # nodes: elements along the plate


def duration(seconds):
    for unit, size in (("h", 3600.0), ("min", 60.0)):
        if seconds >= 1.5 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.2g} s" if seconds < 100.0 else f"{seconds:.0f} s"


def measured_line(rows, program):
    """A time a size; sizes that were not measured are scaled by N³ from the largest that was."""
    known = {round(row["N"]): row["seconds"] for row in rows
             if row["name"].startswith(f"table2/{program}_wall/")}
    if not known:
        return ["not measured"] * len(SIZES)
    largest = max(known)
    power = 3 if program in ("factorisation", "conventional") else 2
    return [duration(known[n]) if n in known
            else duration(known[largest] * (n / largest) ** power) + " †" for n in SIZES]


def table(rows):
    named = {row["name"]: row for row in rows}
    head = "| | " + " | ".join(f"N = {n:,}" for n in [*SIZES, *FAST]) + " |\n"
    text = head + "|---" * (1 + len(SIZES) + len(FAST)) + "|\n"
    for what, seconds in PAPER.items():
        text += f"| paper: {what} | {' | '.join(map(duration, seconds))} | | |\n"
    for what, program in PROGRAMS.items():
        text += f"| here: {what} | {' | '.join(measured_line(rows, program))} | | |\n"
    fluid = []
    for nodes, nx in [*zip(SIZES, (50, 75, 100, 120)), *FAST.items()]:
        row = named.get(f"case_wall/lattice/nx={nx}")
        fluid.append(duration(row["seconds"]) if row and round(row["N"]) == nodes else "–")
    text += f"| here: fluid by the lattice operator, 30 modes, two threads | {' | '.join(fluid)} |\n"
    return text + ("\n† scaled from the largest size measured: by N³ the factorisation and the "
                   "products, by N² what grows so.\n")

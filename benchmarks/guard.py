#!/usr/bin/env python3
"""Fails when a small fixed case got more expensive than benchmarks/baseline.json allows.

  guard.py BENCH_GUARD             compares; exit code 1 names each case, figure and change
  guard.py BENCH_GUARD --update    writes the baseline anew (say why in CHANGELOG.md)
  guard.py BENCH_GUARD --only A,B  some cases only

Instructions are counted by valgrind, so a busy machine changes nothing; the one time is a ratio to
FFTW in the same run. Counts hold for the compiler and the instruction set that the baseline names;
elsewhere they are told but not compared, while iterations and bytes are.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

BASELINE = pathlib.Path(__file__).with_name("baseline.json")

# How much more is too much, as a share: instructions wander with the libraries' choice of kernels,
# iterations by one with the last bit of a sum, a time with the machine
MARGIN = {"instructions": 0.03, "iterations": 0.05, "applications": 0.05, "allocated_bytes": 0.05,
          "memory_bytes": 0.02, "time_ratio": 0.6}
TIMED = {"time_of_application"}  # not under valgrind


def machine():
    """What instruction counts depend on."""
    flags = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    wide = all(re.search(rf"\b{flag}\b", flags) for flag in ("avx2", "fma", "bmi2"))
    compiler = subprocess.run(["c++", "-dumpfullversion"], capture_output=True, text=True, check=False)
    return f"{platform.machine()}{'-v3' if wide else ''}, gcc {compiler.stdout.strip()}"


def run_case(program, case):
    """Figures of one case by name."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = [program, case]
    with tempfile.TemporaryDirectory() as folder:
        if case not in TIMED:
            command = ["valgrind", "--tool=callgrind", "--collect-atstart=no",
                       "--toggle-collect=*guarded*", f"--callgrind-out-file={folder}/out", *command]
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if done.returncode != 0:
        sys.exit(f"guard: {case} failed:\n{done.stdout}{done.stderr}")
    figures = {}
    for line in done.stdout.splitlines():
        name, value = line.split()
        figures[name] = float(value)
    collected = re.search(r"Collected : (\d+)", done.stderr)
    if collected:
        figures["instructions"] = float(collected.group(1))
    if "instructions" in figures and figures["instructions"] == 0:
        sys.exit(f"guard: no instruction of {case} was counted")
    return figures


def measure(program, cases):
    """Figures of all cases; those under valgrind two at a time, times alone."""
    counted = [case for case in cases if case not in TIMED]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        measured = dict(zip(counted, pool.map(lambda case: run_case(program, case), counted)))
    for case in cases:
        if case in TIMED:
            measured[case] = run_case(program, case)
    return measured


def compare(measured, baseline, here):
    """Lines about what got worse, and about what got so much better that the baseline is stale."""
    worse, better = [], []
    for case, figures in measured.items():
        for figure, value in figures.items():
            known = baseline["cases"].get(case, {}).get(figure)
            if known is None:
                worse.append(f"{case}: {figure} = {value:.6g} has no baseline")
                continue
            if figure == "instructions" and here != baseline["machine"]:
                continue
            change = value / known - 1.0 if known else (1.0 if value else 0.0)
            margin = MARGIN[figure]
            text = f"{case}: {figure} {known:.6g} -> {value:.6g}, {100.0 * change:+.1f} %"
            if change > margin:
                worse.append(f"{text} (allowed {100.0 * margin:+.0f} %)")
            elif change < -2.0 * margin:
                better.append(text)
    return worse, better


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    known = subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()
    cases = options.only.split(",") if options.only else known
    here = machine()
    measured = measure(program, cases)

    if options.update:
        BASELINE.write_text(json.dumps({"machine": here, "cases": measured}, indent=2,
                                       sort_keys=True) + "\n", encoding="utf-8")
        print(f"guard: {BASELINE} written; say why in CHANGELOG.md")
        return 0

    baseline = json.loads(BASELINE.read_text(encoding="utf-8"))
    worse, better = compare(measured, baseline, here)
    if here != baseline["machine"]:
        print(f"guard: instructions not compared: {here}, baseline {baseline['machine']}")
    for line in better:
        print(f"guard: cheaper: {line}")
    for line in worse:
        print(f"guard: WORSE: {line}")
    print(f"guard: {len(measured)} cases, {sum(map(len, measured.values()))} figures, "
          f"{len(worse)} worse, {len(better)} cheaper than the margin")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())

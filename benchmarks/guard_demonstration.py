#!/usr/bin/env python3
"""Shows that the regression guard sees what it is there for: in a scratch copy of the source, three
deliberate losses are built one after the other, and each must make guard.py fail at its case.

  guard_demonstration.py SOURCE_DIR     about ten minutes; exit code 1 when a loss goes unnoticed
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

# name, file, what is there, what takes its place, cases to measure, what the guard must say
LOSSES = [
    ("near field 20 % slower", "src/bem/near_matrix.cpp",
     "        const std::vector<Complex>& values =\n",
     "        if (i % 5 == 0) row.from_moments(block, i);\n"
     "        const std::vector<Complex>& values =\n",
     "pfft_setup", "WORSE: pfft_setup: instructions"),
    ("one more transform in the convolution", "fmm/src/pfft/lane_convolution.cpp",
     "  transform_rows(grid, workspace);\n",
     "  transform_rows(grid, workspace);\n  transform_rows(grid, workspace);\n",
     "pfft_apply", "WORSE: pfft_apply: instructions"),
    ("a weakened preconditioner", "include/floe/bem/damped_wave_preconditioner.hpp",
     "double damping = 0.35;", "double damping = 3.5;",
     "gmres", "WORSE: gmres: iterations"),
]


def run(command, folder, **options):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, **options)


def require(done, what):
    if done.returncode != 0:
        sys.exit(f"guard demonstration: {what} failed:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")


def guard(scratch, cases):
    require(run(["cmake", "--build", "build", "--target", "bench_guard", "--parallel",
                 str(os.cpu_count())], scratch), "build")
    return run([sys.executable, "benchmarks/guard.py", "build/benchmarks/bench_guard", "--only",
                cases], scratch)


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    unnoticed = []
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder) / "floe"
        shutil.copytree(source, scratch, ignore=shutil.ignore_patterns(
            "build", ".git", "node_modules"))
        require(run(["cmake", "-G", "Ninja", "-B", "build", "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
                     "-DFLOE_CHECKS=ON", "-DFLOE_TESTS=OFF", "-DFLOE_REPORT=OFF",
                     "-DFLOE_BENCHMARKS=ON", "-DCMAKE_CXX_FLAGS=-D_GLIBCXX_ASSERTIONS"], scratch),
                "configuration")
        require(guard(scratch, ",".join(loss[4] for loss in LOSSES)), "guard of the plain copy")
        for name, path, old, new, case, expected in LOSSES:
            file = scratch / path
            text = file.read_text(encoding="utf-8")
            if text.count(old) != 1:
                sys.exit(f"guard demonstration: {path} has {text.count(old)} places for: {name}")
            file.write_text(text.replace(old, new), encoding="utf-8")
            done = guard(scratch, case)
            seen = done.returncode == 1 and expected in done.stdout
            print(f"{name}: {'noticed' if seen else 'NOT NOTICED'}\n{done.stdout}", flush=True)
            if not seen:
                unnoticed.append(name)
            file.write_text(text, encoding="utf-8")
    return 1 if unnoticed else 0


if __name__ == "__main__":
    sys.exit(main())

"""Every source of ours is as clang-format 14 would write it. To mend: `check_format.py ROOT --fix`."""

import pathlib
import shutil
import subprocess
import sys

import house

CODE = ["include", "src", "fmm", "tests", "benchmarks", "python", "examples"]
CLANG_FORMAT = shutil.which("clang-format-14") or "clang-format-14"


def run(root, options):
    sources = [str(p) for p in house.files_under(root, CODE, house.SOURCE_SUFFIXES)]
    return subprocess.run([CLANG_FORMAT, *options, *sources], cwd=root, text=True, stderr=subprocess.PIPE)


def check(root):
    result = run(root, ["--dry-run", "--Werror"])
    places = [line for line in result.stderr.splitlines() if ": error:" in line]
    if result.returncode != 0 and not places:
        return [result.stderr.strip()]
    return places


CONFIGURATION = (pathlib.Path(__file__).resolve().parents[2] / ".clang-format").read_text(encoding="utf-8")
GOOD = {".clang-format": CONFIGURATION, "src/a.cpp": "int f(int x) { return 2 * x; }\n"}
BAD = [({"src/a.cpp": "int f (int x) {return 2*x;}\n"}, "src/a.cpp:1")]

if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[2] == "--fix":
        sys.exit(run(pathlib.Path(sys.argv[1]), ["-i"]).returncode)
    house.main(check, GOOD, BAD)

"""Runs the commands of a page as they are printed, one after another, and fails with the first that fails.

    run_pages.py FLOE ROOT PAGE

The commands are the blocks ```sh of the page; a command that is not to be run stands in a block without `sh`.
They run by `bash -euo pipefail` in a folder that looks like a clone in which floe is built: cases, meshes, docs,
scripts and build/release/floe. `scripts/run` builds nothing there, and long cases are shorter (run_cases.py). A ```toml block after "save it as `NAME`" is
saved. A page without a command fails too, and so does a command in a block of another kind than these.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

import run_cases

BLOCK = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SAVED = re.compile(r"save it as `([\w.-]+)`[^`]*$", re.IGNORECASE)
COMMAND = re.compile(r"^\s*(?:build/release/)?floe [a-z]|^\s*scripts/", re.MULTILINE)
RUN = """#!/usr/bin/env bash
set -euo pipefail
build/release/floe run "$@"
name=$(basename "$1" .toml); measured=${1%.toml}.measured.csv
[ -f "$measured" ] || measured=
scripts/plot_lines "$name.out" ${measured:+"$measured"}
"""


def steps(text):
    """("run", commands), ("save", name, content) in the order of the page; a complaint as ("wrong", text)."""
    end = 0
    for block in BLOCK.finditer(text):
        kind, content = block.groups()
        name = SAVED.search(text[end:block.start()])
        end = block.end()
        if kind == "sh":
            yield "run", content, ""
        elif kind == "toml" and name:
            yield "save", content, name.group(1)
        elif kind and kind != "toml" and COMMAND.match(content):
            yield "wrong", content, ""


def make_clone(folder, floe, root):
    """What the pages expect of a clone."""
    for name in ("meshes", "docs", "report", "tests"):
        (folder / name).symlink_to(root / name)
    (folder / "cases").mkdir()
    for case in (root / "cases").iterdir():
        if case.suffix == ".toml":
            (folder / "cases" / case.name).write_text(run_cases.shortened(case), encoding="utf-8")
        else:
            (folder / "cases" / case.name).symlink_to(case)
    scripts = folder / "scripts"
    scripts.mkdir()
    for script in (root / "scripts").iterdir():
        if script.name != "run":
            (scripts / script.name).symlink_to(script)
    (scripts / "run").write_text(RUN, encoding="utf-8")
    (scripts / "run").chmod(0o755)
    built = folder / "build" / "release"
    built.mkdir(parents=True)
    (built / "floe").symlink_to(floe)


def run_page(floe, root, page):
    """What went wrong, or nothing."""
    count = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_clone(folder, floe, root)
        environment = {**os.environ, "PATH": f"{folder / 'build' / 'release'}:{os.environ['PATH']}"}
        for step, content, file in steps(page.read_text(encoding="utf-8")):
            if step == "wrong":
                return f"a command stands in a block that is not ```sh:\n{content}"
            if step == "save":
                (folder / file).write_text(content, encoding="utf-8")
                continue
            count += 1
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", content], cwd=folder, env=environment, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            if done.returncode != 0:
                return f"exit code {done.returncode} of\n{content}\n{done.stdout}"
    return "" if count else "no command was run"


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    complaint = run_page(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]))
    print(f"{sys.argv[3]}: {complaint}" if complaint else "in order")
    sys.exit(1 if complaint else 0)

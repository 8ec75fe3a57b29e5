"""docs/howto/case_file.md names exactly the keys that the program reads, and the examples of the
documents are cases that it accepts.

    check_case_keys.py FLOE ROOT

The program is asked: an unknown key in a section makes it list the keys that it knows there.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import house

PAGE = "docs/howto/case_file.md"
WITH_EXAMPLES = ["README.md", "docs/howto"]
NONE = "qqqqqqqqqqqqqqqq"  # near to no key
SMALLEST = {
    "water": "depth = 10.0",
    "plate": "thickness = 1.0\nyoungs_modulus = 1e10\npoisson_ratio = 0.3\ndensity = 500.0",
    "mesh": "rectangle = { length = 20.0, width = 10.0, nx = 4, ny = 2 }",
    "waves": "omega = [0.5]\nheading_deg = [0]",
}
# Where in a case an unknown key goes, for every table of the page and its tables within
PROBES = {
    "water": {"water": f"{NONE} = 1"},
    "plate": {"plate": f"{NONE} = 1"},
    "plate.region": {"plate": f"{SMALLEST['plate']}\n[[plate.region]]\n{NONE} = 1"},
    "plate.structure": {"plate": f"structure = {{ {NONE} = 1 }}"},
    "mesh": {"mesh": f"{NONE} = 1"},
    "mesh.rectangle": {"mesh": f"rectangle = {{ {NONE} = 1 }}"},
    "mesh.disc": {"mesh": f"disc = {{ {NONE} = 1 }}"},
    "mesh.ring": {"mesh": f"ring = {{ {NONE} = 1 }}"},
    "mesh.lshape": {"mesh": f"lshape = {{ {NONE} = 1 }}"},
    "mesh.modules": {"mesh": f"modules = {{ {NONE} = 1 }}"},
    "modes": {"modes": f"{NONE} = 1"},
    "waves": {"waves": f"{NONE} = 1"},
    "solver": {"solver": f"{NONE} = 1"},
    "sea_grid": {"sea_grid": f"{NONE} = 1"},
    "sea_grid.omega": {"sea_grid": f"omega = {{ {NONE} = 1 }}"},
    "sea": {"[sea]": f"{NONE} = 1"},
    "output": {"output": f"{NONE} = 1"},
    "output.lines.NAME": {"output": f"lines = {{ NAME = {{ {NONE} = 1 }} }}"},
    "output.combinations.NAME": {"output": f"combinations = {{ NAME = {{ {NONE} = 1 }} }}"},
    "output.fields": {"output": f"fields = [{{ {NONE} = 1 }}]"},
}


def check_case(floe, text, meshes=None):
    """Exit code and error message of `floe check` for a case with this text, beside a folder `meshes`."""
    with tempfile.TemporaryDirectory() as folder:
        if meshes:
            (pathlib.Path(folder) / "meshes").symlink_to(meshes.resolve())
        (pathlib.Path(folder) / "case.toml").write_text(text, encoding="utf-8")
        done = subprocess.run([floe, "check", "case.toml"], cwd=folder, capture_output=True, text=True, check=False)
        return done.returncode, done.stderr


def case_with(sections):
    return "".join(f"[{name}]\n{body}\n" for name, body in {**SMALLEST, **sections}.items())


def known_keys(floe, text):
    """The names that the program lists when it meets the unknown key."""
    found = re.search(r"\(known are (.*)\)", check_case(floe, text)[1])
    return set(found.group(1).split(", ")) if found else set()


def documented_keys(page):
    """{section: keys} from the tables under the headings `## [section]`; "" is the top."""
    keys, section = {"": set()}, None
    for line in page.splitlines():
        heading = re.match(r"##+ (?:\[(\w+)\]|(At the top)|.*)$", line)
        if heading:
            section = heading.group(1) or ("" if heading.group(2) else None)
            if section:
                keys[section] = set()
                keys[""].add(section)
        row = re.match(r"\| `([\w.]+)` \|", line)
        if row and section is not None:
            *path, key = row.group(1).split(".")
            keys.setdefault(".".join([section, *path]) if section else "", set()).add(key)
    return keys


def documented_quantities(page):
    part = page.partition("### Quantities")[2].partition("\n## ")[0]
    return {name for row in re.findall(r"^\| (`.*?`) \|", part, re.MULTILINE) for name in re.findall(r"`(\w+)`", row)}


def compare(where, documented, known):
    for key in sorted(documented - known):
        yield f"{PAGE}: {where} {key}: the program does not know it"
    for key in sorted(known - documented):
        yield f"{PAGE}: {where} {key}: is missing"


def check_examples(floe, root):
    for path in house.files_under(root, WITH_EXAMPLES, {".md"}):
        for example in re.findall(r"```toml\n(.*?)```", (root / path).read_text(encoding="utf-8"), re.DOTALL):
            code, error = check_case(floe, example, root / "meshes")
            if code != 0:
                yield f"{path}: an example is refused: {error.strip()}"


def check_new_case(floe, documented):
    """What `floe init` writes names every key but those of special seas, and is accepted."""
    with tempfile.TemporaryDirectory() as folder:
        made = subprocess.run([floe, "init", "new.toml", "--sea", "2", "6.3"], cwd=folder, capture_output=True, text=True, check=False)
        if made.returncode != 0:
            yield f"floe init: {made.stderr.strip()}"
            return
        text = (pathlib.Path(folder) / "new.toml").read_text(encoding="utf-8")
    code, error = check_case(floe, text)
    if code != 0:
        yield f"floe init writes a case that is refused: {error.strip()}"
    for section in ("", "water", "plate", "mesh", "modes", "waves", "solver", "sea_grid", "output"):
        for key in sorted(documented[section]):
            if not re.search(rf"\b{key}\b", text):
                yield f"floe init: {section or 'at the top'} {key} is not named in what it writes"


def check(floe, root):
    page = (root / PAGE).read_text(encoding="utf-8")
    documented = documented_keys(page)
    new_case = list(check_new_case(floe, documented))
    complaints = list(compare("key", documented.pop(""), known_keys(floe, f"{NONE} = 1\n" + case_with({}))))
    for section in sorted(set(documented) | set(PROBES)):
        known = known_keys(floe, case_with(PROBES[section])) if section in PROBES else set()
        complaints += compare(f"[{section}]", documented.get(section, set()), known)
    message = check_case(floe, case_with({"output": f'quantities = ["{NONE}"]'}))[1]
    listed = re.search(r"must be one of (.*)\)", message)
    complaints += compare("quantity", documented_quantities(page), set(listed.group(1).split(", ")) if listed else set())
    return complaints + new_case + list(check_examples(floe, root))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} FLOE ROOT")
    found = check(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]))
    print("\n".join(found) or "in order")
    sys.exit(1 if found else 0)

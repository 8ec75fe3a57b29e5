"""Documents and code agree:
- a tag like (G.3) that any source, test or document cites is defined once in docs/theory;
- the key equations that a chapter names in its line "Key equations: …" are cited by its module;
- every relative link of a document leads to a file, and to a heading in it.
A definition is \\tag{G.3} in a displayed equation, or (G.3) at the end of an indented line.
"""

import pathlib
import re

import house

# Files that documents may link to before they exist. Take an entry out when its file has come.
PENDING: set[str] = set()
MODULE_OF_CHAPTER = {"fast_sums": "fmm", "solver": "krylov", "seas": "wave"}  # where the names differ
CITING = ["include", "src", "fmm", "tests", "benchmarks", "docs", "README.md", "CONTRIBUTING.md"]
SUFFIXES = house.SOURCE_SUFFIXES | {".md", ".csv"}

CITATION = re.compile(r"\(([BCEFGHPRSW]\.\d+)\)")
DEFINITION = re.compile(r"\\tag\{([BCEFGHPRSW]\.\d+)\}|^ {4,}.*\(([BCEFGHPRSW]\.\d+)\)\s*$")
KEY_LINE = re.compile(r"^Key equations: ")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.*?) *$")


def prose_lines(root, path):
    """Numbered lines of a document outside fenced code."""
    fenced = False
    for number, line in enumerate(house.read_lines(root, path), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def chapters(root):
    return house.files_under(root, ["docs/theory"], {".md"})


def definitions(root):
    """(tag: place) of all equations, and complaints about tags defined twice."""
    found, complaints = {}, []
    for path in chapters(root):
        for number, line in enumerate(house.read_lines(root, path), 1):
            for tag in (a or b for a, b in DEFINITION.findall(line)):
                if tag in found:
                    complaints.append(f"{path}:{number}: ({tag}) is defined at {found[tag]} already")
                found.setdefault(tag, f"{path}:{number}")
    return found, complaints


def check_citations(root, defined):
    for path in house.files_under(root, CITING, SUFFIXES):
        if path.parts[:2] == ("tests", "house"):
            continue
        for number, line in enumerate(house.read_lines(root, path), 1):
            for tag in CITATION.findall(line):
                if tag not in defined:
                    yield f"{path}:{number}: ({tag}) is not defined in docs/theory"


def cited_by(root, module):
    folders = ["fmm"] if module == "fmm" else [f"include/floe/{module}", f"src/{module}"]
    sources = house.files_under(root, folders, house.SOURCE_SUFFIXES)
    has_code = any(p.suffix == ".cpp" for p in sources)
    return has_code, {tag for p in sources for line in house.read_lines(root, p) for tag in CITATION.findall(line)}


def check_key_equations(root):
    """Chapters whose module has no code yet are left out."""
    for path in chapters(root):
        module = MODULE_OF_CHAPTER.get(path.stem, path.stem)
        has_code, cited = cited_by(root, module)
        for number, line in enumerate(house.read_lines(root, path), 1):
            if has_code and KEY_LINE.match(line):
                for tag in CITATION.findall(line):
                    if tag not in cited:
                        yield f"{path}:{number}: key equation ({tag}) is cited nowhere in {module}"


def anchors(root, path):
    """The names under which GitHub reaches the headings of a document."""
    names = set()
    for _, line in prose_lines(root, path):
        found = HEADING.match(line)
        if found:
            words = re.sub(r"[^\w\- ]", "", re.sub(r"[`*]", "", found.group(1)).lower())
            names.add(words.replace(" ", "-"))
    return names


def check_links(root):
    for path in [p for p in house.files_under(root, ["."], {".md"}) if not p.parts[0].startswith(".")]:
        for number, line in prose_lines(root, path):
            for link in LINK.findall(line):
                if re.match(r"[a-z]+:", link):
                    continue
                name, _, anchor = link.partition("#")
                target = (root / path.parent / name).resolve() if name else root / path
                inside = target.is_relative_to(root.resolve()) or not name
                pending = inside and name and target.relative_to(root.resolve()).as_posix() in PENDING
                if not inside or not (target.exists() or pending):
                    yield f"{path}:{number}: link to {link}, which does not exist"
                elif anchor and target.suffix == ".md" and target.exists():
                    if anchor not in anchors(root, target.resolve().relative_to(root.resolve())):
                        yield f"{path}:{number}: link to {link}: no such heading"


def check_pending(root):
    for name in sorted(PENDING):
        if (root / name).exists():
            yield f"tests/house/check_docs.py: {name} exists now: take it out of PENDING"


def check(root):
    defined, complaints = definitions(root)
    for part in (check_citations(root, defined), check_key_equations(root), check_links(root), check_pending(root)):
        complaints += part
    return complaints


GOOD = {
    "README.md": "[theory](docs/theory/green.md#the-wave-part) [web](https://example.org)\n```\n[x](no.md)\n```\n",
    "docs/theory/green.md": "# The wave part\nKey equations: (G.1)\n$$ x \\tag{G.1} $$\n    y = x  (G.2)\nSee (G.2).\n",
    "include/floe/green/green_function.hpp": "/// (G.1)\n",
    "src/green/green_function.cpp": "// as in (G.2)\n",
    "docs/theory/coupling.md": "Key equations: (C.1)\n$$ y \\tag{C.1} $$\n",
}
BAD = [
    ({"src/green/table.cpp": "int i;\n// see (G.7)\n"}, "src/green/table.cpp:2: (G.7) is not defined"),
    ({"docs/conventions.md": "by (H.4)\n"}, "(H.4) is not defined"),
    ({"docs/theory/wave.md": "$$ z \\tag{G.1} $$\n"}, "(G.1) is defined at"),
    ({"include/floe/green/green_function.hpp": "\n"}, "key equation (G.1) is cited nowhere in green"),
    ({"README.md": "[plan](docs/plan.md)\n"}, "README.md:1: link to docs/plan.md"),
    ({"README.md": "[up](../../etc/)\n"}, "link to ../../etc/"),
    ({"README.md": "[part](docs/theory/green.md#nothing)\n"}, "no such heading"),
    *[({name: "\n"}, "take it out of PENDING") for name in sorted(PENDING)[:1]],
]

if __name__ == "__main__":
    house.main(check, GOOD, BAD)

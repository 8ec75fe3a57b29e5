"""What the checkers of the house share: finding files, and proving that a checker can fail.

A checker is a function check(root) that returns a list of complaints, each "file:line: what is wrong".
Run as a program it checks the tree given as argument; with --self-test it checks small trees made in
a temporary directory, bad ones that must be complained about and a good one that must not.
"""

import pathlib
import re
import sys
import tempfile

SOURCE_SUFFIXES = {".hpp", ".cpp"}


def files_under(root, folders, suffixes):
    """Sorted paths, relative to root, of the files with these suffixes; build trees are left out."""
    found = []
    for folder in folders:
        base = root / folder
        if base.is_file():
            found.append(base.relative_to(root))
        elif base.is_dir():
            found += [p.relative_to(root) for p in base.rglob("*") if p.suffix in suffixes and p.is_file()]
    return sorted(p for p in found if p.parts[0] != "build" and not p.parts[0].endswith(".out")
                  and "node_modules" not in p.parts)


def read_lines(root, path):
    return (root / path).read_text(encoding="utf-8").splitlines()


def strip_comments_and_strings(text):
    """The C++ text with comments and literals blanked, line breaks kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
    return pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def check_example(check, files):
    """Complaints about a tree with these files (path: text)."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return check(root)


def self_test(check, good, bad):
    """good: a tree; bad: list of (changes to the good tree, words that a complaint must contain)."""
    failures = [f"good example: unexpected complaint: {c}" for c in check_example(check, good)]
    for changes, words in bad:
        complaints = check_example(check, {**good, **changes})
        if not any(words in complaint for complaint in complaints):
            failures.append(f"bad example not noticed: wanted '{words}', got {complaints}")
    return failures


def main(check, good, bad):
    arguments = sys.argv[1:]
    if arguments == ["--self-test"]:
        complaints, subject = self_test(check, good, bad), f"{len(bad)} bad examples noticed"
    elif len(arguments) == 1:
        complaints, subject = check(pathlib.Path(arguments[0])), "in order"
    else:
        sys.exit(f"usage: {sys.argv[0]} ROOT | --self-test")
    for complaint in complaints:
        print(complaint)
    print(f"{len(complaints)} complaints" if complaints else subject)
    sys.exit(1 if complaints else 0)

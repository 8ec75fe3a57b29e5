"""The manual page and the completion scripts say what `--help` says, and complete what they should.

    check_manual.py FLOE
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile


def output(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, check=True, **more).stdout


def helped(floe, path=()):
    """{("run",): ({flags}, {words})} of the command and all below it, from their --help."""
    text = output(floe, *path, "--help")
    flags = {name for line in re.findall(r"^  (-\S*)", text, re.MULTILINE) for name in line.split(",")}
    part = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
    words = set(re.findall(r"^  (\w+)", part.group(1), re.MULTILINE)) if part else set()
    found = {path: (flags, words)}
    for word in words:
        found.update(helped(floe, (*path, word)))
    return found


def check_man(floe, commands):
    """The sections of the page against the help; groff finds nothing to complain about."""
    page = output(floe, "man")
    plain = re.sub(r"\\f[BIR]", "", page).replace("\\-", "-")
    documented = {}
    for section in re.split(r"^\.S[SH] ", plain, flags=re.MULTILINE)[1:]:
        head = section.splitlines()[0]
        path = tuple(re.match(r"floe((?: [a-z]+)*)", head).group(1).split()) if head.startswith("floe") else ()
        if head.startswith("floe") or head == "OPTIONS":
            documented[path] = {n for line in re.findall(r"^\.TP\n(-.*)$", section, re.MULTILINE) for n in re.findall(r"(?<!\S)--?\w[\w-]*", line)}
    for path, (flags, words) in commands.items():
        if (not words or not path) and documented.get(path) != flags:
            yield f"man page: floe {' '.join(path)}: {documented.get(path)} instead of {flags}"
    warned = subprocess.run(["groff", "-man", "-Tutf8", "-Kutf8", "-ww", "-z"], input=page, capture_output=True, text=True, check=False)
    if warned.stderr:
        yield f"man page: groff says {warned.stderr.strip()}"


def bash(script, folder, line):
    """What bash offers for the words of a line, the last one being typed."""
    words = re.findall(r"=|[^\s=]+", line) + ([""] if line.endswith((" ", "=")) else [])
    quoted = " ".join("'" + word + "'" for word in words)
    return set(output("bash", "-c", f"source '{script}'; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _floe; "
                      'printf "%s\\n" "${COMPREPLY[@]}"', cwd=folder).split())


def fish(script, folder, line):
    home = {**os.environ, "HOME": str(folder / "home"), "XDG_CONFIG_HOME": str(folder / "home")}
    offered = output("fish", "-c", f"source '{script}'; complete -C '{line}'", cwd=folder, env=home)
    return {text.split("\t")[0] for text in offered.splitlines()}


def check_completion(floe, commands, folder):
    (folder / "plate.toml").touch()
    (folder / "plain.txt").touch()
    (folder / "plates").mkdir()
    (folder / "home").mkdir()
    for shell in ("bash", "zsh", "fish"):
        (folder / shell).write_text(output(floe, "completion", shell), encoding="utf-8")
        done = subprocess.run([shell, "-n", folder / shell], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            yield f"{shell}: {done.stderr.strip()}"
    expected = {"floe run pla": {"plate.toml", "plates"}, "floe report pla": {"plates"}, "floe run --progress ": {"auto", "plain", "json", "none"},
                "floe run --progress=p": {"plain"}, "floe completion ": {"bash", "zsh", "fish"}, "floe run --threads ": set()}
    for path, (flags, words) in commands.items():
        line = " ".join(("floe", *path))
        expected[line + " -"] = flags
        if words:
            expected[line + " "] = words
    for line, wanted in expected.items():
        offered = bash(folder / "bash", folder, line)
        if offered != wanted:
            yield f"bash: {line!r} offers {sorted(offered)} instead of {sorted(wanted)}"
        if "=" in line or line.endswith(" -"):
            continue
        offered = {text.rstrip("/") for text in fish(folder / "fish", folder, line)} - {"plain.txt"}  # comes last there
        if offered != wanted:
            yield f"fish: {line!r} offers {sorted(offered)} instead of {sorted(wanted)}"
    script = (folder / "zsh").read_text(encoding="utf-8")
    for path, (flags, words) in commands.items():
        part = script.partition(f"\n_{'_'.join(('floe', *path))}() {{")[2].partition("\n}\n")[0]
        for name in sorted(flags):
            if f"'{name}[" not in part:
                yield f"zsh: floe {' '.join(path)}: {name} is missing"
        for word in sorted(words):
            if f"'{word}:" not in part:
                yield f"zsh: floe {' '.join(path)}: {word} is missing"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve())
    all_commands = helped(program)
    with tempfile.TemporaryDirectory() as name:
        complaints = [*check_man(program, all_commands), *check_completion(program, all_commands, pathlib.Path(name))]
    print("\n".join(complaints) or f"in order: {len(all_commands)} commands")
    sys.exit(1 if complaints else 0)

"""A Release build of the program is hardened: position-independent, relocations read-only and bound at
the start, no executable stack, stack protectors, checked library calls.

    check_hardening.py FLOE
"""

import re
import subprocess
import sys

HAS = {
    "position-independent (PIE)": ("-h", r"Type:\s+DYN \(Position-Independent"),
    "relocations read-only (RELRO)": ("-l", r"GNU_RELRO"),
    "bound at the start (NOW)": ("-d", r"FLAGS.*\bNOW\b"),
    "stack not executable": ("-l", r"GNU_STACK(?:\s+0x[0-9a-f]+){5}\s+RW\s"),
    "stack protectors": ("--dyn-syms", r"__stack_chk_fail"),
    "checked library calls (FORTIFY)": ("--dyn-syms", r"\b__\w+_chk\b(?<!__stack_chk)"),
}


def main(program):
    missing = []
    for what, (option, pattern) in HAS.items():
        shown = subprocess.run(["readelf", "-W", option, program], capture_output=True, text=True, check=True).stdout
        found = [name for name in re.findall(pattern, shown) if name != "__stack_chk_fail" or "stack" in what]
        if not found:
            missing.append(what)
    if missing:
        sys.exit(f"{program} lacks: {', '.join(missing)}")
    print(f"{len(HAS)} measures found")


if __name__ == "__main__":
    main(*sys.argv[1:])

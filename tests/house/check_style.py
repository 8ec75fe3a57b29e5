"""Rules of CONTRIBUTING.md that a compiler does not see: length of files, no prints in the library,
no `using namespace` in headers, scripts that can be started.
"""

import os
import re

import house

LONGEST_FILE = 400
CODE = ["include", "src", "fmm", "tests", "benchmarks", "python", "examples"]
PROGRAM = ("src/main.cpp", "src/program/", "tests/", "benchmarks/", "fmm/tests/", "examples/")
PRINT = re.compile(r"\bstd::(?:cout|cerr|clog|printf|puts)\b|(?<![\w:.>])(?:printf|puts|putchar)\s*\("
                   r"|\bfprintf\s*\(\s*std(?:out|err)\b|\bfmt::print\s*\(")
USING_NAMESPACE = re.compile(r"\busing\s+namespace\b")


def check(root):
    complaints = []
    for path in house.files_under(root, CODE, house.SOURCE_SUFFIXES):
        text = (root / path).read_text(encoding="utf-8")
        length = text.count("\n")
        if length > LONGEST_FILE:
            complaints.append(f"{path}:{length}: too long (at most {LONGEST_FILE} lines; split it)")
        silent = not path.as_posix().startswith(PROGRAM)
        for number, line in enumerate(house.strip_comments_and_strings(text).splitlines(), 1):
            if silent and PRINT.search(line):
                complaints.append(f"{path}:{number}: the library prints (give it to the caller's Log)")
            if path.suffix == ".hpp" and USING_NAMESPACE.search(line):
                complaints.append(f"{path}:{number}: using namespace in a header")
    for path in house.files_under(root, [*CODE, "scripts"], ("", ".py")):
        begins = (root / path).read_bytes()[:2]
        if begins == b"#!" and not os.access(root / path, os.X_OK):
            complaints.append(f"{path}:1: begins with #! and cannot be started (chmod +x)")
    return complaints


GOOD = {
    "src/main.cpp": 'int main() { std::cout << "floe"; }\n',
    "src/program/report.cpp": 'void f() { std::printf("x"); }\n',
    "src/io/text.cpp": 'void g() { std::snprintf(b, 9, "std::cout"); }  // no std::cout here\nusing namespace std;\n',
    "include/floe/io/text.hpp": "/* using namespace std; */\n",
    "fmm/tests/sum_test.cpp": "void h() { std::cout << 1; }\n",
}
BAD = [
    ({"src/io/text.cpp": "void g() { std::cerr << 1; }\n"}, "src/io/text.cpp:1: the library prints"),
    ({"fmm/src/sum.cpp": 'int x;\nvoid g() { printf("%d", x); }\n'}, "fmm/src/sum.cpp:2: the library prints"),
    ({"include/floe/io/text.hpp": "inline void p() { fprintf(stderr, name); }\n"}, "the library prints"),
    ({"include/floe/io/text.hpp": "using namespace std;\n"}, "using namespace in a header"),
    ({"examples/python/figures.py": "#!/usr/bin/python3\n"}, "figures.py:1: begins with #!"),
    ({"src/io/text.cpp": "\n" * (LONGEST_FILE + 1)}, "too long"),
]

if __name__ == "__main__":
    house.main(check, GOOD, BAD)

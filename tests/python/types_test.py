import inspect
import os
import pathlib
import subprocess
import sys
import unittest

import floe
from floe import _core
from support import ROOT

PACKAGE = pathlib.Path(floe.__file__).parent


class EveryPublicName(unittest.TestCase):
    def test_says_what_it_is(self):
        for name in floe.__all__:
            if name != "__version__":
                self.assertTrue(inspect.getdoc(getattr(floe, name)), name)
        self.assertGreater(len(floe.__all__), 20)

    def test_has_a_version(self):
        self.assertRegex(floe.__version__, r"^\d+\.\d+\.\d+$")


class TypeHints(unittest.TestCase):
    def mypy(self, *arguments):
        result = subprocess.run(
            ["/usr/bin/python3", "-m", *arguments],
            capture_output=True,
            text=True,
            env=os.environ | {"MYPYPATH": f"{PACKAGE.parent}:{ROOT / 'examples/python'}", "MYPY_CACHE_DIR": os.devnull},
            cwd=PACKAGE.parent,
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def setUp(self):
        if subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode != 0:
            self.skipTest("no mypy (scripts/setup installs it)")

    def test_hold_in_the_module_and_in_the_example(self):
        self.mypy("mypy", "--ignore-missing-imports", "-p", "floe", "-m", "paper_figures")

    def test_name_what_the_compiled_part_has(self):
        stub = (PACKAGE / "_core.pyi").read_text(encoding="utf-8")
        for name, value in vars(_core).items():
            if not name.startswith("__"):
                self.assertRegex(stub, rf"(def|class) {name}\b")
                if callable(value) and not inspect.isclass(value):
                    self.check_arguments(name, value, stub)

    def check_arguments(self, name, function, stub):
        """The arguments in the docstring of pybind11 are those of the stub, in order."""
        signature = function.__doc__.split("\n")[0]
        mine = [part.split(":")[0].strip() for part in signature[signature.index("(") + 1 :].split(", ") if ":" in part]
        start = stub.index(f"def {name}(")
        for argument in mine:
            place = stub.index(f"{argument}:", start)
            self.assertGreater(place, start, f"{name}: {argument}")
            start = place


if __name__ == "__main__":
    unittest.main()

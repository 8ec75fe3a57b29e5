import unittest
import warnings

import floe
from support import InFolder, case


class EveryError(unittest.TestCase):
    def test_has_the_exit_code_of_the_program(self):
        codes = {
            floe.CaseError: 3,
            floe.MeshError: 4,
            floe.SeaError: 5,
            floe.BudgetError: 6,
            floe.FileError: 7,
            floe.ConvergenceError: 8,
            floe.StoreError: 9,
            floe.BusyError: 10,
        }
        for kind, code in codes.items():
            self.assertEqual(kind.exit_code, code)
            self.assertTrue(issubclass(kind, floe.Error))


class AWrongCase(InFolder):
    def test_is_named_by_key_value_and_rule(self):
        with self.assertRaises(floe.CaseError) as caught:
            floe.run(case(water={"depth": -3.0}))
        self.assertEqual(str(caught.exception), "invalid water.depth = -3 m (must be positive or inf)")
        self.assertIsInstance(caught.exception, ValueError)

    def test_names_the_nearest_key(self):
        with self.assertRaisesRegex(floe.CaseError, "thickness"):
            floe.run(case(plate={"thicknes": 2.0}))

    def test_keeps_the_place_in_a_file(self):
        text = floe.case_text(case(water={"depth": -3.0}))
        (self.folder / "case.toml").write_text(text, encoding="utf-8")
        line = 1 + text.splitlines().index("depth = -3.0")
        with self.assertRaisesRegex(floe.CaseError, f"case.toml:{line}:9: invalid water.depth"):
            floe.run(self.folder / "case.toml")

    def test_may_hold_nothing_that_a_case_file_cannot(self):
        for value in (None, object(), 1j):
            with self.assertRaisesRegex(floe.CaseError, r"invalid water.depth = .* \(must be a number, a text"):
                floe.run(case(water={"depth": value}))

    def test_is_told_from_a_wrong_mesh_and_a_wrong_sea(self):
        changed = case()
        changed["mesh"] = {"file": "/nowhere/plate.msh"}
        with self.assertRaisesRegex(floe.MeshError, "nowhere"):
            floe.run(changed)
        sea = {"name": "high", "spectrum": "jonswap", "significant_height": -1.0, "peak_period": 9.0}
        with self.assertRaisesRegex(floe.SeaError, "significant_height"):
            floe.run(case() | {"sea": [sea | {"spreading": "cos2", "mean_heading_deg": 0}]})


class AWrongArgument(InFolder):
    def test_is_refused(self):
        for arguments in ({"threads": 0}, {"threads": 1025}, {"memory": 0.0}, {"resume": True}, {"fresh": True}):
            with self.assertRaises(floe.CaseError):
                floe.run(case(), **arguments)
        with self.assertRaises(floe.CaseError):
            floe.run(case(), self.folder / "out", resume=True, fresh=True)

    def test_is_told_from_too_little_memory(self):
        with self.assertRaises(floe.BudgetError) as caught:
            floe.run(case(), memory=1e6)
        self.assertIsInstance(caught.exception, MemoryError)

    def test_is_told_from_a_folder_that_cannot_be_made(self):
        with self.assertRaises(floe.FileError) as caught:
            floe.run(case(), self.folder / "missing" / "out")
        self.assertIsInstance(caught.exception, OSError)

    def test_is_told_from_a_folder_without_results(self):
        with self.assertRaisesRegex(floe.StoreError, "no result of floe"):
            floe.load(self.folder)


class AWarning(unittest.TestCase):
    def test_is_issued_and_kept(self):
        coarse = case(waves={"omega": [1.5]}, mesh={"rectangle": {"length": 300.0, "width": 60.0, "nx": 20, "ny": 4}})
        with warnings.catch_warnings(record=True) as issued:
            warnings.simplefilter("always")
            result = floe.run(coarse)
        self.assertEqual({warning.category for warning in issued}, {floe.AccuracyWarning})
        self.assertEqual([str(warning.message) for warning in issued], result.warnings)
        self.assertRegex("\n".join(result.warnings), "nodes")

    def test_is_given_for_every_check_that_wants_attention(self):
        with warnings.catch_warnings(record=True):
            warnings.simplefilter("always")
            result = floe.run(case(modes={"count": 6}))
        attention = [check.name for check in result.checks if check.status != "good"]
        self.assertTrue(attention)
        told = "\n".join(result.warnings)
        for name in attention:
            if name != "nodes a wavelength":
                self.assertIn(f"self-check, {name} = ", told)


if __name__ == "__main__":
    unittest.main()

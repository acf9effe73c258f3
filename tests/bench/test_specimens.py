"""bench/specimens: where its specimens stand, and how it says what seeds have."""

import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "specimens"
LOADER = importlib.machinery.SourceFileLoader("specimens", str(SCRIPT))
specimens = importlib.util.module_from_spec(importlib.util.spec_from_loader("specimens", LOADER))
sys.modules["specimens"] = specimens
LOADER.exec_module(specimens)


def along(case, distance):
    """m, the point of a case's axis so far from its base."""
    return [start + distance * way for start, way in zip(specimens.CASES[case].base, specimens.CASES[case].axis)]


class Specimens(unittest.TestCase):
    def test_an_inclined_specimen_keeps_its_middle_one_in_place_the_middle_of_its_lower_half(self):
        for speed in (60, 200):
            for case, distance in ((f"inclined-{speed}", 0.05), (f"in-place-{speed}", 0.025)):
                for one, other in zip(along(case, distance), along(f"upright-{speed}", distance)):
                    self.assertAlmostEqual(one, other, delta=1e-4)

    def test_every_case_has_its_scene_and_says_where_it_stands(self):
        for name, case in specimens.CASES.items():
            self.assertTrue((SCRIPT.parents[1] / "scenes" / f"{case.scene}.toml").exists(), name)
            self.assertEqual(case.sets(9)[:4], ["--set", "seed=9", "--set", f"wall.specimen.base_m={list(case.base)}"])

    def test_the_mean_of_the_seeds_comes_with_its_standard_error(self):
        # 1, 2 and 3 scatter by 1, their mean by 1 / sqrt(3).
        self.assertEqual(specimens.said([1, 2, 3]), "2 +- 0.58")
        self.assertEqual(specimens.said([0.001, 0.002, 0.003], 1e3), "2 +- 0.58")
        self.assertEqual(specimens.said([0.1234]), "0.123")

    def test_two_cases_are_told_apart_where_the_gap_is_beyond_what_seeds_scatter(self):
        # Variances of 1 in three seeds each: t of 4 degrees at 95 % is 2.776, times sqrt(2 / 3) = 2.27.
        self.assertIn("not told apart (chance reaches 2.3)", specimens.apart("x", [1, 2, 3], [3, 4, 5]))
        self.assertIn("told apart (chance reaches 2.3)", specimens.apart("x", [1, 2, 3], [4, 5, 6]))
        self.assertNotIn("not told", specimens.apart("x", [1, 2, 3], [4, 5, 6]))


if __name__ == "__main__":
    unittest.main()

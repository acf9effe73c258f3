"""bench/specimens: where its specimens stand, what it keeps of former runs, and how it says what seeds have."""

import importlib.machinery
import importlib.util
import os
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

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
        self.assertIn("not told apart (chance reaches 2.3)", specimens.apart("x", [1, 2, 3], [3, 4, 5], 1))
        self.assertIn("told apart (chance reaches 2.3)", specimens.apart("x", [1, 2, 3], [4, 5, 6], 1))
        self.assertNotIn("not told", specimens.apart("x", [1, 2, 3], [4, 5, 6], 1))

    def test_one_of_ten_comparisons_is_held_to_a_tenth_of_the_error(self):
        # t of 4 degrees at 99.5 % is 5.598, times sqrt(2 / 3) = 4.57.
        self.assertIn("not told apart (chance reaches 4.6)", specimens.apart("x", [1, 2, 3], [5, 6, 7], 10))
        self.assertNotIn("not told", specimens.apart("x", [1, 2, 3], [6, 7, 8], 10))


PROGRAM = """#!/bin/sh
[ "$1" = --version ] && echo "tumble 9" && exit
echo "$@" >> "$(dirname "$0")/calls"
echo '{"facts": {"touches": {"value": 5}}}'
"""


class Kept(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.root = Path(held.name)
        self.program(PROGRAM)
        self.scene("duration_s = 1")
        self.options = SimpleNamespace(folder=self.root / "out", threads=1, cases=["quick"], seeds=[7])
        for patch in (mock.patch.dict(os.environ, TUMBLE=str(self.root / "tumble")),
                      mock.patch.object(specimens.programs, "ROOT", self.root), mock.patch("builtins.print")):
            patch.start()
            self.addCleanup(patch.stop)

    def program(self, text):
        (self.root / "tumble").write_text(text)
        (self.root / "tumble").chmod(0o755)
        specimens.build_of.cache_clear()

    def scene(self, text):
        (self.root / "scenes").mkdir(exist_ok=True)
        (self.root / "scenes" / "specimen-quick.toml").write_text(text)

    def calls(self):
        file = self.root / "calls"
        return len(file.read_text().splitlines()) if file.exists() else 0

    def test_a_run_is_kept_while_program_scene_and_settings_are_the_same(self):
        specimens.run(self.options)
        specimens.run(self.options)
        self.assertEqual(self.calls(), 1)
        self.scene('title = "another"\nclaim = "more"\nduration_s = 1')
        specimens.run(self.options)
        self.assertEqual(self.calls(), 1)
        self.assertTrue(specimens.has_run("quick", 7, self.options))
        self.scene("duration_s = 2")
        self.assertFalse(specimens.has_run("quick", 7, self.options))
        specimens.run(self.options)
        self.assertEqual(self.calls(), 2)
        self.program(PROGRAM + "# another build\n")
        self.assertTrue(specimens.has_run("quick", 7, self.options))  # the tables name its program
        specimens.run(self.options)
        self.assertEqual(self.calls(), 3)

    def test_an_unfinished_run_goes_on_and_another_scenes_does_not(self):
        specimens.run(self.options)
        folder = self.root / "out" / "quick" / "7"
        (folder / "report.txt").unlink()
        (folder / "state").mkdir()
        specimens.run(self.options)
        self.assertTrue((folder / "state").exists())
        self.scene("duration_s = 2")
        specimens.run(self.options)
        self.assertFalse((folder / "state").exists())

    def test_contacts_are_solved_once_by_one_program_of_one_run(self):
        specimens.run(self.options)
        folder = self.root / "out" / "quick" / "7"
        for _ in range(2):
            self.assertEqual(specimens.solved(folder, "30 x 6", ["around=30"], self.options), {"touches": 5})
        self.assertEqual(self.calls(), 2)
        self.program(PROGRAM + "# another build\n")
        specimens.solved(folder, "30 x 6", ["around=30"], self.options)
        self.assertEqual(self.calls(), 3)
        specimens.solved(folder, "30 x 6", ["around=31"], self.options)
        self.assertEqual(self.calls(), 4)
        specimens.mark(folder, {"program": "another"})
        specimens.solved(folder, "30 x 6", ["around=31"], self.options)
        self.assertEqual(self.calls(), 5)


if __name__ == "__main__":
    unittest.main()

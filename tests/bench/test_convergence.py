"""bench/sidebyside/convergence.py: what a step half as long may move before bench/compare complains."""

import random
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
from sidebyside import convergence


class Halved(unittest.TestCase):
    def test_a_drift_beyond_the_scatter_of_seeds_is_complained_of_with_its_numbers(self):
        # Means 23 and 24, variances 0.01 of three seeds each: error sqrt(0.02 / 3) = 0.0816, times t = 5.598 of four degrees,
        # which 99.5 % stay within: one of ten comparisons.
        found = convergence.halved([22.9, 23.0, 23.1], [23.9, 24.0, 24.1], 10)
        self.assertAlmostEqual(found["moves"], 1.0)
        self.assertAlmostEqual(found["scatter"], 5.598 * (0.02 / 3)**0.5, places=4)
        self.assertIs(found["converged"], False)
        said = convergence.complaint("drum, box2d", "slope", found)
        self.assertIn("has not converged: half the step moves it by 1, from 23 to 24", said)

    def test_the_same_drift_within_the_scatter_is_not(self):
        found = convergence.halved([122, 123, 124], [123, 124, 125], 10) # 4.6 may be chance: 4 % of the figure
        self.assertIs(found["converged"], True)
        self.assertIsNone(convergence.complaint("drum, box2d", "slope", found))

    def test_a_scatter_of_more_than_a_tenth_of_the_figure_hides_too_much(self):
        found = convergence.halved([22, 23, 24], [23, 24, 25], 10) # 20 % of it
        self.assertIsNone(found["converged"])
        self.assertIn("cannot be told from 3 seeds", convergence.complaint("drum, box2d", "slope", found))

    def test_one_seed_tells_nothing_and_says_so(self):
        found = convergence.halved([23.0], [23.0], 10)
        self.assertIsNone(found["converged"])
        self.assertIn("cannot be told from one seed", convergence.complaint("drum, soft", "slope", found))

    def test_of_calls_that_compare_ten_figures_that_have_converged_one_in_twenty_complains_at_most(self):
        # At 95 % for each comparison it would be 1 - 0.95^10 = 40 of a hundred. Of 60 calls 3 may, give or take 1.7.
        normal = random.Random(1).gauss
        seeds = lambda: [normal(23, 1) for _ in range(3)]
        complained = sum(any(convergence.halved(seeds(), seeds(), 10)["converged"] is False for _ in range(10)) for _ in range(60))
        self.assertLess(complained, 3 + 3 * 1.7)


if __name__ == "__main__":
    unittest.main()

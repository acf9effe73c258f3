"""bench/sidebyside/student.py: how far two means may lie apart by chance."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
from sidebyside import student


class Student(unittest.TestCase):
    def test_t_is_what_the_tables_say(self):
        for share, degrees, t in ((0.95, 1, 12.706), (0.95, 4, 2.776), (0.95, 18, 2.101), (0.99, 2, 9.925), (0.99, 14, 2.977),
                                  (0.995, 2, 14.089), (0.995, 4, 5.598)):
            self.assertAlmostEqual(student.bound(share, degrees), t, delta=1e-3)

    def test_a_sample_that_scatters_alone_has_its_own_degrees_of_freedom_and_two_that_scatter_alike_have_both(self):
        self.assertAlmostEqual(student.welch([1, 2, 3], [4, 5, 6]), 4)
        self.assertAlmostEqual(student.welch([1, 2, 3], [5, 5, 5]), 2)
        # Variances 1 and 4 of three each: (1 + 4)^2 / (1/2 + 16/2).
        self.assertAlmostEqual(student.welch([1, 2, 3], [2, 4, 6]), 25 / 8.5)

    def test_the_more_comparisons_a_call_makes_the_further_each_may_lie_apart(self):
        a, b = [1, 2, 3], [4, 5, 6]
        self.assertAlmostEqual(student.chance(a, b, 1), 2.776 * (2 / 3)**0.5, delta=1e-3)
        self.assertAlmostEqual(student.chance(a, b, 10), 5.598 * (2 / 3)**0.5, delta=1e-3)

    def test_samples_without_scatter_leave_nothing_to_chance(self):
        self.assertEqual(student.chance([2, 2], [3, 3], 10), 0)


if __name__ == "__main__":
    unittest.main()

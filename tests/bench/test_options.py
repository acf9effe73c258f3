"""bench/compare refuses what a case would not heed; a case that does heed it would run for minutes."""

import subprocess
import unittest
from pathlib import Path

COMPARE = Path(__file__).resolve().parents[2] / "bench" / "compare"


class Options(unittest.TestCase):
    def test_an_option_that_the_case_does_not_take_is_refused_with_those_that_it_does(self):
        for words, said in ((["hard", "--repeats", "3"], "hard takes no --repeats, only --seeds"),
                            (["live", "--steps", "100"], "live takes no --steps, only --seeds"),
                            (["trough", "--seeds", "3"], "trough takes no --seeds, only --repeats and --steps"),
                            (["drop", "--seeds", "3"], "drop takes no --seeds, only --save")):
            ran = subprocess.run([COMPARE, *words], capture_output=True, text=True, timeout=60)
            if "has no numpy" in ran.stderr:
                self.skipTest(ran.stderr)
            self.assertEqual(ran.returncode, 2)
            self.assertIn(said, ran.stderr)


if __name__ == "__main__":
    unittest.main()

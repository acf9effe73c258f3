#!/usr/bin/python3
"""Makes the sealed cases for students, scenes/measured/cases/1 ... 6:

    tests/blind/teaching_cases.py build/release/tests/blind/blindgen scenes/measured/cases [NUMBER...]

What each hides stands below; whoever wants to solve them should not read on. The sixth was the third: the program does not find
what it hides, and it is kept as the failure that it is.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

CASES = [  # bench, kind, effect, standard errors from the best other explanation, seed
    ("lane", "listed", "roll.coulomb", 10, 4101),
    ("drop", "null", "", 5, 4102),
    ("drop", "listed", "ins.low_pass", 10, 4113),
    ("lane", "listed", "grav.tilt_x", 10, 4104),
    ("drop", "unlisted", "warms-up", 14, 4105),
    ("drop", "listed", "ins.low_pass", 10, 4103),
]


def main():
    blindgen, out = sys.argv[1], pathlib.Path(sys.argv[2])
    for number, (bench, kind, effect, size, seed) in enumerate(CASES, 1):
        if sys.argv[3:] and str(number) not in sys.argv[3:]:
            continue
        with tempfile.TemporaryDirectory() as folder:
            made = subprocess.run([blindgen, folder, "1", str(seed), bench, kind, effect, str(size)],
                                  capture_output=True, text=True, check=True)
            sealed = json.loads(made.stdout.splitlines()[0])
            case = out / str(number)
            shutil.rmtree(case, ignore_errors=True)
            shutil.copytree(pathlib.Path(folder) / sealed["case"], case)
            (case / "commitment.txt").unlink()
            note = f"# Against scenes/{sealed['scene']}; `tumble reveal scenes/measured/cases/{number}` opens sealed.txt.\n"
            measurement = case / "measurement.toml"
            measurement.write_text(note + measurement.read_text())
            (case / "sealed.txt").write_text("`tumble reveal` reads this.\n" + sealed["answer"].encode().hex() + "\n")


if __name__ == "__main__":
    main()

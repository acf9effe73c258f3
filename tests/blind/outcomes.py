#!/usr/bin/python3
"""One report of every outcome, from files alone, as a user would get it:

    tests/blind/outcomes.py build/release/tumble build/release/tests/blind/blindgen out/outcomes [--words] [NAME...]

Says what each came to; ends with 1 where one came to another outcome than it should. With --words no report is made.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "scenes" / "measured" / "cases"
TROUGH = ROOT / "scenes" / "measured" / "trough"

# What to expect; the scene; where the case is: a folder, what blindgen makes, a folder of which only an innocent cause is asked, or a
# bed's measurement, whose runs lie beside its scene.
WANTED = {
    "consistent": ("CONSISTENT WITH THE BASELINE", "bounce", CASES / "2"),
    "named": ("NAMED", "lane", CASES / "1"),
    "ambiguous": ("AMBIGUOUS", "bounce", ("51", "drop", "listed", "drag.linear", "1.5")),
    "two-causes": ("TWO CAUSES", "lane", ("52", "lane", "two", "roll.coulomb+grav.tilt_x", "12")),
    "none-known": ("NONE OF THE KNOWN CAUSES", "bounce", CASES / "5"),
    "cannot-decide": ("CANNOT DECIDE", "bounce", [CASES / "2"]),
    "consistent-spin": ("CONSISTENT WITH THE BASELINE", "slope", ("54", "spin", "null", "nothing", "5")),  # these two take a second
    "named-bed": ("NAMED", "measured/trough/trough", TROUGH / "measurement-2.toml"),
    "none-known-spin": ("NONE OF THE KNOWN CAUSES", "slope", ("55", "spin", "unlisted", "film", "10")),
}


def laid_out(blindgen, case, folder):
    shutil.rmtree(folder, ignore_errors=True)
    if isinstance(case, tuple):
        subprocess.run([blindgen, folder, "1", *case], check=True, stdout=subprocess.DEVNULL)
        shutil.copytree(folder / "case-0000", folder, dirs_exist_ok=True)
        for made in folder.glob("case-0000*"):
            shutil.rmtree(made)
        return
    shutil.copytree(case[0] if isinstance(case, list) else case, folder, ignore=shutil.ignore_patterns("sealed.txt"))
    if isinstance(case, list):
        measurement = folder / "measurement.toml"
        measurement.write_text('causes = ["ins.clock_offset"]  # which is innocent below\n' + measurement.read_text())


def diagnosed(tumble, folder, words, scene="scene.toml", data="measurement.toml", *more):
    """What the program says of a case, with a report beside it unless only words are asked for."""
    command = [tumble, "diagnose", scene, "--data", data, "--quiet", *more]
    done = subprocess.run(command + (["--json"] if words else ["--report", "report"]), cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{folder.name}: {done.stdout}{done.stderr}")
    return json.loads(done.stdout if words else (folder / "report" / "diagnosis.json").read_text())


def main():
    tumble, blindgen = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:3])
    out, wrong, asked = pathlib.Path(sys.argv[3]), 0, sys.argv[4:]
    words = "--words" in asked
    names = [word for word in asked if word != "--words"] or list(WANTED)
    for name in names:
        outcome, scene, case = WANTED[name]
        folder = out / name
        scene = ROOT / "scenes" / f"{scene}.toml"
        begun = time.monotonic()
        if isinstance(case, pathlib.Path) and case.suffix == ".toml":
            folder.mkdir(parents=True, exist_ok=True)
            found = diagnosed(tumble, folder, words, scene, case, "--seeds", "6", "--old-runs")
        else:
            laid_out(blindgen, case, folder)
            shutil.copy(scene, folder / "scene.toml")
            found = diagnosed(tumble, folder, words)
        wrong += found["outcome"] != outcome
        print(f"{name}, {time.monotonic() - begun:.1f} s: {found['outcome']}{'' if found['outcome'] == outcome else ', not ' + outcome}\n"
              f"  {found['verdict']}\n  {found['next']}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()

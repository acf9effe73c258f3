#!/usr/bin/env python3
"""Measures a bed as a laboratory would: runs a scene with something hidden in it and writes means as [[bulk]] tables.

The laboratory here is the same solver as the one that diagnoses (an "inverse crime"), so it is at least given seeds,
a time step and sizes of its own with --hide, and tells numbers only.
    tests/blind/measured_bed.py build/release/tumble scenes/measured/trough/trough.toml --condition "quarter load" \\
        --condition "half load: fill.0.count=120 fill.1.count=120" --hide wall.trough.motion.1.phase_deg=-90 \\
        --seeds 501:504 --time 1.4:3 --measures circulation,surface_slope --causes exc.phase,grav.tilt_x --title "A bed"
"""
import argparse
import csv
import pathlib
import statistics
import subprocess
import tempfile

UNITS = {"circulation": "rad_s", "surface_slope": "deg", "surface_slope_left": "deg", "surface_slope_right": "deg",
         "bulk_height": "m", "centre_of_mass_y": "m", "mean_speed": "m_s",
         "rms_velocity_x": "m_s", "rms_velocity_y": "m_s", "rms_velocity_z": "m_s", "contacts_per_body": ""}


def means_of(arguments, sets, seed, begin, end):
    with tempfile.TemporaryDirectory() as folder:
        command = [arguments.tumble, "run", arguments.scene, "--out", folder + "/run", "--quiet"]
        measures = "[" + ", ".join(f'"{name}"' for name in arguments.measures) + "]"
        for text in [*sets, *arguments.hide, f"seed={seed}", f"duration_s={end}", f"observe.measures={measures}"]:
            command += ["--set", text]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        with open(folder + "/run/series.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    half = (float(rows[1]["time_s"]) - float(rows[0]["time_s"])) / 2
    within = [row for row in rows if begin + half < float(row["time_s"]) <= end + half]
    heads = [name + ("_" + UNITS[name] if UNITS[name] else "") for name in arguments.measures]
    return [statistics.mean(x for x in (float(row[head]) for row in within) if x == x) for head in heads]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tumble")
    parser.add_argument("scene")
    parser.add_argument("--condition", action="append", required=True, help='"NAME: key=value ... | hidden=value ..."')
    parser.add_argument("--hide", nargs="*", default=[], help="sets under all conditions that the measurement does not tell of")
    parser.add_argument("--seeds", required=True, help="A:B, both included")
    parser.add_argument("--time", required=True, help="A:B, s, averaged over")
    parser.add_argument("--measures", required=True, type=lambda text: text.split(","))
    parser.add_argument("--causes", required=True, type=lambda text: text.split(","))
    parser.add_argument("--title", required=True)
    arguments = parser.parse_args()
    first, last = map(int, arguments.seeds.split(":"))
    begin, end = map(float, arguments.time.split(":"))
    print(f'title = "{arguments.title}"')
    print("causes = [" + ", ".join(f'"{cause}"' for cause in arguments.causes) + "]")
    for condition in arguments.condition:
        name, _, words = condition.partition(":")
        told, _, untold = words.partition("|")
        sets = told.split()
        runs = [means_of(arguments, sets + untold.split(), seed, begin, end) for seed in range(first, last + 1)]
        print(f'\n[[bulk]]\nname = "{name}"')
        if sets:
            print("set = [" + ", ".join(f'"{text}"' for text in sets) + "]")
        print(f"from_s = {begin:g}\nuntil_s = {end:g}\nruns = {len(runs)}")
        for name, values in zip(arguments.measures, zip(*runs)):
            print(f'[[bulk.number]]\nmeasure = "{name}"\nvalue = {statistics.mean(values):.4g}')
            if UNITS[name]:
                print(f'unit = "{UNITS[name]}"')
            print(f"sigma = {statistics.stdev(values):.2g}", flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Makes docs/thrown-away-phase.md from the diagnoses of scenes/measured/trough and the runs of scenes/measured/trough-3d:

    docs/thrown_away_phase.py build/release/tumble

What is not in the tables beside the scenes is run; what is counts, whatever version of the program made it.
"""
import collections
import csv
import json
import pathlib
import re
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True
import trough_in_space

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "scenes/measured/trough"
SEEDS = 6
SHOWN = [("", "0", "as the scene has it: in phase"), ("exc.phase", "90", "sideways a quarter period ahead"),
         ("exc.phase", "-90", "sideways a quarter period behind"),
         ("exc.sideways", "0.75", "in phase, sideways 2.1 times as wide"),
         ("exc.sideways", "-0.75", "in phase, sideways 0.47 times as wide"),
         ("exc.rocking", "0.25", "in phase, rocking by 0.25 deg"), ("exc.rocking", "-0.25", "the other way round"),
         ("exc.rocking_ahead", "0.5", "in phase, rocking by 0.5 deg a quarter period ahead"), ("exc.rocking_ahead", "-0.5", "the other way round"),
         ("grav.tilt_x", "2.5", "in phase, tilted by 2.5 deg"), ("grav.tilt_x", "-2.5", "the other way round"),
         ("roll.coulomb", "0.2", "in phase, rolling friction 0.2"), ("fric.wall", "0.75", "in phase, wall friction 2.1 times")]

# The page; {WORDS} are filled in.
TEXT = """# The phase that was thrown away

<!-- Made by docs/thrown_away_phase.py; change that, not this. -->

A. Lopez Marrero (LJMU 2020, chapter 5) measured how a vibratory trough shakes, took from the spectra an upright harmonic of 1.949 mm and one across of 0.404 mm at
25 Hz, and gave both to his simulation. The phase between them was not kept, and what came out wrong was put down to the software's algorithm. In the laboratory the load then ran to one slope and circulated;
in the simulation it did neither. This page asks what a diagnosis makes of that, in a plane; and what the phase does [in space](#in-space-spheres-and-cones), to
spheres and cones. Everything on it but its pictures, which are of the [gallery](gallery.md), is made by one command:

```sh
docs/thrown_away_phase.py build/release/tumble
```

**The scene** is [`scenes/measured/trough/trough.toml`](../scenes/measured/trough/trough.toml): the profile of the trough in two dimensions, with the thesis' amplitudes in phase, its frictions and restitutions,
120 discs of 20 and 22 mm (quarter load) or 240 (half load). **The laboratory** is not the thesis', which prints no number for slope or circulation. It is a simulation with the phase put back, a quarter period, of
which the diagnosis is told nothing but means of four runs each. It has seeds, a time step and sizes of bodies of its own; but it is the same solver, so this page shows what such data can tell, not that the
machine had this phase.

## Three numbers: something of the excitation

Circulation, slope and height of the bed under two loads differ from the simulation in phase by chi-square {CHI} (the gate is at {GATE}). **{FIRST_OUTCOME}.** {FIRST_VERDICT}

{LIBRARY}

Walls that rock do to these numbers what the dropped phase does: by a fifth of a degree in time with their upright shaking, or by a third a quarter period ahead of it. What would part them, by the response table:

{PLAN}

Bodies' contacts cannot be counted in a machine, and runs are a weak means: with 24 of them and the height of the centre and the sideways speed besides, phase and rocking ahead stayed ambiguous
(`measured_bed.py` as in [the beds' list](../tests/blind/beds/README.md), seeds 501 to 524). Rocking is better looked for where it is.

## A second sensor on the other wall

The walls are 0.44 m apart. An accelerometer on either of them tells rocking of 0.02 deg, 0.15 mm between the two. Say it saw none. The measurement then has the same three numbers of the same four runs, and two causes that are
known to be next to nothing:

```toml
[[nuisance]]
cause = "exc.rocking"
spread = 0.02  # deg

[[nuisance]]
cause = "exc.rocking_ahead"
spread = 0.02
```

**{OUTCOME}.** {VERDICT}

{MEASURED}

A missing load, the nearest of the others, is {NEAREST}, where a name needs 3.

±: standard error of the mean, of four runs measured and {SEEDS} simulated. The last column was run with seeds of its own at the fitted value; so large a difference from what the table foretold has
p = {P_CONFIRMED}. What the phase leaves of the misfit has p = {P_LEFT}.

![Circulation of the half load: measured, the baseline (in phase, with what rocking the sensors allow), and extended by the cause named](gallery/thrown-away-phase-circulation-half.svg)
![Slope of the quarter load: measured, the baseline, and extended by the cause named](gallery/thrown-away-phase-slope-quarter.svg)

## What each cause does

Means of {SEEDS} seeds from 1.4 to 3 s, ± the standard deviation from seed to seed; {RUNS} runs, in [`trough.response.csv`](../scenes/measured/trough/trough.response.csv).

{RESPONSE}

{CONCLUSIONS}

{SPACE}
"""

CONCLUSIONS = """**What the phase explains.** In phase the half load turns by [half||0|circulation] rad/s, which is no more than its seeds scatter, with its surface at [half||0|slope] deg: no circulation, no slope, as
the thesis' simulation of the full trough. A quarter period apart, it turns by [half|exc.phase|90|circulation] rad/s and slopes by [half|exc.phase|90|slope] deg; with the phase on the other side by
[half|exc.phase|-90|circulation] rad/s. The side is the phase's.

**What it does not explain.** At a quarter of the load the thesis' simulation had one slope, but a flatter one than the machine. The phase does not make it steeper: [quarter||0|slope] deg in phase,
[quarter|exc.phase|90|slope] and [quarter|exc.phase|-90|slope] a quarter period to either side. Three things on this page do. Walls that rock by 0.25 deg, 1 mm up and down at the sides, give [quarter|exc.rocking|0.25|slope] deg and
[quarter|exc.rocking|0.25|circulation] rad/s: slope and circulation together. A trough that leans by 2.5 deg gives [quarter|grav.tilt_x|2.5|slope] deg and leaves the circulation where it was ([quarter|grav.tilt_x|2.5|circulation] rad/s).
Bodies that do not roll freely, as cones do not, stand steeper, too ([quarter|roll.coulomb|0.2|slope] deg with rolling friction 0.2). The thesis measured at one place of the machine, which shows neither rocking nor tilt.

**Phase or amplitude.** The sideways amplitude comes from the same sensor as the phase. Twice as wide and in phase, the quarter load turns by [quarter|exc.sideways|0.75|circulation] rad/s, the half load by
[half|exc.sideways|0.75|circulation]: to the same side as in phase, for a straight line stays a straight line. Over all numbers {SIDEWAYS}. So an amplitude that is wrong does not stand in for the phase here.
Nor do these means tell it: it was not asked for beside the phase, and scales what the phase does.

**What would decide.** The phase: both channels of the one sensor, read at the same instants (`tumble excitation` fits amplitude and phase); no bed is needed. Rocking: a second sensor on the other wall, 0.44 m away; 0.25 deg
are 1.9 mm between the two, as much as the whole upright amplitude. A tilt: a spirit level. With the bed alone, slope *and* circulation at a quarter load: rocking moves both, a tilt the slope only
({ROCKING_TILT} of rocking is left when a tilt is fitted in its place).

**What a plane is not.** Discs in a plane are no cones in space; those follow. The laboratory is the solver itself. Signs and orders of magnitude are what such a plane can give."""


def diagnose(tumble, measurement):
    told = subprocess.run([tumble, "diagnose", CASE / "trough.toml", "--data", CASE / measurement, "--json", "--quiet", "--seeds", str(SEEDS), "--old-runs"],
                          check=True, capture_output=True, text=True)
    return json.loads(told.stdout)


def mean_and_scatter(values):
    return statistics.mean(values), statistics.stdev(values)


def response():
    lines = [line for line in (CASE / "trough.response.csv").read_text(encoding="utf-8").splitlines() if line[0] != "#"]
    runs = collections.defaultdict(list)
    for row in csv.DictReader(lines):
        if int(row["seed"]) <= SEEDS:  # later ones confirm, or are of a longer table
            runs[row["condition"], row["cause"], row["amplitude"]].append(row)
    return runs


def response_table(runs):
    rows = ["| shaken | quarter load: circulation, rad/s | slope, deg | half load: circulation, rad/s | slope, deg |",
            "| --- | --- | --- | --- | --- |"]
    for cause, amplitude, words in SHOWN:
        cells = []
        for condition in ("quarter load", "half load"):
            for column in ("circulation_rad_s", "surface_slope_deg"):
                mean, scatter = mean_and_scatter([float(r[column]) for r in runs[condition, cause, amplitude]])
                digits = 3 if column.startswith("c") else 1
                cells.append(f"{mean:.{digits}f} ± {scatter:.{digits}f}")
        rows.append(f"| {words} | " + " | ".join(cells) + " |")
    return "\n".join(rows)


def measured_table(beds):
    rows = ["| load | number | measured | in phase, with what rocking the sensors allow | with the cause named |", "| --- | --- | --- | --- | --- |"]
    for one in beds:
        unit = one["unit"].replace("_s", "/s")
        cells = [f'{one[k]:.3g} ± {one[k + "_standard_error"]:.2g}' for k in ("measured", "baseline", "extended")]
        rows.append(f"| {one['condition']} | {one['measure'].replace('_', ' ')}, {unit} | " + " | ".join(cells) + " |")
    return "\n".join(rows)


def library_table(found):
    rows = ["| cause | fall of chi-square | standing |", "| --- | --- | --- |"]
    for cause in sorted(found["library"], key=lambda one: -one["chi_square_reached"]):
        rows.append(f"| `{cause['id']}` | {cause['chi_square_reached']:.1f} | {cause['standing']} |")
    return "\n".join(rows)


def sideways(found):
    """How far another sideways amplitude, in phase, goes in place of the phase."""
    library = {one["id"]: one for one in found["library"]}
    one, phase = library["exc.sideways"], library["exc.phase"]["chi_square_reached"]
    if "seeds" in one["standing"]:
        return f"that is no more than what {SEEDS} seeds scatter"
    if one["chi_square_reached"] > phase / 2:
        raise SystemExit("a sideways amplitude explains more than half of what the phase does: the page says that it does not stand in for it")
    end = re.search(r"(?:below|above) (-?[\d.]+), the end of what was run", one["standing"])
    if not end:
        raise SystemExit(f"the page has no words for a sideways amplitude that is {one['standing']}")
    return f"the farthest that was run to the better side, {end[1]}, explains {one['chi_square_reached']:.0f} of chi-square, the phase {phase:.0f}"


def plan(found):
    return "\n".join(f"- {one['sentence']}: {one['separation']:.1f} standard errors apart" for one in found["experiments"])


def left_of(found, cause, rival):
    ids = [one["id"] for one in found["library"]]
    return found["isolability"][ids.index(cause)][ids.index(rival)]


def filled(text, runs):
    """[half|exc.phase|90|slope] becomes the mean of those runs."""
    def value(match):
        load, cause, amplitude, what = match.groups()
        column, digits = {"circulation": ("circulation_rad_s", 3), "slope": ("surface_slope_deg", 1)}[what]
        return f"{statistics.mean(float(r[column]) for r in runs[load + ' load', cause, amplitude]):.{digits}f}"
    return re.sub(r"\[(half|quarter)\|([^|\]]*)\|([^|\]]*)\|(\w+)\]", value, text)


def main():
    space = trough_in_space.section(sys.argv[1])
    first, found = (diagnose(sys.argv[1], measurement) for measurement in ("measurement.toml", "measurement-2.toml"))
    runs = response()
    text = filled(TEXT.replace("{CONCLUSIONS}", CONCLUSIONS), runs)
    seeds = len(runs["quarter load", "", "0"])
    for key, value in {"SPACE": space, "FIRST_OUTCOME": first["outcome"], "FIRST_VERDICT": first["verdict"], "PLAN": plan(first),
                       "VERDICT": found["verdict"], "OUTCOME": found["outcome"], "MEASURED": measured_table(found["beds"]),
                       "RESPONSE": response_table(runs), "LIBRARY": library_table(first), "SEEDS": str(seeds),
                       "RUNS": str(sum(map(len, runs.values()))), "GATE": f"{first['gate']:.1f}",
                       "CHI": f"{first['chi_square_baseline']:.0f}",
                       "P_CONFIRMED": f"{found['confirmation']['p']:.2g}", "P_LEFT": f"{found['adequacy_winner']['p']:.2g}",
                       "NEAREST": next(one["standing"] for one in found["library"] if one["id"] == "load.fill"),
                       "SIDEWAYS": sideways(first),
                       "ROCKING_TILT": f"{left_of(first, 'exc.rocking', 'grav.tilt_x'):.2f}"}.items():
        text = text.replace("{" + key + "}", value)
    (ROOT / "docs/thrown-away-phase.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

"""The runs of scenes/measured/trough-3d, of which docs/thrown_away_phase.py makes a part of its page.

What is not in runs.csv beside the scenes is run, one after another on one core; a changed scene makes its runs stale.
"""
import collections
import csv
import hashlib
import json
import math
import pathlib
import re
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "scenes/measured/trough-3d"
TABLE = CASE / "runs.csv"
THESIS, TWICE, EQUAL = "0.0004038", "0.0008076", "0.001949"  # m across: what the thesis measured, and as much as upright
LOADS = {"full": 2439, "quarter": 610}  # bodies in 50 mm of the trough; the thesis has 4878 in 100 mm
BLOCK_S, FIRST_S = 0.8, 0.6  # blocks of ten pairs of periods, from when the wall begins to move
MEANS_S, LATE_S = (1.4, 3.8), 6.2  # what means are over; from when on long runs tell what lasts
SHORT_S, LONG_S = 3.8, 10.2
MEASURES = ("circulation_rad_s", "surface_slope_deg", "bulk_height_m", "rms_velocity_y_m_s", "rms_velocity_z_m_s")
COLUMNS = ("bodies", "load", "across_m", "phase_deg", "seed", "hash", "processor_s", "from_s", *MEASURES)

# Bodies, load, across, phase, seeds. At 30 and 11.96 deg, across times sine of the phase is as of the thesis' amplitude at 90.
WANTED = [("spheres", "full", THESIS, "0", 6), ("spheres", "full", THESIS, "90", 6), ("spheres", "full", THESIS, "-90", 3),
          ("spheres", "full", EQUAL, "0", 3), ("spheres", "full", EQUAL, "90", 3),
          ("spheres", "full", TWICE, "30", 3), ("spheres", "full", EQUAL, "11.96", 3),
          ("spheres", "quarter", THESIS, "0", 6), ("spheres", "quarter", THESIS, "90", 6),
          ("spheres", "quarter", EQUAL, "0", 3), ("spheres", "quarter", EQUAL, "90", 3),
          ("spheres", "quarter", TWICE, "30", 3), ("spheres", "quarter", EQUAL, "11.96", 3),
          ("cones", "full", THESIS, "0", 3), ("cones", "full", THESIS, "90", 3),
          ("cones", "full", EQUAL, "0", 2), ("cones", "full", EQUAL, "90", 2),
          ("cones", "quarter", THESIS, "0", 3), ("cones", "quarter", THESIS, "90", 3),
          ("cones", "quarter", EQUAL, "0", 3), ("cones", "quarter", EQUAL, "90", 3)]


def duration_of(bodies, load, across, seed):
    """The later seeds of the spheres that the page is about go on, to tell what lasts."""
    return LONG_S if (bodies, load, across) == ("spheres", "full", THESIS) and seed > 3 else SHORT_S

# The part of the page; {WORDS} and [settings] are filled in.
TEXT = """## In space: spheres and cones

[`spheres.toml`](../scenes/measured/trough-3d/spheres.toml) and [`cones.toml`](../scenes/measured/trough-3d/cones.toml) are the thesis' trough in space, with its load per length (full) or a quarter of it.
What is reduced, and what that costs, stands in them. {RUNS} runs, {MINUTES} core minutes, are in [`runs.csv`](../scenes/measured/trough-3d/runs.csv). The trough shakes from 0.6 s on; means are from 1.4 to 3.8 s, ± the
standard deviation from seed to seed. Circulation counts from y (up) towards z (across) here: what turns by a negative rate in the plane turns by a positive one in space. Slopes have the same sign in both.

**Full load**

{FULL}

**Quarter load**

{QUARTER}

**What a quarter period does**, against in phase: difference of the means ± its standard error, p by Welch's test.

{PHASE}

### Is the phase above the scatter, with the thesis' amplitudes?

**Yes, under both loads, with spheres and with cones.** In phase a full load of spheres turns by [spheres|full|thesis|0|circulation] rad/s, which is no more than its seeds scatter; a quarter period ahead by [spheres|full|thesis|90|circulation],
a quarter period behind by [spheres|full|thesis|-90|circulation]. Cones turn a little even in phase, [cones|full|thesis|0|circulation] rad/s, and by [cones|full|thesis|90|circulation] a quarter period ahead. Their slope does not show the phase at full load ([cones|full|thesis|0|slope] and [cones|full|thesis|90|slope] deg); that of
spheres does.

**But it is slow.** At that rate a full load of spheres goes round in {TURN} s; in the 6 s for which the thesis' simulation shook, it would have turned by {SIX} deg. In part that is the way to the slope. Spheres of seeds 4 to 6 were shaken on:

{LASTS}

From 6.2 s on {LATE} rad/s are left, a turn in {LATE_TURN} s. So with the thesis' amplitudes the phase makes a full load circulate, but little.

**At a quarter of the load the phase chooses the side.** In phase there is one slope, as the thesis' simulation had: [spheres|quarter|thesis|0|slope] deg for spheres, [cones|quarter|thesis|0|slope] for cones. A quarter period ahead it is
[spheres|quarter|thesis|90|slope] and [cones|quarter|thesis|90|slope]: as steep, and down to the other side. That the machine's was steeper is not explained by the phase, here as in the plane.

### What the sideways amplitude does

As wide across as upright and a quarter period ahead, a full load turns by [spheres|full|equal|90|circulation] rad/s (spheres) and [cones|full|equal|90|circulation] (cones): {GROWN_SPHERES} and {GROWN_CONES} times as fast as with the thesis' amplitude, for
4.8 times the width. In phase the width makes nothing of it ([spheres|full|equal|0|circulation] and [cones|full|equal|0|circulation]). The phase decides whether and to which side a full load turns, the amplitude across how fast. A quarter load
gets steeper with the width, in phase and out of it: [spheres|quarter|equal|0|slope] and [spheres|quarter|equal|90|slope] deg for spheres, [cones|quarter|equal|0|slope] and [cones|quarter|equal|90|slope] for cones. The thesis' amplitude across is
what one sensor at one place of the machine saw. If it was too small for where the load is, that would make a load turn faster and a quarter load stand steeper, as the machine's did; these runs cannot say that it was.

For orientation, LIGGGHTS with 2,000 spheres in a U trough, means over 3 s, a seed each; quoted, not made by the command. Its trough, stiffness and axes are its own: sizes may be compared, not digits or signs.

{LIGGGHTS}

There, too, the phase makes much of a wide shaking and little of the thesis'; three seeds of 3 s left that little barely above the scatter, and more seeds set it apart here. Its load sloped by 7 to 8 deg when wide and a quarter
period apart, more than spheres do here ([spheres|full|equal|90|slope]) and as cones do ([cones|full|equal|90|slope]).

### Which of the two data can tell

Spheres, three shakings with the same amplitude across times the sine of the phase, and two in phase:

{TRADED}

How far the second and the third are from the first, ± standard error, and p:

{TOLD}

- **The circulation of a full load tells neither.** It tells their product, amplitude times sine of the phase: the thesis' amplitude a quarter period apart, twice that at 30 deg and 4.8 times that at 12 deg turn alike.
- **The full load's sideways speed tells the amplitude, not the phase**: [spheres|full|thesis|90|speed], [spheres|full|twice|30|speed] and [spheres|full|equal|11.96|speed] mm/s; with the thesis' amplitude [spheres|full|thesis|0|speed] in phase and [spheres|full|thesis|90|speed] out of it. With the circulation beside it both are told, but for the sign of the cosine.
- **A quarter load beside the full one tells both, and that sign.** It slopes and turns to the side of the cosine where that is large: [spheres|quarter|thesis|90|slope] deg, but [spheres|quarter|twice|30|slope] and [spheres|quarter|equal|11.96|slope].
- **The sensor tells both at once**, if its channels are read at the same instants, for the place where it sits.

None of this sets phase and amplitude apart from rocking or a tilt, which have not been run in space. Loads are softer and lie in a thinner slice than the thesis', means begin 0.8 s after the shaking does, and the laboratory is missing: the
thesis prints no slope and no circulation. A small trough of spheres that is shaken as wide across as upright gives its phase to 2 degrees ([diagnosis.md](diagnosis.md))."""


def hash_of(bodies):
    """Of all that decides a run but what is set in it: the scene without its comments, and its cones."""
    lines = (line.split("#")[0].strip() for line in (CASE / f"{bodies}.toml").read_text(encoding="utf-8").splitlines())
    text = "\n".join(line for line in lines if line)
    if bodies == "cones":
        text += (CASE / "cone-12.csv").read_text(encoding="utf-8")
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def stored():
    """Blocks of every run whose scene is still as it was: (bodies, load, across, phase) -> seed -> rows."""
    runs = collections.defaultdict(lambda: collections.defaultdict(list))
    if TABLE.exists():
        lines = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if line[0] != "#"]
        for row in csv.DictReader(lines):
            if row["hash"] == hash_of(row["bodies"]):
                runs[row["bodies"], row["load"], row["across_m"], row["phase_deg"]][int(row["seed"])].append(row)
    return runs


def blocks_of(series, duration):
    """Means over blocks of a run's rows; a row belongs to the block in whose time it lies, its beginning included."""
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(series.open(encoding="utf-8"))]
    for number in range(round((duration - FIRST_S) / BLOCK_S)):
        begin = FIRST_S + number * BLOCK_S
        inside = [r for r in rows if begin - 1e-6 <= r["time_s"] < begin + BLOCK_S - 1e-6]
        yield [f"{begin:.1f}"] + [f"{statistics.mean(r[m] for r in inside):.6g}" for m in MEASURES]


def run(tumble, bodies, load, across, phase, seed):
    """One run, added to the table. Raises CalledProcessError where the program refuses it."""
    sets = [f"fill.0.count={LOADS[load]}", f"wall.0.motion.1.amplitude_m={across}", f"wall.0.motion.1.phase_deg={phase}", f"seed={seed}"]
    duration = duration_of(bodies, load, across, seed)
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        subprocess.run([tumble, "run", CASE / f"{bodies}.toml", "--out", out, "--threads", "1", "--quiet", "--checkpoint-every", "0", "--duration", str(duration)]
                       + [word for one in sets for word in ("--set", one)], check=True, stdout=subprocess.DEVNULL)
        spent = json.loads((out / "run.json").read_text(encoding="utf-8"))["processor_s"]
        new = not TABLE.exists()
        with TABLE.open("a", encoding="utf-8") as table:
            if new:
                table.write("# Runs of docs/thrown_away_phase.py: means over blocks of 0.8 s, a line each.\n" + ",".join(COLUMNS) + "\n")
            for block in blocks_of(out / "series.csv", duration):
                table.write(",".join([bodies, load, across, phase, str(seed), hash_of(bodies), f"{spent:.1f}", *block]) + "\n")


def complete(tumble):
    """Makes the runs that the table lacks, first seeds first."""
    kept = stored()
    for seed in range(1, 1 + max(one[-1] for one in WANTED)):
        for *key, seeds in WANTED:
            if seed <= seeds and seed not in kept[tuple(key)]:
                run(tumble, *key, seed)



def means(runs, key, measure, window=MEANS_S):
    """A number for each seed of one setting: the mean of its blocks that begin in the window. Empty where no run is that long."""
    column = next(m for m in MEASURES if m.startswith(measure))
    inside = [[float(r[column]) for r in rows if window[0] - 1e-6 <= float(r["from_s"]) < window[1] - 1e-6] for rows in runs[key].values()]
    whole = round((window[1] - window[0]) / BLOCK_S)
    return [statistics.mean(blocks) for blocks in inside if len(blocks) == whole]


def number(values, digits):
    """Mean and scatter from seed to seed; a single run has none."""
    if len(values) == 1:
        return f"{values[0]:.{digits}f}"
    return f"{statistics.mean(values):.{digits}f} ± {statistics.stdev(values):.{digits}f}"


def beyond(t, freedom):
    """Two-sided p of Student's t, by Simpson's rule over the density up to t."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(freedom * math.pi)
    density = [scale * (1 + (abs(t) * k / 1000) ** 2 / freedom) ** (-(freedom + 1) / 2) for k in range(1001)]
    inner = abs(t) / 3000 * (density[0] + density[-1] + 4 * sum(density[1:-1:2]) + 2 * sum(density[2:-1:2]))
    return max(0, 1 - 2 * inner)


def difference(one, other):
    """Of the mean of `other` from that of `one`: how large, its standard error and p by Welch's test."""
    a, b = statistics.variance(one) / len(one), statistics.variance(other) / len(other)
    apart, error = statistics.mean(other) - statistics.mean(one), math.sqrt(a + b)
    freedom = (a + b) ** 2 / (a * a / (len(one) - 1) + b * b / (len(other) - 1))
    return apart, error, beyond(apart / error, freedom)


# Load, across, phase, words for it, what LIGGGHTS had with 2,000 spheres
SHOWN = [("full", THESIS, "0", "thesis' amplitudes, in phase", "-0.003, -0.002"),
         ("full", THESIS, "90", "the same, a quarter period ahead", "-0.014, -0.015, 0.000"),
         ("full", THESIS, "-90", "a quarter period behind", ""),
         ("full", EQUAL, "0", "as wide across as upright, in phase", "-0.003"),
         ("full", EQUAL, "90", "the same, a quarter period ahead", "-0.10, -0.11"),
         ("quarter", THESIS, "0", "thesis' amplitudes, in phase", ""),
         ("quarter", THESIS, "90", "the same, a quarter period ahead", ""),
         ("quarter", EQUAL, "0", "as wide across as upright, in phase", ""),
         ("quarter", EQUAL, "90", "the same, a quarter period ahead", "")]


def shaken_table(runs, load):
    rows = ["| shaken | bodies | seeds | circulation, rad/s | slope, deg | sideways speed, mm/s |", "| --- | --- | --- | --- | --- | --- |"]
    for at, across, phase, words, _ in SHOWN:
        for bodies in ("spheres", "cones"):
            key = (bodies, at, across, phase)
            if at == load and key in runs:
                cells = [number(means(runs, key, "circulation"), 3), number(means(runs, key, "surface_slope"), 1),
                         number([1000 * v for v in means(runs, key, "rms_velocity_z")], 1)]
                rows.append(f"| {words} | {bodies} | {len(runs[key])} | " + " | ".join(cells) + " |")
    return "\n".join(rows)


def liggghts_table(runs):
    rows = ["| full load of spheres | LIGGGHTS, rad/s | here, rad/s |", "| --- | --- | --- |"]
    for at, across, phase, words, theirs in SHOWN:
        if theirs:
            rows.append(f"| {words} | {theirs} | {number(means(runs, ('spheres', at, across, phase), 'circulation'), 3)} |")
    return "\n".join(rows)


def phase_table(runs):
    """What a quarter period does to circulation and slope, where there are seeds enough to say."""
    rows = ["| bodies, load, across | number | a quarter period makes | p |", "| --- | --- | --- | --- |"]
    for bodies, load, across in ((b, l, a) for l in LOADS for a in (THESIS, EQUAL) for b in ("spheres", "cones")):
        for measure, digits, unit in (("circulation", 3, "rad/s"), ("surface_slope", 1, "deg")):
            one, other = (means(runs, (bodies, load, across, phase), measure) for phase in ("0", "90"))
            if min(len(one), len(other)) >= 3:
                apart, error, p = difference(one, other)
                rows.append(f"| {bodies}, {load}, {1000 * float(across):.3g} mm | {measure.replace('_', ' ')} | "
                            f"{apart:+.{digits}f} ± {error:.{digits}f} {unit} | {p:.1g} |")
    return "\n".join(rows)


def lasting_table(runs):
    windows = [MEANS_S, (3.8, LATE_S), (LATE_S, LONG_S)]
    rows = ["| phase | number | " + " | ".join(f"{a:g} to {b:g} s" for a, b in windows) + " |", "| --- | --- |" + " --- |" * len(windows)]
    for phase in ("0", "90"):
        key = ("spheres", "full", THESIS, phase)
        long_ones = {key: {seed: rows for seed, rows in runs[key].items() if seed > 3}}
        for measure, digits, unit in (("circulation", 3, "rad/s"), ("surface_slope", 1, "deg")):
            rows.append(f"| {phase} deg | {measure.replace('_', ' ')}, {unit} | "
                        + " | ".join(number(means(long_ones, key, measure, window), digits) for window in windows) + " |")
    return "\n".join(rows)


def traded_table(runs):
    rows = ["| load | across | phase | circulation, rad/s | slope, deg | sideways speed, mm/s |", "| --- | --- | --- | --- | --- | --- |"]
    for load in LOADS:
        for across, phase in ((THESIS, "90"), (TWICE, "30"), (EQUAL, "11.96"), (EQUAL, "0"), (THESIS, "0")):
            key = ("spheres", load, across, phase)
            rows.append(f"| {load} | {1000 * float(across):.3f} mm | {float(phase):.0f} deg | {number(means(runs, key, 'circulation'), 3)} | "
                        f"{number(means(runs, key, 'surface_slope'), 1)} | {number([1000 * v for v in means(runs, key, 'rms_velocity_z')], 1)} |")
    return "\n".join(rows)


def told_table(runs):
    rows = ["| number | twice as wide, 30 deg | 4.8 times as wide, 12 deg |", "| --- | --- | --- |"]
    for load in LOADS:
        for measure, digits, unit, factor, words in (("circulation", 3, "rad/s", 1, "circulation"), ("surface_slope", 1, "deg", 1, "slope"),
                                                     ("rms_velocity_z", 1, "mm/s", 1000, "sideways speed")):
            cells = []
            for rival in ((TWICE, "30"), (EQUAL, "11.96")):
                one, other = ([factor * v for v in means(runs, ("spheres", load, *shaking), measure)] for shaking in ((THESIS, "90"), rival))
                apart, error, p = difference(one, other)
                cells.append(f"{apart:+.{digits}f} ± {error:.{digits}f}, p = {p:.1g}")
            rows.append(f"| {load} load: {words}, {unit} | " + " | ".join(cells) + " |")
    return "\n".join(rows)


def filled(text, runs):
    """[spheres|full|thesis|90|circulation] becomes the mean of those runs; circulation in rad/s, slope in deg, speed in mm/s."""
    across = {"thesis": THESIS, "twice": TWICE, "equal": EQUAL}
    shown = {"circulation": (1, 3, "circulation"), "slope": (1, 1, "surface_slope"), "speed": (1000, 0, "rms_velocity_z")}

    def value(match):
        bodies, load, wide, phase, what = match.groups()
        factor, digits, measure = shown[what]
        return f"{factor * statistics.mean(means(runs, (bodies, load, across[wide], phase), measure)):.{digits}f}"
    return re.sub(r"\[(spheres|cones)\|(\w+)\|(\w+)\|([-.\d]+)\|(\w+)\]", value, text)


def section():
    """The part of the page that these runs make."""
    runs = stored()
    every = [rows[0] for seeds in runs.values() for rows in seeds.values()]
    text = filled(TEXT, runs)
    turns = {(b, a): statistics.mean(means(runs, (b, "full", a, "90"), "circulation")) for b in ("spheres", "cones") for a in (THESIS, EQUAL)}
    ahead = turns["spheres", THESIS]
    late = statistics.mean(means(runs, ("spheres", "full", THESIS, "90"), "circulation", (LATE_S, LONG_S)))
    for key, value in {"FULL": shaken_table(runs, "full"), "QUARTER": shaken_table(runs, "quarter"), "PHASE": phase_table(runs),
                       "LASTS": lasting_table(runs), "TRADED": traded_table(runs), "LIGGGHTS": liggghts_table(runs),
                       "TOLD": told_table(runs), "LATE": f"{late:.3f}", "LATE_TURN": f"{2 * math.pi / late:.0f}",
                       "GROWN_SPHERES": f"{turns['spheres', EQUAL] / ahead:.1f}", "GROWN_CONES": f"{turns['cones', EQUAL] / turns['cones', THESIS]:.1f}",
                       "RUNS": str(len(every)), "MINUTES": f"{sum(float(row['processor_s']) for row in every) / 60:.0f}",
                       "TURN": f"{2 * math.pi / ahead:.0f}", "SIX": f"{math.degrees(6 * ahead):.0f}"}.items():
        text = text.replace("{" + key + "}", value)
    return text

"""The runs of scenes/measured/trough-3d: which are wanted, how each is made, and the table they stand in, runs.csv.

A run is in the table whole or not at all. It counts while all that decides it is as it was: hash_of says what that is.
"""
import collections
import csv
import hashlib
import json
import math
import os
import pathlib
import statistics
import subprocess
import tempfile

import scatter

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "scenes/measured/trough-3d"
TABLE = CASE / "runs.csv"
# m across: what the thesis measured, twice that, and as much as upright
THESIS, TWICE, EQUAL = "0.0004038", "0.0008076", "0.001949"
LOADS = {"full": 2439, "quarter": 610}  # bodies in 50 mm of the trough; the thesis has 4878 in 100 mm
BLOCK_S, FIRST_S = 0.8, 0.6  # blocks of ten pairs of periods, from when the wall begins to move
SHORT_S, LONG_S = 3.8, 10.2
MEASURES = ("circulation_rad_s", "surface_slope_deg", "bulk_height_m", "rms_velocity_y_m_s", "rms_velocity_z_m_s")
# overlap_ratio_max is the deepest of the whole run; empty in runs made before it was kept
COLUMNS = ("bodies", "load", "across_m", "phase_deg", "seed", "hash", "processor_s", "overlap_ratio_max", "from_s",
           *MEASURES)
# What bodies, as the table names them, set in their scene
SETS = {"spheres": [], "cones": [],
        "stiff spheres": ["material.media.youngs_modulus_Pa=2e7", "material.lining.youngs_modulus_Pa=2e7",
                          "time_step_s=1.75e-5"],
        "fine spheres": ["time_step_s=1.25e-5"]}

# Bodies, load, across, phase, seeds. At 30, 150 and 11.96 deg, across times sine of the phase is as of the thesis'
# amplitude at 90.
WANTED = [("spheres", "full", THESIS, "0", 6), ("spheres", "full", THESIS, "90", 6),
          ("spheres", "full", THESIS, "-90", 3),
          ("spheres", "full", EQUAL, "0", 6), ("spheres", "full", EQUAL, "90", 3),
          ("spheres", "full", TWICE, "30", 6), ("spheres", "full", EQUAL, "11.96", 6),
          ("spheres", "quarter", THESIS, "0", 6), ("spheres", "quarter", THESIS, "90", 6),
          ("spheres", "quarter", EQUAL, "0", 3), ("spheres", "quarter", EQUAL, "90", 3),
          ("spheres", "quarter", TWICE, "30", 3), ("spheres", "quarter", TWICE, "150", 3),
          ("spheres", "quarter", EQUAL, "11.96", 3),
          ("cones", "full", THESIS, "0", 3), ("cones", "full", THESIS, "90", 3),
          ("cones", "full", EQUAL, "0", 2), ("cones", "full", EQUAL, "90", 2),
          ("cones", "quarter", THESIS, "0", 3), ("cones", "quarter", THESIS, "90", 3),
          ("cones", "quarter", EQUAL, "0", 3), ("cones", "quarter", EQUAL, "90", 3),
          ("stiff spheres", "full", THESIS, "0", 3), ("stiff spheres", "full", THESIS, "90", 3),
          ("stiff spheres", "full", EQUAL, "90", 2),
          ("stiff spheres", "quarter", THESIS, "0", 3), ("stiff spheres", "quarter", THESIS, "90", 3),
          ("fine spheres", "full", THESIS, "90", 1)]


def scene_of(bodies):
    return CASE / f"{bodies.split()[-1]}.toml"


def duration_of(bodies, load, across, seed):
    """The later seeds of the spheres that the page is about go on, to tell what lasts."""
    return LONG_S if (bodies, load, across) == ("spheres", "full", THESIS) and seed > 3 else SHORT_S


def blocks_in(duration):
    """How many whole blocks a run of so many seconds has."""
    return round((duration - FIRST_S) / BLOCK_S)


def arguments(bodies, load, across, phase, seed):
    """What the program is told beside the scene."""
    sets = [f"fill.0.count={LOADS[load]}", f"wall.0.motion.1.amplitude_m={across}",
            f"wall.0.motion.1.phase_deg={phase}", f"seed={seed}", *SETS[bodies]]
    return (["--threads", "1", "--duration", str(duration_of(bodies, load, across, seed))]
            + [word for one in sets for word in ("--set", one)])


def hash_of(bodies, load, across, phase, seed):
    """Of all that decides a run's rows: scene without comments, cones, arguments, duration, and how blocks are cut.

    Not the program: any new build would make an hour of runs stale. Instead one run is made anew with the program at
    hand each time, and compared (see check_program).
    """
    lines = (line.split("#")[0].strip() for line in scene_of(bodies).read_text(encoding="utf-8").splitlines())
    parts = [line for line in lines if line]
    if scene_of(bodies).stem == "cones":
        parts.append((CASE / "cone-12.csv").read_text(encoding="utf-8"))
    parts += arguments(bodies, load, across, phase, seed) + [str(BLOCK_S), str(FIRST_S), *MEASURES]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def run_of(row):
    """Which run a row is of: bodies, load, across, phase, seed. Raises KeyError or ValueError where it says none."""
    return row["bodies"], row["load"], row["across_m"], row["phase_deg"], int(row["seed"])


def whole(one, rows):
    """Whether these rows are all blocks of that run, each once and in order, and all that decides it is as it was."""
    begins = [f"{FIRST_S + k * BLOCK_S:.1f}" for k in range(blocks_in(duration_of(*one[:3], one[4])))]
    return ([row["from_s"] for row in rows] == begins
            and all(row["hash"] == hash_of(*one) and all(row[m] for m in MEASURES) for row in rows))


def stored():
    """Blocks of every run that counts: (bodies, load, across, phase) -> seed -> rows."""
    found = collections.defaultdict(list)
    if TABLE.exists():
        lines = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if line.strip() and line[0] != "#"]
        for row in csv.DictReader(lines):
            try:
                found[run_of(row)].append(row)
            except (KeyError, TypeError, ValueError):
                pass  # a line cut short
    runs = collections.defaultdict(dict)
    for one, rows in found.items():
        if one[0] in SETS and one[1] in LOADS and whole(one, rows):
            runs[one[:4]][one[4]] = rows
    return runs


def write(runs):
    """The table anew, whole: what does not count any more goes."""
    text = ("# Runs of docs/thrown_away_phase.py: means over blocks of 0.8 s, a line each.\n" + ",".join(COLUMNS) + "\n"
            + "".join(",".join(row[c] for c in COLUMNS) + "\n"
                      for seeds in runs.values() for rows in seeds.values() for row in rows))
    beside = TABLE.with_suffix(".new")
    beside.write_text(text, encoding="utf-8")
    os.replace(beside, TABLE)


def blocks_of(series, duration):
    """Means over blocks of a run's rows; a row is of the block in whose time it lies, its beginning included."""
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(series.open(encoding="utf-8"))]
    for number in range(blocks_in(duration)):
        begin = FIRST_S + number * BLOCK_S
        inside = [r for r in rows if begin - 1e-6 <= r["time_s"] < begin + BLOCK_S - 1e-6]
        yield {"from_s": f"{begin:.1f}", **{m: f"{statistics.mean(r[m] for r in inside):.6g}" for m in MEASURES}}


def rows_of(one, out):
    """The table's rows of a run that has been written to `out`."""
    told = json.loads((out / "run.json").read_text(encoding="utf-8"))
    head = dict(zip(COLUMNS, (*one[:4], str(one[4]), hash_of(*one), f"{told['processor_s']:.1f}",
                              f"{told['overlap_ratio_max']:.3f}")))
    return [{**head, **block} for block in blocks_of(out / "series.csv", duration_of(*one[:3], one[4]))]


def made(tumble, one):
    """The rows of one run, made now. Raises CalledProcessError where the program refuses it."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        subprocess.run([tumble, "run", scene_of(one[0]), "--out", out, "--quiet", "--checkpoint-every", "0",
                        *arguments(*one)], check=True, stdout=subprocess.DEVNULL)
        return rows_of(one, out)


def complete(tumble):
    """Makes the runs that the table lacks, first seeds first."""
    runs = stored()
    for seed in range(1, 1 + max(one[-1] for one in WANTED)):
        for *key, seeds in WANTED:
            if seed <= seeds and seed not in runs[tuple(key)]:
                runs[tuple(key)][seed] = made(tumble, (*key, seed))
                write(runs)


def check_program(tumble):
    """Makes the cheapest run anew; True where it comes out digit for digit as it is stored.

    Raises SystemExit where it is farther from what its seeds gave than a further seed would be: the program has
    changed what it does, and the table is of another one.
    """
    key = ("spheres", "quarter", THESIS, "0")
    kept = stored()[key]
    again = made(tumble, (*key, 1))
    if all(new[m] == old[m] for new, old in zip(again, kept[1]) for m in MEASURES):
        return True
    for measure in MEASURES:
        *seeds, now = [statistics.mean(float(row[measure]) for row in rows[1:]) for rows in (*kept.values(), again)]
        off = (now - statistics.mean(seeds)) / statistics.stdev(seeds)
        if scatter.beyond(off / math.sqrt(1 + 1 / len(seeds)), len(seeds) - 1) < 0.001:
            raise SystemExit(f"{TABLE} is of another program: made anew, {measure} of {' '.join(key)} is {now:.4g}, "
                             f"{abs(off):.0f} standard deviations of its seeds off. Delete the table and make it anew.")
    return False

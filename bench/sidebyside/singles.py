"""Single contacts, ours and LIGGGHTS from the same numbers: drop, oblique impact, two spheres, one clump."""

import csv
import tempfile
from datetime import date
from math import cos, pi, sin
from pathlib import Path

import numpy as np

from . import liggghts, programs
from .replay import cone, oblique, turn, two_spheres

ANGLES = (5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 60, 70, 80)
FINE_POINTS = 10**8  # of a clump's mass in LIGGGHTS, for figures that are kept
MATTER = ("density", "E", "nu", "Ew", "nuw", "e", "mu", "g", "dt", "nstep", "every")


def drop(dt, Ew):
    """The thesis' 25.5 mm sphere falls 200 mm onto a plane."""
    every = 10 if dt < 2e-6 else 1
    steps = round(0.42 / dt / every) * every
    return {"radius": 12.75e-3, "density": 1665.71, "E": 4.6e8, "nu": 0.2887, "Ew": Ew, "nuw": 0.25, "e": 0.67, "mu": 0.86,
            "y0": 0.21275, "vx": 0.0, "vy": 0.0, "wz": 0.0, "g": 9.81, "dt": dt, "nstep": steps,
            "every": every}


def glass_pair(**other):
    """Chung and Ooi 2011, test 1, glass."""
    return two_spheres(r1=1e-2, r2=1e-2, density=2800.0, E=4.8e10, nu=0.2, e=1.0, mu=0.35, x1=-1.00001e-2, y1=0.0,
                       x2=1.00001e-2, y2=0.0, vx1=10.0, vy1=0.0, vx2=-10.0, vy2=0.0, wz1=0.0, wz2=0.0, dt=2e-8, nstep=2200,
                       **other)


def stiff_pair():
    """Two unlike spheres, off centre and spinning, as stiff as glass."""
    return two_spheres(r2=3e-3, density=2500.0, E=7e9, mu=0.4, y2=6.3e-3, vy1=1.5, dt=2e-8)


def runs(case):
    """[(name, deck, variables)] of a case."""
    if case == "drop":
        return [(f"dt {dt:.4g} s, wall {Ew / 1e6:g} MPa", "plane.in", drop(dt, Ew))
                for Ew in (2.5e7, 4.6e8) for dt in (1e-6, 1 / 350000, 5e-6, 1e-5)]
    if case == "oblique":
        return [(f"{a} deg", "plane.in", oblique(a)) for a in ANGLES] + \
               [("20 deg, e 0.5, mu 0.5", "plane.in", oblique(20, e=0.5, mu=0.5)),
                ("60 deg, e 0.3, mu 0.2, spinning", "plane.in", oblique(60, e=0.3, mu=0.2, wz=-2000.0))]
    if case == "pair":
        return [("glass, central, e 1", "pair.in", glass_pair()), ("off centre, spinning", "pair.in", stiff_pair()),
                ("off centre, spinning, soft", "pair.in", two_spheres())]
    if case == "clump":
        return [("cone, base down, e 0.3", "clump.in", cone()), ("cone, base down, e 0.67", "clump.in", cone(e=0.67, mu=0.86)),
                ("cone, tilted 34 deg", "clump.in", cone(q1=cos(0.3), q4=sin(0.3), y0=10.4e-3)),
                ("cone, on its side", "clump.in", cone(q1=cos(pi / 4), q4=sin(pi / 4), y0=13e-3, nstep=3000))]
    raise KeyError(case)


def peer_motion(deck, P):
    """LIGGGHTS' motion [step, body, 9]: x, v, w; and what ours needs to start alike."""
    folder = liggghts.run(deck, P).folder
    _, rows = liggghts.trace(folder)
    if deck != "clump.in":
        return rows[:, :, 1:10], None
    _, bodies = liggghts.trace(folder, "body.dump")
    return bodies[:, :, :9], {"spheres": rows[0], "body": bodies[0, 0]}


def start_lines(deck, P, start):
    """(template files' texts, lines for bench_contact bodies=)."""
    still = "1 0 0 0"
    if deck == "plane.in":
        return [f"0 0 0 {P['radius']!r}\n"], [f"0 0 {P['y0']!r} 0 {still} {P['vx']!r} {P['vy']!r} 0 0 0 {P['wz']!r}"]
    if deck == "pair.in":
        return [f"0 0 0 {P[r]!r}\n" for r in ("r1", "r2")], \
               [f"{i} {P[f'x{i+1}']!r} {P[f'y{i+1}']!r} 0 {still} {P[f'vx{i+1}']!r} {P[f'vy{i+1}']!r} 0 0 0 {P[f'wz{i+1}']!r}"
                for i in (0, 1)]
    q = np.array([P[f"q{i}"] for i in (1, 2, 3, 4)])
    first = np.array([float(x) for x in Path(P["spheres"]).read_text().split()[:3]])
    origin = start["spheres"][0, 1:4] - turn(q) @ first
    words = [*origin, *q, *start["body"][3:9]]
    return [Path(P["spheres"]).read_text()], ["0 " + " ".join(repr(float(w)) for w in words)]


def our_motion(deck, P, start):
    """Our motion [step, body, 9] for the same numbers."""
    folder = Path(tempfile.mkdtemp(prefix="tumble-contact-"))
    templates, bodies = start_lines(deck, P, start)
    for k, text in enumerate(templates):
        (folder / f"template{k}.txt").write_text(text)
    (folder / "bodies.txt").write_text("\n".join(bodies) + "\n")
    words = [f"{k}={P[k]!r}" for k in MATTER if k in P]
    words += ["templates=" + ",".join(f"template{k}.txt" for k in range(len(templates))), f"plane={int(deck != 'pair.in')}"]
    if start is not None:
        words += [f"mass={start['body'][16]!r}", "inertia=" + ",".join(repr(float(x)) for x in start["body"][13:16])]
    output = programs.run([programs.ours("contact"), *words], folder=folder).output
    rows = np.array([[float(x) for x in line.split()] for line in output.splitlines()])
    return rows[:, 2:11].reshape(-1, len(bodies), 9)


def overlap(deck, P, motion):
    """Overlap at every step, m; of a clump the fall of its centre below where it started."""
    if deck == "plane.in":
        return P["radius"] - motion[:, 0, 1]
    if deck == "pair.in":
        return P["r1"] + P["r2"] - np.linalg.norm(motion[:, 0, :3] - motion[:, 1, :3], axis=1)
    return motion[0, 0, 1] - motion[:, 0, 1]


def figures(deck, P, motion):
    """Peak overlap (m), peak acceleration of the first body (m/s2, second difference of the
    recorded rows), velocity, spin at the end."""
    x = motion[:, 0, :3]
    acceleration = np.linalg.norm(x[2:] - 2 * x[1:-1] + x[:-2], axis=1) / (P["dt"] * P["every"])**2
    found = {"peak_overlap_m": overlap(deck, P, motion).max(), "peak_acceleration_m_s2": acceleration.max(),
             "vx_m_s": motion[-1, 0, 3], "vy_m_s": motion[-1, 0, 4], "wz_rad_s": motion[-1, 0, 8]}
    if deck == "plane.in" and P["g"] > 0:
        after = motion[np.argmax(overlap(deck, P, motion) > 0):, 0, 1]
        found = {"rebound_height_m": after.max() - P["radius"], **found}
    return found


def scales(P, found):
    """What a difference of each figure is held against: itself, or the speed and spin of the impact."""
    speed = max(np.hypot(P.get("vx", P.get("vx1", 0)), P.get("vy", P.get("vy1", 0))), (2 * P.get("g", 0) * 0.2)**0.5)
    size = P.get("radius", P.get("r1", 1e-2))
    floor = {"vx_m_s": speed, "vy_m_s": speed, "wz_rad_s": speed / size}
    return {k: floor.get(k, abs(v)) for k, v in found.items()}


def apart(ours, theirs):
    """Largest difference of displacement, velocity and spin at any step, each over its largest change (LIGGGHTS)."""
    steps = min(len(ours), len(theirs))
    ours, theirs = (np.concatenate([m[:steps, :, :3] - m[:1, :, :3], m[:steps, :, 3:]], axis=2) for m in (ours, theirs))
    out = {}
    for name, part in (("displacement", np.s_[:, :, :3]), ("velocity", np.s_[:, :, 3:6]), ("spin", np.s_[:, :, 6:9])):
        change = np.abs(theirs[part] - theirs[:1][part]).max()
        difference = np.abs(ours[part] - theirs[part]).max()
        out[name] = difference / change if change > 1e-9 else difference
    return out


def reference_file(case):
    return programs.REFERENCE / f"liggghts-{case}.csv"


def save_reference(case, rows):
    """Writes LIGGGHTS' figures with deck, version and date."""
    columns = list(dict.fromkeys(k for row in rows for k in row["peer"]))
    with open(reference_file(case), "w", newline="") as out:
        out.write(f"# {liggghts.version()}, bench/decks/{rows[0]['deck']}, {date.today()}; inputs: runs(\"{case}\") in "
                  f"bench/sidebyside/singles.py{', ntry 1e8' if case == 'clump' else ''}\n")
        writer = csv.writer(out)
        writer.writerow(["run", *columns])
        for row in rows:
            writer.writerow([row["run"], *(f"{row['peer'][k]:.9g}" for k in columns)])


def saved_reference(case):
    """{run: figures} as saved, empty when there is none."""
    if not reference_file(case).exists():
        return {}
    with open(reference_file(case)) as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        return {row.pop("run"): {k: float(v) for k, v in row.items() if v} for row in rows}


def compare(case, peer_only=False, fine=False):
    """One row per run (fine: LIGGGHTS weighs its clumps with 1e8 points, minutes each): figures of both, their differences, and how far the motions are apart at any step. A program
    that is missing leaves its part out and is named in "problem"; the saved figures then stand for LIGGGHTS."""
    rows, saved = [], saved_reference(case)
    for name, deck, P in runs(case):
        P = {**P, "ntry": FINE_POINTS} if fine and deck == "clump.in" else P
        row = {"run": name, "deck": deck, "problem": []}
        theirs = start = None
        try:
            theirs, start = peer_motion(deck, P)
            row["peer"] = figures(deck, P, theirs)
        except programs.Missing as problem:
            row["problem"].append(str(problem))
            row["peer"] = saved.get(name, {})
        if not peer_only and (theirs is not None or deck != "clump.in"):
            try:
                ours = our_motion(deck, P, start)
                row["tumble"] = figures(deck, P, ours)
                if theirs is not None:
                    row["apart"] = apart(ours, theirs)
            except programs.Missing as problem:
                row["problem"].append(str(problem))
        if row.get("tumble") and row["peer"]:
            scale = scales(P, row["peer"])
            row["difference"] = {k: abs(row["tumble"][k] - row["peer"][k]) / scale[k] for k in row["peer"] if scale[k] > 0}
        rows.append(row)
    return rows

"""The same cones fall into the same trough, come to rest and are shaken: bulk statistics of ours and LIGGGHTS.

Both start from the state that LIGGGHTS leaves after insertion, one per seed, with the same step. Single paths part after
a few collisions; what must agree is the bulk, within its scatter from seed to seed.
"""

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from . import liggghts, programs, student

LENGTH, RADIUS = 0.1, 0.24             # m, period in x and radius of the trough's bottom
SHAKING = 0.04                         # s, period of the wall's motion
# The bed answers every second shake alike (it turns at -0.5 rad/s in one period, at +0.2 in the next), so means are
# taken over pairs of periods; the first pair is left to the start.
PAIR = 2 * SHAKING
SHARE = 0.02                           # of the peer's mean; differences below it, or that may be chance, count as agreement
MASS = 4.675e-3
SEEDS = (49979687, 67867967, 86028121, 104395301, 122949823, 141650939, 160481183, 179424673, 198491317, 217645199)
INERTIA = 1.66e-7                      # kg m2, mean of the cone's principal moments; for the spin's energy only


def spheres_of(path):
    """id radius x y z vx vy vz of the first frame, sorted by id."""
    _, rows = next(liggghts.frames(path))
    return rows[np.argsort(rows[:, 0])]


def contacts_per_body(rows, each=65):
    """(touching sphere pairs, touching body pairs) per body, each pair counted for both."""
    x, R, body = rows[:, 2:5], rows[:, 1], (rows[:, 0].astype(int) - 1) // each
    spheres, pairs = 0, set()
    for i in range(0, len(x), 500):
        apart = x[i:i + 500, None] - x[None]
        apart[..., 0] -= LENGTH * np.round(apart[..., 0] / LENGTH)
        touch = np.einsum("ijk,ijk->ij", apart, apart) < (R[i:i + 500, None] + R[None])**2
        a, b = np.nonzero(touch & (body[i:i + 500, None] != body[None]))
        spheres += len(a)
        pairs.update(zip(body[i + a], body[b]))
    bodies = len(x) / each
    return spheres / bodies, len(pairs) / bodies


def solid_fraction(rows, layers=((0.01, 0.03), (0.03, 0.05), (0.05, 0.07)), points=4000, margin=0.02):
    """Share of a layer (y from, to; m), `margin` away from the wall, that lies inside a sphere; fixed sample points."""
    x, R = rows[:, 2:5], rows[:, 1]
    random = np.random.default_rng(1)
    shares = []
    for lo, hi in layers:
        p = np.stack([random.uniform(-LENGTH / 2, LENGTH / 2, points), random.uniform(lo, hi, points),
                      random.uniform(-RADIUS, RADIUS, points)], axis=1)
        p = p[np.hypot(p[:, 1] - RADIUS, p[:, 2]) < RADIUS - min(margin, lo)]
        inside = 0
        for i in range(0, len(p), 200):
            apart = p[i:i + 200, None] - x[None]
            apart[..., 0] -= LENGTH * np.round(apart[..., 0] / LENGTH)
            inside += (np.einsum("ijk,ijk->ij", apart, apart) < R**2).any(axis=1).sum()
        shares.append(inside / len(p))
    return shares


def movement(rows):
    """Per row of [frame, body, x v w]: mean y (m), energies of translation and spin (J), turning of the bulk about its
    centre in the y-z plane (rad/s)."""
    x, v, w = rows[..., :3], rows[..., 3:6], rows[..., 6:9]
    arm, drift = x - x.mean(1, keepdims=True), v - v.mean(1, keepdims=True)
    swirl = (arm[..., 1] * drift[..., 2] - arm[..., 2] * drift[..., 1]).sum(1) / (arm[..., 1]**2 + arm[..., 2]**2).sum(1)
    return {"y": x[..., 1].mean(1), "translation": MASS / 2 * (v**2).sum((1, 2)), "spin": INERTIA / 2 * (w**2).sum((1, 2)),
            "turning": swirl}


def statistics(rest, vibrating, settled, every, dt):
    """The figures that are compared, by name with unit; motion arrays [frame, body, 9], spheres at rest."""
    fall, shake = movement(rest), movement(vibrating)
    energy = fall["translation"] + fall["spin"]
    peak = int(np.argmax(energy))
    below = np.nonzero(energy[peak:] < 0.01 * energy[peak])[0]
    pair = round(PAIR / (every * dt))
    pairs = (len(shake["y"]) - 1) // pair
    late = np.s_[1 + pair:1 + pairs * pair]
    touching, neighbours = contacts_per_body(settled)
    found = {"bodies": rest.shape[1], "peak_kinetic_J": energy[peak],
             "time_to_1_percent_s": (below[0] if len(below) else np.nan) * every * dt, "height_at_rest_m": fall["y"][-1],
             "sphere_contacts_per_body": touching, "neighbours_per_body": neighbours,
             "height_shaken_m": shake["y"][late].mean(), "translation_shaken_J": shake["translation"][late].mean(),
             "spin_shaken_J": shake["spin"][late].mean(), "turning_shaken_rad_s": shake["turning"][late].mean()}
    for k, share in enumerate(solid_fraction(settled)):
        found[f"solid_fraction_layer_{k + 1}"] = share
    return found


def their_run(seed, settings, core):
    deck = {"N": settings["cones"], "seed": seed, "dt": settings["dt"], "g": 9.81, "skin": 1e-3, "every": settings["every"],
            "nset": settings["rest_steps"], "nvib": settings["shake_steps"],
            "cone": str(programs.peer_file("common/cone65.txt")), "stl": str(programs.peer_file("trough/trough.stl"))}
    ran = liggghts.run("bulk.in", deck, [core])
    steps, rows = [], []
    for step, frame in liggghts.frames(ran.folder / "body.dump"):
        if step not in steps[-1:]:
            steps.append(step), rows.append(frame)
    split = settings["rest_steps"] // settings["every"] + 1
    return ran, np.array(rows[:split]), np.array(rows[split - 1:])


def our_run(folder, settings, core):
    rows = folder / "ours.rows"
    programs.run([programs.ours("trough"), f"state={folder / 'state.dump'}", f"out={folder / 'ours.dump'}",
                  f"cone={programs.peer_file('common/cone65.txt')}", f"stl={programs.peer_file('trough/trough.stl')}",
                  f"dt={settings['dt']!r}", f"rows={rows}", f"every={settings['every']}",
                  f"row_steps={settings['rest_steps']}", f"row_vibrate_steps={settings['shake_steps']}"], [core], folder)
    read = [np.loadtxt(f"{rows}.{part}") for part in ("rest", "vibrating")]
    return [part.reshape(-1, len(np.unique(part[:, 1])), 11)[:, :, 2:] for part in read]


def one_seed(seed, settings, core):
    """Statistics of both for one seed."""
    ran, rest, vibrating = their_run(seed, settings, core)
    every, dt = settings["every"], settings["dt"]
    theirs = statistics(rest, vibrating, spheres_of(ran.folder / "settled.dump"), every, dt)
    rest, vibrating = our_run(ran.folder, settings, core)
    return statistics(rest, vibrating, spheres_of(ran.folder / "ours.dump"), every, dt), theirs


def compare(cones=200, seeds=8, cores=(0, 1), dt=1e-5, rest_steps=60000, shake_steps=40000, every=200):
    """Settings, and a table as of student.table."""
    settings = {"cones": cones, "dt": dt, "rest_steps": rest_steps, "shake_steps": shake_steps, "every": every}
    programs.ours("trough"), programs.need("liggghts")
    with ThreadPoolExecutor(len(cores)) as pool:
        both = list(pool.map(lambda k: one_seed(SEEDS[k], settings, cores[k % len(cores)]), range(seeds)))
    return settings, student.table(both, SHARE)

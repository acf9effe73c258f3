"""Feeds LIGGGHTS' recorded trajectories to the law as we read it, and says how far the forces are apart.

python3 -m sidebyside.replay, from bench/: prints the table of docs/peers.md, "What LIGGGHTS computes".
"""

from dataclasses import replace
from math import cos, pi, radians, sin

import numpy as np

from . import law, liggghts, programs
from .law import Choices

UP = np.array([0.0, 1.0, 0.0])


def at_contact(v, w, force, torque, mass, inertia, dt, choices):
    """Velocities that the force was computed with: half a step before those that are recorded."""
    if choices.velocity == "full":
        return v, w
    return v - dt / 2 * force / mass, w - dt / 2 * torque / inertia


def plane(P, rows, choices):
    """Predicted force and torque on a sphere at the plane y = 0, each step; rows as plane.in records them."""
    mass = 4 / 3 * pi * P["radius"]**3 * P["density"]
    E, G = law.effective(P["E"], P["nu"], P["Ew"], P["nuw"])
    pair = law.Pair(E, G, law.beta(P["e"]), P["mu"], P["radius"], mass)
    xi, out = np.zeros(3), np.zeros((len(rows), 6))
    for k, row in enumerate(rows):
        x, v, w, force, torque = row[1:16].reshape(5, 3)
        v, w = at_contact(v, w, force, torque, mass, 0.4 * mass * P["radius"]**2, P["dt"], choices)
        overlap = P["radius"] - x[1]
        if overlap <= 0:
            xi = np.zeros(3)
            continue
        r = -law.arm(P["radius"], overlap, choices) * UP
        f, xi = law.push(pair, overlap, UP, v + np.cross(w, r), xi, P["dt"], choices)
        out[k] = np.r_[f, np.cross(r, f)]
    return out


def pair(P, rows, choices):
    """Predicted force on the first of two spheres and torques on both, each step; rows as pair.in records them."""
    R = np.array([P["r1"], P["r2"]])
    m = 4 / 3 * pi * R**3 * P["density"]
    E, G = law.effective(P["E"], P["nu"], P["E"], P["nu"])
    constants = law.Pair(E, G, law.beta(P["e"]), P["mu"], R.prod() / R.sum(), m.prod() / m.sum())
    xi, out = np.zeros(3), np.zeros((len(rows), 9))
    for k, both in enumerate(rows):
        x, v, w, force, torque = both[:, 1:16].reshape(2, 5, 3).transpose(1, 0, 2)
        v, w = at_contact(v, w, force, torque, m[:, None], (0.4 * m * R**2)[:, None], P["dt"], choices)
        distance = np.linalg.norm(x[0] - x[1])
        overlap, n = R.sum() - distance, (x[0] - x[1]) / distance
        if overlap <= 0:
            xi = np.zeros(3)
            continue
        r0, r1 = (-law.arm(R[0], overlap, choices) * n, law.arm(R[1], overlap, choices) * n)
        slip = v[0] + np.cross(w[0], r0) - v[1] - np.cross(w[1], r1)
        f, xi = law.push(constants, overlap, n, slip, xi, P["dt"], choices)
        out[k] = np.r_[f, np.cross(r0, f), np.cross(r1, -f)]
    return out


def turn(q):
    """Rotation matrix of a quaternion (scalar first)."""
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def clump(P, spheres, bodies, choices):
    """Predicted force and torque on every sphere of a clump at the plane y = 0, each step; as clump.in records them."""
    E, G = law.effective(P["E"], P["nu"], P["Ew"], P["nuw"])
    xi, out = np.zeros((spheres.shape[1], 3)), np.zeros((*spheres.shape[:2], 6))
    for k, (rows, body) in enumerate(zip(spheres, bodies)):
        X, V, W, A, inertia, M = body[:3], body[3:6], body[6:9], turn(body[9:13]), body[13:16], body[16]
        x, force, torque, R = rows[:, 1:4], rows[:, 10:13], rows[:, 13:16], rows[:, 16]
        if choices.velocity == "half":
            V = V - P["dt"] / 2 * force.sum(0) / M
            L = inertia * (A.T @ W) - A.T @ (P["dt"] / 2 * (np.cross(x - X, force) + torque).sum(0))
            W = A @ (L / inertia)
        overlaps = R - x[:, 1]
        xi[overlaps <= 0] = 0
        for i in np.nonzero(overlaps > 0)[0]:
            mass = M if choices.mass == "body" else 4 / 3 * pi * R[i]**3 * P["density"]
            constants = law.Pair(E, G, law.beta(P["e"]), P["mu"], R[i], mass)
            r = -law.arm(R[i], overlaps[i], choices) * UP
            f, xi[i] = law.push(constants, overlaps[i], UP, V + np.cross(W, x[i] - X + r), xi[i], P["dt"], choices)
            out[k, i] = np.r_[f, np.cross(r, f)]
    return out


def oblique(degrees, **other):
    """A 2.5 mm sphere at 3.9 m/s against the rigid plane, `degrees` from the normal; Chung and Ooi 2011, test 4."""
    a = radians(degrees)
    return {"radius": 2.5e-3, "density": 4000.0, "E": 3.8e11, "nu": 0.23, "Ew": 1e20, "nuw": 0.23, "e": 0.98, "mu": 0.092,
            "y0": 2.50001e-3, "vx": 3.9 * sin(a), "vy": -3.9 * cos(a), "wz": 0.0, "g": 0.0, "dt": 1e-8, "nstep": 900,
            "every": 1, **other}


def two_spheres(**other):
    """Two unlike spheres, off centre and spinning; soft, so that they overlap much and their normal turns."""
    return {"r1": 5e-3, "r2": 2e-3, "density": 2500.0, "E": 5e6, "nu": 0.25, "e": 0.6, "mu": 3.0, "x1": 0.0, "y1": 0.0,
            "x2": 5e-3, "y2": 5e-3, "vx1": 1.0, "vy1": 2.5, "vx2": -0.5, "vy2": -2.0, "wz1": 100.0, "wz2": -300.0,
            "dt": 5e-7, "nstep": 4000, "every": 1, **other}


def cone(**other):
    """The 65-sphere cone on the thesis' lining, base down, sliding."""
    return {"spheres": str(programs.peer_file("common/cone65.txt")), "nspheres": 65, "density": 1665.71, "E": 4.6e8,
            "nu": 0.2887, "Ew": 2.5e7, "nuw": 0.25, "e": 0.3, "mu": 0.5, "y0": 6.7e-3, "vx": 0.3, "vy": -1.0, "q1": 1.0,
            "q2": 0.0, "q3": 0.0, "q4": 0.0, "g": 0.0, "dt": 2e-6, "nstep": 1500, "every": 1, **other}


def apart(predicted, recorded):
    """Largest difference of force and of torque over the largest recorded, the worse of the two."""
    parts = [np.s_[..., a:a + 3] for a in range(0, recorded.shape[-1], 3)]
    return max(np.abs(predicted[p] - recorded[p]).max() / np.abs(recorded[p]).max() for p in parts)


def recorded_cases():
    """Yields (name, function of the choices that gives the distance)."""
    tilted = {"q1": cos(0.3), "q4": sin(0.3), "y0": 10.4e-3}
    for name, P in [("oblique 20 deg, e 0.98, mu 0.092", oblique(20)), ("oblique 20 deg, e 0.5, mu 0.5", oblique(20, e=0.5, mu=0.5)),
                    ("oblique 5 deg, e 0.3, mu 0.2", oblique(5, e=0.3, mu=0.2)),
                    ("oblique 60 deg, e 0.3, mu 0.2", oblique(60, e=0.3, mu=0.2))]:
        _, rows = liggghts.trace(liggghts.run("plane.in", P).folder)
        yield name, lambda c, P=P, r=rows[:, 0]: apart(plane(P, r, c), r[:, 10:16])
    P = two_spheres()
    _, rows = liggghts.trace(liggghts.run("pair.in", P).folder)
    both = np.concatenate([rows[:, 0, 10:16], rows[:, 1, 13:16]], axis=1)
    yield "two soft spheres, 5 and 2 mm", lambda c: apart(pair(P, rows, c), both)
    for name, P in [("cone, base down", cone()), ("cone, tilted", cone(**tilted))]:
        folder = liggghts.run("clump.in", P).folder
        _, spheres = liggghts.trace(folder)
        _, bodies = liggghts.trace(folder, "body.dump")
        yield name, lambda c, P=P, s=spheres, b=bodies[:, 0]: apart(clump(P, s, b, c), s[:, :, 10:16])


def main():
    base = Choices()
    heads = ["as read"] + ["/".join(str(v) for k, v in vars(o).items() if v != getattr(base, k)) for o in law.OTHERS]
    print(liggghts.version())
    print(" | ".join(["case", *heads]))
    for name, distance in recorded_cases():
        print(" | ".join([name, *(f"{distance(replace(c)):.1e}" for c in [base, *law.OTHERS])]), flush=True)


if __name__ == "__main__":
    main()

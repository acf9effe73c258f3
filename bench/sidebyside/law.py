"""LIGGGHTS' "hertz tangential history", written out, with its choices as switches.

Replaying a recorded trajectory through a set of choices and comparing the forces tells which choices LIGGGHTS makes:
the right ones agree to rounding (docs/peers.md).
"""

from dataclasses import dataclass
from math import log, pi, sqrt

import numpy as np


@dataclass(frozen=True)
class Choices:
    lever: str = "half"        # half: R - d/2;  surface: R - d;  radius: R
    mass: str = "body"         # m* from the body's mass, or from the sphere's own
    slides_on: str = "spring"  # what is held against the limit: the spring, or the spring and the dashpot
    limit: str = "total"       # friction times |F_n| with its damping, or times the elastic part
    history: str = "project"   # project onto the present plane, or rotate with its length kept
    velocity: str = "half"     # half a step ago, or at the step


OTHERS = [Choices(lever="surface"), Choices(lever="radius"), Choices(mass="sphere"), Choices(slides_on="sum"),
          Choices(limit="elastic"), Choices(history="rotate"), Choices(velocity="full")]


@dataclass(frozen=True)
class Pair:
    E: float         # Pa, E*
    G: float         # Pa, G*
    beta: float      # -, ln e / sqrt(ln^2 e + pi^2)
    friction: float  # -
    radius: float    # m, R*
    mass: float      # kg, m*


def effective(E1, nu1, E2, nu2):
    """E*, G* in Pa."""
    return (1 / ((1 - nu1**2) / E1 + (1 - nu2**2) / E2),
            1 / (2 * (2 - nu1) * (1 + nu1) / E1 + 2 * (2 - nu2) * (1 + nu2) / E2))


def beta(e):
    return log(e) / sqrt(log(e)**2 + pi**2)


def push(pair, overlap, n, v, xi, dt, choices=Choices()):
    """Force on the first body (N) and the new spring (m). n points to the first body, v is its surface velocity
    relative to the second's at the contact (m/s), xi the spring before the step."""
    a = sqrt(pair.radius * overlap)
    k_n, k_t = 4 / 3 * pair.E * a, 8 * pair.G * a
    c_n = -2 * sqrt(5 / 6) * pair.beta * sqrt(2 * pair.E * a * pair.mass)
    c_t = -2 * sqrt(5 / 6) * pair.beta * sqrt(k_t * pair.mass)
    v_n = v @ n
    v_t = v - v_n * n
    f_n = k_n * overlap - c_n * v_n
    if choices.history == "rotate":
        length, flat = np.linalg.norm(xi), xi - (xi @ n) * n
        xi = flat * (length / np.linalg.norm(flat)) if length > 0 else xi
    xi = xi + v_t * dt
    xi = xi - (xi @ n) * n
    limit = pair.friction * abs(f_n if choices.limit == "total" else k_n * overlap)
    spring, dashpot = -k_t * xi, -c_t * v_t
    held = spring if choices.slides_on == "spring" else spring + dashpot
    size = np.linalg.norm(held)
    if size <= limit:
        return f_n * n + spring + dashpot, xi
    f_t = held * (limit / size)
    return f_n * n + f_t, -f_t / k_t


def arm(radius, overlap, choices):
    """Distance from a sphere's centre to the point where the force acts on it, m."""
    return radius - {"half": overlap / 2, "surface": overlap, "radius": 0.0}[choices.lever]

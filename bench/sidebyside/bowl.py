"""The same bowl, disc and cones under ours and LIGGGHTS: how much motion the disc puts into the media.

scenes/bowl.toml with cones twice as long and ten times softer, as bowl-quick.toml has them, of 36 spheres. Both codes get the same spheres, materials and step, and
the walls' triangles as `tumble walls` writes them; each fills the bowl in its own way. Paths part at once. What is
compared are means over the last 0.3 s of 0.6 s of turning, by when the bulk has forgotten its beginning.
"""

import csv
import json
import math
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from . import liggghts, programs, student
from .bulk import SEEDS

SCENE = programs.ROOT / "scenes" / "bowl.toml"
# The step is that of the small cones; `size` doubles it, too.
REDUCED = ("reduce.size=2", "material.media.youngs_modulus_Pa=4.6e7", "material.sensor.youngs_modulus_Pa=4.6e7",
           "time_step_s=5e-6", "contact.accepted_overlap=0.9")
REST, TURN, LATE = 0.7, 0.6, 0.3       # s: when the scene's disc begins to turn, how long it turns, what of it counts
FALL = 0.6                             # s, that LIGGGHTS' cones have to fall and come to rest
EVERY = 0.01                           # s, between rows
SHARE = 0.02                           # of LIGGGHTS' mean; differences below it count as agreement
LOW, RADIUS = 0.04, 0.1665             # m, the layer over the disc that the thesis sees move fastest; the bowl's radius


def flags(*sets):
    return [word for text in sets for word in ("--set", text)]


def our_run(seed, core, folder):
    """The run's resolved scene and its figures, per kg where masses differ (ours has the sensor's 28 g more)."""
    run = folder / "ours"
    programs.run([programs.tumble(), "run", SCENE, "--out", run, "--threads", 1, "--quiet",
                  *flags(*REDUCED, f"seed={seed}", f"duration_s={REST + TURN}", f"render.every_s={EVERY}")], [core], folder)
    from_s = REST + TURN - LATE
    with open(run / "series.csv") as lines:
        rows = [row for row in csv.DictReader(lines) if float(row["time_s"]) > from_s + EVERY / 2]
    mean = lambda name: np.mean([float(row[name]) for row in rows])
    flow = json.loads(programs.run([programs.tumble(), "flow", run, "--time", f"{from_s + EVERY / 2}:", "--body", "cone", "--radius",
                                    RADIUS, "--heights", f"0,{LOW}", "--rings", 1, "--layers", 1, "--quiet", "--json"],
                                   [core], folder).output)
    checked = json.loads(programs.run([programs.tumble(), "check", run / "scene.toml", "--json"], [core], folder).output)
    cones = next(body["wanted"] * body["mass_kg"] for body in checked["bodies"] if body["name"] == "cone")
    low = flow["layers"][0]
    scene = tomllib.loads((run / "scene.toml").read_text())
    return scene, {"translation_J_per_kg": mean("kinetic_translation_J") / checked["mass_kg"], "rms_vertical_m_s": mean("rms_velocity_y_m_s"),
                   "mean_speed_m_s": mean("mean_speed_m_s"), "centre_m": mean("centre_of_mass_y_m"),
                   "lowest_40_mm_speed_m_s": low["speed_m_s"], "lowest_40_mm_tangential_m_s": low["v_tangential_m_s"],
                   "lowest_40_mm_share": low["mass_kg"] / cones}


def their_run(seed, scene, core, folder):
    """LIGGGHTS with the scene's cones, materials, step and walls: its figures."""
    walls = folder / "walls"
    programs.run([programs.tumble(), "walls", SCENE, "--out", walls, "--quiet"], [core], folder)
    cone = folder / "cone.txt"
    cone.write_text("".join(" ".join(f"{number:.17g}" for number in sphere) + "\n" for sphere in scene["body"]["cone"]["spheres_m"]))
    media = scene["material"]["media"]

    def steps(time):
        return round(time / scene["time_step_s"])

    deck = {"N": scene["fill"][0]["count"], "seed": seed, "dt": scene["time_step_s"], "cone": str(cone), "bowl": str(walls / "bowl.stl"),
            "disc": str(walls / "disc.stl"), "density": media["density_kg_m3"], "media": media["youngs_modulus_Pa"],
            "lining": scene["material"]["lining"]["youngs_modulus_Pa"], "nset": steps(FALL), "nturn": steps(TURN),
            "every": steps(EVERY), "skin": 1.5e-3}
    ran = liggghts.run("bowl.in", deck, [core])
    late = steps(FALL + TURN - LATE) + 1
    rows = np.array([frame for step, frame in liggghts.frames(ran.folder / "body.dump") if step > late])
    x, v = rows[..., :3], rows[..., 3:6]
    around = (v[..., 0] * x[..., 2] - v[..., 2] * x[..., 0]) / np.maximum(np.hypot(x[..., 0], x[..., 2]), 1e-9)  # about +y
    speed, low = np.linalg.norm(v, axis=2), x[..., 1] < LOW
    return {"translation_J_per_kg": (v**2).sum(2).mean() / 2, "rms_vertical_m_s": math.sqrt((v[..., 1]**2).mean()),
            "mean_speed_m_s": speed.mean(), "centre_m": x[..., 1].mean(), "lowest_40_mm_speed_m_s": speed[low].mean(),
            "lowest_40_mm_tangential_m_s": around[low].mean(), "lowest_40_mm_share": low.mean()}


def one_seed(seed, core):
    folder = Path(tempfile.mkdtemp(prefix="tumble-bowl-"))
    scene, ours = our_run(seed, core, folder)
    return ours, their_run(seed, scene, core, folder)


def compare(seeds=2, cores=(0, 1)):
    """Settings, and a table as of student.table."""
    programs.tumble(), programs.need("liggghts")
    with ThreadPoolExecutor(len(cores)) as pool:
        both = list(pool.map(lambda k: one_seed(SEEDS[k], cores[k % len(cores)]), range(seeds)))
    return {"reduced": REDUCED, "rest_s": REST, "turn_s": TURN, "late_s": LATE}, student.table(both, SHARE)

#!/usr/bin/env python3
"""Makes the sealed cases of beds, tests/blind/beds/sealed/1 ... 9, from the repository's root:

    tests/blind/sealed_beds.py build/release/tumble tests/blind/beds/sealed [NUMBER...]

What each hides, how much of it and which seeds its runs have is drawn here by chance and told to nobody: it goes into the
case's sealed.txt, which `tumble reveal` opens. A case that has a sealed.txt already is measured again as that says; remove its
folder to draw another. Among the first draws of all, the phase, a load that is missing, rolling and nothing come up at least once each,
as do two causes at once and something that is no cause of the library: a half-order line in the trough's shaking, or a post on
the heap's floor.
"""
import json
import pathlib
import secrets
import subprocess
import sys
import tempfile

CHANCE = secrets.SystemRandom()
TROUGH = {"scene": "scenes/measured/trough/trough.toml", "time": "1.4:3",
          "measures": "circulation,surface_slope,bulk_height,rms_velocity_x",
          "causes": "exc.phase,exc.sideways,exc.rocking,grav.tilt_x,roll.coulomb,fric.wall,load.fill",
          "conditions": [("quarter load", (60, 60)), ("half load", (120, 120))], "standard": (60, 60),
          "own": ["time_step_s=4e-5", "body.disc.radius_mm=11.2", "body.small.radius_mm=9.8"],
          "hides": ["", "exc.phase", "load.fill"]}
HEAP = {"scene": "tests/blind/beds/heap.toml", "time": "1.3:1.5",
        "measures": "surface_slope_left,surface_slope_right,bulk_height",
        "causes": "roll.coulomb,fric.factor,rest.factor,load.fill,grav.tilt_x",
        "conditions": [("140 discs", (70, 70)), ("80 discs", (40, 40))], "standard": (70, 70),
        "own": ["time_step_s=3e-5", "body.small.radius_mm=3.5", "body.large.radius_mm=4.5"],
        "hides": ["", "roll.coulomb", "load.fill"]}
MORE_OF_TROUGH = {**TROUGH, "hides": ["exc.phase+load.fill", "half-order-line"]}
MORE_OF_HEAP = {**HEAP, "hides": ["roll.coulomb+load.fill", "post-on-floor"]}
CASES = [TROUGH, TROUGH, TROUGH, HEAP, HEAP, MORE_OF_TROUGH, MORE_OF_TROUGH, MORE_OF_HEAP, MORE_OF_HEAP]
SEEDS = 4


AMPLITUDES = {"exc.phase": lambda: CHANCE.choice([-1, 1]) * CHANCE.randint(55, 125),
              "load.fill": lambda: -CHANCE.choice([2, 3, 4, 5]) / 20, "roll.coulomb": lambda: CHANCE.randint(9, 19) / 100,
              "half-order-line": lambda: CHANCE.randint(20, 40) / 1e4,  # m, upright
              "post-on-floor": lambda: CHANCE.randint(12, 20) / 1e3}    # m, its height
UNLISTED = {  # what is written under the scene that is measured
    "half-order-line": '[[wall.motion]]\nkind = "harmonic"\naxis = "y"\namplitude_m = {}\nfrequency_Hz = 12.5\nstart_s = 1.0\n',
    "post-on-floor": '[[wall]]\nname = "post"\nshape = "segment"\nfrom_m = [0.03, -0.004]\nto_m = [0.03, {}]\nmaterial = "glass"\n'}


def drawn(effects):
    """The answer for one case: amplitudes that a laboratory would not call small."""
    hidden = [{"id": one, "listed": one not in UNLISTED, "amplitude": AMPLITUDES[one]()} for one in effects.split("+") if one]
    kind = "null" if not hidden else "two" if len(hidden) > 1 else "listed" if hidden[0]["listed"] else "unlisted"
    return {"kind": kind, "hidden": hidden, "first_seed": CHANCE.randint(10**5, 10**9)}


def hiding(answer):
    """Sets under all conditions, by what the numbers of bodies are multiplied, and what stands under the scene."""
    sets, share, under = [], 1, ""
    for hidden in answer["hidden"]:
        if hidden["id"] == "exc.phase":
            sets.append(f"wall.trough.motion.1.phase_deg={hidden['amplitude']}")
        elif hidden["id"] == "roll.coulomb":
            sets += ["contact.rolling=cdt", f"pair.glass-glass.rolling_friction={hidden['amplitude']}"]
        elif hidden["id"] == "load.fill":
            share = 1 + hidden["amplitude"]
        else:
            under = UNLISTED[hidden["id"]].format(hidden["amplitude"])
    return sets, share, under


def measured(tumble, bed, answer):
    """measurement.toml, by measured_bed.py."""
    sets, share, under = hiding(answer)
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as scene:
        scene.write(pathlib.Path(bed["scene"]).read_text() + "\n" + under)
        scene.flush()
        return measured_in(scene.name, tumble, bed, answer, sets, share)


def measured_in(scene, tumble, bed, answer, sets, share):
    command = [str(pathlib.Path(__file__).with_name("measured_bed.py")), tumble, scene, "--time", bed["time"],
               "--measures", bed["measures"], "--causes", bed["causes"], "--title", "A bed with something hidden in it, or nothing",
               "--seeds", f"{answer['first_seed']}:{answer['first_seed'] + SEEDS - 1}", "--hide", *bed["own"], *sets]
    for name, counts in bed["conditions"]:
        told = "" if counts == bed["standard"] else " ".join(f"fill.{k}.count={n}" for k, n in enumerate(counts))
        untold = " ".join(f"fill.{k}.count={round(n * share)}" for k, n in enumerate(counts))
        command += ["--condition", f"{name}: {told} | {untold}"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def unsealed(file):
    return json.loads(bytes.fromhex(file.read_text().splitlines()[-1]))


def main():
    tumble, out = sys.argv[1], pathlib.Path(sys.argv[2])
    while True:
        effects = [CHANCE.choice(bed["hides"]) for bed in CASES]
        if set(effects) >= {one for bed in CASES for one in bed["hides"]}:
            break
    for number, (bed, effect) in enumerate(zip(CASES, effects), 1):
        if sys.argv[3:] and str(number) not in sys.argv[3:]:
            continue
        case = out / str(number)
        seal = case / "sealed.txt"
        if not seal.exists():
            case.mkdir(parents=True, exist_ok=True)
            seal.write_text("`tumble reveal` reads this.\n" + json.dumps(drawn(effect)).encode().hex() + "\n")
        note = f"# Against {bed['scene']}; `tumble reveal {out}/{number}` opens sealed.txt.\n"
        (case / "measurement.toml").write_text(note + measured(tumble, bed, unsealed(seal)))


if __name__ == "__main__":
    main()

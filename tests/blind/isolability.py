#!/usr/bin/python3
"""What each experiment can tell apart: its own simulation as data, with noise, and the share of every cause's effect that
the others leave. Prints Markdown for docs/diagnosis.md.

    tests/blind/isolability.py build/release/tumble [EXPERIMENT...]
"""
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def leaning(degrees):
    slope = math.radians(degrees)
    return f"gravity_m_s2=[{9.81 * math.sin(slope):.6f}, {-9.81 * math.cos(slope):.6f}, 0.0]"


def offset(spread):
    return f'instrument = "clock_offset"\nper = "series"\nspread = {spread}'


FRICTION = 'key = "pair.{}.friction"\nspread = 0.03'
DROPS = [[f"fill.0.position_m.1={0.12 + height}"] for height in (0.5, 0.8, 1.1, 1.5)]
LIGHT = [[f"fill.0.position_m.1={0.12 + height}", "body.ball.mass_kg=0.15"] for height in (0.8, 1.4)]
THROWS = [[f"fill.0.velocity_m_s.0={speed}"] for speed in (2.5, -2.5, 1.4, -1.4)]
ON_SLOPE = [[f"fill.0.velocity_m_s.0={2.0 * way}", leaning(-3 * way)] for way in (1, -1)]
ROLLED = [[f"fill.0.velocity_m_s.0={v}", f"fill.0.angular_velocity_rad_s.2={-v / 0.05}"] for v in (1.0, -1.0, 0.5, -0.5)]
OBLIQUE = [["fill.0.position_m.1=0.15", f"fill.0.velocity_m_s=[{3 * math.sin(math.radians(a)):.5f}, "
            f"{-3 * math.cos(math.radians(a)):.5f}, 0.0]"] for a in (10, 25, 40, 55, 70, 80)]
WAY = [("way", "centre_of_mass_x", 2e-3)]
SPEED = "key = \"fill.0.velocity_m_s.0\"\nper = \"series\"\nspread = 0.03"

EXPERIMENTS = {  # scene, sets of each record, columns (head, measure, sigma), nuisances, duration, readings a second, clock
    "drops": ("bounce", DROPS, [("height", "centre_of_mass_y", 2e-3)],
              ['key = "pair.leather-wood.restitution"\nspread = 0.05', offset(0.005)], 2.5, 120, False),
    "drops, light ball, clock": ("bounce", DROPS + LIGHT, [("height", "centre_of_mass_y", 2e-3)],
                                 ['key = "pair.leather-wood.restitution"\nspread = 0.05', offset(0.005)], 2.5, 120, True),
    "slope, sliding": ("slope", [[leaning(a)] for a in (18, -18, 24, -24, 30, -30)], WAY,
                       [FRICTION.format("plastic-board"), offset(0.005)], 0.8, 100, False),
    "throws": ("lane", THROWS, WAY, [FRICTION.format("rubber-wood"), SPEED, offset(0.005)], 3.0, 60, False),
    "throws, slope, clock": ("lane", THROWS + ON_SLOPE, WAY, [FRICTION.format("rubber-wood"), SPEED, offset(0.005)], 3.0, 60,
                             True),
    "roll-out": ("lane", ROLLED, WAY, [SPEED, offset(0.005)], 3.0, 60, False),
    "oblique impact": ("lane", OBLIQUE, WAY + [("height", "centre_of_mass_y", 2e-3), ("spin", "angular_speed_max", 0.5)],
                       ['key = "pair.rubber-wood.restitution"\nspread = 0.05', FRICTION.format("rubber-wood"), offset(0.002)],
                       0.4, 200, False),
    "spin-down": ("slope", [["gravity_m_s2=[0.0, -9.81, 0.0]", f"fill.0.angular_velocity_rad_s.1={w}"]
                            for w in (40, -40, 20, -20)], [("spin", "angular_speed_max", 0.2)],
                  [FRICTION.format("plastic-board"), offset(0.002)], 0.3, 200, False),
    "ball on a shaking plate": ("plate", [[f"wall.0.motion.0.amplitude_m={0.00155262 * g:.6f}"] for g in (1.3, 1.6, 2.0, 2.4)],
                                [("height", "centre_of_mass_y", 5e-4)],
                                ['key = "pair.plastic-steel.restitution"\nspread = 0.05', offset(0.001)], 0.6, 200, False),
}


def recorded(tumble, scene, sets, columns, duration, rate, folder):
    """Time and columns as the program itself gives them."""
    words = [tumble, "run", str(ROOT / "scenes" / f"{scene}.toml"), "--out", str(folder), "--force", "--quiet",
             "--duration", str(duration), "--set", f"observe.every_s={1 / rate}",
             "--set", "observe.measures=" + json.dumps([measure for _, measure, _ in columns])]
    for one in sets:
        words += ["--set", one]
    subprocess.run(words, check=True, capture_output=True)
    with open(folder / "series.csv") as file:
        rows = list(csv.DictReader(file))
    return rows


def case(tumble, folder, scene, records, columns, nuisances, duration, rate, clock):
    noise = random.Random(1)
    toml = "".join(f"[[nuisance]]\n{one}\n" for one in nuisances)
    for number, sets in enumerate(records):
        rows = recorded(tumble, scene, sets, columns, duration, rate, folder / "run")
        heads = {head: next(key for key in rows[0] if key.startswith(measure)) for head, measure, _ in columns}
        units = {head: heads[head][len(measure) + 1:] for head, measure, _ in columns}
        lines = ["time_s," + ",".join(f"{head}_{units[head]}" for head in heads) + (",clock_s" if clock else "")]
        for row in rows:
            cells = [f"{float(row[heads[head]]) + noise.gauss(0, sigma):.7g}" for head, _, sigma in columns]
            lines.append(",".join([row["time_s"], *cells] + ([f"{float(row['time_s']) + noise.gauss(0, 1e-3):.6f}"] if clock else [])))
        (folder / f"{number}.csv").write_text("\n".join(lines) + "\n")
        toml += f'[[series]]\nname = "{number}"\nfile = "{number}.csv"\nset = {json.dumps(sets)}\n'
        for head, measure, sigma in columns:
            toml += f'[[series.column]]\nhead = "{head}"\nmeasure = "{measure}"\nsigma = {sigma}\n'
        if clock:
            toml += '[[series.column]]\nhead = "clock"\nmeasure = "time"\nsigma = 1e-3\n'
    (folder / "m.toml").write_text(toml)


def main():
    tumble = str(pathlib.Path(sys.argv[1]).resolve())
    for name in sys.argv[2:] or EXPERIMENTS:
        scene = EXPERIMENTS[name][0]
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            case(tumble, folder, *EXPERIMENTS[name])
            done = subprocess.run([tumble, "diagnose", str(ROOT / "scenes" / f"{scene}.toml"), "--data", str(folder / "m.toml"),
                                   "--json", "--quiet"], capture_output=True, text=True)
        if done.returncode:
            print(f"\n### {name}\n\n{done.stdout}{done.stderr}")
            continue
        found = json.loads(done.stdout)
        ids = [cause["id"] for cause in found["library"]]
        left = found["isolability"]
        shown = [k for k in range(len(ids)) if left[k][k] is not None]
        print(f"\n### {name}: `scenes/{scene}.toml`\n\n{found['outcome'].capitalize()}, {found['readings']} readings.\n")
        print("| | smallest, 3 se | " + " | ".join(f"`{ids[k]}`" for k in shown) + " |")
        print("| --- " * (len(shown) + 2) + "|")
        for i in shown:
            cells = ["" if i == j else f"**{left[i][j]:.2f}**" if left[i][j] < 0.05 else f"{left[i][j]:.2f}" for j in shown]
            print(f"| `{ids[i]}` | {3 * found['library'][i]['standard_error']:.2g} | " + " | ".join(cells) + " |")
        print(flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""What each experiment can tell apart: its own simulation as data, with noise, and the share of every cause's effect that
the others leave. The tables of docs/diagnosis.md are its output.

    tests/blind/isolability.py build/release/tumble [EXPERIMENT...]             # prints them
    tests/blind/isolability.py build/release/tumble --write [EXPERIMENT...]     # puts them into the page
    tests/blind/isolability.py build/release/tumble --check [EXPERIMENT...]     # holds the page against them
"""
import argparse
import csv
import json
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "diagnosis.md"


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
WAY = [("way", "centre_of_mass_x", 2e-3)]
SPEED = "key = \"fill.0.velocity_m_s.0\"\nper = \"series\"\nspread = 0.03"

EXPERIMENTS = {  # of records: scene, sets of each record, columns (head, measure, sigma), nuisances, duration, readings a second, clock
    "one drop": ("bounce", DROPS[2:3], [("height", "centre_of_mass_y", 2e-3)],
                 ['key = "pair.leather-wood.restitution"\nspread = 0.05', offset(0.005)], 2.5, 120, False),
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
    "spin-down": ("slope", [["gravity_m_s2=[0.0, -9.81, 0.0]", f"fill.0.angular_velocity_rad_s.1={w}"]
                            for w in (40, -40, 20, -20)], [("spin", "angular_speed_max", 0.2)],
                  [FRICTION.format("plastic-board"), offset(0.002)], 0.3, 200, False),
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


def beds(scene, measurement, seeds):
    """A bed's table, from the numbers measured of it and the runs that are kept beside its scene: none is made."""
    def command(tumble, folder):
        kept = shutil.copy((ROOT / scene).with_suffix(".response.csv"), folder)
        return [tumble, "diagnose", str(ROOT / scene), "--data", str(ROOT / measurement), "--seeds", str(seeds), "--table",
                str(kept), "--old-runs"]
    return command


def records(name):
    def command(tumble, folder):
        case(tumble, folder, *EXPERIMENTS[name])
        scene = ROOT / "scenes" / f"{EXPERIMENTS[name][0]}.toml"
        return [tumble, "diagnose", str(scene), "--data", str(folder / "m.toml")]
    return command


def of_the_generator(bench, scene):
    """A case of blindgen's with nothing hidden: impacts that need finer steps than a run takes."""
    def command(tumble, folder):
        blindgen = pathlib.Path(tumble).parent / "tests" / "blind" / "blindgen"
        subprocess.run([blindgen, folder, "1", "77", bench, "null", "nothing", "5"], check=True, capture_output=True)
        return [tumble, "diagnose", str(ROOT / "scenes" / f"{scene}.toml"), "--data", str(folder / "case-0000" / "measurement.toml")]
    return command


COMMANDS = {name: records(name) for name in EXPERIMENTS}
COMMANDS["oblique"] = of_the_generator("oblique", "lane")
COMMANDS["plate"] = of_the_generator("plate", "plate")
COMMANDS["trough"] = beds("scenes/measured/trough/trough.toml", "scenes/measured/trough/measurement.toml", 6)
COMMANDS["heap"] = beds("tests/blind/beds/heap.toml", "tests/blind/beds/rolling.toml", 4)


def table_of(tumble, name):
    with tempfile.TemporaryDirectory() as place:
        command = COMMANDS[name](tumble, pathlib.Path(place))
        done = subprocess.run([*command, "--json", "--quiet"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{name}: {done.stdout}{done.stderr}")
    found = json.loads(done.stdout)
    ids = [cause["id"] for cause in found["library"]]
    left = found["isolability"]
    shown = [k for k in range(len(ids)) if left[k][k] is not None]
    if not shown:
        sys.exit(f"{name}: {found['verdict']}")
    lines = ["| | least | " + " | ".join(f"`{ids[k].split('.')[1]}`" for k in shown) + " |",
             "| --- " * (len(shown) + 2) + "|"]
    for i in shown:
        cells = ["" if i == j else f"**{left[i][j]:.2f}**" if left[i][j] < 0.055 else f"{left[i][j]:.2f}" for j in shown]
        lines.append(f"| `{ids[i]}` | {3 * found['library'][i]['standard_error']:.2g} | " + " | ".join(cells) + " |")
    return lines


def marker(name):
    return f"<!-- isolability.py: {name} -->"


def on_the_page(page, name):
    """Where the table begins and ends."""
    found = re.search(re.escape(marker(name)) + r"\n\n((?:.+\n)+)", page)
    if not found:
        sys.exit(f"{PAGE}: it has no table of '{name}': add {marker(name)} and run this with --write")
    return found.span(1)


def differences(name, old, new):
    """Where two tables are not in step: other causes, a share off by more than 0.03, a least amplitude by a tenth."""
    def cells(lines):
        return [[cell.strip(" `*") for cell in line.strip("|").split("|")] for line in lines]
    old, new = cells(old), cells(new)
    if [row[0] for row in old] != [row[0] for row in new] or old[0] != new[0]:
        return [f"{name}: the page lists {', '.join(row[0] for row in old[2:])}; there show {', '.join(row[0] for row in new[2:])}"]
    wrong = []
    for was, now in zip(old[2:], new[2:]):
        if abs(float(was[1]) / float(now[1]) - 1) > 0.1:
            wrong.append(f"{name}: least {was[0]} is {was[1]} on the page, {now[1]} in fact")
        for other, a, b in zip(old[0][2:], was[2:], now[2:]):
            if a and abs(float(a) - float(b)) > 0.03:
                wrong.append(f"{name}: of {was[0]} {other} leaves {a} on the page, {b} in fact")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tumble")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("experiments", nargs="*", metavar="EXPERIMENT", help="; ".join(COMMANDS))
    args = parser.parse_intermixed_args()
    tumble = str(pathlib.Path(args.tumble).resolve())
    wrong = []
    if args.check:
        wrong += [f"{PAGE}: '{name}' is no experiment of this script"
                  for name in re.findall(r"<!-- isolability.py: (.+) -->", PAGE.read_text()) if name not in COMMANDS]
        for name in COMMANDS:
            on_the_page(PAGE.read_text(), name)
    for name in args.experiments or COMMANDS:
        lines = table_of(tumble, name)
        if args.write:
            page = PAGE.read_text()
            begin, end = on_the_page(page, name)
            PAGE.write_text(page[:begin] + "\n".join(lines) + "\n" + page[end:])
        elif args.check:
            page = PAGE.read_text()
            wrong += differences(name, page[slice(*on_the_page(page, name))].splitlines(), lines)
        else:
            print(f"\n**{name}**\n\n" + "\n".join(lines), flush=True)
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()

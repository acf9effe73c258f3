#!/usr/bin/python3
"""Blind tests of `tumble diagnose`: hide an effect, demand it back.

    tests/blind/judge.py build/release/tumble build/release/tests/blind/blindgen --cases 200

blindgen writes cases and commitments; its answers stay in this program's memory until every diagnosis is written, and
are then held against their commitments. Every diagnosis runs in a folder that holds its case and the scene, nothing
else. A seed is drawn unless one is given; it is printed, and thresholds apply to seeds drawn.
"""
import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import secrets
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / "scenes" / "bounce.toml"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tumble")
    parser.add_argument("blindgen")
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--seed", type=int, help="drawn where none is given")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", nargs=3, metavar=("KIND", "EFFECT", "SIZE"), help="all cases alike")
    parser.add_argument("--keep", type=pathlib.Path, help="leave cases and diagnoses in this folder")
    parser.add_argument("--json", action="store_true", help="print figures as JSON")
    return parser.parse_args()


def make_cases(args, folder):
    only = args.only or []
    made = subprocess.run([args.blindgen, folder, str(args.cases), str(args.seed), *only],
                          capture_output=True, text=True, check=True)
    return [json.loads(line) for line in made.stdout.splitlines()]


def diagnose(tumble, folder):
    shutil.copy(SCENE, folder / "scene.toml")
    begun = time.monotonic()
    done = subprocess.run([tumble, "diagnose", "scene.toml", "--data", "measurement.toml", "--json", "--quiet"],
                          cwd=folder, capture_output=True, text=True)
    (folder / "diagnosis.json").write_text(done.stdout)
    if done.returncode != 0:
        return {"outcome": "FAILED", "causes": [], "pairs": [], "what": done.stdout[-400:] + done.stderr[-400:], "took": 0}
    found = json.loads(done.stdout)
    found["took"] = time.monotonic() - begun
    return found


def verified(sealed, folder):
    """The answer, if it is the one that was committed to."""
    sealed_hash = hashlib.sha256((sealed["salt"] + sealed["answer"]).encode()).hexdigest()
    if sealed_hash != (folder / sealed["case"] / "commitment.txt").read_text().strip():
        sys.exit(f"{sealed['case']}: the answer is not the one committed to")
    return json.loads(sealed["answer"])


def verdict(answer, found):
    """One word for what was found, seen from the truth."""
    true = {h["id"] for h in answer["hidden"]}
    outcome = found["outcome"]
    named = set(found["causes"])
    pairs = [set(p) for p in found["pairs"]]
    if outcome.startswith("NAMED"):
        return "correct" if len(true) == 1 and true <= named else "misnamed"
    if outcome == "TWO CAUSES":
        return "correct pair" if named == true else "wrong pair"
    if outcome == "AMBIGUOUS":
        holds = any(p == true for p in pairs) if pairs else (len(true) == 1 and true <= named)
        return "ambiguous with truth" if holds else "ambiguous without truth"
    return {"CONSISTENT WITH THE BASELINE": "none", "NONE OF THE KNOWN CAUSES": "unknown", "UNSURE": "unsure",
            "CANNOT DECIDE": "cannot decide"}.get(outcome, "failed")


def tabulate(rows):
    """Counts of verdicts by kind and size."""
    words = ["correct", "misnamed", "ambiguous with truth", "ambiguous without truth", "none", "unknown", "unsure",
             "correct pair", "wrong pair", "cannot decide", "failed"]
    groups = {}
    for row in rows:
        key = (row["kind"], row["wanted"] if row["kind"] != "null" else 0)
        groups.setdefault(key, []).append(row["verdict"])
    print(f"{'kind':9} {'size':>5} {'cases':>6}  " + "  ".join(words))
    for (kind, size), found in sorted(groups.items()):
        counts = "  ".join(f"{found.count(w):{len(w)}d}" for w in words)
        print(f"{kind:9} {size:5.1f} {len(found):6d}  {counts}")


def confusion(rows):
    print("\nhidden -> answers (all sizes)")
    table = {}
    for row in rows:
        hidden = "+".join(row["hidden"]) or "nothing"
        answer = row["outcome"].split(",")[0].lower() + (": " + "+".join(row["causes"]) if row["causes"] else "")
        table.setdefault(hidden, {}).setdefault(answer, 0)
        table[hidden][answer] += 1
    for hidden, answers in sorted(table.items()):
        print(f"  {hidden:28} " + "; ".join(f"{n} x {a}" for a, n in sorted(answers.items(), key=lambda x: -x[1])))


def pulls(rows):
    """(found - true) / standard error of amplitudes of effects that were rightly named alone."""
    values = []
    for row in rows:
        if row["verdict"] == "correct" and row["fitted"] and row["fitted"][0]["id"] in row["hidden"]:
            fitted = row["fitted"][0]
            values.append((fitted["amplitude"] - row["amplitude"]) / fitted["standard_error"])
    if len(values) < 3:
        return None
    mean = sum(values) / len(values)
    spread = (sum((v - mean) ** 2 for v in values) / (len(values) - 1)) ** 0.5
    inside = sum(abs(v) < 1.96 for v in values)
    return {"cases": len(values), "mean": mean, "sd": spread, "inside_95": inside}


def main():
    args = arguments()
    args.tumble, args.blindgen = (str(pathlib.Path(p).resolve()) for p in (args.tumble, args.blindgen))
    args.seed = args.seed if args.seed is not None else secrets.randbits(48)
    folder = args.keep or pathlib.Path(tempfile.mkdtemp(prefix="blind-"))
    folder.mkdir(parents=True, exist_ok=True)
    sealed = make_cases(args, folder)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        found = list(pool.map(lambda s: diagnose(args.tumble, folder / s["case"]), sealed))
    rows = []
    for seal, one in zip(sealed, found):
        answer = verified(seal, folder)
        rows.append({"case": seal["case"], "kind": answer["kind"], "wanted": answer["wanted"], "design": answer["design"],
                     "hidden": [h["id"] for h in answer["hidden"]],
                     "amplitude": answer["hidden"][0]["amplitude"] if answer["hidden"] else 0,
                     "d": answer["d"], "d_sep": answer["d_sep"], "nearest": answer["nearest"],
                     "outcome": one["outcome"], "causes": one["causes"], "fitted": one.get("fitted", []),
                     "what": one.get("what", ""), "verdict": verdict(answer, one), "took": one["took"],
                     "settings": one.get("settings")})
    if not args.keep:
        shutil.rmtree(folder)
    if args.json:
        print(json.dumps({"seed": args.seed, "rows": rows}, indent=1))
        return
    settings = json.dumps(rows[0]["settings"], sort_keys=True)
    print(f"seed {args.seed}, settings {hashlib.sha256(settings.encode()).hexdigest()[:12]}, {len(rows)} cases, "
          f"{sum(r['took'] for r in rows) / len(rows):.1f} s each\n")
    tabulate(rows)
    confusion(rows)
    if pull := pulls(rows):
        print(f"\namplitudes rightly named: {pull['cases']}, pull {pull['mean']:+.2f} +- {pull['sd']:.2f}, "
              f"{pull['inside_95']} inside the 95 % interval")


if __name__ == "__main__":
    main()

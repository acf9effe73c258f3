#!/usr/bin/python3
"""Blind tests of `tumble diagnose`: hide an effect, demand it back.

    tests/blind/judge.py build/release/tumble build/release/tests/blind/blindgen --cases 200

blindgen writes cases and commitments; its answers stay in this program's memory until every diagnosis is written, and
are then held against their commitments. Every diagnosis runs in a folder that holds its case and the scene, nothing
else. A seed is drawn unless one is given; it is printed, and targets apply to seeds drawn: where the counts refute one (its
one-sided 95 % limit lies on the wrong side), the exit status is 1. The public seeds stand in
this file: what goes wrong there may be looked into, and what was mended by them is proved by others.

An ambiguous case whose first recommendation the generator can do is diagnosed again, with that one experiment and no other.
"""
import argparse
import concurrent.futures
import hashlib
import json
import math
import pathlib
import secrets
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "scenes"
PUBLIC = (16051, 16052, 16053, 16054)
MET = 0.96  # of a size: the generator meets it within 4 %, so that from there on an effect counts as being of that size


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tumble", nargs="?")
    parser.add_argument("blindgen", nargs="?")
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--seed", type=int, help="drawn where none is given")
    parser.add_argument("--public", action="store_true", help="so many cases of each public seed")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--at-least", type=float, metavar="SIZE", help="draw no smaller effects: sizes are 2, 3.5, 5 and 8")
    parser.add_argument("--only", nargs=4, metavar=("BENCH", "KIND", "EFFECT", "SIZE"), help="all cases alike")
    parser.add_argument("--keep", type=pathlib.Path, help="leave cases and diagnoses in this folder")
    parser.add_argument("--rows", type=pathlib.Path, help="append one JSON line a case to this file")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE",
                        help="a key of every measurement, such as margin_nats=1e-6: an ablation")
    parser.add_argument("--tell", type=pathlib.Path, nargs="+", help="judge nothing: the tables of such files")
    return parser.parse_args()


def make_cases(args, seed, folder):
    only = args.only or ([str(args.at_least)] if args.at_least else [])
    made = subprocess.run([args.blindgen, folder, str(args.cases), str(seed), *only],
                          capture_output=True, text=True, check=True)
    print(made.stderr, end="")
    return [json.loads(line) for line in made.stdout.splitlines()]


def diagnose(tumble, folder, scene, sets):
    shutil.copy(SCENES / scene, folder / "scene.toml")
    measurement = folder / "measurement.toml"
    measurement.write_text("".join(f"{one}\n" for one in sets) + measurement.read_text())
    begun = time.monotonic()
    done = subprocess.run([tumble, "diagnose", "scene.toml", "--data", "measurement.toml", "--json", "--quiet"],
                          cwd=folder, capture_output=True, text=True)
    (folder / "diagnosis.json").write_text(done.stdout)
    if done.returncode != 0:
        return {"outcome": "FAILED", "causes": [], "pairs": [], "what": done.stdout[-400:] + done.stderr[-400:], "took": 0}
    found = json.loads(done.stdout)
    found["took"] = time.monotonic() - begun
    return found


def asked(found):
    """The experiment that is recommended first, of an ambiguous case; else none."""
    return found["experiments"][0]["id"] if found["outcome"] == "AMBIGUOUS" and found["experiments"] else ""


def follows(sealed):
    """Of which case a sealed one is, and the experiment that was added to it; "" where none was."""
    case, _, experiment = sealed["case"][len("case-"):].partition("-")
    return f"case-{case}", experiment


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
        key = (row["kind"], row["wanted"] if row["hidden"] else 0)
        groups.setdefault(key, []).append(row["verdict"])
    print(f"{'kind':9} {'size':>5} {'cases':>6}  " + "  ".join(words))
    for (kind, size), found in sorted(groups.items()):
        counts = "  ".join(f"{found.count(w):{len(w)}d}" for w in words)
        print(f"{kind:9} {size:5.1f} {len(found):6d}  {counts}")


def confusion(rows):
    print("\nhidden -> answers (all sizes)")
    table = {}
    for row in rows:
        hidden = row["bench"] + ": " + ("+".join(row["hidden"]) or row["kind"])
        answer = row["outcome"].split(",")[0].lower() + (": " + "+".join(row["causes"]) if row["causes"] else "")
        table.setdefault(hidden, {}).setdefault(answer, 0)
        table[hidden][answer] += 1
    for hidden, answers in sorted(table.items()):
        print(f"  {hidden:36} " + "; ".join(f"{n} x {a}" for a, n in sorted(answers.items(), key=lambda x: -x[1])))


def rightly_fitted(rows):
    """What was fitted, and the truth, of effects that were rightly named alone."""
    return [(row["fitted"][0], row["amplitude"]) for row in rows
            if row["verdict"] == "correct" and row["fitted"] and row["fitted"][0]["id"] in row["hidden"]]


def inside(low, high, least, most):
    """What an interval of 95 % (low to high) makes of a figure that is to lie between `least` and `most`."""
    if low >= least and high <= most:
        return "proved"
    return "refuted" if high < least or low > most else "not refuted"


def amplitudes(rows):
    """Pull and coverage of amplitudes rightly named (Markdown). Whether a target is refuted."""
    found = rightly_fitted(rows)
    count = len(found)
    if count < 3:
        return False
    pulls = [(one["amplitude"] - truth) / one["standard_error"] for one, truth in found]
    mean = sum(pulls) / count
    spread = (sum((pull - mean) ** 2 for pull in pulls) / (count - 1)) ** 0.5
    error = spread / count ** 0.5
    about = 1.96 / (2 * (count - 1)) ** 0.5 * spread
    held = sum(one["low_95"] <= truth <= one["high_95"] for one, truth in found)
    low, high = bounds(held, count)
    words = [inside(mean - 1.96 * error, mean + 1.96 * error, -0.15, 0.15),
             inside(spread - about, spread + about, 0.9, 1.15), inside(low, high, 92, 98)]
    print(f"| pull of amplitudes rightly named: mean | within 0.15 | {mean:+.2f} +- {error:.2f}, {count} cases | {words[0]} |")
    print(f"| the same: standard deviation | 0.9 to 1.15 | {spread:.2f} (95 %: {spread - about:.2f} to {spread + about:.2f}) | {words[1]} |")
    print(f"| limits of 95 % that hold the truth | 92 to 98 % | {held} of {count}, {100 * held / count:.1f} % (95 %: {low:.1f} to {high:.1f}) | {words[2]} |")
    return "refuted" in words


def tail(hits, cases, p):
    """P(at least so many hits of so many cases) where each has probability p."""
    return sum(math.comb(cases, k) * p ** k * (1 - p) ** (cases - k) for k in range(hits, cases + 1))


def bounds(hits, cases):
    """Clopper and Pearson's one-sided 95 % limits of a rate, in per cent: below and above."""
    def solve(wanted):
        lo, hi = 0.0, 1.0
        for _ in range(60):
            middle = (lo + hi) / 2
            lo, hi = (middle, hi) if wanted(middle) else (lo, middle)
        return 100 * lo
    low = 0.0 if hits == 0 else solve(lambda p: tail(hits, cases, p) < 0.05)
    high = 100.0 if hits == cases else solve(lambda p: 1 - tail(hits + 1, cases, p) > 0.05)
    return low, high


def share(rows, chosen, good, wanted):
    """Of the table of targets: hits of cases, rate, limits; and what that makes of the target, "at least 95 %"."""
    cases = [r for r in rows if chosen(r)]
    hits = sum(good(r) for r in cases)
    if not cases:
        return "no case", "open"
    low, high = bounds(hits, len(cases))
    rate = 100 * hits / len(cases)
    least, limit = wanted.startswith("at least"), float(wanted.split()[2])
    if low >= limit if least else high <= limit:
        word = "proved"
    elif high < limit if least else low > limit:
        word = "refuted"
    else:
        word = "met" if (rate >= limit if least else rate <= limit) else "missed"
    return f"{hits} of {len(cases)}, {rate:.1f} % (95 %: {low:.1f} to {high:.1f})", word


def as_large_as(row, size):
    return row["d_sep"] >= MET * size


def targets(rows):
    """The promises, each with what was found (Markdown). Whether one is refuted."""
    listed = lambda r: r["kind"] == "listed"
    unlisted = lambda r: r["kind"] == "unlisted"
    said = lambda *words: lambda r: r["verdict"] in words
    single = said("correct", "misnamed")
    far = lambda r: unlisted(r) and as_large_as(r, 8)
    targets = [
        ("right name or class, d_sep >= 5", "at least 95 %", lambda r: listed(r) and as_large_as(r, 5), said("correct")),
        ("right name or class, d_sep >= 8", "at least 98 %", lambda r: listed(r) and as_large_as(r, 8), said("correct")),
        ("listed effect, confident wrong name or pair, any size", "at most 1 %", listed, said("misnamed", "wrong pair")),
        ("nothing hidden: confident name", "at most 1 %", lambda r: r["kind"] == "null", said("misnamed", "wrong pair")),
        ("nothing hidden: any alarm", "at most 2 %", lambda r: r["kind"] == "null", lambda r: r["verdict"] != "none"),
        ("not in the library, d_res >= 8: single name", "at most 3 %", far, said("misnamed")),
        ("the same, pairs too", "at most 10 %", far, said("misnamed", "wrong pair")),
        ("the same, flagged or ambiguous", "at least 90 %", far, said("unknown", "ambiguous without truth", "unsure")),
        ("not in the library, d_res >= 10: named, alone or as a pair", "at most 1 %",
         lambda r: unlisted(r) and as_large_as(r, 10), said("misnamed", "wrong pair")),
        ("two listed effects: another name or pair than theirs", "at most 1 %", lambda r: r["kind"] == "two",
         lambda r: r["verdict"] == "wrong pair" or (r["verdict"] == "misnamed" and not set(r["hidden"]) & set(r["causes"]))),
        ("noise and clocks out of the ordinary, nothing hidden: confident name", "at most 1 %",
         lambda r: r["kind"] == "distractor", said("misnamed", "wrong pair")),
        ("ambiguous, then the first experiment recommended, alone, d_sep >= 5", "at least 95 %",
         lambda r: r["kind"] == "loop" and as_large_as(r, 5), said("correct")),
        ("ambiguous: the set holds the truth", "at least 98 %",
         lambda r: listed(r) and r["verdict"].startswith("ambiguous"), said("ambiguous with truth")),
    ]
    print(f"\n{len(rows)} cases" + (", of public seeds: they prove nothing" if rows[0].get("public") else ""))
    print("\n| figure | target | found | which makes it |\n| --- | --- | --- | --- |")
    refuted = False
    for name, wanted, chosen, good in targets:
        found, word = share(rows, chosen, good, wanted)
        refuted = refuted or word == "refuted"
        print(f"| {name} | {wanted} | {found} | {word} |")
    return amplitudes(rows) or refuted


def normal(z):
    return 0.5 * math.erfc(-z / 2 ** 0.5)


def calibration(rows):
    """Naming rate beside Phi(d/2 - 3/d), which knows the margin, and that times Phi(d - root of the gate), which knows the gate, too;
    and whether the counts allow the rate to lie within 4 % of the latter, as the design wants. Whether they do not."""
    refuted = False
    print("\n| d_sep | cases | rightly named | margin | margin and gate | within 4 % |\n| --- | --- | --- | --- | --- | --- |")
    for low, high in ((1.5, 2.75), (2.75, 4.25), (4.25, 6.5), (6.5, 20)):
        some = [r for r in rows if r["kind"] == "listed" and low < r["d_sep"] <= high and r.get("gate")]
        if some:
            margins = [normal(r["d_sep"] / 2 - 3 / r["d_sep"]) for r in some]
            both = [m * normal(r["d"] - r["gate"] ** 0.5) for m, r in zip(margins, some)]
            hits = sum(r["verdict"] == "correct" for r in some)
            rate, foretold = 100 * hits / len(some), 100 * sum(both) / len(some)
            least, most = bounds(hits, len(some))
            word = "refuted" if least > foretold + 4 or most < foretold - 4 else "met" if abs(rate - foretold) <= 4 else "missed"
            refuted = refuted or word == "refuted"
            print(f"| {low:g} to {high:g} | {len(some)} | {rate:.0f} % | {100 * sum(margins) / len(some):.0f} % | {foretold:.0f} % | {word} |")
    return refuted


def loops(rows):
    """What was recommended first in ambiguous cases, and what came of it."""
    first = [r for r in rows if r.get("asked")]
    if not first:
        return
    print("\n| recommended first | cases | done | right afterwards | of them with d_sep >= 5 |\n| --- | --- | --- | --- | --- |")
    for experiment in sorted({r["asked"] for r in first}):
        done = [r for r in rows if r["kind"] == "loop" and r.get("added") == experiment]
        enough = [r for r in done if as_large_as(r, 5)]
        right = lambda some: f"{sum(r['verdict'] == 'correct' for r in some)} of {len(some)}"
        print(f"| {experiment} | {sum(r['asked'] == experiment for r in first)} | {len(done)} | {right(done)} | {right(enough)} |")


def told(rows):
    """Seeds drawn and public ones are never added up. Whether those drawn refute a target."""
    refuted = False
    for some in ([r for r in rows if not r.get("public")], [r for r in rows if r.get("public")]):
        if some:
            tabulate(some)
            confusion(some)
            missed = targets(some)
            loops(some)
            missed = calibration(some) or missed
            refuted = refuted or (missed and not some[0].get("public"))
    return refuted


def judged(args, seed):
    """One row a case."""
    folder = args.keep / str(seed) if args.keep else pathlib.Path(tempfile.mkdtemp(prefix="blind-"))
    folder.mkdir(parents=True, exist_ok=True)
    sealed = make_cases(args, seed, folder)
    found = {}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        def run(seals):
            found.update(zip([s["case"] for s in seals], pool.map(
                lambda s: diagnose(args.tumble, folder / s["case"], s["scene"], args.set), seals)))
        run([s for s in sealed if not follows(s)[1]])
        run([s for s in sealed if follows(s)[1] and asked(found[follows(s)[0]]) == follows(s)[1]])
    rows = []
    for seal in sealed:
        one = found.get(seal["case"])
        if not one:
            continue
        answer = verified(seal, folder)
        rows.append({"seed": seed, "public": seed in PUBLIC, "case": seal["case"], "kind": answer["kind"], "wanted": answer["wanted"],
                     "bench": answer["bench"], "more": answer["more"], "added": follows(seal)[1],
                     "asked": "" if follows(seal)[1] else asked(one),
                     "hidden": [h["id"] for h in answer["hidden"]],
                     "amplitude": answer["hidden"][0]["amplitude"] if answer["hidden"] else 0,
                     "d": answer["d"], "d_sep": answer["d_sep"], "nearest": answer["nearest"],
                     "outcome": one["outcome"], "causes": one["causes"], "fitted": one.get("fitted", []),
                     "what": one.get("what", ""), "verdict": verdict(answer, one), "took": one["took"],
                     "settings": one.get("settings"), "gate": one.get("gate", 0)})
    if not args.keep:
        shutil.rmtree(folder)
    return rows


def main():
    args = arguments()
    if args.tell:
        sys.exit(told([json.loads(line) for file in args.tell for line in file.read_text().splitlines()]))
    args.tumble, args.blindgen = (str(pathlib.Path(p).resolve()) for p in (args.tumble, args.blindgen))
    seeds = PUBLIC if args.public else [args.seed if args.seed is not None else secrets.randbits(48)]
    rows = [row for seed in seeds for row in judged(args, seed)]
    if args.rows:
        with args.rows.open("a") as out:
            out.writelines(json.dumps(row) + "\n" for row in rows)
    settings = json.dumps(rows[0]["settings"], sort_keys=True)
    print(f"seed {', '.join(map(str, seeds))}, settings {hashlib.sha256(settings.encode()).hexdigest()[:12]}, {len(rows)} cases, "
          f"{sum(r['took'] for r in rows) / len(rows):.1f} s each\n")
    sys.exit(told(rows))


if __name__ == "__main__":
    main()

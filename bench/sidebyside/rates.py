"""Steps per second, ours and the peer's, in turn on the same core: spheres (LAMMPS), trough (LIGGGHTS), a drum and what a
lecture shows (Box2D); discs alone."""

import json
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from statistics import median

from . import convergence, liggghts, programs


def spread(values):
    """[min, median, max], or nothing."""
    return [min(values), median(values), max(values)] if values else None


def lines_of(ran):
    """JSON lines of a bench program: (blocks, summary)."""
    rows = [json.loads(line) for line in ran.output.splitlines() if line.startswith("{")]
    return [row for row in rows if "block" in row], rows[-1]


def links(*names):
    """A new folder with links to files of the peers' decks, laid out as there."""
    root = Path(tempfile.mkdtemp(prefix="tumble-peer-"))
    for name in names:
        source = programs.peer_file(name)
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).symlink_to(source)
    return root


def attempt(problems, job, *words):
    """What the job gives, or nothing and its problem noted once."""
    try:
        return job(*words)
    except programs.Missing as problem:
        if str(problem) not in problems:
            problems.append(str(problem))
        return None


def result(case, unit, ours, peer, theirs, problems, **more):
    """The object that compare prints; ours: list of (rate, summary), theirs: list of (rate, MB)."""
    rates, peer_rates = [rate for rate, _ in ours], [rate for rate, _ in theirs]
    found = {"case": case, "unit": unit, "threads": 1, "tumble": spread(rates), "peer": peer, "peer_value": spread(peer_rates),
             "ratio": median(rates) / median(peer_rates) if rates and peer_rates else None,
             "peak_rss_MB": max((s["peak_rss_MB"] for _, s in ours), default=None),
             "peer_peak_rss_MB": max((mb for _, mb in theirs), default=None)}
    if ours:
        found["summary"] = ours[-1][1]
    if problems:
        found["problem"] = problems
    return {**found, **more}


def our_spheres(threads, pre, steps, cores):
    ran = programs.run([programs.ours("spheres"), f"state={programs.peer_file('spheres/state.data')}", f"threads={threads}",
                        f"pre={pre}", f"steps={steps}"], cores)
    blocks, summary = lines_of(ran)
    return blocks[-1]["rate"], summary


def lammps_spheres(style, pre, steps, core):
    """The deck takes 1000 steps first, as ours does."""
    folder = links("spheres/state.data", "spheres/spheres_lammps.in") / "spheres"
    ran = programs.run([programs.need("lmp"), "-in", "spheres_lammps.in", "-var", "style", style, "-var", "skin", "0.4e-3",
                        "-var", "nrun", steps, "-log", "none"], [core], folder)
    taken, seconds = liggghts.loops(ran.output)[-1]
    return 32000 * taken / seconds, ran.peak_rss_MB


def at_once(job, *words, cores):
    """The summed rate of as many independent runs as there are cores, each on its own: what the machine itself gains."""
    with ThreadPoolExecutor(len(cores)) as pool:
        return sum(rate for rate, _ in pool.map(lambda core: job(*words, [core]), cores))


def gain(two, one, machine):
    """Of two threads over one, and of two independent runs over one: cores that share hardware hold both down."""
    over_one = (lambda rates: median(rates) / median(one)) if one else (lambda rates: None)
    return {"tumble": spread(two), "gain": over_one(two) if two else None,
            "two_runs_at_once": spread(machine), "gain_of_two_runs": over_one(machine) if machine else None}


def spheres(repeats=3, steps=3000, core=0, other=1):
    """32,000 spheres in dense flow: one thread and two of ours, LAMMPS gran/hertz/history on one core."""
    one, two, machine, theirs, problems = [], [], [], [], []
    for _ in range(repeats):
        for keep, job, words in ((one, our_spheres, (1, 1000, steps, [core])),
                                 (theirs, lammps_spheres, ("hertz", 1000, steps, core)),
                                 (two, our_spheres, (2, 1000, steps, [core, other]))):
            got = attempt(problems, job, *words)
            if got is not None:
                keep.append(got)
        both = attempt(problems, lambda: at_once(our_spheres, 1, 1000, steps, cores=[core, other]))
        if both is not None:
            machine.append(both)
    return result("spheres", "body-steps/s", one, "lammps gran/hertz/history", theirs, problems,
                  two_threads=gain([rate for rate, _ in two], [rate for rate, _ in one], machine))


def our_discs(threads, steps, cores):
    """(rate, summary); the summary tells before and after the timed steps how dense the flow was and how fast."""
    ran = programs.run([programs.ours("discs"), f"threads={threads}", f"steps={steps}"], cores)
    blocks, summary = lines_of(ran)
    flow = next(json.loads(line) for line in ran.output.splitlines() if line.startswith('{"solid_fraction"'))
    return blocks[-1]["rate"], {**summary, "flow": flow}


def discs(repeats=3, steps=10000, core=0, other=1):
    """10,000 discs in dense flow down a slope, one thread and two; no peer here simulates discs."""
    one, two, problems = [], [], []
    for _ in range(repeats):
        for keep, threads, cores in ((one, 1, [core]), (two, 2, [core, other])):
            got = attempt(problems, our_discs, threads, steps, cores)
            if got is not None:
                keep.append(got)
    return result("discs", "disc-steps/s", one, None, [], problems,
                  two_threads=gain([rate for rate, _ in two], [rate for rate, _ in one], []))


# What tells of each scene whether its steps are short enough: a measure, averaged from a time on (s).
FIGURES = {"repose-2d": ("surface_slope_left", 2.6), "hopper-2d": ("centre_of_mass_y", 1.5), "drum-2d": ("surface_slope", 2.0),
           "shaken-bed-2d": ("centre_of_mass_y", 1.5), "trough-2d": ("surface_slope", 2.0)}
FIRST_SEED = 11


def flat(core, name, sets, *times):
    """What bench_scene2d prints of a shipped scene; timed from start to end, or as `times` say. "figure" is its measure."""
    measure, begins = FIGURES[name]
    scene = programs.ROOT / "scenes" / f"{name}.toml"
    ran = programs.run([programs.ours("scene2d"), f"scene={scene}", f"sets={','.join(sets)}", f"measure={measure}",
                        f"measured_from={begins}", *times], [core])
    got = json.loads([line for line in ran.output.splitlines() if line.startswith("{")][-1])
    figure = next(value for key, value in got.items() if key.startswith(measure))
    if figure is None:
        raise programs.Missing(f"{name} with {', '.join(sets)} has no {measure} to be measured from {begins} s on")
    return {**got, "figure": figure}


def half_step(got, solver):
    """The setting that halves the step of a run."""
    return f"{'box2d.' if solver == 'box2d' else ''}time_step_s={got['step_s'] / 2}"


def under_both(problems, core, name, seeds, *times):
    """{"soft": {"step": runs by seed, "half_step": the same}, "box2d": ...}, in turn: what others do meanwhile is shared."""
    kept = {solver: {"step": [], "half_step": []} for solver in ("soft", "box2d")}
    for seed in range(FIRST_SEED, FIRST_SEED + seeds):
        for solver, runs in kept.items():
            sets = [f"solver={solver}", f"seed={seed}"]
            whole = attempt(problems, flat, core, name, sets, *times)
            half = whole and attempt(problems, flat, core, name, [*sets, half_step(whole, solver)], *times)
            if half:
                runs["step"].append({**whole, "seed": seed})
                runs["half_step"].append({**half, "seed": seed})
    return kept


def held(problems, name, kept, comparisons):
    """Whether the figure of either solver stays when the step is halved; problems get what does not. `comparisons`: of the call."""
    found = {}
    for solver, runs in kept.items():
        if runs["step"]:
            found[solver] = convergence.halved(*([got["figure"] for got in runs[step]] for step in ("step", "half_step")), comparisons)
            said = convergence.complaint(f"{name}, {solver}", FIGURES[name][0], found[solver])
            problems += [said] if said else []
    return found


def video_seconds(name, cores):
    """From the scene to its video: seconds by the clock and of all cores together, and simulated seconds."""
    with tempfile.TemporaryDirectory(prefix="tumble-bench-") as folder:
        ran = programs.run([programs.tumble(), "run", programs.ROOT / "scenes" / f"{name}.toml", "--video", "--json", "--quiet",
                            "--out", f"{folder}/run"], cores)
    return {"seconds": ran.seconds, "processor_s": ran.processor_s, "simulated_s": json.loads(ran.output)["time_s"]}


def live(seeds=3, core=0):
    """What a lecture can show while it runs: the shipped scenes of two dimensions, whole, under soft contacts and under Box2D in
    turn, each once more in half its step, and how long the trough takes to its video."""
    problems, runs, soft, boxed = [], [], [], []
    for name in FIGURES:
        kept = under_both(problems, core, name, seeds)
        row = {solver: {"rate": median(got["rate"] for got in runs_of["step"]), "step_s": runs_of["step"][0]["step_s"],
                        "bodies": runs_of["step"][0]["bodies"]} for solver, runs_of in kept.items() if runs_of["step"]}
        if len(row) == 2:
            row["box2d"]["ratio"] = row["soft"]["rate"] / row["box2d"]["rate"]
        runs.append({"run": name, "tumble": row.get("soft", {}), "peer": row.get("box2d"),
                     "held": held(problems, name, kept, comparisons=2 * len(FIGURES))})
        soft += [(got["rate"], got) for got in kept["soft"]["step"]]
        boxed += [(got["rate"], got["peak_rss_MB"]) for got in kept["box2d"]["step"]]
    ratios = [run["peer"]["ratio"] for run in runs if run["peer"] and "ratio" in run["peer"]]
    return result("live", "simulated s per s of processor time", soft, "box2d", boxed, problems, runs=runs,
                  ratio=median(ratios) if ratios else None, trough_2d_video=attempt(problems, video_seconds, "trough-2d", None))


def hard(seeds=3, core=0):
    """The drum from 2 to 5 s under soft contacts and under Box2D, in turn, a run each per seed: simulated seconds per second of
    processor time, and of Box2D also without the books that are kept beside it. Each once more in half its step, Box2D also
    with twice the iterations: the slopes of the surface say whether the steps were short enough."""
    problems, times = [], ("from=2", "until=5")
    kept = under_both(problems, core, "drum-2d", seeds, *times)
    soft, boxed = kept["soft"]["step"], kept["box2d"]["step"]
    slopes = held(problems, "drum-2d", kept, comparisons=2)
    finer = [attempt(problems, flat, core, "drum-2d", ["solver=box2d", f"seed={got['seed']}", "box2d.velocity_iterations=40",
                                                       "box2d.position_iterations=16"], *times) for got in boxed]
    found = result("hard", "simulated s per s of processor time", [(got["rate"], got) for got in soft], "box2d",
                   [(got["rate"], got["peak_rss_MB"]) for got in boxed], problems, slopes=slopes,
                   slopes_twice_the_iterations=[got["figure"] for got in finer if got],
                   peer_without_books=spread([got["rate"] / (1 - got["books_share"]) for got in boxed]))
    if soft and boxed:
        found["ratio_in_half_steps"] = (median(got["rate"] for got in kept["soft"]["half_step"])
                                        / median(got["rate"] for got in kept["box2d"]["half_step"]))
    return found


def our_trough(blocks, steps, vibrate_blocks, vibrate_steps, cores, threads=1):
    """([(rate, summary) at rest], [(rate, summary) vibrating])"""
    ran = programs.run([programs.ours("trough"), f"state={programs.peer_file('trough/settled.dump')}", f"threads={threads}",
                        f"cone={programs.peer_file('common/cone65.txt')}", f"stl={programs.peer_file('trough/trough.stl')}",
                        f"blocks={blocks}", f"steps={steps}", f"vibrate_blocks={vibrate_blocks}",
                        f"vibrate_steps={vibrate_steps}"], cores)
    rows, summary = lines_of(ran)
    return tuple([(row["rate"], summary) for row in rows if row["block"] == name] for name in ("at rest", "vibrating"))


def our_trough_at_rest(blocks, steps, cores):
    """(median rate, summary)"""
    rest, _ = our_trough(blocks, steps, 0, 0, cores)
    return median(rate for rate, _ in rest), rest[-1][1]


def liggghts_trough(blocks, steps, vibrate_blocks, vibrate_steps, core):
    """The peers' deck at skin 1 mm: inserts 500 cones, settles them, then the timed runs."""
    folder = links("trough/trough_liggghts.in", "trough/trough.stl", "common/cone65.txt") / "trough"
    words = {"N": 500, "px": 1, "pz": 1, "sskin": 1e-3, "skin": 1e-3, "nset": 8000, "gset": 40, "npre": 500, "nst": steps,
             "nblk": blocks, "nrun": vibrate_steps, "nper": max(1, vibrate_blocks), "ybot": 0.05, "ytop": 0.6, "zi": 13}
    command = [programs.need("liggghts"), "-in", "trough_liggghts.in", "-log", "none", "-var", "v0", "-1.0"]
    for name, value in words.items():
        command += ["-var", name, value]
    ran = programs.run(command, [core], folder)
    rates = [(500 * taken / seconds, ran.peak_rss_MB) for taken, seconds in liggghts.loops(ran.output) if taken > 1]
    return rates[2:2 + blocks], rates[2 + blocks:]


def trough(repeats=2, steps=1500, core=0, other=1):
    """500 cones at rest and vibrating: ours before and after each LIGGGHTS run, which settles its cones first."""
    rest, shaken, two, machine, peer_rest, peer_shaken, problems = [], [], [], [], [], [], []
    for _ in range(repeats):
        for kept, job, words in (((rest, shaken), our_trough, (5, steps, 1, 14000, [core])),
                                 ((peer_rest, peer_shaken), liggghts_trough, (3, steps, 1, 14000, core)),
                                 ((two, []), our_trough, (5, steps, 0, 0, [core, other], 2)),
                                 ((rest, shaken), our_trough, (5, steps, 1, 14000, [core]))):
            got = attempt(problems, job, *words)
            for keep, values in zip(kept, got or ()):
                keep.extend(values)
        both = attempt(problems, lambda: at_once(our_trough_at_rest, 5, steps, cores=[core, other]))
        if both is not None:
            machine.append(both)
    vibrating = result("trough, vibrating", "body-steps/s", shaken, "liggghts", peer_shaken, [])
    return result("trough", "body-steps/s", rest, "liggghts", peer_rest, problems, vibrating=vibrating,
                  two_threads=gain([rate for rate, _ in two], [rate for rate, _ in rest], machine))

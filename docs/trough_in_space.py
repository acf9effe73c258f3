"""The part of docs/thrown-away-phase.md that the runs of scenes/measured/trough-3d make.

What is not in runs.csv is run, one after another on one core (trough_runs). What the text concludes is checked against
the runs: claims() has the sentences, and the page is not made where one does not hold.
"""
import math
import re
import statistics
import textwrap

from scatter import combined, difference, mean_of, ratio
from trough_runs import BLOCK_S, EQUAL, LOADS, LONG_S, TABLE, THESIS, TWICE, check_program, complete, stored

MEANS_S, LATE_S = (1.4, 3.8), 6.2  # what means are over; from when on long runs tell what lasts
FIRST_BLOCK, LAST_BLOCK = (MEANS_S[0], MEANS_S[0] + BLOCK_S), (MEANS_S[1] - BLOCK_S, MEANS_S[1])  # its ends
WIDER = float(EQUAL) / float(THESIS)

# The part of the page; {WORDS} and [settings] are filled in.
TEXT = """## In space: spheres and cones

[`spheres.toml`](../scenes/measured/trough-3d/spheres.toml) and [`cones.toml`](../scenes/measured/trough-3d/cones.toml)
are the thesis' trough in space, with its load per length (full) or a quarter of it. What is reduced, and what that
costs, stands in them. {RUNS} runs, {MINUTES} core minutes, are in [`runs.csv`](../scenes/measured/trough-3d/runs.csv).
{AGAIN} Circulation counts from y (up) towards z (across) here: what turns by a negative rate in the plane turns by a
positive one in space. Slopes have the same sign in both.

**What the numbers are of.** The trough shakes from 0.6 s on. Means are from 1.4 to 3.8 s, ± the standard deviation from
seed to seed. All comparisons and ratios below are of this stretch and of no other, and what lasts is another matter: a
full load of spheres that turns by {EARLY} rad/s in it turns by {LATE} from 6.2 s on. Widely shaken loads still get
steeper in it: full loads a quarter period apart slope by {SPHERES_FIRST} deg in its first 0.8 s and by {SPHERES_LAST}
in its last (spheres), {CONES_FIRST} and {CONES_LAST} (cones). What stands in brackets after a number is its interval of
95 %, from the scatter of few seeds.

**How soft the bodies are decides how fast a full load turns.** Media and lining have 1e7 Pa here; the thesis simulated
4.6e8 and 2.5e7. Twice as stiff, a full load of spheres turns {STIFF_TIMES} times as fast with the thesis' amplitudes
and a quarter period:

{STIFF}

In phase neither is told from rest: twice as stiff, seeds leave {STIFF_REST} rad/s. So rates below are of 1e7 Pa, are
not converged, and may not be compared with a machine's; that the phase makes a load turn, and to which side, holds with
both. Half the time step does not do it: one run gives {FINE} rad/s, {FINE_APART} from the seeds of the full one. Cones
are at 91 % of the stable step, with overlaps accepted up to 0.6 of a sphere's radius; none was run stiffer, or with a
smaller step.

**Full load**

{FULL}

**Quarter load**

{QUARTER}

**What a quarter period does**, against in phase: difference of the means, its interval, p by Welch's test.

{PHASE}

### Is the phase above the scatter, with the thesis' amplitudes?

**Yes, under both loads, with spheres and with cones**, for the circulation. In phase a full load of spheres turns by
{REST_SPHERES} rad/s, which its seeds do not tell from none; a quarter period ahead by
[spheres|full|thesis|90|circulation], a quarter period behind by [spheres|full|thesis|-90|circulation]. Cones turn a
little even in phase, {REST_CONES} rad/s, and by [cones|full|thesis|90|circulation] a quarter period ahead. The slope of
a full load of spheres shows the phase; that of cones does not with these seeds, which leave {CONES_SLOPE} deg.

**How fast, these runs do not say.** A full load of spheres goes round in {TURN} s with 1e7 Pa; in the 6 s for which the
thesis' simulation shook, it would have turned by {SIX} deg. With 2e7 Pa that is {STIFF_TURN} s and {STIFF_SIX} deg, and
the thesis' bodies were stiffer still. With 1e7 Pa it is in part the way to the slope. Spheres of seeds 4 to 6 were
shaken on:

{LASTS}

From 6.2 s on {LATE} rad/s are left, a turn in {LATE_TURN} s. So with the thesis' amplitudes the phase makes a full load
circulate, for as long as these runs go.

**At a quarter of the load the phase chooses the side.** In phase there is one slope, as the thesis' simulation had:
[spheres|quarter|thesis|0|slope] deg for spheres, [cones|quarter|thesis|0|slope] for cones. A quarter period ahead it is
[spheres|quarter|thesis|90|slope] and [cones|quarter|thesis|90|slope], down to the other side and about as steep:
steeper by {STEEPER_SPHERES} deg for spheres and {STEEPER_CONES} for cones. So that the machine's was steeper is not
explained by the phase, here as in the plane, but for what these intervals leave.

### What the sideways amplitude does

As wide across as upright, {WIDER} times the thesis' amplitude, and a quarter period ahead, a full load turns by
[spheres|full|equal|90|circulation] rad/s (spheres) and [cones|full|equal|90|circulation] (cones). Over this stretch,
with 1e7 Pa, that is {GROWN_SPHERES} and {GROWN_CONES} times as fast as with the thesis' amplitude; in its last 0.8 s
alone, {LAST_SPHERES} and {LAST_CONES}. Twice as stiff, spheres turn {GROWN_STIFF} times as fast. So these ratios are no
law of the width. In phase the width adds {WIDTH_SPHERES} rad/s to what spheres do and {WIDTH_CONES} to what cones do:
neither is told from nothing, and neither is as much as half of what a quarter period does at that width. So the phase
decides whether and to which side a full load turns, the amplitude across how fast. A quarter load gets steeper with the
width, in phase and out of it: [spheres|quarter|equal|0|slope] and [spheres|quarter|equal|90|slope] deg for spheres,
[cones|quarter|equal|0|slope] and [cones|quarter|equal|90|slope] for cones. The thesis' amplitude across is what one
sensor at one place of the machine saw. If it was too small for where the load is, that would make a load turn faster
and a quarter load stand steeper, as the machine's did; these runs cannot say that it was.

For orientation, LIGGGHTS with 2,000 spheres in a U trough, means over 3 s, a seed each; quoted, not made by the
command. Its trough, stiffness and axes are its own, and twice the stiffness alone changes a rate here by factors like
those between the two.

{LIGGGHTS}

There, too, the phase makes much of a wide shaking and little of the thesis'; three seeds of 3 s left that little barely
above the scatter, and more seeds set it apart here. Its load sloped by 7 to 8 deg when wide and a quarter period apart,
more than spheres do here ([spheres|full|equal|90|slope] deg); {CONES_WIDE_SEEDS} runs of cones do
[cones|full|equal|90|slope], and were not done sloping.

### Which of the two data can tell

Spheres, three shakings with the same amplitude across times the sine of the phase, and two in phase; under a quarter
load, one with the cosine reversed:

{TRADED}

How far the second and the third are from the first, with the interval and p:

{TOLD}

- **The circulation of a full load tells neither**, being one number. What it tells is about their product, amplitude
  times sine of the phase, and that with one stiffness only: without it, not even the product. Twice the thesis'
  amplitude at 30 deg and {WIDER} times that at 12 deg turn as the thesis' amplitude a quarter period apart does, but
  for {MOST_30} and {MOST_12} rad/s ({SHARE_30} and {SHARE_12} % of its {EARLY}): so much these seeds leave open, and
  less they could not tell. Those 12 deg add {TWELVE} rad/s to what the same width does in phase. Nor is the rate in
  proportion to the product: {WIDER} times that, at a quarter period, turns spheres {GROWN_SPHERES} times as fast, by
  {EXCESS_SPHERES} rad/s more than in proportion (cones {EXCESS_CONES}); counted from what each width does in phase, by
  {EXCESS_REST_SPHERES} (cones {EXCESS_REST_CONES}).
- **The full load's sideways speed tells the amplitude, and little of the phase**: [spheres|full|thesis|90|speed],
  [spheres|full|twice|30|speed] and [spheres|full|equal|11.96|speed] mm/s. A quarter period adds {SPEED_THESIS} mm/s
  with the thesis' amplitude and {SPEED_EQUAL} as wide as upright. With the circulation beside it both are told as far
  as the above goes, but for the sign of the cosine.
- **A quarter load beside the full one tells that sign.** It slopes and turns to the side of the cosine where that is
  large: [spheres|quarter|thesis|90|slope] deg at 90 deg, [spheres|quarter|twice|30|slope] and
  [spheres|quarter|equal|11.96|slope] at 30 and 12, and [spheres|quarter|twice|150|slope] at 150, where the sine is as
  at 30 and the cosine reversed.
- **The sensor tells both at once**, if its channels are read at the same instants, for the place where it sits.

None of this sets phase and amplitude apart from rocking or a tilt, which have not been run in space. Loads lie in a
thinner slice than the thesis', and the laboratory is missing: the thesis prints no slope and no circulation. A small
trough of spheres that is shaken as wide across as upright gives its phase to 2 degrees
([diagnosis.md](diagnosis.md))."""


class Numbers:
    """What the runs give, by name: circulation in rad/s, slope in deg, speed across in mm/s; one value a seed."""
    ACROSS = {"thesis": THESIS, "twice": TWICE, "equal": EQUAL}
    SHOWN = {"circulation": (1, 3, "circulation_rad_s"), "slope": (1, 1, "surface_slope_deg"),
             "speed": (1000, 1, "rms_velocity_z_m_s")}

    def __init__(self, runs):
        self.runs = runs

    def of(self, name, measure, window=MEANS_S, seeds_from=1):
        """Of "spheres|full|thesis|90": means over the blocks in the window, of the runs that are that long."""
        bodies, load, across, phase = name.split("|")
        factor, _, column = self.SHOWN[measure]
        runs = [rows for seed, rows in sorted(self.runs[bodies, load, self.ACROSS[across], phase].items())
                if seed >= seeds_from]
        inside = [[float(r[column]) for r in rows if window[0] - 1e-6 <= float(r["from_s"]) < window[1] - 1e-6]
                  for rows in runs]
        whole = round((window[1] - window[0]) / BLOCK_S)
        return [factor * statistics.mean(blocks) for blocks in inside if len(blocks) == whole]

    def change(self, one, other, measure):
        return difference(self.of(one, measure), self.of(other, measure))

    def shown(self, name, measure):
        """Mean and scatter from seed to seed; a single run has none."""
        return spread(self.of(name, measure), self.SHOWN[measure][1])

    def filled(self, text):
        """[spheres|full|thesis|90|circulation] becomes the mean of those runs."""
        def value(match):
            measure = match.group(2)
            return f"{statistics.mean(self.of(match.group(1), measure)):.{self.SHOWN[measure][1]}f}"
        return re.sub(r"\[((?:spheres|cones)(?:\|[-.\w]+){3})\|(\w+)\]", value, text)


def spread(values, digits):
    if len(values) == 1:
        return f"{values[0]:.{digits}f}"
    return f"{statistics.mean(values):.{digits}f} ± {statistics.stdev(values):.{digits}f}"


# Load, across, phase, words for it, what LIGGGHTS had with 2,000 spheres
SHOWN = [("full|thesis|0", "thesis' amplitudes, in phase", "-0.003, -0.002"),
         ("full|thesis|90", "the same, a quarter period ahead", "-0.014, -0.015, 0.000"),
         ("full|thesis|-90", "a quarter period behind", ""),
         ("full|equal|0", "as wide across as upright, in phase", "-0.003"),
         ("full|equal|90", "the same, a quarter period ahead", "-0.10, -0.11"),
         ("quarter|thesis|0", "thesis' amplitudes, in phase", ""),
         ("quarter|thesis|90", "the same, a quarter period ahead", ""),
         ("quarter|equal|0", "as wide across as upright, in phase", ""),
         ("quarter|equal|90", "the same, a quarter period ahead", "")]
UNITS = {"circulation": "rad/s", "slope": "deg", "speed": "mm/s"}


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def shaken_table(numbers, load):
    rows = []
    for setting, words, _ in SHOWN:
        for bodies in ("spheres", "cones"):
            name = f"{bodies}|{setting}"
            values = numbers.of(name, "slope") if setting.startswith(load) else []
            if values:
                rows.append([words, bodies, str(len(values)), *(numbers.shown(name, m) for m in UNITS)])
    return table(["shaken", "bodies", "seeds", "circulation, rad/s", "slope, deg", "sideways speed, mm/s"], rows)


def liggghts_table(numbers):
    rows = [[words, theirs, numbers.shown(f"spheres|{setting}", "circulation")]
            for setting, words, theirs in SHOWN if theirs]
    return table(["full load of spheres", "LIGGGHTS, rad/s", "here, rad/s"], rows)


def phase_table(numbers):
    """What a quarter period does to circulation and slope."""
    rows = []
    for load, across, bodies in ((l, a, b) for l in LOADS for a in ("thesis", "equal") for b in ("spheres", "cones")):
        for measure in ("circulation", "slope"):
            change = numbers.change(f"{bodies}|{load}|{across}|0", f"{bodies}|{load}|{across}|90", measure)
            rows.append([f"{bodies}, {load}, {1000 * float(Numbers.ACROSS[across]):.3g} mm", measure,
                         f"{change.told(Numbers.SHOWN[measure][1])} {UNITS[measure]}", f"{change.p:.1g}"])
    return table(["bodies, load, across", "number", "a quarter period makes", "p"], rows)


def stiffness_table(numbers):
    rows = []
    for setting, words in (("full|thesis|0", "full, thesis' amplitudes, in phase"),
                           ("full|thesis|90", "full, a quarter period ahead"),
                           ("full|equal|90", "full, the same, as wide across as upright"),
                           ("quarter|thesis|0", "quarter, thesis' amplitudes, in phase"),
                           ("quarter|thesis|90", "quarter, a quarter period ahead")):
        names = [f"{bodies}|{setting}" for bodies in ("spheres", "stiff spheres")]
        rows.append([words, *(numbers.shown(name, measure) for measure in ("circulation", "slope") for name in names),
                     str(len(numbers.of(names[1], "slope")))])
    return table(["load of spheres", "1e7 Pa: circulation, rad/s", "2e7 Pa", "1e7 Pa: slope, deg", "2e7 Pa",
                  "seeds of 2e7 Pa"], rows)


def lasting_table(numbers):
    windows = [MEANS_S, (3.8, LATE_S), (LATE_S, LONG_S)]
    rows = [[f"{phase} deg", f"{measure}, {UNITS[measure]}",
             *(spread(numbers.of(f"spheres|full|thesis|{phase}", measure, window, 4), Numbers.SHOWN[measure][1])
               for window in windows)] for phase in ("0", "90") for measure in ("circulation", "slope")]
    return table(["phase", "number", *(f"{a:g} to {b:g} s" for a, b in windows)], rows)


def traded_table(numbers):
    rows = []
    for load in LOADS:
        for across, phase in (("thesis", "90"), ("twice", "30"), ("equal", "11.96"), ("equal", "0"), ("thesis", "0"),
                              ("twice", "150")):
            name = f"spheres|{load}|{across}|{phase}"
            if numbers.of(name, "slope"):
                rows.append([load, f"{1000 * float(Numbers.ACROSS[across]):.3f} mm", f"{float(phase):.0f} deg",
                             str(len(numbers.of(name, "slope"))), *(numbers.shown(name, m) for m in UNITS)])
    return table(["load", "across", "phase", "seeds", "circulation, rad/s", "slope, deg", "sideways speed, mm/s"], rows)


def told_table(numbers):
    rows = []
    for load in LOADS:
        for measure, unit in UNITS.items():
            changes = [numbers.change(f"spheres|{load}|thesis|90", f"spheres|{load}|{rival}", measure)
                       for rival in ("twice|30", "equal|11.96")]
            rows.append([f"{load} load: {'sideways ' * (measure == 'speed')}{measure}, {unit}",
                         *(f"{c.told(Numbers.SHOWN[measure][1])}, p = {c.p:.1g}" for c in changes)])
    return table(["number", "twice as wide, 30 deg", f"{WIDER:.1f} times as wide, 12 deg"], rows)


def estimates(n):
    """What the text states with an interval, by name; the same numbers are what claims() checks."""
    def circulation(name, window=MEANS_S, seeds_from=1):
        return n.of(name, "circulation", window, seeds_from)
    found = {}
    for bodies in ("spheres", "cones"):
        rest, turns, wide_rest, wide = (circulation(f"{bodies}|full|{a}|{p}")
                                        for a in ("thesis", "equal") for p in ("0", "90"))
        found |= {("rest", bodies): mean_of(rest), ("turns", bodies): difference(rest, turns),
                  ("width", bodies): difference(rest, wide_rest), ("wide turns", bodies): difference(wide_rest, wide),
                  ("wider turns", bodies): difference(turns, wide),
                  ("excess", bodies): combined((1, wide), (-WIDER, turns)),
                  ("excess over rest", bodies): combined((1, wide), (-1, wide_rest), (-WIDER, turns), (WIDER, rest)),
                  ("quarter turns", bodies): difference(*(circulation(f"{bodies}|quarter|thesis|{p}")
                                                          for p in ("0", "90"))),
                  ("full slope", bodies): n.change(f"{bodies}|full|thesis|0", f"{bodies}|full|thesis|90", "slope")}
        slopes = {(a, p): n.of(f"{bodies}|quarter|{a}|{p}", "slope") for a in ("thesis", "equal") for p in ("0", "90")}
        found |= {("quarter slope", bodies, a, p): mean_of(values) for (a, p), values in slopes.items()}
        found |= {("steeper", bodies): combined((-1, slopes["thesis", "90"]), (-1, slopes["thesis", "0"])),
                  ("wider in phase", bodies): difference(slopes["thesis", "0"], slopes["equal", "0"]),
                  ("wider ahead", bodies): difference(slopes["equal", "90"], slopes["thesis", "90"])}
    ahead = circulation("spheres|full|thesis|90")
    late = circulation("spheres|full|thesis|90", (LATE_S, LONG_S), 4)
    found |= {"behind": n.change("spheres|full|thesis|0", "spheres|full|thesis|-90", "circulation"),
              "late": mean_of(late),
              "slowing": difference(late, circulation("spheres|full|thesis|90", MEANS_S, 4)),
              "steepening": difference(*(n.of("spheres|full|equal|90", "slope", window)
                                         for window in (FIRST_BLOCK, LAST_BLOCK))),
              "wide slope": mean_of(n.of("spheres|full|equal|90", "slope")),
              "stiff": difference(ahead, circulation("stiff spheres|full|thesis|90")),
              "stiff rest": mean_of(circulation("stiff spheres|full|thesis|0")),
              "fine": difference(ahead, circulation("fine spheres|full|thesis|90")),
              "30": difference(ahead, circulation("spheres|full|twice|30")),
              "12": difference(ahead, circulation("spheres|full|equal|11.96")),
              "12 from 0": n.change("spheres|full|equal|0", "spheres|full|equal|11.96", "circulation")}
    for load in LOADS:
        found["stiff turns", load] = n.change(*(f"stiff spheres|{load}|thesis|{p}" for p in ("0", "90")), "circulation")
    for across in ("thesis", "equal"):
        found["speed", across] = n.change(f"spheres|full|{across}|0", f"spheres|full|{across}|90", "speed")
    found |= {("speed", rival): n.change("spheres|full|thesis|90", f"spheres|full|{rival}", "speed")
              for rival in ("twice|30", "equal|11.96")}
    found |= {("side", rival): mean_of(n.of(f"spheres|quarter|{rival}", "slope"))
              for rival in ("twice|30", "equal|11.96", "twice|150")}
    found |= {("turns to", rival): mean_of(circulation(f"spheres|quarter|{rival}"))
              for rival in ("twice|30", "equal|11.96", "twice|150")}
    return found


def claims(n, e):
    """Words of the text, the estimates they rest on, and what each of those has to be."""
    both = ("spheres", "cones")
    ahead = statistics.mean(n.of("spheres|full|thesis|90", "circulation"))
    yield ("Yes, under both loads, with spheres and with cones",
           [e[what, b] for what in ("turns", "quarter turns") for b in both], lambda one: one.p < 0.01)
    yield "which its seeds do not tell from none", [e["rest", "spheres"]], lambda one: one.may_be_0
    yield "a quarter period behind by", [e["behind"]], lambda one: one.high < 0
    yield "Cones turn a little even in phase", [e["rest", "cones"]], lambda one: one.low > 0 and one.p < 0.05
    yield "The slope of a full load of spheres shows the phase", [e["full slope", "spheres"]], lambda one: one.p < 0.01
    yield "that of cones does not with these seeds", [e["full slope", "cones"]], lambda one: one.may_be_0
    yield "Widely shaken loads still get steeper in it", [e["steepening"]], lambda one: one.high < 0
    yield "How soft the bodies are decides how fast a full load turns", [e["stiff"]], lambda one: one.p < 0.01
    yield "In phase neither is told from rest", [e["rest", "spheres"], e["stiff rest"]], lambda one: one.may_be_0
    yield ("that the phase makes a load turn, and to which side, holds with both",
           [e["stiff turns", load] for load in LOADS], lambda one: one.p < 0.01 and one.low > 0)
    yield "Half the time step does not do it", [e["fine"]], lambda one: one.may_be_0 and one.high < e["stiff"].value
    yield "it is in part the way to the slope", [e["slowing"]], lambda one: one.low > 0
    yield "the phase makes a full load circulate, for as long as these runs go", [e["late"]], lambda one: one.low > 0
    yield ("At a quarter of the load the phase chooses the side", [e["quarter slope", b, "thesis", "0"] for b in both],
           lambda one: one.low > 0)
    yield "down to the other side", [e["quarter slope", b, "thesis", "90"] for b in both], lambda one: one.high < 0
    for b in both:
        yield ("about as steep", [e["steeper", b]],
               lambda one, b=b: one.may_be_0 and one.most < e["quarter slope", b, "thesis", "0"].value)
    yield "neither is told from nothing", [e["width", b] for b in both], lambda one: one.may_be_0
    for b in both:
        yield ("neither is as much as half of what a quarter period does at that width", [e["width", b]],
               lambda one, b=b: one.most < e["wide turns", b].value / 2)
    yield ("So the phase decides whether and to which side a full load turns, the amplitude across how fast",
           [e["wider turns", b] for b in both], lambda one: one.low > 0)
    yield ("A quarter load gets steeper with the width, in phase and out of it",
           [e[what, b] for what in ("wider in phase", "wider ahead") for b in both], lambda one: one.low > 0)
    yield ("turn as the thesis' amplitude a quarter period apart does, but for", [e["30"], e["12"]],
           lambda one: one.may_be_0 and one.most < ahead)
    yield "Nor is the rate in proportion to the product", [e["excess", "spheres"]], lambda one: one.low > 0
    yield "more than spheres do here", [e["wide slope"]], lambda one: one.low > -7
    yield "So these ratios are no law of the width", [e["excess", "spheres"]], lambda one: one.low > 0
    yield ("sideways speed tells the amplitude", [e["speed", "twice|30"], e["speed", "equal|11.96"]],
           lambda one: one.p < 0.01)
    yield ("and little of the phase", [e["speed", "thesis"], e["speed", "equal"]],
           lambda one: one.most < e["speed", "twice|30"].low / 2)
    near = ("twice|30", "equal|11.96")  # a load that slopes upwards across turns by a negative rate
    yield "It slopes and turns to the side of the cosine", [e["side", one] for one in near], lambda one: one.low > 0
    yield ("It slopes and turns to the side of the cosine", [e["turns to", one] for one in near],
           lambda one: one.high < 0)
    yield "the sine is as at 30 and the cosine reversed", [e["side", "twice|150"]], lambda one: one.high < 0
    yield "the sine is as at 30 and the cosine reversed", [e["turns to", "twice|150"]], lambda one: one.low > 0


def check(n, e):
    """Raises SystemExit at the first sentence that the runs do not bear out, or that is not in the text."""
    said = " ".join(TEXT.split())
    for words, told, holds in claims(n, e):
        if words not in said:
            raise SystemExit(f"trough_in_space.py checks a sentence that its text does not have: \"{words}\"")
        for one in told:
            if not holds(one):
                raise SystemExit(f"docs/thrown-away-phase.md would say \"{words}\", which {TABLE.name} does not bear "
                                 f"out: {one.told(4)}, p = {one.p:.2g}. Change the text, or measure more.")


def grown(n, bodies, window):
    return ratio(*(n.of(f"{bodies}|full|{a}|90", "circulation", window) for a in ("thesis", "equal")))


def words(n, e, program_agrees):
    """What {WORDS} of the text become."""
    ahead, late = statistics.mean(n.of("spheres|full|thesis|90", "circulation")), e["late"].value
    soft, stiff, fine = (n.of(f"{made}|full|thesis|90", "circulation")
                         for made in ("spheres", "stiff spheres", "fine spheres"))
    every = [rows[0] for seeds in n.runs.values() for rows in seeds.values()]
    found = {"RUNS": str(len(every)), "MINUTES": f"{sum(float(row['processor_s']) for row in every) / 60:.0f}",
             "AGAIN": "The program that made this page gives one of them again "
                      + ("digit for digit." if program_agrees else "within what seeds scatter, not digit for digit."),
             "EARLY": f"{ahead:.3f}", "LATE": f"{late:.3f}", "LATE_TURN": f"{2 * math.pi / late:.0f}",
             "TURN": f"{2 * math.pi / ahead:.0f}", "SIX": f"{math.degrees(6 * ahead):.0f}", "WIDER": f"{WIDER:.1f}",
             "STIFF_TIMES": "{:.1f} ({:.1f} to {:.1f})".format(*ratio(soft, stiff)), "STIFF": stiffness_table(n),
             "STIFF_TURN": f"{2 * math.pi / statistics.mean(stiff):.0f}",
             "STIFF_SIX": f"{math.degrees(6 * statistics.mean(stiff)):.0f}",
             "GROWN_STIFF": "{:.1f} ({:.1f} to {:.1f})".format(*grown(n, "stiff spheres", MEANS_S)),
             "FINE": f"{fine[0]:.3f}", "FINE_APART": e["fine"].told(3),
             "CONES_WIDE_SEEDS": str(len(n.of("cones|full|equal|90", "slope"))),
             "CONES_SLOPE": e["full slope", "cones"].told(1),
             "MOST_30": f"{e['30'].most:.3f}", "MOST_12": f"{e['12'].most:.3f}",
             **{f"SHARE_{one}": f"{100 * e[one].most / ahead:.0f}" for one in ("30", "12")},
             "STIFF_REST": e["stiff rest"].told(3), "TWELVE": e["12 from 0"].told(3),
             "FULL": shaken_table(n, "full"), "QUARTER": shaken_table(n, "quarter"), "PHASE": phase_table(n),
             "LASTS": lasting_table(n), "TRADED": traded_table(n), "LIGGGHTS": liggghts_table(n), "TOLD": told_table(n)}
    for bodies in ("spheres", "cones"):
        upper = bodies.upper()
        found |= {f"REST_{upper}": e["rest", bodies].told(3, ""), f"WIDTH_{upper}": e["width", bodies].told(3),
                  f"STEEPER_{upper}": e["steeper", bodies].told(1), f"EXCESS_{upper}": e["excess", bodies].told(3),
                  f"EXCESS_REST_{upper}": e["excess over rest", bodies].told(3)}
        for name, window in (("FIRST", FIRST_BLOCK), ("LAST", LAST_BLOCK)):
            found[f"{upper}_{name}"] = f"{statistics.mean(n.of(f'{bodies}|full|equal|90', 'slope', window)):.1f}"
        for name, window in (("GROWN", MEANS_S), ("LAST", LAST_BLOCK)):
            found[f"{name}_{upper}"] = "{:.1f} ({:.1f} to {:.1f})".format(*grown(n, bodies, window))
    return found | {f"SPEED_{across.upper()}": e["speed", across].told(1) for across in ("thesis", "equal")}


def wrapped(text):
    """Prose in lines of 120; headings and tables as they are."""
    parts = []
    for part in text.split("\n\n"):
        pieces = re.split(r"\n(?=- )", part) if part.startswith("- ") else [part]
        indent = "  " if part.startswith("- ") else ""
        if not part.startswith(("#", "|")):
            part = "\n".join(textwrap.fill(" ".join(piece.split()), 120, subsequent_indent=indent,
                                           break_long_words=False, break_on_hyphens=False) for piece in pieces)
        parts.append(part)
    return "\n\n".join(parts)


def section(tumble):
    """The part of the page that these runs make; those that are missing are run.

    Raises SystemExit where the text does not hold (check) or the runs are of another program (check_program).
    """
    complete(tumble)
    agrees = check_program(tumble)
    numbers = Numbers(stored())
    found = estimates(numbers)
    check(numbers, found)
    text = numbers.filled(TEXT)
    for key, value in words(numbers, found, agrees).items():
        text = text.replace("{" + key + "}", value)
    return wrapped(text)

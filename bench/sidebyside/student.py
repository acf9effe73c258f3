"""How far the means of two small samples may lie apart by chance: Student's t with Welch's degrees of freedom."""

from math import atan, cos, gamma, pi, sqrt, tan
from statistics import mean, variance

# Of all calls in which nothing differs, the share that may complain all the same. A call makes many comparisons, so each
# is held to its part of this (Bonferroni): ten comparisons to 99.5 %.
FALSE_ALARMS = 0.05
INTERVALS = 40                         # of Simpson's rule; t comes out to 1e-3 and better


def within(t, degrees):
    """P(|T| < t). With T = sqrt(degrees) tan(angle) the density of the angle is cos(angle)^(degrees - 1), but for a factor."""
    step = atan(t / sqrt(degrees)) / INTERVALS
    heights = [cos(k * step)**(degrees - 1) for k in range(INTERVALS + 1)]
    area = step / 3 * (heights[0] + 4 * sum(heights[1:-1:2]) + 2 * sum(heights[2:-1:2]) + heights[-1])
    return area * 2 / sqrt(pi) * gamma((degrees + 1) / 2) / gamma(degrees / 2)


def bound(share, degrees):
    """The t that so large a share of comparisons stays within (two sides), by halving the angle's interval."""
    low, high = 0.0, pi / 2
    for _ in range(25):
        middle = (low + high) / 2
        low, high = (middle, high) if within(sqrt(degrees) * tan(middle), degrees) < share else (low, middle)
    return sqrt(degrees) * tan(low)


def error(a, b):
    """Standard error of the difference of the means; two values each at least."""
    return sqrt(variance(a) / len(a) + variance(b) / len(b))


def welch(a, b):
    """Degrees of freedom of that error where the samples need not scatter alike (Welch 1947)."""
    parts = [(variance(sample) / len(sample), len(sample) - 1) for sample in (a, b)]
    return sum(part for part, _ in parts)**2 / sum(part**2 / degrees for part, degrees in parts)


def chance(a, b, comparisons):
    """What of the difference of the means may be chance, where a call makes so many comparisons."""
    return error(a, b) and bound(1 - FALSE_ALARMS / comparisons, welch(a, b)) * error(a, b)


def table(both, share):
    """Of (ours, theirs) per seed, each {figure: value}: {figure: {"tumble": [per seed], "liggghts": [per seed], "apart":
    difference of the means in standard errors, "agrees": whether it may be chance or is below `share` of theirs}}. One
    seed tells neither."""
    rows = {}
    for name in both[0][0]:
        ours, theirs = ([float(pair[side][name]) for pair in both] for side in (0, 1))
        gap = mean(ours) - mean(theirs)
        off = error(ours, theirs) if len(both) > 1 else 0
        agrees = abs(gap) <= max(chance(ours, theirs, len(both[0][0])), share * abs(mean(theirs))) if len(both) > 1 else None
        rows[name] = {"tumble": ours, "liggghts": theirs, "apart": gap / off if off > 0 else (0.0 if gap == 0 else None),
                      "agrees": agrees}
    return rows

"""Means of few runs: how far they are apart, and what their scatter leaves open. Every run is a seed of its own."""
import math
import statistics


def beyond(t, freedom):
    """Two-sided p of Student's t, by Simpson's rule over the density up to t."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(freedom * math.pi)
    density = [scale * (1 + (abs(t) * k / 1000) ** 2 / freedom) ** (-(freedom + 1) / 2) for k in range(1001)]
    inner = abs(t) / 3000 * (density[0] + density[-1] + 4 * sum(density[1:-1:2]) + 2 * sum(density[2:-1:2]))
    return max(0, 1 - 2 * inner)


def crossing(inside, near, far):
    """Between near and far, where the condition ceases to hold that holds at near and not at far."""
    for _ in range(60):
        middle = (near + far) / 2
        near, far = (middle, far) if inside(middle) else (near, middle)
    return near


def t_95(freedom):
    """The t that 5 % of all exceed to either side."""
    return crossing(lambda t: beyond(t, freedom) > 0.05, 0, 100)


class Estimate:
    """Of one number: value, standard error, degrees of freedom; p of it being 0; its 95 % interval."""

    def __init__(self, value, error, freedom):
        self.value, self.error, self.p = value, error, beyond(value / error, freedom)
        self.low, self.high = value - t_95(freedom) * error, value + t_95(freedom) * error

    @property
    def most(self):
        """How far from 0 it may be, to the side where it may be farther."""
        return max(abs(self.low), abs(self.high))

    @property
    def may_be_0(self):
        return self.low < 0 < self.high

    def told(self, digits, sign="+"):
        return f"{self.value:{sign}.{digits}f} ({self.low:{sign}.{digits}f} to {self.high:{sign}.{digits}f})"


def mean_of(values):
    """Of two values or more."""
    return Estimate(statistics.mean(values), statistics.stdev(values) / math.sqrt(len(values)), len(values) - 1)


def combined(*parts):
    """The sum of means, each times its factor, by Welch's test; parts are (factor, two values or more)."""
    spreads = [factor**2 * statistics.variance(values) / len(values) for factor, values in parts]
    freedom = sum(spreads) ** 2 / sum(s * s / (len(values) - 1) for s, (_, values) in zip(spreads, parts))
    return Estimate(sum(factor * statistics.mean(values) for factor, values in parts), math.sqrt(sum(spreads)), freedom)


def difference(one, other):
    """Mean of `other` less that of `one`, by Welch's test; a single `other` is taken to scatter as `one` does."""
    if len(other) == 1:
        error = statistics.stdev(one) * math.sqrt(1 + 1 / len(one))
        return Estimate(other[0] - statistics.mean(one), error, len(one) - 1)
    return combined((-1, one), (1, other))


def ratio(one, other):
    """Of the mean of `other` to that of `one`, and the ends of its 95 % interval (Fieller's, with Welch's freedom).

    Both means have to be well above 0.
    """
    value = statistics.mean(other) / statistics.mean(one)

    def may_be(times):
        return combined((-times, one), (1, other)).p > 0.05
    return value, crossing(may_be, value, 0), crossing(may_be, value, 10 * value)

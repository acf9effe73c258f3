"""Whether a figure of a chaotic run still moves when the step is halved, held against its scatter from seed to seed."""

from statistics import mean

from . import student


def halved(coarse, fine, comparisons):
    """{"step": values by seed, "half_step": the same, "moves": difference of the means, "scatter": what of it may be
    chance in one of so many comparisons, "converged": whether it may be all}. A single seed has no scatter: then nothing is
    known, and converged is None.
    """
    found = {"step": list(coarse), "half_step": list(fine), "moves": mean(fine) - mean(coarse)}
    if min(len(coarse), len(fine)) < 2:
        return {**found, "scatter": None, "converged": None}
    scatter = student.chance(coarse, fine, comparisons)
    return {**found, "scatter": scatter, "converged": abs(found["moves"]) <= scatter}


def complaint(name, figure, found):
    """A sentence for what has not converged or cannot be told; else nothing. What it says of `scatter` is a reader's caution:
    a figure that has converged may still move by so much."""
    if found["converged"] is None:
        return f"{name}: whether {figure} has converged cannot be told from one seed; --seeds 3"
    if found["converged"]:
        return None
    return (f"{name}: {figure} has not converged: half the step moves it by {found['moves']:.2g}, from {mean(found['step']):.4g} "
            f"to {mean(found['half_step']):.4g}, and seeds scatter by no more than {found['scatter']:.2g}")

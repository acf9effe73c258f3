"""Whether a figure of a chaotic run still moves when the step is halved, held against its scatter from seed to seed."""

from statistics import mean

from . import student


# A figure whose step may move it by more than this share unseen is not known well enough to be called converged.
BLUR = 0.1


def halved(coarse, fine, comparisons):
    """{"step": values by seed, "half_step": the same, "moves": difference of the means, "scatter": what of it may be
    chance in one of so many comparisons, "converged": whether it may be all}. converged is None where nothing can be told: a
    single seed has no scatter, and a scatter of a tenth of the figure would hide as large a move.
    """
    found = {"step": list(coarse), "half_step": list(fine), "moves": mean(fine) - mean(coarse)}
    if min(len(coarse), len(fine)) < 2:
        return {**found, "scatter": None, "converged": None}
    scatter = student.chance(coarse, fine, comparisons)
    if abs(found["moves"]) > scatter:
        return {**found, "scatter": scatter, "converged": False}
    blurred = scatter > BLUR * abs(mean(found["step"]))
    return {**found, "scatter": scatter, "converged": None if blurred else True}


def complaint(name, figure, found):
    """A sentence for what has not converged or cannot be told; else nothing."""
    if found["scatter"] is None:
        return f"{name}: whether {figure} has converged cannot be told from one seed; --seeds 3"
    if found["converged"] is None:
        return (f"{name}: whether {figure} has converged cannot be told from {len(found['step'])} seeds: half the step moves it by "
                f"{found['moves']:.2g} of {mean(found['step']):.4g}, and {found['scatter']:.2g} may be chance; more --seeds")
    if found["converged"]:
        return None
    return (f"{name}: {figure} has not converged: half the step moves it by {found['moves']:.2g}, from {mean(found['step']):.4g} "
            f"to {mean(found['half_step']):.4g}, and seeds scatter by no more than {found['scatter']:.2g}")

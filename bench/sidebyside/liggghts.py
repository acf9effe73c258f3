"""Runs LIGGGHTS decks and reads what they leave."""

import re
import tempfile
from pathlib import Path

import numpy as np

from . import programs

# Some MPI builds buffer what a failing run says; the log file has it.
LOG = "log.liggghts"


def version():
    """Its own name and number; asking for help ends it with 1."""
    text = programs.run([programs.need("liggghts"), "-h"], may_fail=True).output
    found = re.search(r"Version (\S+ [0-9.]+)", text)
    return found[1] if found else "unknown"


def run(deck, variables, cores=None):
    """Runs bench/decks/DECK with -var NAME VALUE for each variable; returns what it printed and where it ran."""
    folder = Path(tempfile.mkdtemp(prefix="tumble-liggghts-"))
    command = [programs.need("liggghts"), "-in", programs.DECKS / deck, "-log", LOG]
    for name, value in variables.items():
        command += ["-var", name, value if isinstance(value, str) else repr(value)]
    try:
        return programs.run(command, cores, folder)
    except programs.Missing as problem:
        log = folder / LOG
        tail = log.read_text(errors="replace")[-600:] if log.exists() else ""
        raise programs.Missing(f"{problem}\n{tail}") from None


def frames(path):
    """Yields (step, rows) of a dump; rows is an array of one line per atom or local entry."""
    step, rows, reading = None, [], False
    with open(path) as lines:
        for line in lines:
            if line.startswith("ITEM: TIMESTEP"):
                if step is not None:
                    yield step, np.array(rows)
                step, rows, reading = int(next(lines)), [], False
            elif line.startswith("ITEM:"):
                reading = line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES"))
            elif reading:
                rows.append([float(word) for word in line.split()])
    if step is not None:
        yield step, np.array(rows)


def trace(folder, name="trace.dump"):
    """All frames of a dump as (steps, array [frame, row, column]); every frame must have equally many rows."""
    steps, rows = zip(*frames(Path(folder) / name))
    return np.array(steps), np.array(rows)


def loops(output):
    """(steps, seconds) of every run in a LAMMPS or LIGGGHTS output."""
    found = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", output, re.M)
    return [(int(steps), float(seconds)) for seconds, steps in found]

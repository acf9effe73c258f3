"""Finds, pins and runs programs; measures their time and memory."""

import os
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DECKS = ROOT / "bench" / "decks"
REFERENCE = ROOT / "bench" / "reference"
PEERS = ROOT.parent / "shared" / "peers"
PACKAGES = {"liggghts": "liggghts", "lmp": "lammps", "mpirun": "openmpi-bin", "taskset": "util-linux"}


class Missing(Exception):
    """A program or a file that a case needs is not there; the message says what to do."""


@dataclass
class Ran:
    output: str
    seconds: float
    processor_s: float
    peak_rss_MB: float
    folder: Path


def need(program):
    """Path of an installed program, or Missing with the package to install."""
    path = shutil.which(program)
    if path is None:
        raise Missing(f"{program} is not installed: apt-get install {PACKAGES.get(program, program)}")
    return path


def ours(name):
    """Path of bench_NAME: TUMBLE_BENCH_DIR, else the first build folder that has it, release first."""
    folders = [Path(os.environ["TUMBLE_BENCH_DIR"])] if "TUMBLE_BENCH_DIR" in os.environ else []
    folders += [ROOT / "build" / kind / "bench" for kind in ("release", "dev")]
    for folder in folders:
        path = folder / f"bench_{name}"
        if path.exists():
            return str(path)
    raise Missing(f"bench_{name} is not built: cmake --preset release && cmake --build --preset release")


def tumble():
    """Path of the program: TUMBLE_BENCH_DIR's, else of the first build folder that has it, release first."""
    folders = [Path(os.environ["TUMBLE_BENCH_DIR"]).parent] if "TUMBLE_BENCH_DIR" in os.environ else []
    for folder in [*folders, ROOT / "build" / "release", ROOT / "build" / "dev"]:
        if (folder / "tumble").exists():
            return str(folder / "tumble")
    raise Missing("tumble is not built: cmake --preset release && cmake --build --preset release")


def peer_file(path):
    """A file of the peers' decks, or Missing."""
    full = PEERS / path
    if not full.exists():
        raise Missing(f"{full} is not there: the peers' decks lie beside the project, in ../shared/peers")
    return full


def run(command, cores=None, folder=None, environment=None, may_fail=False):
    """Runs a command to its end, on the given cores only; Missing when it fails, with the end of what it said."""
    command = [str(word) for word in command]
    if cores is not None:
        command = [need("taskset"), "-c", ",".join(str(core) for core in cores), *command]
    folder = Path(folder) if folder else Path(tempfile.mkdtemp(prefix="tumble-bench-"))
    start = time.monotonic()
    with open(folder / "output.txt", "w") as output:
        process = subprocess.Popen(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT,
                                   env={**os.environ, **(environment or {})})
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    text = (folder / "output.txt").read_text(errors="replace")
    if process.returncode != 0 and not may_fail:
        raise Missing(f"{' '.join(command[:6])} ... ended with {process.returncode}:\n{text[-1500:]}")
    return Ran(text, time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, folder)

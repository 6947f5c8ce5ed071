"""What is killed while a suite runs: workers of a Ray cluster, one of its machines, or the evaluation."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np

from executive.errors import UserError
from robots.clock import WallClock
from tools.evaluate.survival.processes import below, kill

_LOOK_EVERY_S = 0.05
_AT_AN_EPISODE = "ray::_run"
"""So a worker of Ray that is at something is called."""
_AFTER_S = (0.0, 4.0)
"""From one kill to the next, at the least."""
_QUIET = {"RAY_USAGE_STATS_ENABLED": "0", "RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER": "0"}


@dataclass(frozen=True, slots=True)
class Ordered:
    """What is run, and what is done to it.

    Attributes:
        suite, episodes, seed, jobs: As for the evaluation.
        kills: How often something is killed.
        rng: Draws who is killed, and when.
        tell: Takes a line for whoever looks on.
    """

    suite: str
    episodes: int
    seed: int
    jobs: int
    kills: int
    rng: np.random.Generator
    tell: Callable[[str], None]

    def command(self, journal: Path, *more: str) -> list[str]:
        """The evaluation as it is begun by anybody."""
        told = ["--episodes", str(self.episodes), "--seed", str(self.seed), "--jobs", str(self.jobs)]
        kept = ["--journal", str(journal), "--failed", str(journal.parent)]
        return [sys.executable, "-m", "tools.evaluate", self.suite, *told, *kept, *more]


def run_alone(ordered: Ordered, journal: Path) -> None:
    """Run it by processes, and kill nothing; what the journal holds already is not run again."""
    _to_its_end(ordered.command(journal, "--resume"))


def kill_workers(ordered: Ordered, journal: Path) -> int:
    """Kill a random worker of a Ray cluster of this machine again and again; how many were killed."""
    return _hurt(
        ordered, journal, ordered.command(journal, "--ray"), _some_worker(ordered, journal), ordered.kills
    )


def kill_machine(ordered: Ordered, journal: Path) -> int:
    """Kill one of two machines of a Ray cluster, each with one core, once a quarter of all is recorded."""
    with _cluster() as (address, second):

        def down(_pid: int) -> bool:
            if _count(journal) < max(1, ordered.episodes // 4):
                return False
            second()
            return True

        return _hurt(ordered, journal, ordered.command(journal, "--ray", address), down, 1)


def kill_evaluation(ordered: Ordered, journal: Path) -> int:
    """Kill the evaluation at random instants and go on each time; how often."""
    clock = WallClock()
    usual_s, killed = 20.0, 0
    while killed < ordered.kills:
        began_s, there = clock.now_s(), _count(journal)
        instant_s = float(ordered.rng.uniform(0.0, usual_s))
        with _begun(ordered.command(journal, "--resume")) as process:
            while process.poll() is None and clock.now_s() - began_s < instant_s:
                clock.sleep(_LOOK_EVERY_S)
            if process.poll() is not None:  # it was through already: the instants have to come earlier
                raise UserError(f"all was recorded after {killed} kills: more --episodes are needed")
            process.kill()
        killed += 1
        new = _count(journal) - there
        # as many records between two kills as bring the last one near to the end
        usual_s *= 1.3 if new < ordered.episodes / (2.0 * ordered.kills) else 0.8
        ordered.tell(f"killed {killed} of {ordered.kills}: {_count(journal)} of {ordered.episodes} recorded")
    _to_its_end(ordered.command(journal, "--resume"))
    return killed


WAYS: Mapping[str, Callable[[Ordered, Path], int]] = MappingProxyType(
    {"workers": kill_workers, "machine": kill_machine, "evaluation": kill_evaluation}
)
"""What is killed, by its name."""


def _hurt(
    ordered: Ordered, journal: Path, command: Sequence[str], strike: Callable[[int], bool], kills: int
) -> int:
    """Run a command, and strike at what it has begun as records come; how often that met something."""
    clock, killed = WallClock(), 0
    with _begun(command) as process:
        while process.poll() is None and killed < kills:
            clock.sleep(_LOOK_EVERY_S)
            if strike(process.pid):
                killed += 1
                recorded = f"{_count(journal)} of {ordered.episodes} recorded"
                ordered.tell(f"killed {killed} of {kills}: {recorded}")
        process.wait()
    _complain(process.returncode, command)
    return killed


def _some_worker(ordered: Ordered, journal: Path) -> Callable[[int], bool]:
    """Kills a worker that is at an episode, some time after each new record: so the run comes on."""
    clock = WallClock()
    there, due_s = 0, float(ordered.rng.uniform(*_AFTER_S))

    def strike(pid: int) -> bool:
        nonlocal there, due_s
        busy = [one for one, command in below(pid).items() if command.startswith(_AT_AN_EPISODE)]
        if clock.now_s() < due_s or _count(journal) < there or not busy:
            return False
        there, due_s = _count(journal) + 1, clock.now_s() + float(ordered.rng.uniform(*_AFTER_S))
        return kill(busy[int(ordered.rng.integers(len(busy)))])

    return strike


@contextmanager
def _cluster() -> Iterator[tuple[str, Callable[[], None]]]:
    """The address of a Ray cluster of two machines with a core each, and what kills the second one."""
    os.environ.update(_QUIET)
    from ray.cluster_utils import Cluster

    made = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    try:
        second = made.add_node(num_cpus=1)
        made.wait_for_nodes()
        yield made.address, lambda: made.remove_node(second, allow_graceful=False)
    finally:
        made.shutdown()


@contextmanager
def _begun(command: Sequence[str]) -> Iterator[subprocess.Popen[bytes]]:
    quiet = subprocess.DEVNULL
    with subprocess.Popen(command, stdout=quiet, stderr=quiet, env={**os.environ, **_QUIET}) as process:
        try:
            yield process
        finally:
            if process.poll() is None:
                process.kill()


def _to_its_end(command: Sequence[str]) -> None:
    done = subprocess.run(command, capture_output=True, check=False)
    _complain(done.returncode, command, done.stderr.decode(errors="replace"))


def _complain(code: int, command: Sequence[str], said: str = "") -> None:
    """A suite that misses a bar ends with 1, and has run all the same."""
    if code not in (0, 1):
        raise UserError(f"exit code {code} of {' '.join(command)}: {said[-500:]}")


def _count(journal: Path) -> int:
    """Lines of a journal."""
    return journal.read_bytes().count(b"\n") if journal.exists() else 0

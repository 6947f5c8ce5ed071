"""What the report runs: each suite of ``tools.evaluate`` and ``tools.benchmark``, with how many episodes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from tools.benchmark.__main__ import SUITES as BENCHMARKS
from tools.evaluate.__main__ import IN_A_ROW, SUITES
from tools.evaluate.ailing.body_fault import BODY_FAULTS

Kind = Literal["episodes", "benchmark", "scaling"]

NOT_REPORTED = frozenset({"digests", "things", "in_place", "put_things", "grips"})
"""The first compares two versions and says nothing of one; the others need a scene of their user's things."""
SCALING = "scaling"
_USUAL = 200


@dataclass(frozen=True, slots=True)
class Run:
    """One row of the report.

    Attributes:
        name: What the row is called, and the file of its record.
        suite: Of ``tools.evaluate`` or ``tools.benchmark``.
        options: More options of the command.
        episodes: How many; 0 for a benchmark.
        kind: What is run.
    """

    name: str
    suite: str
    options: tuple[str, ...] = ()
    episodes: int = _USUAL
    kind: Kind = "episodes"

    @property
    def is_in_a_row(self) -> bool:
        """Whether one process runs all of it, and begins anew after a kill."""
        return self.kind != "episodes" or self.suite in IN_A_ROW


_EPISODES = {
    "kill": 40, "connection": 70, "load": 4, "fuzz": 100, "mcp": 50, "mcp-fuzz": 100, "hostile": 20,
    "soak": 120, "ros_velocity": 20, "ros_hostile": 2, "ros_action": 50, "sequence": 100, "gpsr": 80,
    "replay": 60, "people-seen": 100, "shown": 60, "fusion": 100,
    "stack": 20, "regions": 12, "openings": 30, "turn_knob": 20, "press": 20,
}  # fmt: skip
"""Of suites whose episodes are long, or thousands of small ones, or of which fewer are asked for."""

_UNDER_FAULTS = (
    Run("pick-clutter", "pick", ("--scene", "clutter")),
    *(
        Run(f"pick-{fault}", "pick", ("--fault", fault), 100)
        for fault in ("moved", "slip", "knocked", "wrong_detection")
    ),
    Run("pick-rgbd", "pick", ("--perception", "rgbd"), 100),
    Run("perception-two-cameras", "perception", ("--cameras", "2"), 100),
)

RUNS: tuple[Run, ...] = (
    *(
        Run(suite, suite, episodes=_EPISODES.get(suite, _USUAL))
        for suite in SUITES
        if suite not in NOT_REPORTED and suite != "fault"
    ),
    *_UNDER_FAULTS,
    *(Run(f"fault-{fault}", "fault", ("--fault", fault), 20) for fault in BODY_FAULTS),
    *(Run(f"benchmark-{suite}", suite, episodes=0, kind="benchmark") for suite in BENCHMARKS),
    Run(SCALING, SCALING, ("--repeats", "15"), episodes=0, kind="scaling"),
)
"""Every run, in the order in which they are made."""


def chosen(names: Sequence[str]) -> tuple[Run, ...]:
    """The runs of some names; a suite's name stands for all of its runs, "benchmarks" for every benchmark.

    Raises:
        ValueError: A name is of no run; the line lists those that are.
    """
    if not names:
        return RUNS
    groups = {"benchmarks": [run.name for run in RUNS if run.kind == "benchmark"]}
    wanted: set[str] = set()
    for name in names:
        found = groups.get(name) or [
            run.name for run in RUNS if name == run.name or (name == run.suite and run.kind == "episodes")
        ]
        if not found:
            raise ValueError(f"no run is called {name!r}; there are {', '.join(run.name for run in RUNS)}")
        wanted.update(found)
    return tuple(run for run in RUNS if run.name in wanted)

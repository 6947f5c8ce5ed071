"""Planners that solve the same problems, taking turns problem by problem."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Protocol

import numpy as np
from rich.console import Console
from rich.table import Table

from kinematics.arrays import Array
from tools.benchmark.problems.arm_judge import path_length
from tools.benchmark.problems.problem import Problem

Referee = Callable[[Problem, Array], bool]
"""Tells whether a path, shape (n, 7), solves a problem and is free."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What one planner made of one problem.

    Attributes:
        path: The shortened path, shape (n, 7), from start to goal, or None.
        set_up_s: Processor time for taking the solids in.
        plan_s: Processor time until the first path.
        shorten_s: Processor time for making it shorter.
    """

    path: Array | None
    set_up_s: float
    plan_s: float
    shorten_s: float

    @property
    def solve_s(self) -> float:
        """Plan and shorten: what a request costs when the scene is known."""
        return self.plan_s + self.shorten_s


class ArmPlanner(Protocol):
    """Somebody who plans for the Panda."""

    @property
    def name(self) -> str:
        """Who it is, with the version."""

    def plan(self, problem: Problem, seed: int) -> Answer:
        """Find a path and make it shorter."""


@dataclass(frozen=True, slots=True)
class Result:
    """One answer, judged."""

    planner: str
    problem: str
    family: str
    solved: bool
    valid: bool
    set_up_s: float
    solve_s: float
    length_rad: float


@dataclass(frozen=True, slots=True)
class Standing:
    """How one planner did in one family.

    Attributes:
        family: Kind of scene, or "all".
        planner: Who.
        problems: How many were put.
        solved: Share that got a path.
        valid: Share of those answers that the referee found right.
        median_ms: Plan and shorten, over solved problems; None when there is none.
        p95_ms: The same, 95th percentile.
        set_up_ms: Taking the solids in, median.
        length_rad: Median length of the valid paths in joint space: one that cuts through a wall is short.
        times_slower: Median over problems of this planner's time to the first planner's, where both
            solved it; None for the first.
        times_slower_spread: Quartiles of that ratio, or None.
        times_longer: The same for the lengths, where both answers are valid.
    """

    family: str
    planner: str
    problems: int
    solved: float
    valid: float
    median_ms: float | None
    p95_ms: float | None
    set_up_ms: float
    length_rad: float | None
    times_slower: float | None
    times_slower_spread: tuple[float, float] | None
    times_longer: float | None

    def to_json(self) -> dict[str, Any]:
        """As plain values."""
        return asdict(self)


def run_contest(
    planners: Sequence[ArmPlanner], problems: Iterable[Problem], referee: Referee, repeats: int = 1
) -> list[Result]:
    """Put each problem to every planner in turn, each time beginning with another one.

    The first problem is put once more before all, and not counted: it warms up.
    """
    results: list[Result] = []
    for k, problem in enumerate(problems):
        if k == 0:
            for planner in planners:
                planner.plan(problem, 0)
        for seed in range(repeats):
            turn = (k + seed) % len(planners)
            results += [
                _judged(planner, problem, planner.plan(problem, seed), referee)
                for planner in (*planners[turn:], *planners[:turn])
            ]
    return results


def _judged(planner: ArmPlanner, problem: Problem, answer: Answer, referee: Referee) -> Result:
    path = answer.path
    return Result(
        planner=planner.name,
        problem=problem.name,
        family=problem.family,
        solved=path is not None,
        valid=path is not None and referee(problem, path),
        set_up_s=answer.set_up_s,
        solve_s=answer.solve_s,
        length_rad=float("nan") if path is None else path_length(path),
    )


def standings(results: Sequence[Result]) -> list[Standing]:
    """Sum up by family and planner; ratios are to the planner that comes first."""
    planners = list(dict.fromkeys(r.planner for r in results))
    families = list(dict.fromkeys(r.family for r in results))
    found = []
    for family in [*families, "all"] if len(families) > 1 else families:
        of_family = [r for r in results if family in (r.family, "all")]
        base = {r.problem: r for r in of_family if r.planner == planners[0]}
        for planner in planners:
            own = [r for r in of_family if r.planner == planner]
            found.append(_standing(family, planner, own, None if planner == planners[0] else base))
    return found


def _standing(family: str, planner: str, own: Sequence[Result], base: dict[str, Result] | None) -> Standing:
    solved = [r for r in own if r.solved]
    times = [1e3 * r.solve_s for r in solved]
    both = [(r, base[r.problem]) for r in solved if base is not None and base[r.problem].solved]
    slower = [r.solve_s / max(b.solve_s, 1e-9) for r, b in both]
    longer = [r.length_rad / max(b.length_rad, 1e-9) for r, b in both if r.valid and b.valid]
    lengths = [r.length_rad for r in solved if r.valid]
    low, high = np.percentile(slower, (25, 75)) if slower else (0.0, 0.0)
    return Standing(
        family=family,
        planner=planner,
        problems=len(own),
        solved=len(solved) / len(own),
        valid=sum(r.valid for r in solved) / len(solved) if solved else 0.0,
        median_ms=float(np.median(times)) if times else None,
        p95_ms=float(np.percentile(times, 95)) if times else None,
        set_up_ms=float(np.median([1e3 * r.set_up_s for r in own])),
        length_rad=float(np.median(lengths)) if lengths else None,
        times_slower=float(np.median(slower)) if slower else None,
        times_slower_spread=(float(low), float(high)) if slower else None,
        times_longer=float(np.median(longer)) if longer else None,
    )


COLUMNS = (
    "family", "planner", "problems", "solved", "valid", "median ms", "p95 ms", "set up ms", "length rad",
    "times slower", "quartiles", "times longer",
)  # fmt: skip
# What fits a terminal; the rest is in the JSON and in the documentation.
BRIEF = ("family", "planner", "solved", "valid", "median ms", "p95 ms", "length rad", "times slower")


def cells(item: Standing) -> list[str]:
    """One standing as the cells of a table's row, in the order of ``COLUMNS``."""
    spread = item.times_slower_spread
    return [
        item.family,
        item.planner,
        str(item.problems),
        f"{item.solved:.1%}",
        f"{item.valid:.1%}",
        _number(item.median_ms, ".4g"),
        _number(item.p95_ms, ".4g"),
        _number(item.set_up_ms, ".3g"),
        _number(item.length_rad, ".2f"),
        _number(item.times_slower, ".2f"),
        "" if spread is None else f"{spread[0]:.2f}–{spread[1]:.2f}",
        _number(item.times_longer, ".2f"),
    ]


def _number(value: float | None, form: str) -> str:
    return "" if value is None else format(value, form)


def print_standings(title: str, items: Sequence[Standing], console: Console) -> None:
    """Print the brief table."""
    table = Table(*BRIEF, title=title)
    for item in items:
        by_name = dict(zip(COLUMNS, cells(item), strict=True))
        table.add_row(*(by_name[name] for name in BRIEF))
    console.print(table)

"""Put the trajectory checker on trial: ``python -m tools.checking.campaign --count 2000 --seed 0 --jobs 2``.

Half of the trajectories are sound, half have a defect; an independent referee decides what is true.
The full trial is ``--count 10000 --defects-only`` for what may not be missed, and half as many of both
for what may not be refused; ``--first`` goes on with one that was interrupted.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from functools import cache, partial
from pathlib import Path

import numpy as np

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import Unsafe
from robots.models.description import load_description
from tools.checking.generator import DEFECTS, Generator, Kind


@dataclass(frozen=True)
class Outcome:
    """One trial.

    Attributes:
        index: With the campaign's seed, it makes the same case again.
        kind, size: What was planted.
        unsafe: What the referee says.
        refused: What the checker says.
        findings: Kinds of the checker's findings.
        message: The checker's first finding.
        violations: The referee's, kind to the excess.
        shortest_s: Duration of the shortest violation.
        check_ms: How long the checker took.
        duration_s, samples: Of the trajectory.
        margins: The referee's smallest clearance, CoM and ZMP margins.
    """

    index: int
    kind: str
    size: float
    unsafe: bool
    refused: bool
    findings: tuple[str, ...]
    message: str
    violations: dict[str, float]
    shortest_s: float
    check_ms: float
    duration_s: float
    samples: int
    margins: tuple[float, float, float]


@cache
def _parts(
    robot: str, smallest_m: float, compiled: bool, meshes: bool
) -> tuple[Generator, TrajectoryChecker]:
    model = RobotModel(load_description(robot))
    return Generator(model, smallest_m=smallest_m, parts=meshes), TrajectoryChecker(
        RobotModel(load_description(robot)), compiled=compiled
    )


def kind_of(index: int, defects_only: bool = False, defects: Sequence[Kind] = DEFECTS) -> Kind:
    """What is planted in a trial: nothing in every second, else each kind in turn."""
    if defects_only:
        return defects[index % len(defects)]
    return "sound" if index % 2 == 0 else defects[(index // 2) % len(defects)]


def trial(
    seed: int,
    index: int,
    robot: str = "talos",
    smallest_m: float = 0.001,
    defects_only: bool = False,
    compiled: bool = True,
    meshes: bool = False,
) -> Outcome:
    """Make, judge and check one case."""
    generator, checker = _parts(robot, smallest_m, compiled, meshes)
    kind = kind_of(index, defects_only, generator.defects)
    case = generator.case(kind, np.random.default_rng([seed, index]))
    started = time.process_time()
    answer = checker.check(case.trajectory, case.scene)
    check_ms = 1e3 * (time.process_time() - started)
    refused = isinstance(answer, Unsafe)
    findings = answer.findings if isinstance(answer, Unsafe) else ()
    verdict = case.verdict
    return Outcome(
        index=index,
        kind=kind,
        size=case.size,
        unsafe=verdict.unsafe,
        refused=refused,
        findings=tuple(sorted({finding.kind.value for finding in findings})),
        message=str(answer) if refused else "",
        violations={name: excess for name, (excess, _) in verdict.violations.items()},
        shortest_s=min(verdict.duration_s.values(), default=0.0),
        check_ms=check_ms,
        duration_s=case.trajectory.duration_s,
        samples=len(case.trajectory.t_s),
        margins=(verdict.least_distance_m, verdict.com_margin_m, verdict.zmp_margin_m),
    )


def campaign(
    count: int,
    seed: int,
    jobs: int,
    robot: str = "talos",
    smallest_m: float = 0.001,
    defects_only: bool = False,
    first: int = 0,
    compiled: bool = True,
    meshes: bool = False,
) -> Iterator[Outcome]:
    """Yield the outcomes of trials ``first`` to ``count`` in order."""
    run = partial(
        trial,
        robot=robot,
        smallest_m=smallest_m,
        defects_only=defects_only,
        compiled=compiled,
        meshes=meshes,
    )
    if jobs == 1:
        for index in range(first, count):
            yield run(seed, index)
        return
    with ProcessPoolExecutor(jobs) as pool:
        yield from pool.map(run, [seed] * (count - first), range(first, count), chunksize=4)


def table(outcomes: list[Outcome]) -> str:
    """The result as text: by kind, how many were missed or refused without need."""
    rows: dict[str, Counter[str]] = defaultdict(Counter)
    for outcome in outcomes:
        row = rows[outcome.kind]
        row["cases"] += 1
        row["missed"] += outcome.unsafe and not outcome.refused
        row["false"] += outcome.refused and not outcome.unsafe
        row["short"] += outcome.unsafe and outcome.shortest_s < 0.01
        row["small"] += outcome.unsafe and outcome.size < 0.005
    lines = [
        f"{'kind':10}{'cases':>7}{'missed':>8}{'false alarms':>14}{'< 10 ms':>9}{'< 5 mm or 5 mrad':>18}"
    ]
    for kind in ("sound", *DEFECTS):
        row = rows[kind]
        lines.append(
            f"{kind:10}{row['cases']:7}{row['missed']:8}{row['false']:14}{row['short']:9}{row['small']:18}"
        )
    times = np.array([outcome.check_ms for outcome in outcomes])
    lines.append(f"check: median {np.median(times):.1f} ms, p95 {np.percentile(times, 95):.1f} ms")
    return "\n".join(lines)


def main() -> int:
    """Run a campaign from the command line; 1 when the checker misses a defect or cries wolf."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--robot", default="talos")
    parser.add_argument("--smallest-mm", type=float, default=1.0, help="of the planted defects")
    parser.add_argument("--defects-only", action="store_true", help="no sound trajectories")
    parser.add_argument("--coal", action="store_true", help="try the checker without compiled code")
    parser.add_argument("--meshes", action="store_true", help="things of convex parts, as of meshes")
    parser.add_argument("--first", type=int, default=0, help="trial to begin with")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    outcomes = []
    for outcome in campaign(
        arguments.count,
        arguments.seed,
        arguments.jobs,
        arguments.robot,
        1e-3 * arguments.smallest_mm,
        arguments.defects_only,
        arguments.first,
        not arguments.coal,
        arguments.meshes,
    ):
        outcomes.append(outcome)
        if outcome.unsafe != outcome.refused:
            print(f"{'MISSED' if outcome.unsafe else 'FALSE ALARM'}: {outcome}", flush=True)
        elif sys.stderr.isatty() or len(outcomes) % 100 == 0:
            print(f"\r{len(outcomes)} of {arguments.count}", end="", file=sys.stderr, flush=True)
    print(f"\n{table(outcomes)}")
    if arguments.json:
        arguments.json.write_text(json.dumps([asdict(outcome) for outcome in outcomes]))
    missed = sum(outcome.unsafe and not outcome.refused for outcome in outcomes)
    false = sum(outcome.refused and not outcome.unsafe for outcome in outcomes)
    sound = sum(not outcome.unsafe for outcome in outcomes)
    return int(missed > 0 or false > 0.01 * sound)


if __name__ == "__main__":
    sys.exit(main())

"""Is a straight line of two radians free? The Panda among solids, side by side with the peers and judged."""

from __future__ import annotations

import contextlib
import importlib.metadata
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Protocol

import numpy as np

from executive.config import APPLICATION
from kinematics.arrays import Array
from kinematics.collision.validity import validity
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tools.benchmark.figures import Figure, figure
from tools.benchmark.own_arm_planner import panda_on_floor
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import PeerProcess, peer_process
from tools.benchmark.problems.arm_judge import REFEREE_STEP_RAD, Arm, ArmJudge
from tools.benchmark.problems.families import FAMILIES
from tools.benchmark.problems.generator import problems
from tools.benchmark.problems.panda_files import write_panda
from tools.benchmark.problems.problem import object_to_json
from tools.benchmark.report import Report

PEERS = {"roboplan": "plan_roboplan"}
LENGTH_RAD = 2.0
# How finely a peer looks along a line: by its documented default, and as finely as the referee.
STEPS_RAD = (0.05, REFEREE_STEP_RAD)
_PER_SCENE = 25
_SEED = 1


class EdgeJudge(Protocol):
    """Somebody who tells whether straight lines are free."""

    @property
    def name(self) -> str:
        """Who it is, with the version."""

    def judge(self, objects: Sequence[SceneObject], edges: Array) -> tuple[list[bool], float]:
        """Whether each of ``edges``, shape (n, 2, 7), is free, and the processor time of all, s."""


class OwnEdgeJudge:
    """The product's judge of lines."""

    def __init__(self) -> None:
        self.name = f"{APPLICATION} {importlib.metadata.version(APPLICATION)}"
        self._model = panda_on_floor()
        self._robot = StandingRobot(self._model, Stance(()))

    def judge(self, objects: Sequence[SceneObject], edges: Array) -> tuple[list[bool], float]:
        """Judge one line after another."""
        judge = validity(self._robot, PlanningScene().with_objects(objects))
        began_s = time.process_time()
        free = [judge.polyline_is_free(edge) for edge in edges]
        return free, time.process_time() - began_s


class PeerEdgeJudge:
    """A peer in its own environment, which looks along a line at every ``step_rad``."""

    def __init__(self, process: PeerProcess, step_rad: float) -> None:
        self.name = f"{process.environment.version.replace('==', ' ')}, step {step_rad:.3g} rad"
        self._process, self._step_rad = process, step_rad

    def judge(self, objects: Sequence[SceneObject], edges: Array) -> tuple[list[bool], float]:
        """Ask the peer."""
        values = [object_to_json(item) for item in objects]
        answer = self._process.ask("edges", objects=values, edges=edges.tolist(), step_rad=self._step_rad)
        return answer["free"], answer["judge_s"]


def collision(
    quick: bool, cache: Path, samples: int | None = None, peers: Sequence[str] = tuple(PEERS)
) -> Report:
    """Lines from random free configurations, in the scenes of every family.

    A peer judges them twice: as its users do, and with the referee's step, which tells what an answer costs
    that is as right as ours. An *optimistic* error is a line that is called free and collides by the
    referee, Coal at 1/256 rad; a *pessimistic* one is the reverse. Time is compared scene by scene.
    """
    files = write_panda(cache / "panda")
    arm = Arm(files)
    missing = [name for name in peers if not PeerEnvironment(name, cache).is_ready]
    with contextlib.ExitStack() as stack:
        judges: list[EdgeJudge] = [OwnEdgeJudge()]
        for name in peers:
            if name not in missing:
                process = stack.enter_context(peer_process(PeerEnvironment(name, cache), PEERS[name]))
                process.ask("load", urdf=str(files.urdf), srdf=str(files.srdf))
                judges.extend(PeerEdgeJudge(process, step_rad) for step_rad in STEPS_RAD)
        scenes = samples or (2 if quick else 134)
        figures = _figures(arm, judges, scenes)
    notes = [f"{scenes * len(FAMILIES) * _PER_SCENE} lines in {scenes} scenes of each family, seed {_SEED}."]
    notes += [f"{name}: its environment is not there (python -m tools.benchmark.peers)" for name in missing]
    return Report("collision", quick, figures, notes=notes)


def _figures(arm: Arm, judges: Sequence[EdgeJudge], scenes: int) -> list[Figure]:
    times: dict[str, list[float]] = {judge.name: [] for judge in judges}
    optimistic: dict[str, list[float]] = {judge.name: [] for judge in judges}
    pessimistic: dict[str, list[float]] = {judge.name: [] for judge in judges}
    free_share: list[float] = []
    for number, (objects, edges) in enumerate(_edges(arm, scenes)):
        referee = ArmJudge(arm, objects)
        truth = [referee.edge_is_free(a, b) for a, b in edges]
        turn = number % len(judges)
        if number == 0:
            for judge in judges:
                judge.judge(objects, edges)
        for judge in [*judges[turn:], *judges[:turn]]:
            free, seconds = judge.judge(objects, edges)
            times[judge.name].append(1e6 * seconds / len(edges))
            both = list(zip(free, truth, strict=True))
            optimistic[judge.name].append(100.0 * sum(f and not t for f, t in both) / len(both))
            pessimistic[judge.name].append(100.0 * sum(t and not f for f, t in both) / len(both))
        free_share.append(100.0 * sum(truth) / len(truth))
    return [
        *_rows(judges, times, optimistic, pessimistic),
        Figure("lines that are free, %", float(np.mean(free_share)), None, None, 1.0),
    ]


def _rows(
    judges: Sequence[EdgeJudge],
    times: dict[str, list[float]],
    optimistic: dict[str, list[float]],
    pessimistic: dict[str, list[float]],
) -> list[Figure]:
    ours, peers = judges[0].name, [judge.name for judge in judges[1:]]
    rows = []
    compared: list[str | None] = [*peers] or [None]
    for peer in compared:
        peer_times = times[peer] if peer else []
        rows.append(figure("line of 2 rad, us", times[ours], peer, peer_times))
        for name, shares in (("optimistic errors, %", optimistic), ("pessimistic errors, %", pessimistic)):
            # shares, not times: their mean over all lines is what counts
            value = float(np.mean(shares[ours]))
            rows.append(Figure(name, value, peer, float(np.mean(shares[peer])) if peer else None, 1.0))
    return rows


def _edges(arm: Arm, scenes: int) -> Iterator[tuple[tuple[SceneObject, ...], Array]]:
    for family in FAMILIES:
        for problem in problems(arm, family, scenes, seed=_SEED):
            rng = np.random.default_rng([7, problem.number])
            judge = ArmJudge(arm, problem.objects)
            yield problem.objects, np.array([_edge(arm, judge, rng) for _ in range(_PER_SCENE)])


def _edge(arm: Arm, judge: ArmJudge, rng: np.random.Generator) -> tuple[Array, Array]:
    """A line from a free configuration in a random direction, within the limits."""
    lower, upper = arm.lower + 0.02, arm.upper - 0.02
    while True:
        a = rng.uniform(lower, upper)
        if judge.collides(a):
            continue
        direction = rng.normal(size=len(a))
        b = a + direction * (LENGTH_RAD / np.linalg.norm(direction))
        if np.all(b > lower) and np.all(b < upper):
            return a, b

"""Whole-body inverse kinematics: TALOS on its feet, a hand to a pose, side by side with the peers."""

from __future__ import annotations

import contextlib
import importlib.metadata
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from executive.config import APPLICATION
from kinematics.arrays import Array
from kinematics.ik.placo_ik import without_meshes
from kinematics.ik.result import IkTolerance
from kinematics.ik.solver import inverse_kinematics
from kinematics.model.standing_robot import StandingRobot
from tools.benchmark.contest import Result, standings
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import PeerProcess, peer_process
from tools.benchmark.reaches import HAND, Reach, ReachingBody
from tools.benchmark.report import Report, contest_figures

PEERS = {"pink": "reach_pink", "mink": "reach_mink"}
TOLERANCE = IkTolerance()
_BASE_LINK = "base_link"


class Solver(Protocol):
    """Somebody who solves whole-body inverse kinematics."""

    @property
    def name(self) -> str:
        """Who it is, with the version."""

    def reach(self, reach: Reach) -> tuple[Array | None, float]:
        """A configuration, or None, and the processor time, s."""


class OwnSolver:
    """The product's whole-body inverse kinematics, from one start after another."""

    def __init__(self, body: ReachingBody) -> None:
        self.name = f"{APPLICATION} {importlib.metadata.version(APPLICATION)}"
        self._ik = inverse_kinematics(StandingRobot(body.model, body.stance), HAND)

    def reach(self, reach: Reach) -> tuple[Array | None, float]:
        """Solve from the first start that leads there."""
        began_s = time.process_time()
        for start in reach.starts:
            result = self._ik.solve(reach.world_T_tcp, start, TOLERANCE)
            if result.within(TOLERANCE):
                return result.q, time.process_time() - began_s
        return None, time.process_time() - began_s


class PeerSolver:
    """A peer that solves in its own environment."""

    def __init__(self, process: PeerProcess, question: Mapping[str, Any]) -> None:
        self.name = process.environment.version.replace("==", " ")
        self._process = process
        process.ask("load", **question)

    def reach(self, reach: Reach) -> tuple[Array | None, float]:
        """Ask the peer."""
        answer = self._process.ask("reach", target=reach.world_T_tcp.tolist(), starts=reach.starts.tolist())
        return None if answer["q"] is None else np.array(answer["q"]), answer["solve_s"]


def robot_question(body: ReachingBody, folder: Path) -> dict[str, Any]:
    """What a peer needs to know: the robot, where it stands, and when a pose counts as reached."""
    folder.mkdir(parents=True, exist_ok=True)
    urdf = folder / "talos_bodies.urdf"
    urdf.write_text(without_meshes(body.model.description.planning_urdf), "utf-8")
    vertices = body.polygon.vertices_m
    edges = np.roll(vertices, -1, axis=0) - vertices
    outward = np.column_stack([edges[:, 1], -edges[:, 0]]) / np.linalg.norm(edges, axis=1, keepdims=True)
    offsets = np.sum(outward * vertices, axis=1) - TOLERANCE.com_margin_m
    com = [*vertices.mean(axis=0).tolist(), float(body.model.com(body.model.q_home)[2])]
    return {
        "urdf": str(urdf),
        "base": _BASE_LINK,
        "joints": list(body.model.joints),
        "lower": body.lower.tolist(),
        "upper": body.upper.tolist(),
        "home": body.model.q_home.tolist(),
        "soles": [[frame, pose.tolist()] for frame, pose in body.stance.soles],
        "tcp": body.tcp,
        "com": com,
        "support": np.column_stack([outward, offsets]).tolist(),
        "position_m": TOLERANCE.position_m,
        "orientation_rad": TOLERANCE.orientation_rad,
    }


def ik(quick: bool, cache: Path, samples: int | None = None, peers: Sequence[str] = tuple(PEERS)) -> Report:
    """Random reaches, each put to everybody in turn."""
    body = ReachingBody()
    question = robot_question(body, cache / "talos")
    results: list[Result] = []
    missing = [name for name in peers if not PeerEnvironment(name, cache).is_ready]
    with contextlib.ExitStack() as stack:
        solvers: list[Solver] = [OwnSolver(body)]
        for name in peers:
            if name not in missing:
                process = stack.enter_context(peer_process(PeerEnvironment(name, cache), PEERS[name]))
                solvers.append(PeerSolver(process, question))
        for number, reach in enumerate(body.reaches(samples or (40 if quick else 1000), seed=0)):
            if number == 0:  # once more before all, and not counted: it warms up
                for solver in solvers:
                    solver.reach(reach)
            turn = number % len(solvers)
            for solver in (*solvers[turn:], *solvers[:turn]):
                q, seconds = solver.reach(reach)
                results.append(_judged(body, solver, number, reach, q, seconds))
    found = standings(results)
    notes = [f"{name}: its environment is not there (python -m tools.benchmark.peers)" for name in missing]
    return Report("ik", quick, contest_figures("whole-body reach, ms", found), found, notes)


def _judged(
    body: ReachingBody, solver: Solver, number: int, reach: Reach, q: Array | None, seconds: float
) -> Result:
    return Result(
        planner=solver.name,
        problem=str(number),
        family="reach",
        solved=q is not None,
        valid=q is not None and body.judge(reach, q, TOLERANCE),
        set_up_s=0.0,
        solve_s=seconds,
        length_rad=0.0 if q is None else float(np.linalg.norm(q[7:] - reach.starts[0][7:])),
    )

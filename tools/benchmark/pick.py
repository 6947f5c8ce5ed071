"""A pick from request to checked motions, amid clutter, beside the same by peers, and how many are found."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.pick import PickPlan, PickRequest
from robots.models.description import load_description
from tools.benchmark.figures import Figure, figure
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import peer_process
from tools.benchmark.peers.picks import PARTS, STAGES, PeerPick, PeerPicker, peer_picker
from tools.benchmark.pick_search import BUDGET_S, RUNNER, LongSearch
from tools.benchmark.problems.picks import picks
from tools.benchmark.report import Report

QUICK_BUDGET_S = 5.0
# What the peers move, and whether that is the whole body.
SPACES = {"trunk and arm": False, "whole body": True}


@dataclass(frozen=True, slots=True)
class Trial:
    """One pick, by the product and, where they are installed, by the peers, once in each of ``SPACES``."""

    request: PickRequest
    solved: bool
    own_s: float
    peers: Mapping[str, PeerPick]


def pick(quick: bool, cache: Path, samples: int | None = None) -> Report:
    """Grasp, inverse kinematics, path, timing and check of every pick; a long search tells what was possible.

    The search is asked only about picks for which the product has no plan: what it plans and checks is
    possible.
    """
    model = RobotModel(load_description("talos"))
    missing = [name for name in PARTS if not PeerEnvironment(name, cache).is_ready]
    with contextlib.ExitStack() as stack:
        peers = {
            name: stack.enter_context(peer_picker(model, cache, whole_body))
            for name, whole_body in ({} if missing else SPACES).items()
        }
        trials = _trials(model, peers, samples or (8 if quick else 200))
    found_s = [trial.own_s for trial in trials if trial.solved]
    notes, possible = [f"{len(found_s)} of {len(trials)} picks were planned and checked, seed 0."], 0
    unsolved = [trial.request for trial in trials if not trial.solved]
    if "ompl" not in missing:
        with peer_process(PeerEnvironment("ompl", cache), RUNNER) as process:
            search = LongSearch(process, model, cache / "talos")
            budget_s = QUICK_BUDGET_S if quick else BUDGET_S
            answers = [search.search(request, budget_s) for request in unsolved]
        possible = sum(answer.solved for answer in answers)
        notes.append(
            f"Of {len(unsolved)} picks without a plan the search solved {possible}, in {budget_s:.0f} s each."
        )
    notes += [f"{name}: its environment is not there (python -m tools.benchmark.peers)" for name in missing]
    refused_s = [trial.own_s for trial in trials if not trial.solved]
    figures = [*_figures(found_s, refused_s, possible), *peer_figures(trials)]
    return Report("pick", quick, figures, notes=[*notes, *peer_notes(trials)])


def _trials(model: RobotModel, peers: Mapping[str, PeerPicker], count: int) -> list[Trial]:
    """Everybody in turn, beginning with another one each time, after a first pick that does not count."""
    planner, checker = MotionPlanner(model), TrajectoryChecker(model)
    trials = []
    for number, request in enumerate(picks(model, count, seed=0)):
        if number == 0:
            solves(planner, checker, request)
            for peer in peers.values():
                peer.pick(request)
        found: dict[str, PeerPick] = {}
        solved, own_s = False, 0.0
        turn = ["", *peers]
        begin = number % len(turn)
        for name in (*turn[begin:], *turn[:begin]):
            if name:
                found[name] = peers[name].pick(request)
                continue
            began_s = time.process_time()
            solved = solves(planner, checker, request)
            own_s = time.process_time() - began_s
        trials.append(Trial(request, solved, own_s, found))
    return trials


def peer_figures(trials: Sequence[Trial]) -> list[Figure]:
    """The product beside the peers, on those picks that both planned."""
    found = []
    for name in SPACES:
        both = _both(trials, name)
        if both:
            own_ms = [1e3 * own_s for own_s, _ in both]
            for how, peer_s in _judged(both).items():
                peer = f"mink, OMPL and toppra, {name}, Coal every {how}"
                found.append(figure("pick that both planned, ms", own_ms, peer, (1e3 * peer_s).tolist()))
    return found


def peer_notes(trials: Sequence[Trial]) -> list[str]:
    """How many the peers planned, the spread of the ratios, and where the peers' time goes."""
    notes = []
    for name in SPACES:
        both = _both(trials, name)
        if not both:
            continue
        planned = sum(trial.peers[name].solved for trial in trials)
        own_s = np.array([own_s for own_s, _ in both])
        ratios = ", ".join(
            f"{_quartiles(peer_s / own_s)} and at the p95 {_p95(peer_s) / _p95(own_s):.1f} (every {how})"
            for how, peer_s in _judged(both).items()
        )
        stages = ", ".join(
            f"{stage} {1e3 * float(np.median([peer.seconds.get(stage, 0.0) for _, peer in both])):.1f}"
            for stage in STAGES
        )
        notes.append(
            f"Peers, {name}: {planned} of {len(trials)} picks planned; times slower on single picks that "
            f"both planned, quartiles: {ratios}; medians of the stages, ms: {stages}."
        )
    return notes


def _judged(both: Sequence[tuple[float, PeerPick]]) -> dict[str, Array]:
    """The peers' times by how often the last judgement looks."""
    return {
        "1/256 rad": np.array([peer.by_way_s for _, peer in both]),
        "0.5 ms": np.array([peer.by_time_s for _, peer in both]),
    }


def _both(trials: Sequence[Trial], name: str) -> list[tuple[float, PeerPick]]:
    return [
        (trial.own_s, trial.peers[name])
        for trial in trials
        if trial.solved and name in trial.peers and trial.peers[name].solved
    ]


def _quartiles(values: Array) -> str:
    return "–".join(f"{value:.1f}" for value in np.percentile(values, (25, 75)))


def _p95(samples: Array) -> float:
    return float(np.percentile(samples, 95))


def _figures(found_s: list[float], refused_s: list[float], possible: int) -> list[Figure]:
    rows = []
    if found_s:
        rows.append(figure("pick planned and checked, ms", [1e3 * s for s in found_s]))
    if refused_s:
        rows.append(figure("pick refused, ms", [1e3 * s for s in refused_s]))
    share = 100.0 * len(found_s) / max(1, len(found_s) + possible)
    return [*rows, Figure("found of the possible ones, %", share, None, None, 1.0)]


def solves(planner: MotionPlanner, checker: TrajectoryChecker, request: PickRequest) -> bool:
    """Plan, and check every motion of the plan as the product does before it moves."""
    plan = planner.answer(request)
    if not isinstance(plan, PickPlan):
        return False
    steps = (plan.reach, plan.approach, plan.lift)
    answers = [checker.check(step.trajectory, step.scene, step.concessions) for step in steps]
    return all(isinstance(answer, CheckedTrajectory) for answer in answers)

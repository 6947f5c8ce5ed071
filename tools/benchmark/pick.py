"""A pick from request to checked motions, amid clutter, beside the same by peers, and how many are found."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from kinematics.motion_planner import MotionPlanner
from kinematics.requests import CheckRequest, PickPlan, PickRequest
from kinematics.robot_model import RobotModel
from kinematics.trajectory import CheckedTrajectory
from robots.description import load_description
from tools.benchmark.figures import Figure, figure
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import peer_process
from tools.benchmark.pick_peers import PARTS, STAGES, PeerPick, PeerPicker, peer_picker
from tools.benchmark.pick_search import BUDGET_S, RUNNER, LongSearch
from tools.benchmark.problems.picks import picks
from tools.benchmark.report import Report

QUICK_BUDGET_S = 5.0


@dataclass(frozen=True, slots=True)
class Trial:
    """One pick, by the product and by the peers where they are installed."""

    request: PickRequest
    solved: bool
    own_s: float
    peer: PeerPick | None


def pick(quick: bool, cache: Path, samples: int | None = None) -> Report:
    """Grasp, inverse kinematics, path, timing and check of every pick; a long search tells what was possible.

    The search is asked only about picks for which the product has no plan: what it plans and checks is
    possible.
    """
    model = RobotModel(load_description("talos"))
    missing = [name for name in PARTS if not PeerEnvironment(name, cache).is_ready]
    with contextlib.ExitStack() as stack:
        peer = None if missing else stack.enter_context(peer_picker(model, cache))
        trials = _trials(model, peer, samples or (8 if quick else 200))
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


def _trials(model: RobotModel, peer: PeerPicker | None, count: int) -> list[Trial]:
    """Everybody in turn, beginning with another one each time, after a first pick that does not count."""
    planner = MotionPlanner(model)
    trials = []
    for number, request in enumerate(picks(model, count, seed=0)):
        if number == 0:
            _solves(planner, request)
            if peer is not None:
                peer.pick(request)
        first = peer.pick(request) if peer is not None and number % 2 else None
        began_s = time.process_time()
        solved = _solves(planner, request)
        own_s = time.process_time() - began_s
        last = peer.pick(request) if peer is not None and first is None else first
        trials.append(Trial(request, solved, own_s, last))
    return trials


def peer_figures(trials: Sequence[Trial]) -> list[Figure]:
    """The product beside the peers, on those picks that both planned."""
    both = _both(trials)
    if not both:
        return []
    own_ms = [1e3 * own_s for own_s, _ in both]
    ways = {
        "mink, OMPL and toppra; Coal every 1/256 rad": [1e3 * peer.by_way_s for _, peer in both],
        "mink, OMPL and toppra; Coal every 0.5 ms": [1e3 * peer.by_time_s for _, peer in both],
    }
    name = "pick that both planned, ms"
    found = [figure(name, own_ms, peer, peer_ms) for peer, peer_ms in ways.items()]
    slow = [Figure(f"{name}, p95", _p95(own_ms), peer, _p95(peer_ms), 1.0) for peer, peer_ms in ways.items()]
    return [*found, *slow]


def peer_notes(trials: Sequence[Trial]) -> list[str]:
    """How many the peers planned, the spread of the ratios, and where the peers' time goes."""
    both = _both(trials)
    if not both:
        return []
    planned = sum(trial.peer is not None and trial.peer.solved for trial in trials)
    spreads = [
        "–".join(
            f"{ratio:.1f}" for ratio in np.percentile([seconds / own_s for own_s, seconds in pairs], (25, 75))
        )
        for pairs in (
            [(own_s, peer.by_way_s) for own_s, peer in both],
            [(own_s, peer.by_time_s) for own_s, peer in both],
        )
    ]
    stages = [
        f"{stage} {1e3 * float(np.median([peer.seconds.get(stage, 0.0) for _, peer in both])):.1f}"
        for stage in STAGES
    ]
    return [
        f"The peers planned {planned} of {len(trials)} picks. On single picks that both planned they took "
        f"{spreads[0]} times as long (quartiles) with Coal at every 1/256 rad, {spreads[1]} times with Coal "
        "at every 0.5 ms.",
        f"The peers' medians, ms: {', '.join(stages)}.",
    ]


def _both(trials: Sequence[Trial]) -> list[tuple[float, PeerPick]]:
    return [
        (trial.own_s, trial.peer)
        for trial in trials
        if trial.solved and trial.peer is not None and trial.peer.solved
    ]


def _p95(samples: Sequence[float]) -> float:
    return float(np.percentile(samples, 95))


def _figures(found_s: list[float], refused_s: list[float], possible: int) -> list[Figure]:
    rows = []
    if found_s:
        rows.append(figure("pick planned and checked, ms", [1e3 * s for s in found_s]))
    if refused_s:
        rows.append(figure("pick refused, ms", [1e3 * s for s in refused_s]))
    share = 100.0 * len(found_s) / max(1, len(found_s) + possible)
    return [*rows, Figure("found of the possible ones, %", share, None, None, 1.0)]


def _solves(planner: MotionPlanner, request: PickRequest) -> bool:
    """Plan, and check every motion of the plan as the product does before it moves."""
    plan = planner.answer(request)
    if not isinstance(plan, PickPlan):
        return False
    steps = (plan.reach, plan.approach, plan.lift)
    answers = [planner.answer(CheckRequest(step.trajectory, step.scene)) for step in steps]
    return all(isinstance(answer, CheckedTrajectory) for answer in answers)

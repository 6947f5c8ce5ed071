"""A pick from request to checked motions, amid clutter, and how many of the possible ones are found."""

from __future__ import annotations

import time
from pathlib import Path

from kinematics.motion_planner import MotionPlanner
from kinematics.requests import CheckRequest, PickPlan, PickRequest
from kinematics.robot_model import RobotModel
from kinematics.trajectory import CheckedTrajectory
from robots.description import load_description
from tools.benchmark.figures import Figure, figure
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import peer_process
from tools.benchmark.pick_search import BUDGET_S, RUNNER, LongSearch
from tools.benchmark.problems.picks import picks
from tools.benchmark.report import Report

QUICK_BUDGET_S = 5.0


def pick(quick: bool, cache: Path, samples: int | None = None) -> Report:
    """Grasp, inverse kinematics, path, timing and check of every pick; a long search tells what was possible.

    The search is asked only about picks for which the product has no plan: what it plans and checks is
    possible.
    """
    model = RobotModel(load_description("talos"))
    planner = MotionPlanner(model)
    environment = PeerEnvironment("ompl", cache)
    found_s: list[float] = []
    refused_s: list[float] = []
    unsolved: list[PickRequest] = []
    for number, request in enumerate(picks(model, samples or (8 if quick else 200), seed=0)):
        if number == 0:
            _solves(planner, request)
        began_s = time.process_time()
        solved = _solves(planner, request)
        (found_s if solved else refused_s).append(time.process_time() - began_s)
        if not solved:
            unsolved.append(request)
    count = len(found_s) + len(refused_s)
    notes, possible = [f"{len(found_s)} of {count} picks were planned and checked, seed 0."], 0
    if environment.is_ready:
        with peer_process(environment, RUNNER) as process:
            search = LongSearch(process, model, cache / "talos")
            budget_s = QUICK_BUDGET_S if quick else BUDGET_S
            answers = [search.search(request, budget_s) for request in unsolved]
        possible = sum(answer.solved for answer in answers)
        notes.append(
            f"Of {len(unsolved)} picks without a plan the search solved {possible}, in {budget_s:.0f} s each."
        )
    else:
        notes.append("ompl: its environment is not there (python -m tools.benchmark.peers)")
    return Report("pick", quick, _figures(found_s, refused_s, possible), notes=notes)


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

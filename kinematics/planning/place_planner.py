"""Plan to put a held object down: choose spot and turn, then the way over it and straight down onto it.

As with picks, it is the goals that fail: each spot is tried with several turns about the vertical, the
most natural for the arm first, and only those whose way down and whose retreat are free are reached for.
A wide berth of what may stand elsewhere than it was seen comes first. Where no way is free, all are tried
again with less room and with the elbow elsewhere: over a high table it is the forearm that meets the edge.
Last, the way down ends where the object should stand, not below.
"""

from __future__ import annotations

from dataclasses import replace

from kinematics.collision.wide_berth import wide_berth
from kinematics.model.robot_model import RobotModel
from kinematics.planning.place_task import PlaceGoal, PlaceTask
from kinematics.requests.place import PlacePlan, PlaceRequest
from kinematics.requests.step import NoPlan, WhyNoPlan
from kinematics.standing.reserves import LEAST_RESERVE_M
from kinematics.standing.reserves import MOVING_RESERVE_M as RESERVE_M

# So many goals that only a detour may come to are kept.
MOST_BLOCKED = 5
# The same for who asks about many places to stand.
FEW_BLOCKED = 2
# Postures from which a thorough search begins, besides home and the present one.
OTHER_SEEDS = 3


class PlacePlanner:
    """Answers place requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: PlaceRequest) -> PlacePlan | NoPlan:
        """Plan transfer and lowering, or say honestly why there is no plan."""
        usual = PlaceTask(self._model, request, RESERVE_M, 0 if request.quick else None)
        if (plan := self._with_berth(usual, request)) is not None:
            return plan
        if (plan := self._first(usual, request)) is not None:
            return plan
        if request.quick:
            return _no_plan(request, usual, usual.considered)
        thorough = PlaceTask(self._model, request, LEAST_RESERVE_M, OTHER_SEEDS, before=usual)
        if (plan := self._first(thorough, request)) is not None:
            return plan
        considered = usual.considered + thorough.considered
        # a hand that took it from this height may have no room to go lower than that
        spots = tuple(replace(spot, below_m=min(spot.below_m, 0.0)) for spot in request.spots)
        if spots != request.spots:
            level = replace(request, spots=spots)
            high = PlaceTask(self._model, level, LEAST_RESERVE_M, OTHER_SEEDS, before=thorough)
            if (plan := self._first(high, level)) is not None:
                return plan
            considered += high.considered
        return _no_plan(request, thorough, considered)

    def _with_berth(self, usual: PlaceTask, request: PlaceRequest) -> PlacePlan | None:
        """A plan that keeps farther from what may stand elsewhere than it was seen, to be judged as usual."""
        if request.quick:
            return None
        wide = wide_berth(self._model, request.scene, request.q_start, RESERVE_M)
        if wide is request.scene:
            return None
        task = PlaceTask(self._model, replace(request, scene=wide), RESERVE_M, 0, before=usual)
        plan = self._first(task, request)
        return None if plan is None else usual.judged_here(plan, request.spots[plan.spot])

    def _first(self, task: PlaceTask, request: PlaceRequest) -> PlacePlan | None:
        """The first spot and turn that a way leads to; straight ways before detours.

        Where straight ways to several goals are blocked, detours to these come before further goals: who
        reaches into a fridge from beside its door never comes to a spot on a straight way.
        """
        most = FEW_BLOCKED if request.quick else MOST_BLOCKED
        blocked: list[PlaceGoal] = []
        for goal in task.goals():
            straight = task.straight(goal.x_hover)
            if straight is not None and (plan := task.timed(goal, straight)) is not None:
                return plan
            if straight is None and len(blocked) < most:
                blocked.append(goal)
                if len(blocked) == most and (plan := self._around(task, blocked)) is not None:
                    return plan
        return self._around(task, blocked) if len(blocked) < most else None

    def _around(self, task: PlaceTask, blocked: list[PlaceGoal]) -> PlacePlan | None:
        for goal in blocked:
            detour = task.detour(goal)
            if detour is not None and (plan := task.timed(goal, detour)) is not None:
                return plan
        return None


def _no_plan(request: PlaceRequest, task: PlaceTask, considered: int) -> NoPlan:
    return NoPlan(
        f"no way to put the {request.held} down was found",
        dict(task.reasons) or {"no free spot": 1},
        {"spots": float(len(request.spots)), "considered": float(considered)},
        WhyNoPlan.NO_SPOT_IS_REACHED,
    )

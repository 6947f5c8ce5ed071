"""Plan a pick: choose hand and grasp, then reach, approach and lift as one chain of motions.

It is the goals that fail, not the passages (field notes), so many grasps are tried, best first.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve
from kinematics.planning.grasps import (
    ABOVE_MIDDLE,
    least_depth_m,
    least_width_m,
    widest_between_pads_m,
)
from kinematics.planning.grasps_of_shapes import every_height, no_grasp_reason
from kinematics.planning.pick_task import Goal, PickTask, Way
from kinematics.planning.shape_grasps import needs_shape_grasps
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.requests.step import NoPlan, WhyNoPlan
from kinematics.standing.reserves import LEAST_RESERVE_M, PLANNING_RESERVE_M

# So many grasps that a straight reach comes to are compared; without one, so many get a detour.
CHOICES = 2
# One whose cost can be undercut by no more than this is taken at once: half of what a hand without any
# room and a CoM at its limit cost together.
WORTH_WAITING = 0.5
MOST_BLOCKED = 8


class PickPlanner:
    """Answers pick requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: PickRequest) -> PickPlan | NoPlan:
        """Plan reach, approach and lift, or say honestly why there is no plan.

        Of the first few grasps that a straight reach comes to, the best one is taken: by reach,
        clearance and balance; a good one is taken at once. Only when there is none are detours
        searched, and only when there is no such grasp at all, those at other heights, with less room
        and with bent knees. Fingers on a palm come in level wherever they can, bent knees or not.
        """
        if self._palms(request):
            for task in self._tasks(request, level=True):
                if (plan := self._best(task)) is not None:
                    return plan
        considered, reasons = 0, Counter[str]()
        for task in self._tasks(request, level=False):
            if (plan := self._best(task)) is not None:
                return plan
            considered, reasons = considered + task.considered, task.reasons
        if considered == 0 and (nowhere := self._nowhere(request)) is not None:
            return nowhere
        hands = " or ".join(request.hands)
        return NoPlan(
            f"no way to grasp the {request.target} with the {hands} hand was found",
            dict(reasons),
            {"grasps_considered": float(considered)},
            WhyNoPlan.NO_GRASP,
        )

    def _tasks(self, request: PickRequest, *, level: bool) -> Iterator[PickTask]:
        """The usual one, and a thorough one."""
        model, grippers = self._model, self._model.description.grippers
        every = every_height(grippers[hand] for hand in request.hands)
        yield PickTask(model, request, (ABOVE_MIDDLE,), PLANNING_RESERVE_M, upright=True, level=level)
        yield PickTask(model, request, every, LEAST_RESERVE_M, upright=False, level=level)

    def _palms(self, request: PickRequest) -> bool:
        """Whether fingers of a hand that may be used close on a palm."""
        grippers = self._model.description.grippers
        return any(grippers[hand].palm_side_m is not None for hand in request.hands)

    def _nowhere(self, request: PickRequest) -> NoPlan | None:
        """That no hand can take hold of it wherever it is; None for what one could."""
        target = request.scene.objects[request.target]
        if needs_shape_grasps(target.shape.parts):
            reasons = [no_grasp_reason(target, self._model, hand) for hand in request.hands]
            known = [reason for reason in reasons if reason is not None]
            return NoPlan(known[0], {}, {}, WhyNoPlan.TOO_WIDE) if len(known) == len(reasons) else None
        return self._too_wide(request)

    def _too_wide(self, request: PickRequest) -> NoPlan | None:
        """That no hand opens so far; None for what is not too wide."""
        width_m = least_width_m(request.scene.objects[request.target])
        grippers = self._model.description.grippers
        widest_m = max(widest_between_pads_m(grippers[hand]) for hand in request.hands)
        if width_m <= widest_m:
            return self._too_deep(request)
        return NoPlan(
            f"the {request.target} is too wide for the hand: {1000 * width_m:.0f} mm, "
            f"and at most {1000 * widest_m:.0f} mm fit between the fingers",
            {},
            {"width_m": width_m, "widest_m": widest_m},
            WhyNoPlan.TOO_WIDE,
        )

    def _too_deep(self, request: PickRequest) -> NoPlan | None:
        """That no hand's fingers close around it; None for what is not too deep."""
        target, grippers = request.scene.objects[request.target], self._model.description.grippers
        depth_m = min(least_depth_m(target, grippers[hand]) for hand in request.hands)
        around_m = max(grippers[hand].around_m for hand in request.hands)
        if depth_m <= around_m:
            return None
        return NoPlan(
            f"the {request.target} is too deep for the hand: {1000 * depth_m:.0f} mm, "
            f"and the fingers close around {1000 * around_m:.0f} mm at most",
            {},
            {"depth_m": depth_m, "around_m": around_m},
            WhyNoPlan.TOO_WIDE,
        )

    def _best(self, task: PickTask) -> PickPlan | None:
        straight: list[tuple[Goal, Curve]] = []
        blocked: list[Way] = []
        liftable: list[Goal] = []
        for candidate in task.candidates():
            # what follows costs this at least: nothing to wait for
            if straight and min(goal.cost for goal, _ in straight) <= candidate.cost + WORTH_WAITING:
                if (plan := _cheapest(task, straight)) is not None:
                    return plan
                straight.clear()
            way = task.solve(candidate)
            if way is None:
                continue
            reach = task.straight_reach(way)
            if reach is None:
                blocked.append(way)
            elif (goal := task.completed(way)) is not None:
                straight.append((goal, reach))
            if len(straight) >= CHOICES:
                if (plan := _cheapest(task, straight)) is not None:
                    return plan
                straight.clear()
            elif len(liftable) + len(blocked) >= MOST_BLOCKED and not straight:
                liftable += _liftable(task, blocked)
                blocked.clear()
                if len(liftable) >= MOST_BLOCKED:
                    break
        if (plan := _cheapest(task, straight)) is not None:
            return plan
        for goal in sorted([*liftable, *_liftable(task, blocked)], key=lambda item: item.cost):
            detour = task.detour(goal)
            if detour is not None and (plan := task.timed(goal, detour)) is not None:
                return plan
        return None


def _liftable(task: PickTask, ways: Sequence[Way]) -> list[Goal]:
    """Those of some grasps from which hand and target come up free."""
    goals = [goal for way in ways if (goal := task.completed(way)) is not None]
    return [free for goal in goals if (free := task.liftable(goal)) is not None]


def _cheapest(task: PickTask, ways: Sequence[tuple[Goal, Curve]]) -> PickPlan | None:
    """The plan of the best goal that has one."""
    for goal, reach in sorted(ways, key=lambda item: item[0].cost):
        free = task.liftable(goal)
        if free is not None and (plan := task.timed(free, reach)) is not None:
            return plan
    return None

"""One planning problem of a pick: candidates, ways to them, and motions in time.

Many grasps are filtered cheaply (does the open hand alone fit there?), then tried with whole-body
inverse kinematics; which of them are tried and taken, ``pick_planner`` says.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.collision.validity import HandJudge, hand_judge
from kinematics.geometry import poses
from kinematics.ik.gaze import gaze_joints
from kinematics.ik.result import DEFAULT_TOLERANCE
from kinematics.ik.solver import LINE_RESERVE_RAD, along_line
from kinematics.model.palm_grip import LEVEL_SINE
from kinematics.model.robot_description import HANDS, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, PolynomialCurve
from kinematics.planning.grasps import GraspCandidate, GraspTable, key_of
from kinematics.planning.grasps_of_shapes import any_grasp_table
from kinematics.planning.path_planner import PathPlanner
from kinematics.planning.planning_task import CARTESIAN_PACE, CARTESIAN_POINTS, REACH_PACE, PlanningTask
from kinematics.requests.grasp import Grasp
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.scene.concessions import ConcessionReason, touching
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import under_foot_of

# Straight approach: long enough that open fingers clear the object before it begins.
APPROACH_M = 0.10
# Grasps whose room is judged in one call.
AT_A_TIME = 40
# What a hand without room, or a CoM at its limit, costs against 1 rad of an unnatural approach.
CLEARANCE_COST = 0.5
ENOUGH_CLEARANCE_M = 0.03
BALANCE_COST = 0.5
ENOUGH_BALANCE_M = 0.06


@dataclass(frozen=True, slots=True)
class Way:
    """A grasp, and the straight way by which the hand can approach it.

    Attributes:
        candidate: The grasp.
        q: Configuration that holds it.
        gaze: Head joints that look at the target.
        approach: The straight way there.
        x_pregrasp: Free coordinates where that way begins.
        still: Whether the other arm stays as it is, instead of helping to balance.
    """

    candidate: GraspCandidate
    q: Array
    gaze: Mapping[str, float]
    approach: Curve
    x_pregrasp: Array
    still: bool = False


@dataclass(frozen=True, slots=True)
class Goal:
    """A grasp with the curves that carry it out; ``cost`` ranks it, smaller first, ``way`` comes to it."""

    way: Way
    grasp: Grasp
    cost: float
    lift: Curve


class PickTask(PlanningTask):
    """One pick: its candidates are grasps.

    Args:
        model: The robot.
        request: What is asked of it.
        heights: Where to grasp from the side: above the middle, as shares of the object's height.
        reserve_m: Kept beyond the margins.
        upright: Try only what does not bend the knees.
        level: Try only level grasps of hands whose fingers close on a palm: others turn what they hold.
    """

    def __init__(
        self,
        model: RobotModel,
        request: PickRequest,
        heights: Sequence[float],
        reserve_m: float,
        upright: bool,
        level: bool = False,
    ) -> None:
        super().__init__(model, request, reserve_m)
        self._request, self._target = request, request.scene.objects[request.target]
        self._heights, self._upright, self._level = heights, upright, level
        self._rng = np.random.default_rng(request.seed)
        self._hands: dict[Hand, HandJudge] = {}
        self._grasp_planners: dict[Hand, tuple[PlanningScene, PathPlanner]] = {}
        # the search starts at home, which keeps elbows where they belong
        self._seed = self.robot.q_home
        self._in_reach: dict[Hand, Array] = {}
        for hand in request.hands:
            offset = self._target.world_T_object[:3, 3] - self._shoulder(hand)
            if np.linalg.norm(offset[:2]) <= model.description.reach_m:
                self._in_reach[hand] = offset
            else:
                self.reasons["out of reach"] += 1

    def candidates(self) -> Iterator[GraspCandidate]:
        """Grasps of all allowed hands, most natural first; those without room for the hand are counted."""
        tables: list[GraspTable] = []
        rows_of: list[list[int]] = []
        excluded = self._request.excluded
        for hand, offset in self._in_reach.items():
            table = any_grasp_table(
                self._target,
                self._model,
                hand,
                float(np.arctan2(offset[1], offset[0])),
                APPROACH_M,
                self._heights,
                2.0 * math.hypot(offset[0], offset[1]),
            )
            rows = self._wanted(table)
            if excluded:
                rows = [k for k in rows if key_of(hand, table.name(k)) not in excluded]
                if len(rows) < len(table):
                    self.reasons["tried before"] += len(table) - len(rows)
            rows_of.append(rows)
            tables.append(table)
        costs = [table.cost[rows] for table, rows in zip(tables, rows_of, strict=True)]
        every = [(number, at) for number, rows in enumerate(rows_of) for at in range(len(rows))]
        # room is judged for as many at a time as are worth a call, when their turn comes
        fits: dict[tuple[int, int], list[bool]] = {}
        for place in np.argsort(np.concatenate([np.empty(0), *costs]), kind="stable").tolist():
            number, at = every[place]
            table, rows = tables[number], rows_of[number]
            block, row = divmod(at, AT_A_TIME)
            if (number, block) not in fits:
                some = rows[block * AT_A_TIME : (block + 1) * AT_A_TIME]
                fits[number, block] = self._has_room(table.hand, table.world_T_tcp[some]).tolist()
            if fits[number, block][row]:
                yield table.candidate(rows[at])
            else:
                self.considered += 1
                self.reasons["hand collides at the grasp"] += 1

    def _wanted(self, table: GraspTable) -> list[int]:
        """Rows of a table that are to be tried: all, or of fingers on a palm those that are level."""
        if not self._level or self._model.description.grippers[table.hand].palm_side_m is None:
            return list(range(len(table)))
        level = np.abs(table.world_T_tcp[:, 2, 0]) <= LEVEL_SINE
        return [int(row) for row in np.flatnonzero(level)]

    def _has_room(self, hand: Hand, places: Array) -> NDArray[np.bool_]:
        """Whether the hand alone has room, open and closed, and where the approach is solved.

        Args:
            hand: The hand.
            places: Of the TCP at grasps, shape (n, 4, 4).
        """
        if hand not in self._hands:
            scene, target = self._request.scene, self._target.name
            self._hands[hand] = hand_judge(self._model, hand, scene, target, self._reserve_m)
        advance_m = self._model.description.grippers[hand].closing_advance_m
        # where the hand is farthest ahead it has the least room: most grasps are seen to fail at once
        advances_m = [advance_m, *np.linspace(0.0, -APPROACH_M, CARTESIAN_POINTS).tolist()]
        return self._hands[hand].fits_along(places, advances_m)

    def solve(self, candidate: GraspCandidate) -> Way | None:
        """Find the approach to a grasp; a failure is counted with its reason."""
        self.considered += 1
        way = self._solve(candidate)
        if isinstance(way, str):
            self.reasons[way] += 1
            return None
        return way

    def straight_reach(self, way: Way) -> Curve | None:
        """The straight way to the pre-grasp, if it is free."""
        return self.straight(way.x_pregrasp)

    def completed(self, way: Way) -> Goal | None:
        """The same with its lift and what it costs; a failure is counted."""
        grasp = way.candidate.grasp
        lift = self._lift(way)
        if lift is None:
            self.reasons["no straight lift"] += 1
            return None
        clearance_m = self._hands[grasp.hand].clearance_m(grasp.world_T_tcp, ENOUGH_CLEARANCE_M)
        balance_m = self.robot.polygon.com_margin_m(self._model.com(way.q))
        cost = (
            way.candidate.cost
            + CLEARANCE_COST * max(0.0, 1.0 - clearance_m / ENOUGH_CLEARANCE_M)
            + BALANCE_COST * max(0.0, 1.0 - balance_m / ENOUGH_BALANCE_M)
        )
        return Goal(way, grasp, cost, lift)

    def detour(self, goal: Goal) -> Curve | None:
        """A way around what is between here and the pre-grasp."""
        curve = self.path(goal.way.x_pregrasp, [goal.grasp.hand], self._rng)
        if curve is None:
            self.reasons["no path to the pre-grasp"] += 1
        return curve

    def liftable(self, goal: Goal) -> Goal | None:
        """The goal with a lift that is free, farther from joint limits if need be; a failure is counted."""
        lift_scene = self._lift_scene(goal.grasp, self._grasp_planner(goal.grasp.hand)[0])
        planner = self.planner_in(lift_scene, reserve_m=0.0)
        if planner.curve_is_free(goal.lift):
            return goal
        again = self._lift(goal.way, LINE_RESERVE_RAD)
        if again is not None and planner.curve_is_free(again):
            return dataclasses.replace(goal, lift=again)
        self.reasons["lift collides"] += 1
        return None

    def timed(self, goal: Goal, reach: Curve) -> PickPlan | None:
        """Give all three motions of a liftable goal their time."""
        request, target, reason = self._request, self._target.name, ConcessionReason
        links = self._model.description.grippers[goal.grasp.hand].touch_links
        under = under_foot_of(self._target, request.scene)
        held = self._held_scene(goal.grasp, request.scene)
        grasped = touching(links, [target], reason.GRASPED_OBJECT, "approach")
        carried = touching([target], under, reason.SUPPORT_OF_HELD_OBJECT, "lift")
        steps = [
            self.first_step("reach", reach, REACH_PACE),
            self.step("approach", goal.way.approach, CARTESIAN_PACE, grasped),
            self.step("lift", goal.lift, CARTESIAN_PACE, carried, held),
        ]
        if any(step is None for step in steps):
            self.reasons["legs cannot follow"] += 1
            return None
        first, second, third = (step for step in steps if step is not None)
        if not all(self.bears(step.trajectory) for step in (first, second, third)):
            self.reasons["too heavy for the legs"] += 1
            return None
        return PickPlan(goal.grasp, first, second, third, self.considered)

    def _lift(self, way: Way, reserve_rad: float = 0.0) -> Curve | None:
        grasp = way.candidate.grasp
        lifted = poses.translation(0.0, 0.0, self._request.lift_m) @ grasp.world_T_tcp
        ik = self.ik_of(grasp.hand)
        up = along_line(ik, way.q, grasp.world_T_tcp, lifted, CARTESIAN_POINTS, reserve_rad)
        if up is not None and way.still:
            up = self._still(up, grasp.hand)
        if up is None or not self.stays_up(up[-1]):
            return None
        return PolynomialCurve(self.looking(self.space.from_many(up), way.gaze))

    def _solve(self, candidate: GraspCandidate) -> Way | str:
        grasp = candidate.grasp
        ik = self.ik_of(grasp.hand)
        first = ik.solve(grasp.world_T_tcp, self._seed, upright=self._upright, lowest_m=self.lowest_m)
        if not first.within(DEFAULT_TOLERANCE):
            return "no inverse kinematics at the grasp"
        way = self._way(candidate, first.q, still=False)
        palm = self._model.description.grippers[grasp.hand].palm_side_m is not None
        if not palm or not isinstance(way, str):
            return way
        # the thumb of such a hand stands out: where the other arm helps to balance, it comes to the chest
        again = self._way(candidate, first.q, still=True)
        return way if isinstance(again, str) else again

    def _way(self, candidate: GraspCandidate, q: Array, *, still: bool) -> Way | str:
        """The way to a grasp that a configuration holds, shape (nq,); ``still`` as of ``Way``."""
        grasp = candidate.grasp
        ik = self.ik_of(grasp.hand)
        _, near = self._grasp_planner(grasp.hand)
        if still:
            (q,) = self._still(q[None], grasp.hand)
        if not near.is_free(self.space.from_q(q)):
            return "collision at the grasp"
        pregrasp = grasp.world_T_tcp @ poses.translation(-grasp.approach_m, 0.0, 0.0)
        back = along_line(ik, q, grasp.world_T_tcp, pregrasp, CARTESIAN_POINTS)
        if back is None:
            return "no straight approach"
        if still:
            back = self._still(back, grasp.hand)
        if not self.stays_up(q, back[-1]):
            return "too low, too far over or too heavy for the legs"
        gaze = gaze_joints(self._model, back[-1], self._target.world_T_object[:3, 3])
        points = self.looking(self.space.from_many(back[::-1]), gaze)
        if not self.planner.is_free(points[0]):
            return "collision before the approach"
        approach = PolynomialCurve(points)
        if not near.curve_is_free(approach):
            return "approach collides"
        return Way(candidate, q, gaze, approach, points[0], still)

    def _still(self, q: Array, hand: Hand) -> Array:
        """Configurations, shape (n, nq), with the other arm as it is at the start; the TCP stays put."""
        stilled, before = q.copy(), q.shape[1] - len(self._model.joints)
        for other in HANDS:
            if other != hand and f"{other}_arm" in self._model.description.groups:
                columns = before + self._model.group(f"{other}_arm")
                stilled[:, columns] = self._request.q_start[columns]
        return stilled

    def _grasp_planner(self, hand: Hand) -> tuple[PlanningScene, PathPlanner]:
        """Scene and planner in which this hand may touch the target."""
        if hand not in self._grasp_planners:
            links = self._model.description.grippers[hand].touch_links
            scene = self._request.scene.allowing((link, self._target.name) for link in links)
            self._grasp_planners[hand] = scene, self.planner_in(scene, self.planner)
        return self._grasp_planners[hand]

    def _lift_scene(self, grasp: Grasp, scene: PlanningScene) -> PlanningScene:
        """The scene with the target in the hand; what it stands on may still touch it."""
        held = self._held_scene(grasp, scene)
        return held.allowing((self._target.name, name) for name in under_foot_of(self._target, scene))

    def _held_scene(self, grasp: Grasp, scene: PlanningScene) -> PlanningScene:
        """A scene with the target in the hand."""
        gripper = self._model.description.grippers[grasp.hand]
        tcp_T_object = poses.inverse(grasp.world_T_tcp) @ self._target.world_T_object
        return scene.with_attached(self._target.name, gripper.tcp_frame, tcp_T_object, gripper.touch_links)

    def _shoulder(self, hand: Hand) -> Array:
        joint = self._model.pin.getJointId(self._model.description.groups[f"{hand}_arm"][1])
        name = next(f.name for f in self._model.pin.frames if f.parentJoint == joint)
        return self._model.frame_pose(self._request.q_start, name)[:3, 3]

"""One problem of putting a held object down: turns at a spot, ways down that are free, and ways there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.validity import hand_judge
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.ik.arm_frames import link_moved_by
from kinematics.ik.gaze import gaze_joints
from kinematics.ik.result import DEFAULT_TOLERANCE, IkResult
from kinematics.ik.solver import LINE_RESERVE_RAD, along_line
from kinematics.model.palm_grip import released
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, PolynomialCurve
from kinematics.planning.path_planner import PathPlanner
from kinematics.planning.planning_task import CARTESIAN_PACE, CARTESIAN_POINTS, REACH_PACE, PlanningTask
from kinematics.requests.place import PlacePlan, PlaceRequest, Spot
from kinematics.scene.concessions import Concession, ConcessionReason, touching
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.reserves import LEAST_RESERVE_M
from kinematics.timing.curve_timing import Pace

# Down at some 4 cm/s, gently: a hand that is to feel a touch must not feel its own inertia.
LOWER_PACE = Pace(velocity=0.03, acceleration=0.06)
# Steps of the turn about the vertical.
TURNS_RAD = tuple(math.radians(a) for a in (0, 20, -20, 40, -40, 60, -60, 80, -80, 100, -100))
# How far the joints of the arm are from home, at most, in further postures that a search begins from.
OTHER_SEED_RAD = 0.8
# A hand that misses a pose by more than this from home and from the present posture is not helped by others:
# of 669 poses that only those came to, 7 had been missed by more.
HOPELESS_M = 0.2
# Of 267 spots that home missed by more than this with the two most natural turns, none had another turn.
FAR_M = 0.3
FAR_TURNS = 2
# Home and the present posture come before random ones.
_OWN_SEEDS = 2


@dataclass(frozen=True, slots=True)
class PlaceGoal:
    """A spot where the object can be put down, and the straight way down to it.

    Attributes:
        spot: Index of the spot among those of the request.
        world_T_object: Pose of the object at rest there, shape (4, 4).
        lower: The way down, over the free coordinates.
        x_hover: Free coordinates where that way begins.
        lower_scene: Scene in which the object may touch what carries it.
    """

    spot: int
    world_T_object: Transform
    lower: Curve
    x_hover: Array
    lower_scene: PlanningScene


class PlaceTask(PlanningTask):
    """One thing to be put down: its candidates are poses.

    Args:
        model: The robot.
        request: What is to be put down, and where it may go.
        reserve_m: Kept in reserve against the checker.
        other_seeds: The inverse kinematics are tried from the present posture, too, and from so many random
            ones; None for home alone.
        before: A task about the same poses; what it found out about them is not searched again.

    Attributes:
        hand: The hand that holds the object.
    """

    def __init__(
        self,
        model: RobotModel,
        request: PlaceRequest,
        reserve_m: float,
        other_seeds: int | None = None,
        before: PlaceTask | None = None,
    ) -> None:
        super().__init__(model, request, reserve_m)
        self._request = request
        self._body = request.scene.attached[request.held]
        frames = model.description.tcp_frames
        self.hand: Hand = next(hand for hand, frame in frames.items() if frame == self._body.frame)
        self._ik = self.ik_of(self.hand)
        self._reached: dict[tuple[bytes, bytes], IkResult] = {} if before is None else before._reached
        self._seed = self._seed_posture()
        self._rng = np.random.default_rng(request.seed)
        self._seeds = [self._seed]
        self._thorough = bool(other_seeds)
        if other_seeds is not None:
            self._seeds += [request.q_start, *(self._random_posture() for _ in range(other_seeds))]
        self._hand_alone = hand_judge(model, self.hand, request.scene, request.held, LEAST_RESERVE_M)
        self._touching: dict[tuple[str, ...], tuple[PlanningScene, PathPlanner]] = {}
        gripper, tcp_T_object = model.description.grippers[self.hand], self._body.frame_T_object
        # a spot is where the thing stands once the fingers have opened
        self._object_T_tcp = poses.inverse(released(gripper, self._body.body.shape, tcp_T_object))

    def turned(self, spot: Spot) -> Iterator[Transform]:
        """The spot's pose with several turns about the vertical, the hand's natural heading first."""
        shoulder = self._model.frame_pose(self._seed, self._shoulder_link())[:3, 3]
        place = spot.world_T_object[:3, 3]
        natural = math.atan2(place[1] - shoulder[1], place[0] - shoulder[0])
        tcp = spot.world_T_object @ self._object_T_tcp
        heading = poses.yaw_of(tcp[:3, :3])
        if abs(tcp[2, 0]) > 0.97:  # pointing down: what would be ahead without the tilt
            heading = math.atan2(tcp[1, 2], tcp[0, 2])
        # the elbow stays off the trunk when the hand comes from its own outer side
        outward = 1.0 if self.hand == "right" else -1.0
        for turn in TURNS_RAD:
            pose = spot.world_T_object.copy()
            pose[:3, :3] = poses.rotation_z(natural + outward * turn - heading) @ pose[:3, :3]
            yield pose

    def goals(self) -> Iterator[PlaceGoal]:
        """Ways down that are free, spot by spot and turn by turn."""
        for index, spot in enumerate(self._request.spots):
            misses_m: list[float] = []
            for world_T_object in self.with_room_for_hand(spot):
                goal = self.solve(index, spot, world_T_object)
                if goal is not None:
                    yield goal
                misses_m.append(self._reach(world_T_object, self._seed).position_error_m)
                if len(misses_m) == FAR_TURNS and min(misses_m) > FAR_M:
                    break

    def with_room_for_hand(self, spot: Spot) -> Iterator[Transform]:
        """Those of ``turned`` where the hand alone collides with nothing; the others are counted."""
        turned = np.array(list(self.turned(spot)))
        lowest = poses.translation(0.0, 0.0, -spot.below_m) @ turned @ self._object_T_tcp
        for pose, collides in zip(turned, self._hand_alone.collisions(lowest), strict=True):
            self.considered += 1
            if collides:
                self.reasons["hand collides at the spot"] += 1
            else:
                yield pose

    def solve(self, index: int, spot: Spot, world_T_object: Transform) -> PlaceGoal | None:
        """Find the way down to a pose; a failure is counted with its reason."""
        why = ""
        for number, seed in enumerate(self._seeds):
            if number == _OWN_SEEDS and self._is_hopeless(world_T_object):
                break
            goal = self._solve(index, spot, world_T_object, seed)
            if isinstance(goal, PlaceGoal):
                return goal
            why = goal
        self.reasons[why] += 1
        return None

    def detour(self, goal: PlaceGoal) -> Curve | None:
        """A way around what is between here and the hover pose."""
        curve = self.path(goal.x_hover, [self.hand], self._rng)
        if curve is None:
            self.reasons["no path over the spot"] += 1
        return curve

    def timed(self, goal: PlaceGoal, transfer: Curve) -> PlacePlan | None:
        """Give both motions their time."""
        spot = self._request.spots[goal.spot]
        first = self.first_step("transfer", transfer, REACH_PACE)
        second = self.step("lower", goal.lower, LOWER_PACE, self._standing(spot))
        if first is None or second is None:
            self.reasons["legs cannot follow"] += 1
            return None
        return PlacePlan(
            hand=self.hand,
            spot=goal.spot,
            world_T_object=goal.world_T_object,
            transfer=first,
            lower=second,
            considered=self.considered,
        )

    def judged_here(self, plan: PlacePlan, spot: Spot) -> PlacePlan:
        """A plan that was made with wider margins, with this task's scenes to be checked in."""
        scene, near = self._request.scene, self.start_concessions("transfer")
        return replace(
            plan,
            transfer=replace(plan.transfer, scene=scene, concessions=near),
            lower=replace(plan.lower, scene=scene, concessions=self._standing(spot)),
        )

    def _standing(self, spot: Spot) -> tuple[Concession, ...]:
        """What the object may touch where it is put."""
        return touching([self._request.held], spot.touches, ConcessionReason.SUPPORT_OF_HELD_OBJECT, "lower")

    def _near(self, spot: Spot) -> tuple[PlanningScene, PathPlanner]:
        """Scene and judge with what the object may touch at a spot; made once."""
        if spot.touches not in self._touching:
            scene = self.scene.allowing((self._request.held, name) for name in spot.touches)
            self._touching[spot.touches] = scene, self.planner_in(scene, self.planner)
        return self._touching[spot.touches]

    def _solve(self, index: int, spot: Spot, world_T_object: Transform, seed: Array) -> PlaceGoal | str:
        placed = world_T_object @ self._object_T_tcp
        lowest = poses.translation(0.0, 0.0, -spot.below_m) @ placed
        first = self._reach(world_T_object, seed)
        if not first.within(DEFAULT_TOLERANCE):
            return "no inverse kinematics at the spot"
        touching, near = self._near(spot)
        if not near.is_free(self.space.from_q(first.q)):
            return "collision at the spot"
        hover = poses.translation(0.0, 0.0, spot.hover_m) @ placed
        up = self._line(first.q, placed, hover)
        if up is None:
            return "no straight way down"
        down = self._line(up[-1], hover, lowest)
        if down is None:
            return "no straight way down"
        if not (self.stands(up[-1]) and self.stands(down[-1])):
            return "too low or too far over"
        gaze = gaze_joints(self._model, down[0], world_T_object[:3, 3])
        points = self.looking(self.rows(down), gaze)
        if not self.planner.is_free(points[0]):
            return "collision above the spot"
        lower = PolynomialCurve(points)
        if not near.curve_is_free(lower):
            return "collision on the way down"
        if not self._retreat_is_free(first.q, placed, world_T_object, gaze):
            return "no free way back for the hand"
        return PlaceGoal(index, world_T_object, lower, points[0], touching)

    def _reach(self, world_T_object: Transform, seed: Array) -> IkResult:
        """The hand where it holds the object at a pose; later rounds ask about the same poses again."""
        key = world_T_object.tobytes(), seed.tobytes()
        if key not in self._reached:
            self._reached[key] = self._ik.solve(world_T_object @ self._object_T_tcp, seed)
        return self._reached[key]

    def _is_hopeless(self, world_T_object: Transform) -> bool:
        """Whether home and the present posture both end far from a pose."""
        own = self._seeds[:_OWN_SEEDS]
        return min(self._reach(world_T_object, seed).position_error_m for seed in own) > HOPELESS_M

    def _line(self, q: Array, start: Transform, end: Transform) -> Array | None:
        """Configurations along a line; a thorough search keeps off joint limits where it can."""
        if self._thorough:
            found = along_line(self._ik, q, start, end, CARTESIAN_POINTS, LINE_RESERVE_RAD)
            if found is not None:
                return found
        return along_line(self._ik, q, start, end, CARTESIAN_POINTS)

    def _retreat_is_free(
        self, q: Array, placed: Transform, world_T_object: Transform, gaze: dict[str, float]
    ) -> bool:
        back = placed @ poses.translation(-self._request.retreat_m, 0.0, 0.0)
        away = self._line(q, placed, back)
        if away is None:
            return False
        released = self.scene.with_detached(self._request.held, world_T_object)
        released = released.allowing((link, self._request.held) for link in self._body.touch_links)
        curve = PolynomialCurve(self.looking(self.rows(away), gaze))
        if not self.planner_in(released).curve_is_free(curve):
            return False
        return self.step("retreat", curve, CARTESIAN_PACE) is not None

    def _seed_posture(self) -> Array:
        """Home, which keeps elbows where they belong, with the other arm where it is."""
        model, request = self._model, self._request
        q = self.robot.q_home
        other = 7 + model.group("left_arm" if self.hand == "right" else "right_arm")
        q[other] = request.q_start[other]
        return q

    def _random_posture(self) -> Array:
        """Home with the arm that moves elsewhere."""
        model, q = self._model, self._seed.copy()
        arm = 7 + model.group(f"{self.hand}_arm")
        q[arm] += self._rng.uniform(-OTHER_SEED_RAD, OTHER_SEED_RAD, len(arm))
        q[arm] = np.clip(q[arm], model.lower_rad[arm - 7], model.upper_rad[arm - 7])
        return q

    def _shoulder_link(self) -> str:
        return link_moved_by(self._model, self._model.description.groups[f"{self.hand}_arm"][1])

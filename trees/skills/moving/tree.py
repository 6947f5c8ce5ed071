"""Walk at a velocity: the leaf that does it, and the tree around it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import Steering, StretchSteering, TurnSteering, VelocitySteering
from kinematics.walking.route.room import WalkingRoom, stopping_distance_m
from trees.failures import Failure, Number, Reason
from trees.nodes.alternatives import Alternatives
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import optional, ports
from trees.readings.odometry import body_pose, feet_pose
from trees.skills.moving.settings import MoveSettings
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint, narrower_arms_are_useless
from trees.skills.walking.walking_leaf import WalkingLeaf, without_held
from trees.skills.walking.walking_room import walking_room
from trees.tasks import MoveTask
from trees.toolbox import Toolbox

_LOOK_EVERY_S = 0.1
_AIMED_RAD = 2.6
"""A heading that is less than this away is turned to; half a turn might be gone the other way round."""
_CORRECTED_RAD = math.radians(2.0)
_CORRECTIONS = 2
_TURNED_RAD = math.radians(5.0)
_WENT_M, _WENT_SHARE = 0.05, 0.05
"""Off by more, it was not what was asked for."""


class Move(WalkingLeaf):
    """Walk at the velocity of the task, for its time or distance, and stop before an obstacle.

    A velocity beyond the robot's limits is refused, never lowered. A turn on the spot for some time is
    carried out as a turn by the angle that follows from it, and the angle is measured, since soles slip. A
    turn for which the hands, or what they hold, have no room is infeasible; from a step away it may be
    possible.
    """

    INPUT_PORTS = ports(task=MoveTask, stepped_m=optional(float))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the robot stands, its pelvis level, and the way is free beyond the stopping distance",
        postcondition="the robot stands still; odometry measured that it went or turned as far as was asked",
        deadline_s=10.0,
        moves="body",
        on_success="the robot stands where it stopped",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def begin(self) -> None:
        """Nothing has moved yet."""
        super().begin()
        self._stopping = False
        self._looked_s = -math.inf
        self._free_m = math.inf
        self._seen = False
        self._last = PlanarPose()
        self._gone_m = self._turned_rad = self._heading_rad = 0.0
        self._aimed, self._corrections = abs(self._turn_rad) <= _AIMED_RAD, 0

    def step(self) -> Status | Failure:
        """Set out, watch the way, stop in time, and wait until the robot stands."""
        toolbox, task = self.toolbox, self._task
        settings = toolbox.model.description.walking
        if settings is None or toolbox.walking is None:
            message = f"{toolbox.model.description.name} cannot walk here"
            return Failure.infeasible(message).because(Reason.CANNOT_WALK)
        if self._handle is None and (beyond := self._beyond_limits(settings)) is not None:
            return beyond
        blocked = self._blocked(settings)
        if self._handle is None and not self._seen:
            return RUNNING
        if self._handle is None:
            if blocked is not None:
                return blocked
            if task.linear_m_s == 0.0 and task.angular_rad_s == 0.0:
                return DONE
            self._last = body_pose(toolbox)
            self._heading_rad = feet_pose(toolbox).yaw_rad + self._turn_rad
            self._handle = toolbox.walking.walk(self._steering(settings), "walk")
            return RUNNING
        if (ended := self.ended_early(self._handle)) is not None:
            return ended
        self._measure()
        if self._handle.finished:
            return self._corrected(settings) or self._stood()
        if not self._aimed and not self._stopping and abs(self._left_rad) <= _AIMED_RAD:
            self._aimed = True
            toolbox.walking.steer(self._handle, self._turn(settings, task.angular_rad_s))
        if blocked is not None and not self._stopping:
            return blocked
        if not self._stopping and self.elapsed_s >= self._duration_s:
            toolbox.walking.finish(self._handle)
            self._stopping = True
        self.feedback_message = f"{self._gone_m:+.2f} m, {math.degrees(self._turned_rad):+.0f} degrees"
        return RUNNING

    @property
    def deadline_s(self) -> float:
        """The contract's, longer by what was asked for."""
        return self.CONTRACT.deadline_s + 2.0 * self._duration_s

    @property
    def _task(self) -> MoveTask:
        task: MoveTask = self.get_input("task")
        return task

    @property
    def _duration_s(self) -> float:
        """For how long; a distance, or an angle, takes as long as it takes."""
        task = self._task
        if self._turn_rad:
            return 2.0 * abs(self._turn_rad / task.angular_rad_s) + 10.0
        if task.duration_s is not None:
            return task.duration_s
        if task.distance_m is not None and task.linear_m_s != 0.0:
            return 2.0 * abs(task.distance_m / task.linear_m_s) + 10.0
        return self.toolbox.policy.of(MoveSettings).move_s

    @property
    def _turn_rad(self) -> float:
        """How far to turn on the spot, to the left; 0 where that is not said."""
        task = self._task
        if task.linear_m_s != 0.0 or task.duration_s is None:
            return 0.0
        return task.angular_rad_s * task.duration_s

    @property
    def _left_rad(self) -> float:
        return self._turn_rad - self._turned_rad

    def _turn(self, settings: WalkingSettings, angular_rad_s: float) -> TurnSteering:
        return TurnSteering(settings, angular_rad_s, wrapped(self._heading_rad))

    def _corrected(self, settings: WalkingSettings) -> Status | None:
        """Turn by what is left, where the soles have slipped."""
        walking, left_rad = self.toolbox.walking, self._left_rad
        if walking is None or not self._turn_rad or self._stopping:
            return None
        if abs(left_rad) <= _CORRECTED_RAD or self._corrections >= _CORRECTIONS:
            return None
        self._corrections += 1
        rate_rad_s = math.copysign(self._task.angular_rad_s, left_rad)
        self._handle = walking.walk(self._turn(settings, rate_rad_s), "turn on")
        return RUNNING

    def _beyond_limits(self, settings: WalkingSettings) -> Failure | None:
        policy, task = self.toolbox.policy, self._task
        fastest_m_s = min(
            policy.of(MoveSettings).fastest_m_s,
            (settings.forward_m if task.linear_m_s > 0.0 else settings.backward_m) / settings.step_s,
        )
        fastest_rad_s = min(policy.of(MoveSettings).fastest_rad_s, settings.turn_rad / settings.step_s)
        for what, unit, value, limit in (
            ("forward speed", "m/s", task.linear_m_s, fastest_m_s),
            ("turning speed", "rad/s", task.angular_rad_s, fastest_rad_s),
        ):
            if not abs(value) <= limit:
                message = f"a {what} of {value:g} {unit} is beyond the limit of {limit:g} {unit}"
                return Failure.refused(message, value=value, limit=limit)
        for what, number in (("duration", task.duration_s), ("distance", task.distance_m)):
            if number is not None and not 0.0 <= number < math.inf:
                return Failure.refused(f"a {what} of {number:g} makes no sense", value=number)
        return None

    def _blocked(self, settings: WalkingSettings) -> Failure | None:
        """Why it must not go on, from the range sensor's last scan."""
        task, sensor = self._task, self.toolbox.ranging
        if sensor is None or (task.linear_m_s == 0.0 and (self._handle or task.angular_rad_s == 0.0)):
            self._seen = True
            return None
        if self.elapsed_s - self._looked_s >= _LOOK_EVERY_S:
            points = sensor.scan()
            if points is None:
                return Failure.execution("the range sensor has fallen silent") if self._seen else None
            self._looked_s, self._seen = self.elapsed_s, True
            points, room = without_held(self.toolbox, points), walking_room(self.toolbox, settings)
            if task.linear_m_s == 0.0:
                return self._no_room_to_turn(room, points)
            self._free_m = room.free_way_m(points, task.linear_m_s)
        needed_m = stopping_distance_m(settings, task.linear_m_s)
        if self._free_m > needed_m:
            return None
        where = "ahead" if task.linear_m_s > 0.0 else "behind"
        return Failure.refused(
            f"an obstacle is {max(self._free_m, 0.0):.2f} m {where}, nearer than the stopping distance of "
            f"{needed_m:.2f} m",
            free_m=self._free_m,
            needed_m=needed_m,
        )

    def _no_room_to_turn(self, room: WalkingRoom, points: NDArray[np.float64]) -> Failure | None:
        turn_rad = self._turn_rad or self._task.angular_rad_s * self._duration_s
        part = room.turn_meets(points, max(-math.tau, min(turn_rad, math.tau)))
        if part is None:
            return None
        return Failure.infeasible(f"there is no room to turn for the {part}").because(Reason.NO_ROOM)

    def _measure(self) -> None:
        now = body_pose(self.toolbox)
        gone = self._last.to(now)
        self._gone_m += gone.x_m
        self._turned_rad += gone.yaw_rad
        self._last = now

    def _steering(self, settings: WalkingSettings) -> Steering:
        task = self._task
        if task.distance_m is not None and task.linear_m_s != 0.0 and task.angular_rad_s == 0.0:
            return StretchSteering(settings, self._last, task.linear_m_s, task.distance_m)
        if self._turn_rad and self._aimed:
            return self._turn(settings, task.angular_rad_s)
        return VelocitySteering(settings, task.linear_m_s, task.angular_rad_s)

    def _stood(self) -> Status | Failure:
        evidence: dict[str, Number] = {
            "walked_m": self._gone_m,
            "turned_rad": self._turned_rad,
            "mean_m_s": self._gone_m / max(self.elapsed_s, 1e-6),
        }
        if (stepped_m := self.optional("stepped_m")) is not None:
            evidence["stepped_before_m"] = stepped_m
        if self._turn_rad and abs(self._left_rad) > _TURNED_RAD:
            turned, asked = (math.degrees(abs(rad)) for rad in (self._turned_rad, self._turn_rad))
            return Failure.postcondition(
                f"it turned by {turned:.0f} degrees, not by {asked:.0f}", None, **evidence
            )
        asked_m = self._task.distance_m
        if asked_m is not None and self._task.linear_m_s != 0.0:
            gone_m = abs(self._gone_m)
            if abs(gone_m - asked_m) > max(_WENT_M, _WENT_SHARE * asked_m):
                return Failure.postcondition(f"it went {gone_m:.2f} m, not {asked_m:.2f}", None, **evidence)
        self._set_output("evidence", evidence)
        return DONE


def move(toolbox: Toolbox) -> Behaviour:
    """Stand upright where the body leans, walk at a velocity for a time or a distance, then stand.

    Where the hands have no room to turn on the spot, a step away comes first.
    """
    upright = ReadyToWalk("stand upright", toolbox, only_if_it_leans=True)
    away = [
        ReadyToWalk("hands at home", toolbox),
        change_viewpoint(toolbox, "room"),
        Move("walk", toolbox),
    ]
    ways = [Move("walk", toolbox), Sequence("from a step away", memory=True, children=away)]
    walk = Alternatives("walk or turn", ways, narrower_arms_are_useless)
    return Sequence("move", memory=True, children=[upright, walk])

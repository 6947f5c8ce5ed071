"""Walk at velocities that are sent while the robot walks, and stop when they fall silent."""

from __future__ import annotations

import math
from dataclasses import replace

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import VelocitySteering
from trees.failures import Failure
from trees.nodes.leaf import RUNNING
from trees.readings.odometry import body_pose
from trees.skills.moving.settings import MoveSettings
from trees.skills.moving.tree import Move
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.tasks import MoveTask
from trees.toolbox import Toolbox


class Drive(Move):
    """Follow the velocities of the toolbox's feed; a silence ends it, and the robot stands.

    A velocity of zero stands and goes on listening. What ``Move`` refuses is refused here as well: a velocity
    beyond the limits, and a way that is not free.
    """

    CONTRACT = replace(
        Move.CONTRACT,
        precondition="the robot stands, its pelvis level, and velocities are sent",
        postcondition="the robot stands still, since nothing was sent any more",
        deadline_s=600.0,
    )

    def begin(self) -> None:
        """Nothing was followed yet."""
        super().begin()
        self._followed: tuple[float, float] = (0.0, 0.0)

    def step(self) -> Status | Failure:
        """Set out, follow what is sent, stop on silence."""
        walking, settings = self.toolbox.walking, self.toolbox.model.description.walking
        if walking is None or settings is None:
            return super().step()
        if self._handle is not None and (ended := self.ended_early(self._handle)) is not None:
            return ended
        if self._handle is not None:
            self._measure()
        if (beyond := self._beyond_limits(settings)) is not None:
            return beyond
        task = self._task
        wanted = (task.linear_m_s, task.angular_rad_s)
        if wanted != (0.0, 0.0) and (blocked := self._blocked(settings)) is not None:
            return blocked
        if self._handle is not None and self._handle.finished:
            self._handle, self._stopping = None, False
        if self._handle is None:
            return self._stand(wanted, settings)
        if wanted == (0.0, 0.0):
            if not self._stopping:
                walking.finish(self._handle)
                self._stopping = True
        elif wanted != self._followed and not self._stopping:
            walking.steer(self._handle, VelocitySteering(settings, *wanted))
            self._followed = wanted
        self.feedback_message = f"{self._gone_m:+.2f} m, {math.degrees(self._turned_rad):+.0f} degrees"
        return RUNNING

    @property
    def deadline_s(self) -> float:
        """The contract's: whoever goes on sending velocities begins anew then."""
        return self.CONTRACT.deadline_s

    @property
    def _task(self) -> MoveTask:
        """What is asked for now: nothing once it is silent."""
        task, heard = super()._task, self._heard()
        if heard is None:
            return replace(task, linear_m_s=0.0, angular_rad_s=0.0)
        return replace(task, linear_m_s=heard[0], angular_rad_s=heard[1])

    def _heard(self) -> tuple[float, float] | None:
        feed = self.toolbox.velocities
        newest = None if feed is None else feed.newest
        if newest is None:
            return None
        silent_s = self.toolbox.clock.now_s() - newest.heard_s
        if silent_s > self.toolbox.policy.of(MoveSettings).silence_s:
            return None
        return newest.linear_m_s, newest.angular_rad_s

    def _stand(self, wanted: tuple[float, float], settings: WalkingSettings) -> Status | Failure:
        """Stand and listen, set out, or end."""
        walking = self.toolbox.walking
        if self._heard() is None:
            return self._stood()
        if wanted != (0.0, 0.0) and self._seen and walking is not None:
            self._last = body_pose(self.toolbox)
            self._handle = walking.walk(VelocitySteering(settings, *wanted), "drive")
            self._followed = wanted
        return RUNNING


def drive(toolbox: Toolbox) -> Behaviour:
    """Stand upright where the body leans, follow velocities as they are sent, then stand."""
    upright = ReadyToWalk("stand upright", toolbox, only_if_it_leans=True)
    return Sequence("drive", memory=True, children=[upright, Drive("walk", toolbox)])

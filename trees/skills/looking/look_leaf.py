"""A leaf that gathers what the camera sees from now on."""

from __future__ import annotations

from dataclasses import dataclass

from py_trees.common import Status

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from robots.perception.detector import PerceptionFrame
from robots.perception.object_estimate import ObjectEstimate, fuse_frames
from trees.failures import Failure
from trees.nodes.leaf import RUNNING, Leaf


@dataclass(frozen=True, slots=True)
class View(Sealed):
    """One picture, and where it was taken from.

    Attributes:
        odom_T_camera: Pose of the camera when the picture was taken, shape (4, 4).
        frame: What the detector has found in the picture.
    """

    odom_T_camera: Transform
    frame: PerceptionFrame


class GatheringLeaf(Leaf):
    """A leaf that gathers pictures taken after its start, each once, with the camera's pose at that time."""

    _views: list[View]

    def begin(self) -> None:
        """Forget earlier frames."""
        self._views = []

    def gather(self) -> None:
        """Take the newest frame if it is one that we have not got."""
        frame = self.toolbox.detector.latest()
        if frame is None or frame.stamp_s < self._started_s:
            return
        if self._views and frame.sequence <= self._views[-1].frame.sequence:
            return
        q = self.toolbox.sensing.state_at(frame.stamp_s).q
        model = self.toolbox.model
        self._views.append(View(model.frame_pose(q, model.description.camera.frame), frame))


class LookLeaf(GatheringLeaf):
    """A leaf that gathers as many pictures as a look needs, and then judges them together."""

    def judge(self, views: list[View]) -> Status | Failure:
        """With enough frames gathered: what follows from them."""
        raise NotImplementedError

    def step(self) -> Status | Failure:
        """Gather until there are enough."""
        self.gather()
        wanted = self.toolbox.policy.look_frames
        if len(self._views) < wanted:
            self.feedback_message = f"{len(self._views)} of {wanted} frames"
            return RUNNING
        return self.judge(self._views)

    @property
    def deadline_s(self) -> float:
        """The policy's time for a look."""
        return self.toolbox.policy.look_timeout_s


def estimates_of(views: list[View]) -> tuple[ObjectEstimate, ...]:
    """What at least half of the frames show, fused."""
    return fuse_frames(
        [(view.odom_T_camera, view.frame) for view in views], min_frames=max(1, (len(views) + 1) // 2)
    )

"""A leaf that gathers what the camera sees from now on."""

from __future__ import annotations

from dataclasses import dataclass

from py_trees.common import Status

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from robots.perception.detector import PerceptionFrame
from robots.perception.fusion.frame_watch import Fault, FrameWatch
from robots.perception.object_estimate import ObjectEstimate, fuse_frames
from trees.failures import Failure, Reason
from trees.nodes.leaf import RUNNING, Leaf
from trees.readings.disagreement import tell_disagreement

_REASONS = {Fault.FROZEN: Reason.FRAMES_FROZEN, Fault.STALE: Reason.FRAMES_STALE}


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
        self._watch = FrameWatch(self.toolbox.clock.now_s())
        self._fault: Failure | None = None

    def gather(self) -> None:
        """Take the newest frame if it is one that we have not got, and it tells of now."""
        frame = self.toolbox.detector.latest()
        fault = self._watch.take(frame, self.toolbox.clock.now_s())
        if fault is not None:
            self._note(fault)
            return
        if frame is None or frame.stamp_s < self._started_s:
            return
        if self._views and frame.sequence <= self._views[-1].frame.sequence:
            return
        q = self.toolbox.sensing.state_at(frame.stamp_s).q
        model = self.toolbox.model
        self._views.append(View(model.frame_pose(q, model.description.camera.frame), frame))

    def _note(self, fault: Fault) -> None:
        """Tell what is wrong with the camera, once; the look goes on, for the camera may come back."""
        failure = Failure.timeout(f"the camera delivers {fault.value}", after_s=self.elapsed_s)
        failure = failure.because(_REASONS[fault]).at(self.where)
        if self._fault is None:
            tell_disagreement(self.toolbox, failure)
        self._fault = failure


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
            if self._fault is not None and self.elapsed_s > self.deadline_s:
                return self._fault
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

"""A leaf that gathers what the camera sees from now on."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from statistics import median

from py_trees.common import Status

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from robots.perception.detector import Detector, PerceptionFrame
from robots.perception.fusion.cameras import HEAD, Seen, seen_by_all
from robots.perception.fusion.frame_watch import Fault, FrameWatch
from robots.perception.object_estimate import ObjectEstimate, fuse_frames
from trees.failures import Failure, FailureKind, Reason
from trees.nodes.leaf import RUNNING, Leaf
from trees.readings.disagreement import tell_disagreement

_REASONS = {Fault.FROZEN: Reason.FRAMES_FROZEN, Fault.STALE: Reason.FRAMES_STALE}

_BAD_S = 0.35
"""When every picture has been bad for so long, the camera is; with its latency that is half a second."""


@dataclass(frozen=True, slots=True)
class View(Sealed):
    """One picture, and where it was taken from.

    Attributes:
        odom_T_camera: Pose of the camera when the picture was taken, shape (4, 4).
        frame: What the detector has found in the picture.
        source: Which camera took it.
    """

    odom_T_camera: Transform
    frame: PerceptionFrame
    source: str = HEAD


class GatheringLeaf(Leaf):
    """A leaf that gathers pictures taken after its start, each once, with the camera's pose at that time.

    Cameras that do not move with the robot are gathered from beside its own, each with a watch of its own.
    """

    _views: list[View]
    _troubles: dict[str, PerceptionFrame]
    _well_s: dict[str, float]

    def begin(self) -> None:
        """Forget earlier frames."""
        now_s = self.toolbox.clock.now_s()
        self._views = []
        self._placed: dict[str, list[View]] = {camera.name: [] for camera in self.toolbox.cameras}
        self._watches = {name: FrameWatch(now_s) for name in (HEAD, *self._placed)}
        self._faults: dict[str, Failure] = {}
        self._troubles, self._well_s = {}, {}

    def trouble(self, source: str = HEAD) -> str | None:
        """What has been wrong with every picture of a camera for too long; None while there are good ones."""
        frame = self._troubles.get(source)
        if frame is None or frame.stamp_s - self._well_s.get(source, self._started_s) < _BAD_S:
            return None
        return frame.trouble

    def gather(self) -> None:
        """Take the newest frame of each camera if it is one that we have not got, and it tells of now."""
        if (frame := self._newest(HEAD, self.toolbox.detector, self._views)) is not None:
            q = self.toolbox.sensing.state_at(frame.stamp_s).q
            model = self.toolbox.model
            self._views.append(View(model.frame_pose(q, model.description.camera.frame), frame))
        for camera in self.toolbox.cameras:
            views = self._placed[camera.name]
            if (frame := self._newest(camera.name, camera.detector, views)) is not None:
                views.append(View(camera.odom_T_camera, frame, camera.name))

    def _newest(self, source: str, detector: Detector, views: list[View]) -> PerceptionFrame | None:
        """The newest frame of one camera, or None when it is none for us."""
        frame = detector.latest()
        fault = self._watches[source].take(frame, self.toolbox.clock.now_s())
        if fault is not None:
            self._note(source, fault)
            return None
        if frame is None or frame.stamp_s < self._started_s:
            return None
        if views and frame.sequence <= views[-1].frame.sequence:
            return None
        if frame.trouble is not None:
            self._troubles[source] = frame
            return None
        self._troubles.pop(source, None)
        self._well_s[source] = frame.stamp_s
        return frame

    def _note(self, source: str, fault: Fault) -> None:
        """Tell what is wrong with a camera, once; the look goes on, for it may come back."""
        failure = Failure.timeout(f"the {source} delivers {fault.value}", after_s=self.elapsed_s)
        failure = failure.because(_REASONS[fault]).at(self.where)
        if source not in self._faults:
            tell_disagreement(self.toolbox, failure)
        self._faults[source] = failure


class LookLeaf(GatheringLeaf):
    """A leaf that gathers as many pictures as a look needs, and then judges them together."""

    def judge(self, views: list[View]) -> Status | Failure:
        """With enough frames gathered: what follows from them.

        Args:
            views: Those of cameras that do not move with the robot first, those of its own last; without
                its own when that one hangs.
        """
        raise NotImplementedError

    def step(self) -> Status | Failure:
        """Gather until there are enough: of the robot's own camera, or of another one when that fails."""
        self.gather()
        wanted = self.toolbox.policy.look_frames
        others = [view for views in self._placed.values() for view in views]
        if len(self._views) >= wanted:
            self._tell_covered()
            self._tell_tilt()
            self._tell_hindrance()
            return self.judge([*others, *self._views])
        if (failure := self._own_failure()) is not None:
            if any(len(views) >= wanted for views in self._placed.values()):
                self._tell_covered()
                return self.judge(others)
            fails = [name for name in self._placed if name in self._faults or self.trouble(name) is not None]
            if self.elapsed_s > self.deadline_s or (
                HEAD not in self._faults and len(fails) == len(self._placed)
            ):
                return failure
        self.feedback_message = f"{len(self._views)} of {wanted} frames"
        return RUNNING

    def _own_failure(self) -> Failure | None:
        """Why the robot's own camera is of no use now; None while it may be."""
        if (trouble := self.trouble()) is not None:
            self.toolbox.world.sees_badly = f"the {HEAD} sees badly: {trouble}"
            message = f"the robot cannot see with its {HEAD}: {trouble}"
            return Failure(FailureKind.EXECUTION, message).because(Reason.CANNOT_SEE)
        return self._faults.get(HEAD)

    def _tell_covered(self) -> None:
        """Say which of several cameras has shown nothing in this look, each once."""
        for source, views in ((HEAD, self._views), *self._placed.items()):
            if not views and (frame := self._troubles.get(source)) is not None:
                failure = Failure(FailureKind.EXECUTION, f"the {source} shows nothing: {frame.trouble}")
                tell_disagreement(self.toolbox, failure.because(Reason.CAMERA_BLIND).at(self.where))

    def _tell_tilt(self) -> None:
        """Say when the camera looks elsewhere than is believed, as what is level shows; the look counts."""
        tilt_rad, most_rad = (
            median(view.frame.tilt_rad for view in self._views),
            self.toolbox.policy.most_tilt_rad,
        )
        if tilt_rad > most_rad:
            message = (
                f"the {HEAD} seems to be turned: what is level leans in its pictures; "
                "I go by what is level, please calibrate it"
            )
            failure = Failure.postcondition(message, leans_rad=tilt_rad, usual_rad=most_rad)
            tell_disagreement(self.toolbox, failure.because(Reason.CAMERA_ASKEW).at(self.where))

    def _tell_hindrance(self) -> None:
        """Say what makes most of the pictures tell less than usual; the look counts."""
        told = Counter(view.frame.hindrance for view in self._views).most_common(1)
        if told and (hindrance := told[0][0]) is not None:
            message = f"the {HEAD} sees badly: {hindrance}"
            self.toolbox.world.sees_badly = message
            failure = Failure.postcondition(message).because(Reason.SEES_BADLY)
            tell_disagreement(self.toolbox, failure.at(self.where))

    @property
    def deadline_s(self) -> float:
        """The policy's time for a look."""
        return self.toolbox.policy.look_timeout_s


def estimates_of(views: list[View]) -> tuple[ObjectEstimate, ...]:
    """What at least half of the frames show, fused."""
    return seen_in(views).estimates


def seen_in(views: list[View]) -> Seen:
    """The same, with what several cameras do not agree on."""
    by_camera: dict[str, list[View]] = {HEAD: []}
    for view in views:
        by_camera.setdefault(view.source, []).append(view)
    told = {
        name: fuse_frames(
            [(view.odom_T_camera, view.frame) for view in some], min_frames=max(1, (len(some) + 1) // 2)
        )
        for name, some in by_camera.items()
        if some
    }
    if len(told) == 1:
        return Seen(next(iter(told.values())), (), ())
    return seen_by_all(told)

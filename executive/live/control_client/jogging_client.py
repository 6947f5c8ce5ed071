"""A person's way to trunk, arms and head, across the socket."""

from __future__ import annotations

from executive.live.control_client.control_link import ControlLink
from executive.live.control_client.motion_client import MotionClient
from kinematics.following.jog_reference import Jog
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene
from robots.control.hands.jogged_body import JogReport
from robots.control.motion_handle import MotionHandle
from robots.live.documents.jog_document import write_jog, write_jogging


class JoggingClient:
    """Has a served robot jogged; satisfies ``trees.toolbox.Jogging``.

    The motion itself is made by the control process, and brakes there when no word comes any more.
    """

    def __init__(self, link: ControlLink, motion: MotionClient, model: RobotModel) -> None:
        """Command through a link."""
        self._link, self._motion, self._model = link, motion, model

    def start(self, scene: PlanningScene) -> JoggingFollowed:
        """Ask for it."""
        number, handle = self._motion.new("jog")
        followed = JoggingFollowed(self._link, handle)
        self._link.jog(handle, number, scene.version, write_jogging(scene, self._model), followed.note)
        return followed


class JoggingFollowed:
    """Jogging in the control process; satisfies ``trees.toolbox.JoggingMotion``.

    Attributes:
        handle: The motion's.
        report: How it goes, as it was told last.
    """

    def __init__(self, link: ControlLink, handle: MotionHandle) -> None:
        """Nothing was said yet."""
        self._link = link
        self.handle = handle
        self.report = JogReport("", moving=False)

    def note(self, report: JogReport) -> None:
        """Take what was told."""
        self.report = report

    def steer(self, jog: Jog) -> None:
        """Go on as asked for, for as long as a word is good for."""
        self._link.steer(self.handle, write_jog(jog))

    def brake(self) -> None:
        """Come to rest now, and go on listening."""
        self._link.steer(self.handle, write_jog(None))

    def finish(self) -> None:
        """Come to rest, and end."""
        self._link.finish(self.handle)

"""The trees' way to a hand that yields, across the socket."""

from __future__ import annotations

import numpy as np

from executive.live.control_client.control_link import ControlLink
from executive.live.control_client.motion_client import MotionClient
from kinematics.model.robot_model import RobotModel
from robots.control.hands.yield_order import YieldOrder
from robots.control.hands.yield_settings import YieldReport
from robots.control.motion_handle import MotionHandle
from robots.live.documents.yield_document import write_yield_order
from trees.world_model import WorldModel


class YieldingClient:
    """Has a served robot's hand lead and yield; satisfies ``trees.toolbox.Yielding``.

    The motion itself is made by the control process.
    """

    def __init__(self, link: ControlLink, motion: MotionClient, model: RobotModel, world: WorldModel) -> None:
        """Command through a link."""
        self._link, self._motion, self._model, self._world = link, motion, model, world

    def start(self, order: YieldOrder) -> YieldingFollowed:
        """Ask for it."""
        verb = "yield with" if order.s_to == order.s_from else "lead"
        number, handle = self._motion.new(f"{verb} the {order.hand} hand")
        followed = YieldingFollowed(self._link, handle, order)
        version, document = self._world.scene.version, write_yield_order(order, self._model)
        self._link.lead(handle, number, version, document, followed.note)
        return followed


class YieldingFollowed:
    """A yielding hand of the control process; satisfies ``trees.toolbox.YieldingMotion``.

    Attributes:
        handle: The motion's.
        report: What was felt, as it was told last.
    """

    def __init__(self, link: ControlLink, handle: MotionHandle, order: YieldOrder) -> None:
        """Nothing was felt yet."""
        self._link = link
        self.handle = handle
        bias = np.zeros(6) if order.bias is None else order.bias
        self.report = YieldReport("running", order.s_from, 0.0, 0.0, bias)

    def note(self, report: YieldReport) -> None:
        """Take what was told."""
        self.report = report

    def finish(self) -> None:
        """Come to rest where the hand is."""
        self._link.finish(self.handle)

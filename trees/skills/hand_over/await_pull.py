"""Wait until the person takes hold and pulls."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.events import Offered
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.readings.held import lost
from trees.readings.touch_watch import TouchWatch
from trees.skills.hand_over.settings import HandOverSettings

_NEAREST_M = 1e-6


class AwaitPull(Leaf):
    """Wait until the person pulls at what the hand offers.

    A pull is a change of the force on the hand, towards the person or up, that is as large, and lasts as
    long, as the policy asks for: fingers that come against the object press the other way. When the object
    leaves the hand, it was taken if such a force was felt before, for however short a time; otherwise it
    slipped.
    """

    INPUT_PORTS = ports(held=HeldObject, place=Place)
    OUTPUT_PORTS = ports(pull_n=float)
    CONTRACT = Contract(
        precondition="the hand offers the object, at rest",
        postcondition="the hand felt a steady pull, or a short one with which the object went",
        deadline_s=1.0,
        on_success="the hand goes on holding",
        on_failure="the hand goes on holding",
        on_cancel="the hand goes on holding",
    )

    def begin(self) -> None:
        """Feel anew; people see to whom it is held out."""
        held, person = self.get_input("held"), self.get_input("place")
        self.toolbox.events(Offered(self.toolbox.clock.now_s(), held.name, person.name))
        self._watch = TouchWatch(self.toolbox, self.get_input("held").hand)
        self._since_s: float | None = None
        self._strongest_n = 0.0

    def step(self) -> Status | Failure:
        """One more reading."""
        settings, held = self.toolbox.policy.of(HandOverSettings), self.get_input("held")
        if self.elapsed_s < settings.offer_rest_s:
            self._watch.feel_rest()
            return RUNNING
        if not self.toolbox.grippers[held.hand].reading().holding:
            self.measured(pull_n=self._strongest_n)
            if self._strongest_n < settings.pull_n:
                return lost(self.toolbox, held)
            self._set_output("pull_n", self._strongest_n)
            return DONE
        pull_n = self._pull_n(self._watch.feel())
        self._strongest_n = max(self._strongest_n, pull_n)
        self.feedback_message = f"{pull_n:.1f} N"
        if pull_n < settings.pull_n:
            self._since_s = None
        elif self._since_s is None:
            self._since_s = self.elapsed_s
        elif self.elapsed_s - self._since_s >= settings.pull_s:
            self.measured(pull_n=pull_n)
            self._set_output("pull_n", pull_n)
            return DONE
        if self.elapsed_s > settings.take_within_s:
            return Failure.postcondition(f"nobody took the {held.name}", waited_s=self.elapsed_s)
        return RUNNING

    def _pull_n(self, force_n: NDArray[np.float64]) -> float:
        """What of a force on the hand, odometry frame, shape (3,), goes towards the person or up."""
        model, place = self.toolbox.model, self.get_input("place")
        tcp_frame = model.description.tcp_frames[self.get_input("held").hand]
        tcp = model.frame_pose(self.toolbox.sensing.state().q, tcp_frame)[:2, 3]
        away = place.odom_T_place[:2, 3] - tcp
        towards_n = float(force_n[:2] @ away) / max(float(np.linalg.norm(away)), _NEAREST_M)
        return math.hypot(max(towards_n, 0.0), max(float(force_n[2]), 0.0))

    @property
    def deadline_s(self) -> float:
        """The policy's patience, and the contract's allowance."""
        return self.toolbox.policy.of(HandOverSettings).take_within_s + self.CONTRACT.deadline_s

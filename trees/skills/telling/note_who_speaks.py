"""Note who speaks: the nearest of the people who were seen."""

from __future__ import annotations

import math

from py_trees.common import Status

from trees.beliefs.grounding.destination import Place
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.readings.odometry import body_pose
from trees.toolbox import Toolbox

CONVERSING_M = 2.5
"""Somebody who stands so near is taken for who speaks, without looking farther around."""


class NoteWhoSpeaks(Leaf):
    """Take the nearest person for the one who speaks to the robot.

    Somebody far away is taken only when the robot has looked all around. Until then, that nobody is near is
    an answer, not a failure, and the robot looks farther around.
    """

    ASKS = True
    INPUT_PORTS = ports(people=optional(dict))
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="the robot has looked for people",
        postcondition="the nearest person that was seen, near enough to speak to the robot",
        deadline_s=1.0,
    )

    def __init__(self, name: str, toolbox: Toolbox, *, anybody: bool = False) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            anybody: Whether the robot has looked everywhere: then the nearest one will do.
        """
        super().__init__(name, toolbox)
        self._anybody = anybody

    def step(self) -> Status | Failure:
        """Compare the distances."""
        people: dict[str, Place] = self.optional("people") or {}
        body = body_pose(self.toolbox)
        away = {
            name: math.hypot(place.odom_T_place[0, 3] - body.x_m, place.odom_T_place[1, 3] - body.y_m)
            for name, place in sorted(people.items())
        }
        if not away:
            return Failure.postcondition("nobody is seen").because(Reason.NOBODY_SEEN)
        nearest = min(away, key=away.__getitem__)
        if away[nearest] > CONVERSING_M and not self._anybody:
            return Failure.postcondition(
                f"{nearest} stands too far away to be who speaks", away_m=away[nearest]
            )
        self.measured(away_m=away[nearest], people=len(people))
        self.feedback_message = nearest
        self._set_output("place", people[nearest])
        return DONE

"""What a hand holds, as it is believed."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.model.robot_description import Hand
from trees.beliefs.scene.believed_thing import split_words
from trees.tasks import ObjectDescription, Thing


@dataclass(frozen=True, slots=True)
class HeldObject(Sealed):
    """An attached body with the hand that holds it.

    Attributes:
        name: Its name in the planning scene.
        hand: The hand.
        shape: Its solid.
        tcp_T_object: Pose in the hand's TCP frame, shape (4, 4).
    """

    name: str
    hand: Hand
    shape: Shape
    tcp_T_object: Transform

    @property
    def kind(self) -> str:
        """Its kind: "cup"."""
        return split_words(self.name)[0]

    @property
    def color(self) -> str | None:
        """Its colour, or None."""
        return split_words(self.name)[1]


def fits(name: str, wanted: Thing | None) -> bool:
    """Tell whether kind, colour and name of a thing of the planning scene are those that are meant."""
    if not isinstance(wanted, ObjectDescription):
        return wanted is None
    kind, color = split_words(name)
    named = wanted.name in (None, name)
    return named and wanted.kind in (None, kind) and wanted.color in (None, color)

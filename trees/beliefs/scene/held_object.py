"""What a hand holds, as it is believed."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.model.robot_description import Hand
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.scene.labels import CalledBy, called_by, is_of_color, label_in, label_of
from trees.tasks import ObjectDescription, Thing


@dataclass(frozen=True, slots=True)
class HeldObject(Sealed):
    """An attached body with the hand that holds it.

    Attributes:
        name: Its name in the planning scene.
        hand: The hand.
        shape: Its solid.
        tcp_T_object: Pose in the hand's TCP frame, shape (4, 4).
        label: What it is called; None where its name says it all.
    """

    name: str
    hand: Hand
    shape: Shape
    tcp_T_object: Transform
    label: Label | None = None

    @property
    def kind(self) -> str:
        """Its kind: "cup"."""
        return (self.label or label_in(self.name)).kind

    @property
    def color(self) -> str | None:
        """Its colour, or None."""
        return (self.label or label_in(self.name)).color


def fits(item: SceneObject, wanted: Thing | None) -> bool:
    """Tell whether kind, colour and name of a thing of the planning scene are those that are meant."""
    if not isinstance(wanted, ObjectDescription):
        return wanted is None
    if wanted.name is not None:
        return wanted.name == item.name
    return is_like(wanted, label_of(item))


def is_like(wanted: ObjectDescription, label: Label) -> bool:
    """Whether what is called so is of the kind and colour that is meant."""
    by = called_by(wanted.kind, label)
    return by is not None and by < CalledBy.MAYBE and is_of_color(wanted.color, wanted.kind, label)

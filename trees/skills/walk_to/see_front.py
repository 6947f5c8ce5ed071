"""See a piece of furniture by the door or drawer that hides all else of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DOOR
from trees.beliefs.grounding.destination import Place, aim_of
from trees.beliefs.openings.handles import BODY_OF
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.tasks import ObjectDescription

_SHUT_RAD = 0.06
_GAP_M = 0.01
"""Between a shut door and what it shuts."""
_FRONT_M = 0.9
"""From the middle of a piece of furniture to the middle of its front, open or closed."""


def behind(place: Place, front: ObjectEstimate) -> Place | None:
    """The piece of furniture where its shut door tells that it is; None of an open one, and of a drawer.

    What was seen from far away is centimetres off; its door is seen from near by.
    """
    turned = poses.yaw_of(poses.inverse(place.odom_T_place)[:3, :3] @ front.odom_T_object[:3, :3])
    if front.kind != DOOR or abs(turned) > _SHUT_RAD:
        return None
    if not isinstance(place.shape, Box) or not isinstance(front.shape, Box):
        return None
    inwards = PlanarPose.of(place.odom_T_place).transform()[:3, 0]
    away_m = 0.5 * (place.shape.size_m[0] + front.shape.size_m[0]) + _GAP_M
    pose = place.odom_T_place.copy()
    pose[:2, 3] = (front.odom_T_object[:3, 3] + away_m * inwards)[:2]
    return replace(place, odom_T_place=pose)


def told_by_front(place: Place, word: str | None, seen: Mapping[str, ObjectEstimate]) -> Place | Failure:
    """The piece of furniture by its front; a failure where none is seen, or the piece itself is.

    Args:
        place: Where the piece is believed to be.
        word: Its kind.
        seen: What was seen by now, by names.
    """
    middle = PlanarPose.of(place.odom_T_place)
    near = [
        (kind_of(name), item)
        for name, item in seen.items()
        if middle.distance_m(PlanarPose.of(item.odom_T_object)) <= _FRONT_M
    ]
    front = next((item for kind, item in near if BODY_OF.get(kind) == word), None)
    if front is None:
        return Failure.postcondition(f"no door of the {word} is seen")
    told = behind(place, front)
    if told is None and any(kind == word for kind, _ in near):
        return Failure.postcondition(f"the {word} is seen itself")
    return told or place


class SeeFront(LookAround):
    """Look once, and recognize a known piece of furniture by its door or drawer.

    A closed fridge, for example, shows nothing but its door to who stands before it. A piece that shows
    itself beside a front that does not tell where it is has to be looked at itself.
    """

    INPUT_PORTS = ports(task=object, known=Place)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="the head is at rest; the piece of furniture was seen before",
        postcondition="its door or drawer was seen; everything seen is in the world model",
        deadline_s=2.0,
    )
    ASKS = True

    def step(self) -> Status | Failure:
        """Look, if it is about something with a door."""
        known: Place = self.get_input("known")
        if known.category != "furniture" or self._word() not in BODY_OF.values():
            return Failure.postcondition("it has no door that could be seen")
        return super().step()

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """A front of the right kind near the piece."""
        told = told_by_front(self.get_input("known"), self._word(), seen)
        if isinstance(told, Failure):
            return told
        self._set_output("place", told)
        self.feedback_message = f"the front of the {self._word()} is there"
        return DONE

    def _word(self) -> str | None:
        aim = aim_of(self.get_input("task"))
        return aim.kind if isinstance(aim, ObjectDescription) else aim if isinstance(aim, str) else None

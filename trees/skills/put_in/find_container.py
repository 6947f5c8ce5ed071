"""See what something is to be put into."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.requests.place import Spot
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DRAWER
from trees.beliefs.grounding.destination import Place, place_believed, place_from, resolve
from trees.beliefs.grounding.furniture_called import is_at, is_of, whole_in
from trees.beliefs.grounding.grounding import Found, ground
from trees.beliefs.openings.drawer_inside import LEAST_OPEN_M, spots_in_drawer
from trees.beliefs.openings.handles import opening_of
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.skills.place.know_destination import room_beside_m
from trees.skills.put_in.inside_of import inside_of
from trees.tasks import Destination, ObjectDescription, PutInTask
from trees.toolbox import Toolbox

# Of an object's foot below the rim when the hand opens: as deep as the hand gets without touching the rim.
_DEPTHS_M = (0.08, 0.06, 0.045, 0.03, 0.015, 0.0)
# Beside the middle, when the middle does not go: a share of the room that is left.
_ASIDE = (0.0, 0.5, -0.5)
_HOVER_M = 0.08


class FindContainer(LookAround):
    """Look, and write poses of the held object in the opening of the container, the deepest one first.

    What is held may hide the container wherever the eyes look. As a last resort an object is taken to be
    where it was seen before: another look, with empty hands, tells what became of it.
    """

    INPUT_PORTS = ports(task=PutInTask, held=HeldObject)
    OUTPUT_PORTS = ports(spots=tuple, place=Place)
    CONTRACT = Contract(
        precondition="the head is at rest; the object is an attached body",
        postcondition="exactly one container that fits was seen, wide enough for the object, and if it is "
        "a drawer, open",
        deadline_s=2.0,
    )

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        wiring: Mapping[str, str] | None = None,
        *,
        remembered: bool = False,
    ) -> None:
        super().__init__(name, toolbox, wiring)
        self._remembered = remembered

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Choose the container, and measure it."""
        held = self.get_input("held")
        to = self.get_input("task").to
        place = _drawer_of_model(to, seen) or resolve(to, seen, self.around(), "to")
        if isinstance(place, Failure) and place.reason is Reason.OUT_OF_VIEW and self._remembered:
            place = self._where_it_was(to) or place
        if isinstance(place, Failure):
            return place
        spots = self._spots_in(held, place)
        if isinstance(spots, Failure):
            return spots
        if not spots:
            return Failure.infeasible(f"the {held.name} is too wide for the {place.name}")
        self._set_output("place", place)
        self._set_output("spots", spots)
        self.feedback_message = f"into the {place.name}"
        return DONE

    def _where_it_was(self, to: Destination) -> Place | None:
        """The object that is meant, as it is believed to stand there still; None of furniture."""
        match ground(to, self.around()) if isinstance(to, ObjectDescription) else None:
            case Found((name, *_)):
                return place_believed(self.toolbox.world.scene.objects[name], "object")
            case _:
                return None

    def _spots_in(self, held: HeldObject, place: Place) -> tuple[Spot, ...] | Failure:
        if place.category == "object":
            return _spots(held, place)
        inside = inside_of(place, self.toolbox.world.scene)
        return inside if isinstance(inside, Failure) else spots_in_drawer(held, inside)


def _drawer_of_model(to: object, seen: Mapping[str, ObjectEstimate]) -> Place | None:
    """The drawer that is meant of pieces that are recognised by models; of several the one that is open."""
    if not isinstance(to, ObjectDescription) or to.kind != DRAWER:
        return None
    meant = {
        name: item
        for name, item in seen.items()
        if item.kind == DRAWER
        and item.moves is not None
        and is_of(whole_in(to), item.moves)
        and is_at(to.ordinal, item.moves)
    }
    ajar = {name: item for name, item in meant.items() if opening_of(DRAWER, item, []) > LEAST_OPEN_M}
    for few in (meant, ajar):
        if len(few) == 1:
            ((name, item),) = few.items()
            return place_from(name, item)
    return None


def _spots(held: HeldObject, place: Place) -> tuple[Spot, ...]:
    shape, room = place.shape, room_beside_m(place.shape, held.shape)
    if float(room.min()) < 0.0:
        return ()
    rim = 0.5 * shape.height_m
    spots = []
    for depth in _DEPTHS_M:
        if depth > shape.height_m - 0.01:
            continue
        for aside in _ASIDE:
            local = np.array([aside * room[0], 0.0, rim - depth + 0.5 * held.shape.height_m, 1.0])
            x, y, z = (float(value) for value in (place.odom_T_place @ local)[:3])
            pose = poses.translation(x, y, z)
            spots.append(Spot(pose, (place.name,), hover_m=_HOVER_M, below_m=0.0))
    return tuple(spots)

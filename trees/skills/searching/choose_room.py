"""Choose a room of the map to look around in, where nobody has looked yet."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose
from trees.beliefs.grounding.destination import Place, place_of_region
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.readings.odometry import feet_pose
from trees.toolbox import Toolbox


class ChooseRoom(Leaf):
    """Choose the nearest room of the map in which the robot has not looked around.

    What is in a room is hidden by its walls from the other rooms.
    """

    ASKS = True
    NONE_LEFT = Reason.NO_ROOMS_LEFT
    INPUT_PORTS = ports(rooms_before=optional(tuple))
    OUTPUT_PORTS = ports(room=Place, rooms=tuple)
    CONTRACT = Contract(
        precondition="something is looked for, and it was not seen from here",
        postcondition="a room of the map, noted as looked around in, as is the one that the robot is in",
        deadline_s=1.0,
    )

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        wiring: Mapping[str, str] | None = None,
        *,
        said: str = "",
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call; knows the map.
            wiring: As for every leaf.
            said: The room that is meant, on the map; any other when it is empty.
        """
        super().__init__(name, toolbox, wiring)
        self._said = said

    def step(self) -> Status | Failure:
        """Look through the map."""
        body, places = feet_pose(self.toolbox), self.toolbox.places
        here = [name for name, region in places.items() if region.contains(body.x_m, body.y_m)]
        seen = {*(self.optional("rooms_before") or ()), *here}
        meant = {name: region for name, region in places.items() if self._said in ("", name)}
        left = {name: region for name, region in meant.items() if self._said or name not in seen}
        others = [place_of_region(name, region) for name, region in left.items()]
        if not others:
            return Failure.postcondition("no other room is on the map").because(self.NONE_LEFT)
        room = min(others, key=lambda one: body.distance_m(PlanarPose.of(one.odom_T_place)))
        self._set_output("room", room)
        self._set_output("rooms", (*sorted(seen), room.name))
        self.feedback_message = room.name
        return DONE

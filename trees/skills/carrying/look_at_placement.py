"""Turn the head to where the object was put, leaning over where that is not enough."""

from __future__ import annotations

from collections.abc import Mapping

from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.ports import ports
from trees.port_values import Placement
from trees.skills.looking.aiming_leaf import AimingLeaf
from trees.skills.looking.look_at import joints_that_show

_CLEAR = 0.25
"""Three quarters of it are far enough from the eyes, if what is so far above its middle is."""


class LookAtPlacement(AimingLeaf):
    """Turn the eyes so that the place where the object was put is in the middle of the picture.

    From an upright posture the near edge of a table is below the picture. Where turning the head is not
    enough, the trunk leans forward as well.
    """

    INPUT_PORTS = ports(held=HeldObject, placement=Placement)
    OUTPUT_PORTS = ports()

    def joints(self) -> Mapping[str, float]:
        """The goal of the head's joints, and of the trunk's if need be, rad."""
        place = self.get_input("placement").odom_T_object[:3, 3]
        return joints_that_show(self.toolbox, place, _CLEAR * self.get_input("held").shape.height_m)

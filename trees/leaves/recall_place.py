"""Recall where something that stays where it is was seen."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.shapes import Box
from robots.perception.detector import Category
from trees.contract import Contract
from trees.destination import Place, aim_of
from trees.failures import Failure
from trees.leaf import DONE, Leaf
from trees.ports import ports
from trees.tasks import ObjectDescription

_CONFIDENCE = 0.5
"""Of what is out of view: a person may have gone."""


class RecallPlace(Leaf):
    """Take a piece of furniture or a person from the world model; nothing is looked at.

    It is where to go and look again. Objects are not recalled: a hand may have moved them.
    """

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="none",
        postcondition="furniture or a person of that name, where it was last seen",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look it up."""
        aim = aim_of(self.get_input("task"))
        wanted = (aim.name or aim.kind) if isinstance(aim, ObjectDescription) else str(aim)
        for name, item in self.toolbox.world.scene.objects.items():
            if not item.movable and wanted is not None and name.casefold() == wanted.casefold():
                category: Category = "furniture" if isinstance(item.shape, Box) else "person"
                self._set_output("place", Place(name, category, item.shape, item.world_T_object, _CONFIDENCE))
                return DONE
        return Failure.postcondition(f"no {wanted} was seen before")

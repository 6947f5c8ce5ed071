"""See where on the boards behind a door there is room."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.openings.fridge_inside import inside_of_fridge, spots_in_fridge
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.sight.sight_of_tops import SightOfTops
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround


class FindBoardRoom(LookAround):
    """Look, and write the free spots for the held object near the front of the boards."""

    INPUT_PORTS = ports(held=HeldObject)
    OUTPUT_PORTS = ports(spots=tuple)
    CONTRACT = Contract(
        precondition="the head is at rest; the object is an attached body",
        postcondition="the door is open, and there is at least one spot with room on a board, all of whose "
        "surroundings were seen; the best first",
        deadline_s=2.0,
    )
    LOOKING_ON = True

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Search the boards of the world model."""
        del seen  # what was believed before counts as well
        toolbox, held = self.toolbox, self.get_input("held")
        model, policy, scene = toolbox.model, toolbox.policy, toolbox.world.scene
        inside = inside_of_fridge(scene)
        if isinstance(inside, Failure):
            return inside
        sight = SightOfTops(toolbox.world.glimpses, model.description.camera, policy.blocked_by_hand_m)
        spots = spots_in_fridge(held, inside, scene, sight)
        if not spots:
            return Failure.postcondition(
                f"no spot on a board is free for the {held.name} as far as was seen",
                boards=len(inside.boards),
            )
        self._set_output("spots", spots)
        self.feedback_message = f"{len(spots)} free spots"
        return DONE

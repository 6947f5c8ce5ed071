"""See where there is room."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.sight.sight_of_tops import SightOfTops
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.readings.around import base_pose
from trees.skills.looking.look_around import LookAround
from trees.skills.place.placement import spots_for
from trees.skills.place.room_tops import on_what
from trees.tasks import PlaceTask


class FindSpots(LookAround):
    """Look, and write the free spots where the task wants the held object, the best one first."""

    INPUT_PORTS = ports(task=PlaceTask, held=HeldObject)
    OUTPUT_PORTS = ports(spots=tuple)
    CONTRACT = Contract(
        precondition="the head is at rest; the object is an attached body",
        postcondition="there is at least one spot with room, on a surface that was seen, and whose "
        "surroundings were seen too; the best first",
        deadline_s=2.0,
    )

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Search the surfaces of the world model."""
        del seen  # what was believed before counts as well
        task, toolbox = self.get_input("task"), self.toolbox
        room = task.on if task.on is not None else task.to
        if isinstance(room, str) and room in toolbox.places:
            return on_what(room, toolbox.places[room], toolbox.world.scene)
        around, base, policy = self.around(), base_pose(toolbox), toolbox.policy
        sight = SightOfTops(
            toolbox.world.glimpses, toolbox.model.description.camera, policy.blocked_by_hand_m
        )
        held, scene = self.get_input("held"), toolbox.world.scene
        origin = toolbox.world.taken_from.get(held.name)
        spots = spots_for(held, task.on, task.to, scene, around, base, policy.support_gap_m, sight, origin)
        if isinstance(spots, Failure):
            return spots
        self._set_output("spots", spots)
        self.feedback_message = f"{len(spots)} free spots"
        return DONE

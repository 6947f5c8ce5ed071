"""Find where an object can be put down, leaving out the spots that were tried in vain."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status
from py_trees.ports import PortInformation

from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.furniture_names import kind_called
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.destination import furniture_named
from trees.beliefs.grounding.grounding import Ambiguous, Choice
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.scene.scene_update import kind_of
from trees.beliefs.sight.sight_of_tops import SightOfTops
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.port_values import Placement
from trees.readings.odometry import base_pose
from trees.skills.looking.look_around import LookAround
from trees.skills.place.placement import SURFACES, is_flat, is_surface, spots_for
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


def on_what(room: str, region: Region, scene: PlanningScene) -> Failure:
    """The question on what it is to be put; its choices are the furniture that was seen in the room.

    Args:
        room: Its name.
        region: Where it is on the map.
        scene: What is believed to be around.
    """

    def is_there(item: SceneObject) -> bool:
        x_m, y_m, _ = item.world_T_object[:3, 3].tolist()
        return is_flat(item) and region.contains(x_m, y_m)

    called = {kind_of(item.name) for item in scene.objects.values() if not item.movable and is_surface(item)}
    ordered = sorted(called, key=lambda words: (SURFACES.index(kind_called(words)), words))
    found = {words: filter(is_there, furniture_named(words, scene)) for words in ordered}
    largest = {words: next(tops, None) for words, tops in found.items()}
    choices = tuple(Choice(top.name, f"the {words}") for words, top in largest.items() if top is not None)
    message = f"on what in the {room} shall it be put?"
    if not choices:
        return Failure.infeasible(f"{message} nothing that things are put on was seen there")
    return which_is_meant(Ambiguous(message, choices), "on", one_will_do=True)


class ExcludeSpot(Leaf):
    """Note after a failed attempt that its spot is not to be tried again."""

    INPUT_PORTS = ports(
        placement=optional(Placement), blocked=PortInformation(frozenset, default_value=frozenset())
    )
    OUTPUT_PORTS = ports(blocked_now=frozenset)
    CONTRACT = Contract(
        precondition="an attempt has failed",
        postcondition="the next plan uses another spot",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Remember it."""
        blocked: frozenset[tuple[float, float]] = self.get_input("blocked")
        placement: Placement | None = self.optional("placement")
        if placement is not None:
            blocked = blocked | {placement.spot}
        self._set_output("blocked_now", blocked)
        self.feedback_message = f"{len(blocked)} spots excluded"
        return DONE

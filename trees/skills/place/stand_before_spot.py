"""Walk to where the hand that holds something gets to where it is to be put."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence as InOrder

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.requests.place import PlaceRequest
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf, rewired
from trees.nodes.ports import ports
from trees.registry import task_that
from trees.skill import After
from trees.skills.place.plan_place import place_request
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walk_to.tree import find_place, walks
from trees.skills.walking.reachable_standing import Stand, StandingRoom, posture_at
from trees.tasks import ObjectDescription, PlaceTask
from trees.toolbox import Toolbox

_SPOTS = 2
_BEFORE_M = (-0.05, 0.35)
"""How far on its own side of the body a hand puts something down, at least and at most."""


class AskForWalkThere(Leaf):
    """Write the task of walking to what the object is to be put on, or beside."""

    INPUT_PORTS = ports(task=PlaceTask, held=HeldObject)
    OUTPUT_PORTS = ports(walk_task=object)
    CONTRACT = Contract(
        precondition="a hand holds the object",
        postcondition="fingers on a palm hold it, and the walk is described",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe it, unless the other hand is as good, the robot cannot walk, or nothing was named."""
        task: PlaceTask = self.get_input("task")
        held: HeldObject = self.get_input("held")
        if self.toolbox.model.description.grippers[held.hand].palm_side_m is None:
            return _no_way("the other hand is nearer than another place to stand")
        to = task.to if task.to is not None else task.on
        if isinstance(to, ObjectDescription) and to.relation is not None:
            to = to.relation.to
        if to is None or not self.toolbox.can_walk:
            return _no_way("there is nowhere else to stand")
        self._set_output("walk_task", task_that(After.AT_GOAL, task.text, to=to))
        return DONE


class ChooseStandToPlace(ChooseStand):
    """Find where to stand so that the held object can be put down on one of the spots that were seen.

    The robot faces as it does, or hardly turns: left and right stay what they were.
    """

    TURNED_RAD = (0.0, 0.3, -0.3)

    INPUT_PORTS = ports(place=Place, held=HeldObject, spots=tuple)
    OUTPUT_PORTS = ports(stand=Stand)
    CONTRACT = Contract(
        precondition="the place was seen; the object is an attached body; there are free spots",
        postcondition="a placing has a plan from the chosen place, and from beside it if that can be",
        deadline_s=30.0,
    )

    def thing(self, place: Place) -> SceneObject | None:
        """The object on the best spot."""
        del place
        held: HeldObject = self.get_input("held")
        return SceneObject(held.name, held.shape, self.get_input("spots")[0].world_T_object)

    def hands(self) -> tuple[Hand, ...]:
        """The hand that holds it."""
        return (self.get_input("held").hand,)

    def usual_again(self) -> PlanarPose | None:
        """None: the spot has no front of its own."""
        return None

    def stands(
        self, here: PlanarPose, places: Sequence[PlanarPose], room: StandingRoom
    ) -> Iterator[PlanarPose]:
        """Those that have the spot before the hand that holds."""
        del here
        x, y = (float(value) for value in self.get_input("spots")[0].world_T_object[:2, 3])
        spot, side = PlanarPose(x, y), 1.0 if self.hands() == ("left",) else -1.0
        least_m, most_m = _BEFORE_M
        return (body for body in places if least_m <= side * body.to(spot).y_m <= most_m and room.has(body))

    def request(self, body: PlanarPose, stance: Stance) -> PlaceRequest:
        """The present posture, carried over to the place."""
        q = posture_at(self.toolbox.motion.reference(), self._here, body)
        spots = tuple(self.get_input("spots")[:_SPOTS])
        return place_request(self.toolbox, self.get_input("held"), spots, q, stance, quick=True)

    def without_any(self) -> Status | Failure:
        """Nobody walks to where nothing can be done."""
        return _no_way(f"there is no place to stand from which the {self.hands()[0]} hand gets to the spot")


def _no_way(message: str) -> Failure:
    return Failure.infeasible(message).because(Reason.NO_WAY_TO_SPOT)


def before_the_spot(bring: Behaviour, toolbox: Toolbox) -> Behaviour:
    """Walk there and bring it. Reads "task", "held" and "spots".

    Args:
        bring: From the hand to a free spot, looked for anew.
        toolbox: What leaves may call.
    """
    steps: list[Behaviour] = [
        find_place(toolbox),
        walks(toolbox, ChooseStandToPlace("choose where to stand", toolbox)),
    ]
    there = rewired(
        InOrder("walk there", memory=True, children=steps), {"task": "walk_task", "evidence": "walk_evidence"}
    )
    children: list[Behaviour] = [AskForWalkThere("say where to", toolbox), there, bring]
    return InOrder("from elsewhere", memory=True, children=children)

"""Stand where something that is held can be put on a board behind an open door."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from trees.failures import Failure
from trees.nodes.alternatives import Alternatives
from trees.nodes.contract import Contract
from trees.nodes.judgements import defect
from trees.nodes.leaf import DONE, Leaf, rewired
from trees.nodes.ports import ports
from trees.registry import task_that
from trees.skill import After
from trees.skills.put_in.choose_stand_to_put import ChooseStandToPut
from trees.skills.walk_to.tree import find_place, walks
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.tasks import ObjectDescription, PutInTask
from trees.toolbox import Toolbox


class CannotWalk(Leaf):
    """Succeed if the robot cannot walk here, and so has to do the task from where it stands."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the robot stands where it stands",
        deadline_s=1.0,
    )
    ASKS = True

    def step(self) -> Status | Failure:
        """Ask what there is to walk with."""
        return Failure.postcondition("it can walk") if self.toolbox.can_walk else DONE


class AskForWalk(Leaf):
    """Write the task of walking to what the object is to be put into."""

    INPUT_PORTS = ports(task=PutInTask)
    OUTPUT_PORTS = ports(walk_task=object)
    CONTRACT = Contract(
        precondition="none",
        postcondition="the walk is described",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe it."""
        task: PutInTask = self.get_input("task")
        if not isinstance(task.to, str | ObjectDescription):
            return Failure.postcondition("it was not said what it is to be put into")
        noun = task.to.kind if isinstance(task.to, ObjectDescription) else task.to
        self._set_output("walk_task", task_that(After.AT_GOAL, task.text, to=noun or task.to))
        return DONE


def come_to_board(toolbox: Toolbox) -> Behaviour:
    """Nothing for a robot that cannot walk; else find it, walk there, look again, and correct.

    Reads "task" and "held".
    """
    steps = Sequence(
        "walk there",
        memory=True,
        children=[
            find_place(toolbox),
            ReadyToWalk("carry it level", toolbox),
            walks(toolbox, ChooseStandToPut("choose where to stand", toolbox)),
        ],
    )
    walk = Sequence(
        "come within reach",
        memory=True,
        children=[
            AskForWalk("say where to", toolbox),
            rewired(steps, {"task": "walk_task", "evidence": "walk_evidence"}),
        ],
    )
    return Alternatives("come to it", [CannotWalk("cannot walk", toolbox), walk], hopeless=defect)

"""Say what has to be picked up first."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.scene.held_object import HeldObject, fits
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.readings.held import free_hands
from trees.registry import skill_of, task_that
from trees.skill import After, Before
from trees.tasks import Destination, ObjectDescription, Task


class AskForPick(Leaf):
    """Write the task of picking up the object that this task is about.

    When a hand has lost the object on its way, that object is picked up again.
    """

    INPUT_PORTS = ports(task=object, held=optional(HeldObject))
    OUTPUT_PORTS = ports(pick_task=object, besides=object)
    CONTRACT = Contract(
        precondition="a hand is free",
        postcondition="the pick is described, and what is not meant by it",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe it; without an object there is nothing to pick up."""
        task = self.get_input("task")
        lost: HeldObject | None = self.optional("held")
        if lost is not None:
            like_it = ObjectDescription(lost.kind, lost.color)
            again = task_that(After.THING_HELD, task.text, object=like_it, hand=task.hand)
            self._set_output("pick_task", again)
            return DONE
        if task.object is None:
            return Failure.postcondition("nothing is in a hand, and nothing was named")
        free = free_hands(self.toolbox, task.hand)
        if isinstance(free, Failure):
            return free
        if task.count != 1 and (held_already := self._held(task.object)):
            return Failure.infeasible(f"the {held_already} is in the hand already: put it down or away first")
        slots = {slot: getattr(task, slot, None) for slot in ("object", "source", "hand")}
        self._set_output("pick_task", task_that(After.THING_HELD, task.text, count=task.count, **slots))
        self._set_output("besides", _goes_to(task))
        return DONE

    def _held(self, wanted: object) -> str:
        """Which of what is meant a hand holds; "" for none."""
        attached = self.toolbox.world.scene.attached
        if not isinstance(wanted, ObjectDescription):
            return ""
        return next((kind_of(name) for name in sorted(attached) if fits(attached[name].body, wanted)), "")


def _goes_to(task: Task) -> Destination | None:
    """The thing that others are put into or next to: it is not one of them."""
    to: Destination | None = getattr(task, "to", None)
    if isinstance(to, ObjectDescription) and to.relation is not None and to.kind is None:
        return to.relation.to
    skill = skill_of(task)
    is_put = skill is not None and not skill.before.isdisjoint({Before.AT_SURFACE, Before.GOAL_OPEN})
    return to if is_put else None

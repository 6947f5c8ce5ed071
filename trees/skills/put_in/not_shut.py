"""Tell, before anything is picked up, when it is to go into a drawer or behind a door that is shut."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from py_trees.common import Status

from kinematics.scene.planning_scene import PlanningScene
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DOOR, DRAWER
from trees.beliefs.openings.drawer_inside import inside_of_drawer
from trees.beliefs.openings.fridge_inside import inside_of_fridge
from trees.beliefs.openings.handles import MEANT_BY
from trees.failures import Failure, FailureKind
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.tasks import ObjectDescription, PutInTask

_INSIDE: Mapping[str, Callable[[PlanningScene], object]] = {
    DRAWER: inside_of_drawer,
    DOOR: inside_of_fridge,
}


class NotShut(LookAround):
    """Look, before anything is picked up, whether the drawer or door that the task names is open.

    It succeeds at once for a container that has no door or drawer. When the door or drawer is not seen from
    here, a later look decides.
    """

    INPUT_PORTS = ports(task=PutInTask)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="the task names nothing that is believed to be shut, or less open than an arm needs",
        deadline_s=2.0,
    )
    LOOKING_ON = True

    def step(self) -> Status | Failure:
        """Look only when it matters."""
        return super().step() if self._opens() in _INSIDE else DONE

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """What was seen before counts as well."""
        del seen
        inside = _INSIDE[self._opens()](self.toolbox.world.scene)
        shut = isinstance(inside, Failure) and inside.kind is FailureKind.INFEASIBLE
        return inside if isinstance(inside, Failure) and shut else DONE

    def _opens(self) -> str:
        """What there is to open, as perception calls it; nothing for a box or a bowl."""
        to = self.get_input("task").to
        return MEANT_BY.get(to.kind or "" if isinstance(to, ObjectDescription) else str(to), "")

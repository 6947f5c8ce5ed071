"""Find out whether what is to be picked up is in a hand already, and whether a hand is free for it."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.furniture_called import is_called, standing_on
from trees.beliefs.scene.held_object import HeldObject, fits
from trees.failures import Failure, Number
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.port_values import Target
from trees.readings.held import free_hands, held_objects, lost
from trees.readings.odometry import what_is_around
from trees.tasks import Destination, ObjectDescription, PickTask


class HandForIt(Leaf):
    """Find out whether a hand already holds what is to be picked up, or else whether a hand is free for it.

    It fails as infeasible when the other hand than the one that was named holds it, and when no hand is free
    for it. Whether the object in a hand is meant depends on the description. One that compares things ("the
    other cup") does not mean it. One that says where the object is means it if it was taken from there, as
    after a cancelled pick. One that also fits something that stands about means that thing.
    """

    INPUT_PORTS = ports(task=PickTask)
    OUTPUT_PORTS = ports(in_hand=bool, target=Target, evidence=dict)
    CONTRACT = Contract(
        precondition="none",
        postcondition="what is meant is an attached body and its gripper says holding, or a hand is free",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Ask grippers and world model; what a hand has lost is forgotten first."""
        gone = [one for one in held_objects(self.toolbox) if not self._feels(one)]
        if gone and self.elapsed_s < self.toolbox.policy.lost_grip_s:
            return RUNNING
        for one in gone:
            lost(self.toolbox, one)
        task: PickTask = self.get_input("task")
        held = self._meant(task)
        if held is None:
            free = free_hands(self.toolbox, task.hand)
            if isinstance(free, Failure):
                return free
            self._set_output("in_hand", False)
            return DONE
        if task.hand not in (None, held.hand):
            return Failure.infeasible(
                f"the {held.name} is in the {held.hand} hand already, not in the {task.hand}",
                already_held=True,
                hand=held.hand,
            )
        return self._told(held)

    def _feels(self, held: HeldObject) -> bool:
        return self.toolbox.grippers[held.hand].reading().holding

    def _meant(self, task: PickTask) -> HeldObject | None:
        """What is held and meant, or None."""
        wanted = task.object
        if not isinstance(wanted, ObjectDescription) or task.count != 1:
            return None
        if wanted.ordinal is not None or wanted.relation is not None or wanted.size is not None:
            return None
        held = [one for one in held_objects(self.toolbox, wanted) if self._is_from(one, task.source)]
        scene = self.toolbox.world.scene
        about = [item.name for item in scene.objects.values() if item.movable and fits(item, wanted)]
        return held[0] if held and not about else None

    def _is_from(self, held: HeldObject, source: Destination | None) -> bool:
        """Whether it was taken from where what is meant is said to be."""
        origin = self.toolbox.world.taken_from.get(held.name)
        if not isinstance(source, str) or origin is None:
            return source is None
        meant = standing_on(source, what_is_around(self.toolbox))
        return is_called(origin.support, source) or meant(origin.support)

    def _told(self, held: HeldObject) -> Status:
        gripper = self.toolbox.model.description.grippers[held.hand]
        reading = self.toolbox.grippers[held.hand].reading()
        odom_T_tcp = self.toolbox.model.frame_pose(self.toolbox.sensing.state().q, gripper.tcp_frame)
        place = odom_T_tcp @ held.tcp_T_object
        self._set_output("target", Target(held.name, held.kind, held.color, held.shape, place, 1.0))
        evidence: dict[str, Number] = {
            "hand": held.hand,
            "gripper_opening_m": reading.opening_m,
            **reading.effort,
            "already_held": True,
        }
        self._set_output("in_hand", True)
        self._set_output("evidence", evidence)
        self.measured(**evidence)
        self.feedback_message = f"the {held.name} is in the {held.hand} hand already"
        return DONE

"""Draw empty arms in before the chest, to walk where hands at home have no room."""

from __future__ import annotations

from kinematics.requests.move import MoveRequest
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf, move_from_here
from trees.nodes.ports import ports
from trees.skills.walking.empty_arms import are_at, home_joints, tucked_joints
from trees.skills.walking.walking_leaf import hands_have_room
from trees.toolbox import Toolbox


class DrawArmsIn(PlannedMotionLeaf):
    """Fold the empty arms before the chest, or bring them home again; nothing else moves."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the robot stands",
        postcondition="every joint of an arm that holds nothing is measured to be where it is wanted",
        deadline_s=20.0,
        moves="body",
        on_success="the arms that hold nothing are drawn in, or at home again",
    )

    def __init__(self, name: str, toolbox: Toolbox, out: bool = False) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            out: Bring them home again.
        """
        super().__init__(name, toolbox)
        self._out = out

    def goal(self) -> MoveRequest | Failure | None:
        """The joints of the empty arms, unless they are there already."""
        toolbox = self.toolbox
        joints = home_joints(toolbox) if self._out else tucked_joints(toolbox)
        if not joints and not self._out:
            return Failure.infeasible(f"{toolbox.model.description.name} has no arm to draw in")
        if are_at(toolbox, joints):
            return None
        if self._out:
            room = hands_have_room(toolbox)
            if room is None:
                return Failure.infeasible(
                    "the range sensor does not tell whether the hands have room to come out"
                )
            if not room:
                return Failure.infeasible("the hands have no room to come out again")
        return move_from_here(toolbox, joints, keep_others=True)

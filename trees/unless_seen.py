"""Something that is done only when the way of the planned motion was not looked at yet."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from kinematics.requests import Grasp
from trees.hand_ways import unseen_below, unseen_on_way
from trees.ports import ports
from trees.skipping import Skipping
from trees.steps import Step, Target
from trees.toolbox import Toolbox


class UnlessSeen(Skipping):
    """Ticks its child when a hand is to go where nobody has looked; otherwise succeeds at once."""

    INPUT_PORTS = ports(target=Target, grasp=Grasp, reach=Step)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(f"{child.name} unless seen", child)
        self._toolbox = toolbox

    def needed(self) -> bool:
        """Whether something of the way is unseen."""
        target, hand = self.get_input("target"), self.get_input("grasp").hand
        return len(unseen_on_way(self._toolbox, target, self.get_input("reach"), hand)) > 0


class UnlessSeenBelow(Skipping):
    """Ticks its child when a hand is to pass low over what nobody has looked at; else succeeds at once."""

    INPUT_PORTS = ports(reach=Step)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(f"{child.name} unless seen", child)
        self._toolbox = toolbox

    def needed(self) -> bool:
        """Whether something below the way is unseen."""
        return len(unseen_below(self._toolbox, self.get_input("reach").trajectory)) > 0

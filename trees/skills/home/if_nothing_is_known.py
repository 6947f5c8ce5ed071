"""Something that is done only by who does not know what is around."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.nodes.arrival import is_told_to_be_home
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.toolbox import Toolbox


class IfNothingIsKnown(Skipping):
    """Ticks its child if nothing has been seen yet and the body is not at home; otherwise succeeds at once.

    This is so when a program has taken over a robot that another one left in the middle of a task.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(f"{child.name} if nothing is known", child)
        self._toolbox = toolbox

    def needed(self) -> bool:
        """Whether hands would move among what nobody has seen."""
        scene = self._toolbox.world.scene
        return not (scene.objects or scene.attached or is_told_to_be_home(self._toolbox))

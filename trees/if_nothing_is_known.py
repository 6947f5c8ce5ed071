"""Something that is done only by who does not know what is around."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.arrival import largest_error
from trees.ports import ports
from trees.skipping import Skipping
from trees.toolbox import Toolbox

_HOME_RAD = 0.01
"""Nearer than this to home, there is no way home that could meet anything."""


class IfNothingIsKnown(Skipping):
    """Ticks its child when nothing was seen yet and the body is not at home; otherwise succeeds at once.

    So it is after a new executive took over a robot that another one left in the middle of something.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(f"{child.name} if nothing is known", child)
        self._toolbox = toolbox

    def needed(self) -> bool:
        """Whether hands would move among what nobody has seen."""
        toolbox = self._toolbox
        scene, model = toolbox.world.scene, toolbox.model
        if scene.objects or scene.attached:
            return False
        return largest_error(model, toolbox.motion.reference(), model.q_home)[1] > _HOME_RAD

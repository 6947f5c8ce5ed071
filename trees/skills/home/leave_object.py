"""Open a hand that a cancelled task left about an object, and draw it back."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.best_effort import BestEffort
from trees.nodes.ports import WritePort
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.let_go import LetGo
from trees.skills.home.find_left_about import FindLeftAbout
from trees.toolbox import Toolbox

_HELD, _TOUCHED = "left_about", "left_standing"
_KEYS = {"held": _HELD, "touched": _TOUCHED}


def leave_object(toolbox: Toolbox, about: HeldObject) -> Behaviour:
    """Any other way would take the object along, and from here the hand hides it from the camera.

    What a hand is about without holding it stands on something, so nothing falls when the fingers open.

    Args:
        toolbox: What the leaves may call.
        about: The object, and where the hand has it.
    """
    known: list[Behaviour] = [
        WritePort("what it is about", _HELD, about),
        WritePort("that it stands", _TOUCHED, True),
    ]
    return _left(f"leave the {about.name}", known, toolbox)


def leave_what_stands(toolbox: Toolbox) -> Behaviour:
    """The same for who took over a robot: which object it is shows only when it was looked at.

    Args:
        toolbox: What the leaves may call.
    """
    return _left("leave what stands", [FindLeftAbout("what a hand is about", toolbox, _KEYS)], toolbox)


def _left(name: str, known: list[Behaviour], toolbox: Toolbox) -> Behaviour:
    children = [
        *known,
        LetGo("let go", toolbox, wiring=_KEYS),
        DrawBack("draw back", toolbox, {"held": _HELD}),
    ]
    return BestEffort(Sequence(name, memory=True, children=children))

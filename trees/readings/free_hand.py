"""Which hand is free for a gesture."""

from __future__ import annotations

from kinematics.model.robot_description import HANDS, Hand
from trees.failures import Failure
from trees.toolbox import Toolbox


def free_hands(toolbox: Toolbox, named: Hand | None) -> tuple[Hand, ...] | Failure:
    """Hands that hold nothing, or the named one if it does not.

    Args:
        toolbox: Knows what is held.
        named: The hand that the task asks for, or None.
    """
    frames = toolbox.model.description.tcp_frames
    carrying = {body.frame: name for name, body in toolbox.world.scene.attached.items()}
    wanted = HANDS if named is None else (named,)
    free = tuple(hand for hand in wanted if frames[hand] not in carrying)
    if free:
        return free
    held = " and ".join(f"the {hand} hand holds the {carrying[frames[hand]]}" for hand in wanted)
    return Failure.infeasible(f"no hand is free: {held}")

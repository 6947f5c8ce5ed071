"""What the hands hold, as the world model has it, and which of them are free."""

from __future__ import annotations

from kinematics.model.robot_description import Hand
from trees.beliefs.scene.held_object import HeldObject, fits
from trees.failures import Failure, Reason
from trees.tasks import Thing
from trees.toolbox import Toolbox


def held_object(toolbox: Toolbox, wanted: Thing | None, hand: Hand | None) -> HeldObject | Failure:
    """The object in a hand that is meant.

    Args:
        toolbox: Knows what is attached, and what the grippers feel.
        wanted: What is meant, or None for whatever is held.
        hand: The hand that is named, or None.
    """
    fitting = [one for one in held_objects(toolbox, wanted) if hand in (None, one.hand)]
    if not fitting:
        what = "nothing" if wanted is None else f"no {wanted}"
        return Failure.postcondition(f"{what} is in the {hand} hand" if hand else f"{what} is in a hand")
    held = fitting[0]
    if not toolbox.grippers[held.hand].reading().holding:
        return Failure.postcondition(
            f"the {held.name} is no longer in the {held.hand} hand",
            opening_m=toolbox.grippers[held.hand].reading().opening_m,
        )
    return held


def held_objects(toolbox: Toolbox, wanted: Thing | None = None) -> list[HeldObject]:
    """Everything that the world model has in a hand and that may be meant, in the order of the names."""
    frames = {frame: side for side, frame in toolbox.model.description.tcp_frames.items()}
    return [
        HeldObject(name, frames[body.frame], body.body.shape, body.frame_T_object, body.body.label)
        for name, body in sorted(toolbox.world.scene.attached.items())
        if body.frame in frames and fits(body.body, wanted)
    ]


def lost(toolbox: Toolbox, held: HeldObject) -> Failure:
    """Forget that a hand holds something, and say that it lost it.

    Args:
        toolbox: Its world model forgets.
        held: What the hand held; where it is now is not known.
    """
    world = toolbox.world
    body = world.scene.attached.get(held.name)
    if body is not None:
        detached = world.scene.with_detached(held.name, body.body.world_T_object)
        world.update(detached.without_object(held.name))
    return Failure.postcondition(
        f"the {held.name} slipped out of the {held.hand} hand, or was taken out of it",
        opening_m=toolbox.grippers[held.hand].reading().opening_m,
    ).because(Reason.SLIPPED)


def free_hands(toolbox: Toolbox, named: Hand | None) -> tuple[Hand, ...] | Failure:
    """Hands that hold nothing, or the named one if it does not.

    Args:
        toolbox: Knows what is held.
        named: The hand that the task asks for, or None.
    """
    frames = toolbox.model.description.tcp_frames
    carrying = {body.frame: name for name, body in toolbox.world.scene.attached.items()}
    wanted = toolbox.model.description.gripping_hands if named is None else (named,)
    free = tuple(hand for hand in wanted if frames[hand] not in carrying)
    if free:
        return free
    held = " and ".join(f"the {hand} hand holds the {carrying[frames[hand]]}" for hand in wanted)
    return Failure.infeasible(f"no hand is free: {held}")

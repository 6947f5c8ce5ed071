"""Go to a person, face them, wave, and say hello."""

from __future__ import annotations

from trees.api import Behaviour, BestEffort, GoHome, Retry, Sequence, Toolbox, tidily
from trees.skills.gestures.raise_hand import RaiseHand
from trees.skills.gestures.swing_hand import SwingHand
from trees.skills.greet.say_hello import SayHello
from trees.skills.greet.still_there import StillThere
from trees.skills.meeting.tree import going_after_is_useless, met

_WAVES = 3
"""How often somebody who walks is waved to anew."""


def greet(task: object, toolbox: Toolbox) -> Behaviour:
    """Meet the person, wave, say hello, and lower the hand. Reads "task", writes "evidence".

    Who has no hand free says hello without a wave, and tells so.

    Args:
        task: What is to be done.
        toolbox: What leaves may call.
    """
    wave: list[Behaviour] = [
        RaiseHand("raise hand", toolbox),
        SwingHand("swing hand", toolbox, {"evidence": "waved"}),
    ]
    attempt: list[Behaviour] = [
        *met(task, toolbox),
        BestEffort(Sequence("wave", memory=True, children=wave)),
        StillThere("still there", toolbox),
    ]
    children: list[Behaviour] = [
        Retry(
            "wave to them",
            Sequence("attempt", memory=True, children=attempt),
            GoHome("lower hand first", toolbox),
            _WAVES,
            going_after_is_useless,
        ),
        SayHello("say hello", toolbox),
        GoHome("lower hand", toolbox),
    ]
    return tidily("greet", children, toolbox, toolbox.policy.walk_timeout_s)

"""Go to a person, face them, wave, and say hello."""

from __future__ import annotations

from trees.api import Behaviour, BestEffort, GoHome, Sequence, Toolbox, tidily
from trees.skills.gestures.raise_hand import RaiseHand
from trees.skills.gestures.swing_hand import SwingHand
from trees.skills.greet.say_hello import SayHello
from trees.skills.meeting.tree import met


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
    children: list[Behaviour] = [
        *met(task, toolbox),
        BestEffort(Sequence("wave", memory=True, children=wave)),
        SayHello("say hello", toolbox),
        GoHome("lower hand", toolbox),
    ]
    return tidily("greet", children, toolbox, toolbox.policy.walk_timeout_s)

"""One exchange between a person, a model and the robot, and what may come of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from tools.evaluate.front.scripted_server import Answer

HASTY = "hasty"
USUAL = "scripted"


@dataclass(frozen=True, slots=True)
class Transcript:
    """One exchange.

    Attributes:
        kind: What sort it is: "invented object", "free speech".
        scene: Where it is said.
        text: What the person says.
        answers: What the model's server sends, request after request.
        wants: Sentences that say what the person wants; none where nothing of what is proposed is wanted.
        replies: What the person answers before read-backs: to questions that the model asks.
        why: A word that the refusal or the question must hold; empty where it is done.
        seen: What is told as perceived beside what is.
        model: Name of the settings.
        fails_first: Whether the first proposal is one that fails.
    """

    kind: str
    scene: str
    text: str
    answers: tuple[Answer, ...]
    wants: tuple[str, ...] = ()
    replies: tuple[str, ...] = ()
    why: str = ""
    seen: tuple[Mapping[str, Any], ...] = ()
    model: str = USUAL
    fails_first: bool = False

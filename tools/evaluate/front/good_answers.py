"""Exchanges in which the model is right: in every form that it may answer in, over several rounds too."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from tools.evaluate.front.free_speech import free_speech
from tools.evaluate.front.scripted_server import Answer, saying, steps
from tools.evaluate.front.transcript import Transcript

_FORMS = ("strict", "fenced", "one command", "list", "unsure", "asks", "action", "fails first")


def good_transcripts(count: int, seed: int) -> list[Transcript]:
    """So many exchanges that ought to end with what the person wants.

    Args:
        count: How many.
        seed: Of the draw.
    """
    rng = np.random.default_rng([seed, 42])
    free = free_speech(count, seed + 1000)
    made = []
    for index, one in enumerate(free):
        form = _FORMS[index % len(_FORMS)]
        made.append(_in_form(one, form, rng))
    return made


def _in_form(one: Transcript, form: str, rng: np.random.Generator) -> Transcript:
    (sentence,) = one.wants
    sure = round(float(rng.uniform(0.8, 1.0)), 2)
    match form:
        case "strict":
            return _with(one, form, steps(sentence, confidence=sure))
        case "fenced":
            text = json.dumps({"steps": [{"command": sentence, "confidence": sure}], "question": None})
            return _with(one, form, saying(f"```json\n{text}\n```"))
        case "one command":
            return _with(one, form, saying({"command": sentence, "confidence": sure}))
        case "list":
            return _with(one, form, saying([{"command": sentence, "confidence": sure}]))
        case "unsure":
            return _with(one, form, steps(sentence, confidence=round(float(rng.uniform(0.1, 0.79)), 2)))
        case "asks":
            asking = saying({"steps": [], "question": "What exactly shall I do?"})
            return _with(one, form, asking, steps(sentence), replies=(f"{sentence} I mean",))
        case "action":
            return _held("tabletop", form, rng)
        case _:
            color, kind = (("red", "cup"), ("blue", "box"))[int(rng.integers(2))]
            text = f"there ought to be a can or else a {color} {kind} about, get a grip of what you find mate"
            told = (steps("pick up the can"), steps(f"pick up the {color} {kind}"))
            wants = ("pick up the can", f"pick up the {color} {kind}")
            return Transcript(form, "tabletop", text, told, wants, fails_first=True)


def _held(scene: str, form: str, rng: np.random.Generator) -> Transcript:
    """An action with every slot there, null where it says nothing, as strict servers have it."""
    color, kind = (("red", "cup"), ("blue", "box"))[int(rng.integers(2))]
    thing: dict[str, Any] = dict.fromkeys(("name", "size", "material", "ordinal", "relation", "traits"))
    step = {
        "action": "pick",
        "object": {**thing, "kind": kind, "color": color},
        "confidence": 0.97,
        "from": None,
        "hand": None,
        "count": None,
    }
    text = f"would be neat to see that {color} {kind} dangling from your arm"
    answer = saying({"steps": [step], "question": None})
    return Transcript(form, scene, text, (answer,), (f"pick up the {color} {kind}",))


def _with(one: Transcript, form: str, *answers: Answer, replies: tuple[str, ...] = ()) -> Transcript:
    return Transcript(form, one.scene, one.text, answers, one.wants, replies)

"""Free speech that the parser refuses, with what a model that paraphrases rightly makes of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np

from executive.understanding.spoken_in import spoken_in
from executive.understanding.understanding import understand
from tools.evaluate.front.scripted_server import steps
from tools.evaluate.front.transcript import Transcript

_THINGS: Mapping[str, Sequence[str]] = MappingProxyType(
    {
        "tabletop": ("red cup", "blue box"),
        "counter": ("red cup", "blue cup", "yellow box"),
        "dinner": ("red cup", "blue cup"),
    }
)
"""Things of a scene that a hand comes to without a step."""

_NUMBERS = ("two", "three", "four", "five", "six")
_WORDS = ("dinner is ready", "the taxi is here", "good morning everybody", "the meeting begins soon")
_PEOPLE = ("Ana", "Ben")

_WISHES: Mapping[str, tuple[str, Sequence[str]]] = MappingProxyType(
    {
        "hold": (
            "pick up the {thing}",
            (
                "any chance of the {thing} ending up in your hand",
                "be a dear and get your fingers around the {thing}",
                "the {thing} looks lonely, lift it up for me would you mate",
                "I bet you manage to hold the {thing} up in the air",
                "how about you and the {thing} get together, hand around it and up",
                "gimme a demonstration with the {thing}: grip, raise",
                "so, about the {thing}: up with it, please",
                "it would make my day to see the {thing} in your grasp",
                "my back hurts, could you be an angel and hoist that {thing}",
                "somebody has to get the {thing} up, and I fancy that is you",
                "the {thing}, if I may trouble you, into your hand it goes",
                "oh and that {thing} there, snatch it for us will you",
            ),
        ),
        "look": (
            "look at the {thing}",
            (
                "mind having a peek at the {thing}",
                "let your gaze wander to the {thing}",
                "I wonder how the {thing} is doing, cast an eye on it",
                "eyes over to the {thing}, my friend",
                "it might be worth a glance, that {thing}",
                "have your cameras on the {thing} for a sec please",
            ),
        ),
        "point": (
            "point at the {thing}",
            (
                "whereabouts is the {thing}, stick your finger out towards it",
                "I cannot spot the {thing} myself, aim your arm at it",
                "signal with your arm which one you call the {thing}",
                "reveal to us with an outstretched arm the {thing} please",
            ),
        ),
        "home": (
            "go home",
            (
                "enough for today, back to your resting posture",
                "you may relax now and get into your home pose",
                "that will be all, arms back home please my dear",
                "let us call it a day, take up your neutral stance",
            ),
        ),
        "wait": (
            "wait for {number} seconds",
            (
                "chill for {number} seconds or thereabouts",
                "let {number} seconds go by in silence would you",
                "tell you what, just idle for {number} seconds",
                "I need {number} seconds to think, bear with me",
                "gimme like {number} seconds of peace",
            ),
        ),
        "wave": (
            "wave to {person}",
            (
                "{person} would be thrilled about a friendly wave from you",
                "why not make {person} smile with a little wave",
                "I reckon {person} deserves a wave, don't be shy",
                "a wave in the direction of {person} would be lovely indeed",
                "{person} is feeling down, cheer things up with a wave",
            ),
        ),
        "say": (
            'say "{words}"',
            (
                "spread the news aloud will you: {words}",
                "everyone ought to be aware that {words}, use your voice",
                "kindly let it be known to the room that {words}",
                "shout out loud and clear, {words}",
            ),
        ),
        "describe": (
            "what is on the table",
            (
                "what have we got on the table, give me the rundown",
                "I'm curious about the table, enlighten me on its contents",
                "fill me in on all that clutter on the table",
                "the table: talk me through it my friend",
            ),
        ),
    }
)
"""What is wanted, as a sentence of the command language, and how people say so who know no such language."""

_SCENES: Mapping[str, Sequence[str]] = MappingProxyType(
    {"wave": ("person", "dinner"), "describe": ("tabletop",)}
)
_OPENERS = ("", "", "hey, ", "listen, ", "alright then, ", "you know what, ", "honestly, ", "hm, ")
_CLOSERS = ("", "", "", " cheers", " if that is no bother", " my good fellow", " whenever it suits you")


def free_speech(count: int, seed: int) -> list[Transcript]:
    """So many different sentences, each refused by the parser where it is said.

    Args:
        count: How many.
        seed: Of the draw.
    """
    rng = np.random.default_rng([seed, 41])
    made: dict[str, Transcript] = {}
    kinds = list(_WISHES)
    while len(made) < count:
        kind = kinds[int(rng.integers(len(kinds)))]
        one = _drawn(kind, rng)
        if one.text not in made and _is_refused(one):
            made[one.text] = one
    return list(made.values())


def _drawn(kind: str, rng: np.random.Generator) -> Transcript:
    wanted, ways = _WISHES[kind]
    scene = _one(rng, _SCENES.get(kind, tuple(_THINGS)))
    slots = {
        "thing": _one(rng, _THINGS.get(scene, ("red cup",))),
        "number": _one(rng, _NUMBERS),
        "words": _one(rng, _WORDS),
        "person": _one(rng, _PEOPLE),
    }
    way = _one(rng, ways).format(**slots)
    text = f"{_one(rng, _OPENERS)}{way}{_one(rng, _CLOSERS)}"
    sentence = wanted.format(**slots)
    return Transcript("free speech", scene, text, (steps(sentence),), (sentence,))


def _is_refused(one: Transcript) -> bool:
    with spoken_in(one.scene):
        return understand(one.text).parsed.refusal is not None


def _one(rng: np.random.Generator, of: Sequence[str]) -> str:
    return of[int(rng.integers(len(of)))]

"""Valid wordings to offer beside a refusal: of the same action as what was said, never of another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from executive.vocabulary import Vocabulary
from executive.vocabulary.written import split_words

EXAMPLES = (
    "pick up the red cup",
    "pick up the red cup on the table",
    "pick up the blue box with the left hand",
    "put the red cup on the shelf",
    "put the ball in the box",
    "bring me the bottle",
    "hand the cup to Ana",
    "open the fridge",
    "open the left drawer",
    "close the fridge",
    "close the drawer",
    "walk to the kitchen",
    "move forward 1 meter",
    "move backward 1 meter",
    "turn left",
    "wave to Ana",
    "point at the bottle",
    "look at the cup",
    "find the red cup",
    "count the cups on the table",
    "what is on the table",
    "describe the red box",
    "say hello to Ana",
    "wait 5 seconds",
    "go home",
    "stop",
)

_FAMILIES: Mapping[str, Sequence[str]] = MappingProxyType(
    {
        "pick": ("PICK_UP", "PICK"),
        "put": ("PUT", "PUT_DOWN", "PUT_IN", "MOVE_THING", "DROP", "DISCARD", "TOSS"),
        "bring": ("BRING", "FETCH", "CARRY", "WANT"),
        "hand": ("GIVE", "RETURN", "CAN_I_HAVE"),
        "open": ("OPEN",),
        "close": ("CLOSE",),
        "walk": ("WALK", "APPROACH", "COME", "COME_BACK", "GO_BACK", "GO_SOMEWHERE"),
        "move": ("MOVE", "BACK_UP", "BRIDGE"),
        "turn": ("TURN", "A_TURN", "AROUND"),
        "wave": ("WAVE", "WAVE_YOUR", "SKILL_AT"),
        "point": ("POINT_AT", "POINT_YOUR"),
        "look": ("LOOK_AT",),
        "find": ("FIND", "SEARCH", "WHERE_IS", "IS_THERE"),
        "count": ("COUNT", "HOW_MANY"),
        "what": ("WHAT_IS", "SEE"),
        "describe": ("DESCRIBE",),
        "say": ("SAY", "TELL"),
        "wait": ("WAIT",),
        "go": ("GO_HOME",),
        "stop": ("STOP", "REVOKE"),
    }
)
"""Word classes of verbs by the first word of the examples that show them."""

_FAMILY_OF = {name: family for family, names in _FAMILIES.items() for name in names}
_HEADINGS = frozenset({"FORWARD", "BACKWARD"})
_TAKES_A_NOUN = frozenset({"the", "a", "an", "my", "your", "our", "this", "that", "of"})
_LITTLE = frozenset({"the", "to", "on", "in", "me", "at", "with", "is", "up"})

LONGEST = 60
"""Words that are looked at, so that no text takes long."""


def nearest_example(text: str, vocabulary: Vocabulary) -> str | None:
    """The valid wording of an action that a text names which looks most like it; None where it names none."""
    said = [word for word, _, _ in split_words(text)][:LONGEST]
    families = next(_families(said, vocabulary), None)
    if families is None:
        return None
    words = {word.rstrip("s") for word in said} - _LITTLE
    heads = any(_heads(said, position, vocabulary) for position in range(len(said)))
    if "move" in families and heads:
        families = {"move"}  # "walk ahead", "drive backwards": not to a place
    fitting = [one for one in EXAMPLES if one.split()[0] in families]
    return max(fitting, key=lambda one: len(words & set(one.lower().split())) / (3 + len(one.split())))


def _heads(said: Sequence[str], position: int, vocabulary: Vocabulary) -> bool:
    """Whether a direction is said at a place: "ahead"."""
    return any(reading.word_class in _HEADINGS for _, reading in vocabulary.matches(said, position))


def is_verb(word_class: str) -> bool:
    """Whether a word class holds verbs of what can be done."""
    return word_class in _FAMILY_OF


def _families(said: Sequence[str], vocabulary: Vocabulary) -> Iterator[set[str]]:
    """The first words of examples of each verb of a text, in its order."""
    position = 0
    while position < len(said):
        found = list(vocabulary.matches(said, position))
        verbs = [(length, reading.word_class) for length, reading in found if is_verb(reading.word_class)]
        longest = max(verbs, default=(0, ""))[0]
        families = {_FAMILY_OF[name] for length, name in verbs if length == longest}
        is_noun = position > 0 and said[position - 1] in _TAKES_A_NOUN
        is_side = any(reading.word_class == "LEFT_RIGHT" for _, reading in found)
        if families and not is_noun and not is_side:
            yield families
        position += max((length for length, _ in found), default=1)

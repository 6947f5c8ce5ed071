"""Questions that hold a task, and what an answer to one means.

An answer chooses ("2", "red", "the left one", "the bigger one"), withdraws ("never mind"), or is not
understood; then the question is asked again. Every word of it counts: what is left over makes it unclear.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass

from executive.meaning import Parsed, Question, Refusal
from trees.beliefs.grounding.grounding import Ambiguous, Found, Grounding
from trees.beliefs.grounding.ranking import ORDER_WORDS, SIZE_WORDS
from trees.tasks import ObjectDescription, ObjectOf, PickTask

MAX_ANSWER = 200
"""Characters of an answer that are looked at."""

MAX_TRIES = 3
"""An answer that is not understood so often leaves the question open."""


@dataclass(frozen=True, slots=True)
class OpenQuestion:
    """What a person is asked; nothing moves before the answer.

    Attributes:
        text: The question.
        choices: What can be chosen, each in words of its own; empty when any sentence may answer.
        tried: What was wrong with the answer before, or nothing.
    """

    text: str
    choices: tuple[str, ...] = ()
    tried: str = ""

    def lines(self) -> list[str]:
        """For people: the question, and a numbered line for each choice."""
        head = [self.tried] if self.tried else []
        return [*head, self.text, *(f"  {i}  {words}" for i, words in enumerate(self.choices, 1))]


@dataclass(frozen=True, slots=True)
class Chosen:
    """The answer means one of the choices."""

    index: int


@dataclass(frozen=True, slots=True)
class Withdrawn:
    """The answer ends the task."""


@dataclass(frozen=True, slots=True)
class Unclear:
    """The answer is not understood; the message says why."""

    message: str


Answer = Chosen | Withdrawn | Unclear
Clarifying = Generator[OpenQuestion, str | None, Parsed]
"""A question where one is open; takes its answer, or None when there is none."""

_WITHDRAWAL_LINES = """
never mind
nevermind
cancel
cancel it
cancel that
stop
abort
quit
exit
no
nope
no thanks
no thank you
none
none of them
neither
neither of them
nothing
forget it
forget about it
forget that
leave it
do nothing
do not
don't
"""
_WITHDRAWALS = frozenset(_WITHDRAWAL_LINES.split("\n")) - {""}
_ASSENTS = frozenset(
    {"yes", "yep", "yeah", "y", "ok", "okay", "sure", "do it", "go ahead", "correct", "right"}
)
_INDIFFERENT = frozenset(
    {"any", "any one", "any of them", "either", "either one", "either of them", "whichever", "i don't care"}
)
_FILLER_WORDS = """
the a an that this please one i mean meant want take pick it's is it number choice option of them would
like on to at my your side
"""
_FILLERS = frozenset(_FILLER_WORDS.split())
_NUMBERS = {
    word: i
    for i, words in enumerate(
        (
            ("1", "first", "1st"), ("2", "two", "second", "2nd"), ("3", "three", "third", "3rd"),
            ("4", "four", "fourth", "4th"), ("5", "five", "fifth", "5th"), ("6", "six", "sixth", "6th"),
            ("7", "seven", "seventh", "7th"), ("8", "eight", "eighth", "8th"), ("9", "nine", "ninth", "9th"),
        )
    )
    for word in words
}  # fmt: skip
_WORD = re.compile(r"[\w]+(?:['.\-][\w]+)*")


def understood_answer(
    text: str,
    choices: Sequence[str],
    ground: Callable[[ObjectDescription], Grounding] | None = None,
    names: Sequence[str] = (),
) -> Answer:
    """Find out what an answer means.

    Args:
        text: What was answered; untrusted.
        choices: What could be chosen, in words.
        ground: Finds among the choices what a description means; left out where they are no things.
        names: What ``ground`` calls the choices, in the same order.
    """
    plain = " ".join(_WORD.findall(text[: MAX_ANSWER + 1].lower().replace("’", "'")))
    if len(text) > MAX_ANSWER or not plain:
        return Unclear("the answer is empty" if not plain else "the answer is too long")
    if plain.removeprefix("please ").removesuffix(" please") in _WITHDRAWALS:
        return Withdrawn()
    if plain in _INDIFFERENT and choices:
        return Chosen(0)
    if plain in _ASSENTS:
        if choices and choices[0] == "yes":
            return Chosen(0)
        if len(choices) == 1:
            return Chosen(0)
    for chosen in (
        _by_words(plain, choices),
        _by_number(plain, choices),
        _by_description(plain, ground, names),
    ):
        if chosen is not None:
            return chosen
    return Unclear(f"{text.strip()[:40]!r} is none of the choices")


def _by_words(plain: str, choices: Sequence[str]) -> Answer | None:
    """The one choice that holds every word of the answer."""
    words = set(plain.split())
    said = words - _FILLERS
    if not said:
        return None
    fitting = [i for i, choice in enumerate(choices) if said <= set(_WORD.findall(choice.lower()))]
    if len(fitting) == 1:
        return Chosen(fitting[0])
    same = [i for i in fitting if set(_WORD.findall(choices[i].lower())) - _FILLERS == said]
    if len(same) == 1:
        return Chosen(same[0])
    return Unclear(f"{plain!r} fits {len(fitting)} of them") if fitting else None


def _by_number(plain: str, choices: Sequence[str]) -> Answer | None:
    """The number of a choice; they are counted from the left, as they are told."""
    said = [word for word in plain.split() if word not in _FILLERS]
    if said[-2:] == ["from", "left"]:
        said = said[:-2]
    if said == ["last"]:
        return Chosen(len(choices) - 1) if choices else None
    if len(said) != 1 or said[0] not in _NUMBERS:
        return None
    index = _NUMBERS[said[0]]
    return Chosen(index) if index < len(choices) else Unclear(f"there are only {len(choices)} choices")


def _by_description(
    plain: str, ground: Callable[[ObjectDescription], Grounding] | None, names: Sequence[str]
) -> Answer | None:
    """The thing that the answer describes; parsed as the object of a pick."""
    if ground is None:
        return None
    wanted = described(plain)
    if wanted is None:
        return None
    match ground(wanted):
        case Found((name,)) if name in names:
            return Chosen(names.index(name))
        case Ambiguous():
            return Unclear(f"{plain!r} fits several of them")
        case _:
            return None


def described(plain: str) -> ObjectDescription | None:
    """The description in "the bigger one", "left", "behind the bottle", or None."""
    from executive.understanding.command_parser import parse

    for sentence in (f"pick up {plain}", f"pick up the {plain} one", f"pick up the one {plain}"):
        commands = parse(sentence).commands
        if len(commands) == 1 and isinstance(commands[0], PickTask):
            task = commands[0]
            plain_pick = task.source is None and task.hand is None and task.count == 1
            if plain_pick and not isinstance(task.object, ObjectOf):
                return task.object
    return _one_word(plain)


def _one_word(plain: str) -> ObjectDescription | None:
    """The description in a single word of order or size."""
    said = [word for word in plain.split() if word not in _FILLERS]
    if len(said) != 1:
        return None
    if said[0] in ORDER_WORDS:
        return ObjectDescription(ordinal=said[0])
    return ObjectDescription(size=said[0]) if said[0] in SIZE_WORDS else None


def clarified(parsed: Parsed, meanings: Mapping[str, Parsed] | None = None) -> Clarifying:
    """Put the question of a sentence that is not clear in itself; the answer takes its place.

    An answer is one of the choices, which are sentences, a sentence of its own, or what was missing in it.

    Args:
        parsed: What has a question.
        meanings: What choices mean that are no sentences, such as "yes".

    Returns:
        What the answer means; the same question when nobody answers, a refusal when it is withdrawn.
    """
    from executive.understanding.command_parser import parse

    tried = ""
    for _ in range(MAX_TRIES):
        question = parsed.question
        if question is None:
            return parsed
        text = yield OpenQuestion(question.text, question.choices, tried)
        if text is None:
            return parsed
        match understood_answer(text, question.choices):
            case Withdrawn():
                return Parsed(parsed.text, refusal=Refusal("withdrawn by the answer"))
            case Chosen(index):
                choice = question.choices[index]
                known = None if meanings is None else meanings.get(choice)
                answered = parse(choice) if known is None else known
            case Unclear(message):
                tried, answered = message, _answered(text, question)
        if meanings is not None and answered not in meanings.values():
            continue
        if answered.commands or (answered.question is not None and answered.question != question):
            parsed = answered
    return parsed


def _answered(text: str, question: Question) -> Parsed:
    """What an answer means that is no choice: by itself, or as what the sentence lacks."""
    from executive.understanding.command_parser import parse

    alone = parse(text)
    if alone.commands or question.completes is None or len(text) > MAX_ANSWER:
        return alone
    before, behind = question.completes
    whole = parse(f"{before}{text.strip().rstrip('.!?')}{behind}")
    return whole if whole.commands or whole.question is not None else alone

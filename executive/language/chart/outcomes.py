"""Which of the readings of a sentence is what was said."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from executive.language.clauses.scopes import UNCLEAR_ORDER
from executive.language.clauses.sentences import Sentence
from executive.language.commands.moving import NO_DIRECTION
from executive.language.commands.speech import UNQUOTED
from executive.language.phrases.values import EXCEEDS, HARMS, Nominal, Trouble
from executive.language.resolve.guards import harm_in
from executive.language.resolve.references import UnresolvedError, commands_of
from executive.meaning import Command, command_json
from trees.tasks import ObjectOf, SayTask

Outcome = tuple[Command, ...] | Trouble
"""What a sentence comes to in one reading: commands, or what keeps them from being done."""

_HANDLED = frozenset({"pick", "place", "put_in", "hand_over", "open", "close"})


def outcomes_of(
    meanings: Iterable[object],
    people_in: Callable[[str], Sequence[Nominal]],
    is_command: Callable[[str], bool] = lambda _text: False,
    remembers: bool = False,
) -> list[Outcome]:
    """What each meaning of the whole sentence comes to, without those that are less likely."""
    troubles: dict[Trouble, None] = {}
    asked: list[int] = []
    understood: dict[str, tuple[tuple[int, ...], tuple[Command, ...]]] = {}
    for meaning in sorted(meanings, key=lambda one: not isinstance(one, Trouble)):
        if isinstance(meaning, Trouble):
            troubles[meaning] = None
        elif isinstance(meaning, Sentence):
            try:
                commands = commands_of(meaning.clauses, people_in, remembers)
            except UnresolvedError as unresolved:
                troubles[unresolved.trouble] = None
                asked += [meaning.unseparated] if unresolved.trouble.asks else []
                continue
            harm = harm_in(commands)
            if harm is not None:
                return [harm]  # no other reading is worth the risk
            spoken = sum(len(one.words) for one in commands if isinstance(one, SayTask))
            refers = -str(commands).count(ObjectOf.__name__)  # as these two among those that are the same
            rank = (meaning.unseparated, spoken, len(commands), refers)
            key = repr([_as_first_named(one, commands) for one in commands])
            if key not in understood or rank < understood[key][0]:
                understood[key] = (rank, commands)
    rival = next((one for one in troubles if one.rivals), None)
    if rival is not None and understood:
        return [rival]
    longer = any(one.message == UNQUOTED for one in troubles)
    if (longer or len({spoken for (_, spoken, *_), _ in understood.values()}) > 1) and any(
        isinstance(one, SayTask) and is_command(one.words)
        for _, commands in understood.values()
        for one in commands
    ):
        return [Trouble("where do the words to say end? put them in quotation marks", asks=True)]
    best = min((rank[:2] for rank, _ in understood.values()), default=(0, 0))
    if asked and min(asked) < best[0]:
        return list(troubles)  # no reading that is less likely is taken because a likely one is asked about
    likely = [commands for rank, commands in understood.values() if rank[:2] == best]
    told: list[Outcome] = [
        one for one in likely if not any(_only_begins_with_more(one, other) for other in likely)
    ]
    return told or list(troubles)


def _as_first_named(command: Command, commands: Sequence[Command]) -> dict[str, Any]:
    """A command as JSON where a place that was opened is told by its words: "in it" is "in the drawer"."""
    told = command_json(command)
    for slot in ("to", "on", "from"):
        place = told.get(slot)
        if isinstance(place, dict) and isinstance(place.get("ref"), int):
            before = commands[place["ref"]]
            if before.action in ("open", "close"):
                named = command_json(before)["object"]
                told[slot] = named["kind"] if set(named) == {"kind"} else named
    return told


def _only_begins_with_more(longer: Sequence[Command], shorter: Sequence[Command]) -> bool:
    """Whether a reading makes a task of what is a courtesy or a statement in another: "come and take it".

    What is handled in one reading and left out in another is no courtesy: "the orange and the orange ball".
    """
    more, ends = longer[: -len(shorter)], [one.action for one in longer[-len(shorter) :]]
    handled = any(one.action in _HANDLED for one in more)
    return len(longer) > len(shorter) and ends == [one.action for one in shorter] and not handled


def explains_best(trouble: Trouble) -> tuple[bool, ...]:
    """How well a trouble explains a sentence, the lowest best; any "go" can lack a direction."""
    no_more = trouble.message == NO_DIRECTION
    harmless = not trouble.message.endswith(HARMS)
    clear = trouble != UNCLEAR_ORDER
    return harmless, EXCEEDS not in trouble.message, no_more, not trouble.asks, clear, not trouble.choices

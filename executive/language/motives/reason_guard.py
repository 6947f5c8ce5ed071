"""Whether a reason may be passed over: it changes nothing of the command, orders nothing, and means no harm.

"Close the window because it is raining" closes the window. "Bring the cup because Ana needs it", "... because
it is on the desk", "... because I want the red one" and "... because I'm off and the plate" say more than the
command does; such a reason is not passed over, and the sentence is refused as before.
"""

from __future__ import annotations

import re
from collections.abc import Set as AbstractSet

from executive.language.motives.reason import (
    NOUNS,
    OWNERS,
    SOMEBODY,
    TELLS_APART,
    THINGS,
    Reason,
    words_of,
)
from executive.language.refusing.examples import is_verb
from executive.language.resolving.hazards import is_hazard
from executive.vocabulary import Reading

_SPOKEN = re.compile(r"[^\W_]+(?:['’-][^\W_]+)*['’]?|[,.;:!?()–—-]")
"""A word, or a mark that people write."""

_RECEIVERS = frozenset({"NAME", "PERSON", "ME", "HIM", "US"})
_PLACING = frozenset({"ON", "ONTO", "IN", "INTO", "AT", "NEXT_TO", "RELATION", "FROM", "TO", "NEAREST_TO"})
_PEOPLE = frozenset({"PEOPLE"})
_ARTICLES = frozenset({"DET", "OWNER", "OWNING", "ALL", "BOTH", "EVERY", "ANOTHER"})
_NUMBERS = frozenset({"AMOUNT", "TENS", "COUPLE"})
_SKILLS_NOT = frozenset({"NO_SKILL", "HARM", "THROW", "ASK", "LIMITLESS"})
_MORE_VERBS = frozenset(
    {
        "PUSH",
        "PULL",
        "CLEAR",
        "MEET",
        "CONTINUE",
        "LEAVE_SO",
        "ENSURE",
        "SHOW_WHERE",
        "POINT_OUT",
        "LOOK",
        "VERIFY",
    }
    | {"TELL_ME", "COME_TO_TELL", "LOOK_INSIDE", "REVOKE", "IDIOM", "HELPS_BODY", "USE"}
)
_HANDLES = frozenset({"PICK", "PICK_UP", "FETCH", "BRING", "CARRY", "GIVE", "RETURN"})
_GOALS = frozenset({"TO", "INTO", "ONTO"})
_WAVE = frozenset({"WAVE"})
_HOLDS = frozenset({"PUT", "PUT_IN", "PUT_DOWN", "MOVE_THING", "DROP", "PICK", "PICK_UP"})
_STANDS_FOR = frozenset({"ONE", "ONES"})
_OPEN_OR_CLOSED = frozenset({"OPENED", "CLOSED"})
_UNITS = frozenset({"LENGTH", "TIME", "ANGLE"})
_ROOM = frozenset({"ROOM"})
_HAND = frozenset({"HAND"})
_LEFT_RIGHT = frozenset({"LEFT_RIGHT"})


def is_harmless(reason: Reason) -> bool:
    """Whether a reason may be passed over."""
    return not (
        is_more_than_a_reason(reason)
        or _counts(reason)
        or tells_apart(reason)
        or tells_where(reason)
        or tells_for_whom(reason)
        or is_leaned_on(reason)
    )


def is_more_than_a_reason(reason: Reason) -> bool:
    """Whether it orders, wishes, joins, denies or harms, or says what follows from "open" and "closed"."""
    return (
        has_signs(reason)
        or _tells_how(reason)
        or any(f" {words} " in reason.said for words in words_of("in_danger"))
        or means_harm(reason)
        or reason.texts[-1] in words_of("denying")
        or _joins_more(reason)
        or _orders(reason)
        or _wishes_something(reason)
        or _is_open_or_closed(reason)
    )


def has_signs(reason: Reason) -> bool:
    """Whether it holds what nobody says: markup, paths, commands of a shell."""
    return not all(_SPOKEN.fullmatch(text) for text in reason.texts)


def _tells_how(reason: Reason) -> bool:
    """Whether it says what is done or left out meanwhile: "without checking for collisions"."""
    said = reason.said
    return any(re.search(rf" {word} \w+ing ", said) for word in words_of("leaving_out"))


def means_harm(reason: Reason) -> bool:
    """Whether it is said to be done for ill, or something dangerous is handled."""
    said = reason.said
    for idiom in words_of("idioms"):
        said = said.replace(f" {idiom} ", " ")
    if any(f" {word} " in said for word in words_of("ill_meant")):
        return True
    handles = any(
        reason.is_about(index, _HANDLES | _HOLDS) and not reason.is_about(index, _HAND)
        for index in reason.elsewhere
    )
    gestures = not handles and any(reason.is_about(index, _WAVE) for index in reason.elsewhere)
    places = reason.elsewhere if gestures else range(len(reason.pieces))
    return any(is_hazard(reading.meaning) for index in places for reading in _nouns_at(reason, index))


def _nouns_at(reason: Reason, index: int) -> list[Reading]:
    texts = [piece.text for piece in reason.pieces]
    found = reason.vocabulary.matches(texts, index)
    return [reading for _, reading in found if reading.word_class in THINGS]


def _joins_more(reason: Reason) -> bool:
    """Whether something is joined to the clause, or it depends on something."""
    if reason.has("joins") or any(piece.quoted for piece in reason.pieces[reason.start : reason.end]):
        return True
    texts = reason.texts
    for index, word in enumerate(texts):
        if word in words_of("and"):
            behind = texts[index + 1 :]
            is_clause = behind and not words_of("finite").isdisjoint(behind)
            if not is_clause or not words_of("describing").isdisjoint(behind):
                return True
    return False


def _orders(reason: Reason) -> bool:
    """Whether something in it may be an order, or is said of the one who is told: "so you can open it"."""
    if _tells_the_robot(reason):
        return True
    return any(_may_order(reason, index) for index in reason.places if not _belongs_before(reason, index))


def _belongs_before(reason: Reason, index: int) -> bool:
    """Whether what stands before a word makes it no order: "I can open it", "the open door"."""
    if index == reason.start:
        return False
    before = reason.pieces[index - 1].text
    return (
        before in words_of("before_verbs")
        or before.endswith("ly")
        or (index - 1 <= reason.start + 1 and reason.is_about(index - 1, _PEOPLE))
        or reason.is_about(index - 1, _ARTICLES | TELLS_APART)
    )


def _may_order(reason: Reason, index: int) -> bool:
    """Whether a command may begin at a place."""
    for length, reading in reason.readings(index):
        verb = is_verb(reading.word_class) or reading.word_class in _SKILLS_NOT | _MORE_VERBS
        alone = length == 1 and reason.pieces[index].text in words_of("no_orders")
        if (
            verb
            and not alone
            and reading.word_class != "WANT"
            and not reading.meaning.endswith((":ing", ":ed"))
        ):
            return True
    return False


def _tells_the_robot(reason: Reason) -> bool:
    """Whether it says what this robot does or is to do."""
    texts = reason.texts
    for index, word in enumerate(texts):
        if word not in words_of("you") or word == "your":
            continue
        before = texts[index - 1] if index else ""
        behind = texts[index + 1] if index + 1 < len(texts) else ""
        if behind == "to" or word != "you":
            return True
        subject = not before or before in words_of("you_begins")
        if subject and behind not in words_of("you_may") | words_of("you_may_not"):
            return True
        if subject and behind == "do" and texts[index + 2 : index + 3] != ["not"]:
            return True
    return False


def _counts(reason: Reason) -> bool:
    """Whether it says how many, which the command may leave open."""
    return any(
        reason.pieces[index].is_number
        or (reason.is_about(index, _NUMBERS) and reason.pieces[index].text != "one")
        for index in reason.places
    )


def tells_apart(reason: Reason, *, may_repeat: bool = False) -> bool:
    """Whether it says which thing or which hand is meant, which the command may leave open.

    Args:
        reason: The clause.
        may_repeat: Whether it may say again what the command says: "my red cup is gone, find the red cup".
    """
    elsewhere = {meaning for index in reason.elsewhere for meaning in meanings_at(reason, index)}
    for index in reason.places:
        if not reason.is_about(index, TELLS_APART):
            continue
        following = index + 1
        alone = following == reason.end or not reason.is_about(following, NOUNS | TELLS_APART)
        if alone and reason.pieces[index - 1].text == "the":
            return True  # "because it is the biggest"
        if following == reason.end:
            continue
        same = not elsewhere.isdisjoint(meanings_at(reason, following))
        same = same and not (may_repeat and _said_again(reason, index))
        if reason.is_about(following, _STANDS_FOR) or same:
            return True
        if reason.is_about(following, _HAND) and not any(
            reason.is_about(one, _LEFT_RIGHT) for one in reason.elsewhere
        ):
            return True
    return False


def _said_again(reason: Reason, index: int) -> bool:
    """Whether the command tells the thing apart by the same word and no other."""
    said = [piece.text for piece in reason.pieces]
    elsewhere = reason.elsewhere
    return any(
        said[one : one + 2] == said[index : index + 2] and one + 1 in elsewhere
        for one in elsewhere
        if not reason.is_about(one - 1, TELLS_APART)
    )


def _wishes_something(reason: Reason) -> bool:
    return any(_wishes(reason, index) and _is_wanted(reason, index + 1) for index in reason.places)


def _wishes(reason: Reason, index: int) -> bool:
    """Whether something is wished at a place; what "is like ice" is not."""
    compared = index > reason.start and reason.pieces[index - 1].text in words_of("be")
    return reason.pieces[index].text in words_of("wants") and not compared


def meanings_at(reason: Reason, index: int) -> set[str]:
    """Canonical names of the things that may be named at a place."""
    return {reading.meaning for reading in _nouns_at(reason, index)}


def _is_wanted(reason: Reason, index: int) -> bool:
    """Whether a thing follows, with what may stand before it: "I want the red cup"."""
    skipped = _ARTICLES | TELLS_APART | _NUMBERS | {"MANY", "QUALITY"}
    while index < reason.end and reason.is_about(index, skipped) and not reason.is_about(index, THINGS):
        index += 1
    return index < reason.end and reason.is_about(index, THINGS | {"THING", "THINGS", "ONES"})


def tells_where(reason: Reason) -> bool:
    """Whether it says where the thing or person is or goes that the command is about: "it is on the desk"."""
    shared = {meaning for index in reason.elsewhere for meaning in meanings_at(reason, index)}
    repeated = any(not shared.isdisjoint(meanings_at(reason, index)) for index in reason.places)
    people = {reason.pieces[index].text for index in reason.elsewhere if reason.is_about(index, SOMEBODY)}
    repeated = repeated or any(
        reason.is_about(index, SOMEBODY) and reason.pieces[index].text in people for index in reason.places
    )
    if not repeated and not _says_it(reason, shared):
        return False
    return any(is_place(reason, index) for index in reason.places)


def _says_it(reason: Reason, shared: AbstractSet[str]) -> bool:
    """Whether something stands for the thing; what "that high", "this morning" and "this pan" do not."""
    return any(
        reason.pieces[index].text in words_of("pronouns")
        and not (
            reason.pieces[index].text in words_of("so_much")
            and index + 1 < reason.end
            and _is_pointed_at(reason, index + 1, shared)
        )
        for index in reason.places
    )


def _is_pointed_at(reason: Reason, index: int, shared: AbstractSet[str]) -> bool:
    """Whether what follows "this" is a degree, a time, or a thing that the command does not name."""
    if reason.pieces[index].text in words_of("degrees"):
        return True
    meanings = meanings_at(reason, index)
    return bool(meanings) and meanings.isdisjoint(shared)


def _is_open_or_closed(reason: Reason) -> bool:
    """Whether it says that something is open or closed, which has to go with what is done to it."""
    return any(reason.is_about(index, _OPEN_OR_CLOSED) for index in reason.places)


def is_place(reason: Reason, index: int) -> bool:
    """Whether it is told at a place where something is, or for whom."""
    word = reason.pieces[index].text
    if word in words_of("somewhere"):
        return index > reason.start and reason.pieces[index - 1].text in words_of("be")
    lengths = [length for length, one in reason.readings(index) if one.word_class in _PLACING]
    if word == "for":
        lengths.append(1)
    if not lengths or any(one.word_class == "STATE" for _, one in reason.readings(index)):
        return False
    named = index + max(lengths)
    return named < reason.end and reason.is_about(named, _ARTICLES | NOUNS | {"ME", "THIS", "HIM", "THEM"})


def tells_for_whom(reason: Reason) -> bool:
    """Whether it names who gets the thing, which the command leaves out: "bring it because Ana needs it"."""
    if reason.has("pronouns") and any(reason.is_about(index, OWNERS) for index in reason.places):
        return True
    rooms = any(reason.is_about(index, _ROOM) for index in reason.places)
    somebody = reason.has("third_person") or reason.names_somebody or rooms
    if any(_is_goal(reason, index) for index in reason.elsewhere):
        return False
    if reason.has("wants") and not {"it", "them"}.isdisjoint(reason.texts):
        return True  # "pick it up because I need it": is it to be brought?
    return somebody and (
        reason.has("wants") or any(reason.is_about(index, _HANDLES) for index in reason.elsewhere)
    )


def _is_goal(reason: Reason, index: int) -> bool:
    """Whether the command says at a place who gets the thing, or where it goes."""
    following = index + 1
    goes = reason.is_about(index, _GOALS) and following < len(reason.pieces)
    return reason.is_about(index, _RECEIVERS) or (goes and reason.is_about(following, _ARTICLES | NOUNS))


def leans(reason: Reason, index: int) -> bool:
    """Whether a word may stand for something that was named; the one of "one metre" may not."""
    following = index + 1
    counts = following < len(reason.pieces) and reason.is_about(following, _UNITS)
    return reason.pieces[index].text in words_of("references") and not counts


def is_leaned_on(reason: Reason) -> bool:
    """Whether "it" or the like behind it may stand for what it names."""
    if not any(leans(reason, index) for index in range(reason.end, len(reason.pieces))):
        return False
    known = reason.vocabulary.single_words
    return any(
        reason.is_about(index, NOUNS | _ARTICLES) or reason.pieces[index].text not in known
        for index in reason.places
    )


def does_something(reason: Reason) -> bool:
    """Whether a task of this robot is named in the clause."""
    return any(
        is_verb(reading.word_class) and reading.word_class != "WANT"
        for index in reason.places
        for _, reading in reason.readings(index)
    )


def holds_something(reason: Reason) -> bool:
    """Whether the command holds something or puts it down, so that how it is to be held may be told."""
    return any(reason.is_about(index, _HOLDS) for index in reason.elsewhere)

"""What a remark may tell that the command leaves open: which thing, how many, where, whom it means.

"Take the cup, it is chipped" may tell which cup, "my cup is dirty, so pick it up" what is to be picked up.
"""

from __future__ import annotations

import enum
import itertools
from collections.abc import Set as AbstractSet

from executive.language.motives.reason import BEINGS, NOUNS, OWNERS, TELLS_APART, Reason, words_of
from executive.language.motives.reason_guard import (
    is_leaned_on,
    is_place,
    leans,
    meanings_at,
    tells_apart,
    tells_for_whom,
    tells_where,
)
from executive.language.resolving.genders import may_be_called

_SOMETIMES_APART = frozenset({"SIZE", "COMPARED"})
_NOT_NAMED = frozenset({"PERSON", "PEOPLE"})
_SEVERAL = frozenset({"KINDS", "PEOPLE", "THEM", "PAIR", "ANIMALS", "FURNITURES", "CONTAINERS", "DOORS"})
_PLACES = frozenset({"FURNITURE", "CONTAINER", "ROOM", "KIND", "DOOR"})
_SUBSTANCE = frozenset({"SUBSTANCE"})
_HIM = frozenset({"HIM"})
_NAME = frozenset({"NAME"})
_MEASURES = frozenset({"LENGTH", "ANGLE"})
_NUMBERS = frozenset({"AMOUNT", "TENS"})
_WHOLE_COUNTS = frozenset({"BOTH", "AMOUNT", "TENS"})
_TIME = frozenset({"TIME"})
_WAIT = frozenset({"WAIT"})
MOVES = frozenset({"MOVE", "TURN", "BACK_UP", "A_TURN", "BRIDGE"})
"""Word classes of motions that are told by how far or how long."""

_LASTING = MOVES | _WAIT
_ENDS = NOUNS | {"ME", "HIM", "HERE", "THERE", "HALF", "IT", "THEM", "COME", "GO_HOME", "ARTICLE"}
_SPEAKS = frozenset({"SAY", "TELL", "TELL_ME", "ASK"})
_LOOK_AT = frozenset({"LOOK_AT"})


class Place(enum.Enum):
    """Where a remark stands.

    Attributes:
        LED: Before a command that "so" or the like leads to.
        BEFORE: Right before a command.
        BEFORE_COLON: Before a command, with a colon between, which may be reported.
        SENTENCE_BEFORE: A sentence of its own.
        BEHIND: Behind a command.
    """

    LED = enum.auto()
    BEFORE = enum.auto()
    BEFORE_COLON = enum.auto()
    SENTENCE_BEFORE = enum.auto()
    BEHIND = enum.auto()


def verbs() -> frozenset[str]:
    """Verbs that make a statement of what stands before them."""
    return words_of("finite") | words_of("verbs")


def subject_of(remark: Reason) -> int:
    """Where its subject begins, behind "today", "in my days" and the like."""
    texts = remark.texts
    lengths = (length for length in (3, 2, 1) if " ".join(texts[:length]) in words_of("fronting"))
    skipped = next(lengths, 0)
    return remark.start + (skipped if skipped + 1 < len(texts) else 0)


def describes(remark: Reason, place: Place) -> bool:
    """Whether it says of the thing or person of the command what tells it from others."""
    if remark.has("one") or tells_apart(remark, may_repeat=True) or _is_about_the_same(remark):
        return True
    if place is Place.BEHIND and (remark.has("not_behind") or remark.has("parts") or may_be_spoken(remark)):
        return True
    if _leaves_open_how_far(remark):
        return True
    first = remark.pieces[subject_of(remark)].text
    about_it = first in words_of("about_it")
    if about_it and (place is not Place.LED or _handles(remark)) and not remark.has("impersonal"):
        return True
    if about_it and place is Place.BEHIND:
        return True
    if first in words_of("about_others") and not _is_known_who(remark, first):
        return True
    thing = about_it and not remark.has("impersonal")
    loose = thing or first in words_of("about_others") or remark.has("wants")
    return any(_is_told_apart(remark, index, loose) for index in remark.places)


def _leaves_open_how_far(remark: Reason) -> bool:
    """Whether the command is a motion without a measure, which the remark may tell: "I've drawn a line"."""
    others = remark.elsewhere
    moves = any(remark.is_about(index, MOVES) for index in others)
    return moves and not any(_is_number(remark, index) or remark.is_about(index, _ENDS) for index in others)


def _handles(remark: Reason) -> bool:
    """Whether the command names a thing that "it" may stand for: "it is chipped, so take the cup"."""
    return any(remark.is_about(index, NOUNS - BEINGS) for index in remark.elsewhere)


def _is_known_who(remark: Reason, first: str) -> bool:
    """Whether "he" or "they" tells nobody from others: the command names whom it means."""
    others = remark.elsewhere
    if any(remark.is_about(index, _NOT_NAMED) for index in others):
        return False
    if first.startswith("they"):
        return not any(remark.is_about(index, _SEVERAL) for index in others)
    names = {remark.pieces[index].text for index in others if remark.is_about(index, _NAME)}
    return bool(names) and _may_be_said_of(remark, names)


def is_of_whom_is_named(remark: Reason) -> bool:
    """Whether the command names one person by name, and whose or for whom it is."""
    others = remark.elsewhere
    named = {remark.pieces[index].text for index in others if remark.is_about(index, _NAME)}
    unnamed = any(remark.is_about(index, _NOT_NAMED | _HIM) for index in others)
    return len(named) == 1 and not unnamed and _may_be_said_of(remark, named)


def _may_be_said_of(remark: Reason, names: AbstractSet[str]) -> bool:
    """Whether "he" or "she" in a remark may be somebody of some names."""
    said = [pronoun for pronoun, sort in (("him", "masculine"), ("her", "feminine")) if remark.has(sort)]
    return all(any(may_be_called(pronoun, name) for name in names) for pronoun in said)


def may_be_spoken(remark: Reason) -> bool:
    """Whether it stands behind words to say without quotation marks, and may be some of them."""
    before = range(remark.start)
    speaks = any(remark.is_about(index, _SPEAKS) and not remark.is_about(index, _LOOK_AT) for index in before)
    return speaks and not any(remark.pieces[index].quoted for index in before)


def _handled(remark: Reason) -> set[str]:
    """Names of the things that the command is about."""
    return {meaning for index in remark.elsewhere for meaning in meanings_at(remark, index)}


def _is_about_the_same(remark: Reason) -> bool:
    """Whether it says something of the thing that is handled: "my cup has a star, so bring me the cup"."""
    handled = _handled(remark)
    first = subject_of(remark)
    return any(
        not handled.isdisjoint(meanings_at(remark, index))
        for index in range(first, min(first + 3, remark.end))
    )


def _is_told_apart(remark: Reason, index: int, loose: bool) -> bool:
    """Whether a word at a place may tell a thing from others: "it is blue", "I like red"."""
    if not remark.is_about(index, TELLS_APART):
        return False
    if not loose and remark.is_about(index, _SOMETIMES_APART):
        return False
    following = index + 1
    if following >= remark.end:
        return True
    known = remark.pieces[following].text in remark.vocabulary.single_words
    return known and not remark.is_about(following, NOUNS | TELLS_APART)


def counts(remark: Reason, place: Place) -> bool:
    """Whether it says how many or how much of what the command leaves open."""
    if any(_is_measure(remark, index) for index in remark.places):
        return True
    numbers = [index for index in remark.places if _is_number(remark, index)]
    return any(not _is_beside_the_point(remark, index, place) for index in numbers)


def _is_measure(remark: Reason, index: int) -> bool:
    """Whether it is a unit; "my feet" are none."""
    owned = index > remark.start and remark.pieces[index - 1].text in words_of("possessive")
    return remark.is_about(index, _MEASURES) and not owned


def _is_number(remark: Reason, index: int) -> bool:
    piece = remark.pieces[index]
    return piece.is_number or (remark.is_about(index, _NUMBERS) and piece.text != "one")


def _is_beside_the_point(remark: Reason, index: int, place: Place) -> bool:
    """Whether it counts minutes, or guests where the things are counted: "both bowls, I cook for six"."""
    others, following = remark.elsewhere, index + 1
    counted = any(remark.pieces[one].is_number or remark.is_about(one, _WHOLE_COUNTS) for one in others)
    if following < remark.end and remark.is_about(following, _TIME):
        goal = any(remark.is_about(one, NOUNS) for one in others)
        lasts = any(remark.is_about(one, _WAIT if goal else _LASTING) for one in others)
        return not (counted or lasts or place is Place.BEHIND)
    guests = following >= remark.end or remark.pieces[following].text in words_of("counted_for")
    return counted and guests and remark.pieces[index - 1].text in words_of("for_it")


def tells_where_or_for_whom(remark: Reason) -> bool:
    """Whether it says where something is or for whom: "I'm on the sofa", "my cup is in the kitchen"."""
    if tells_where(remark) or tells_for_whom(remark):
        return True
    first = subject_of(remark)
    about = words_of("about_me") | words_of("about_others")
    known = any(remark.is_about(index, NOUNS) for index in range(first, min(first + 3, remark.end)))
    is_somebody = remark.pieces[first].text in about or remark.is_about(first, _NAME)
    if is_somebody and remark.has("elsewhere"):
        return True
    if not is_somebody and not known:
        return False
    return remark.has("placed") and any(
        is_place(remark, index)
        and any(remark.is_about(one, _PLACES) for one in range(index + 1, min(index + 4, remark.end)))
        for index in remark.places
    )


def names_more(remark: Reason, place: Place) -> bool:
    """Whether something is named that may be meant too; before "so" things may be."""
    if place is Place.LED:
        return False
    handled, subject = _handled(remark), subject_of(remark)
    with_people = any(remark.is_about(index, BEINGS | _HIM) for index in remark.elsewhere)
    for index in remark.places:
        if not remark.is_about(index, NOUNS) or index == whom_it_names(remark) or _is_doing(remark, index):
            continue
        meanings = meanings_at(remark, index)
        if place is Place.BEFORE and meanings and handled.issuperset(meanings):
            continue
        if handled.isdisjoint(meanings) and _only_happens(remark, index, subject):
            continue
        is_person = index <= subject + 1 and remark.is_about(index, BEINGS)
        if place is Place.BEHIND or not is_person or with_people:
            return True
    return False


def _is_doing(remark: Reason, index: int) -> bool:
    """Whether it is a verb there: "I'm washing up"."""
    is_form = index > remark.start and remark.pieces[index - 1].text in words_of("i_am")
    return is_form and remark.pieces[index].text.endswith("ing")


def _only_happens(remark: Reason, index: int, subject: int) -> bool:
    """Whether something is said of a thing that is not to be handled: "the varnish is dry"."""
    following = [piece.text for piece in remark.pieces[index + 1 : remark.end]]
    begins = index == subject + 1 and bool(following) and following[0] in words_of("just_is")
    if remark.is_about(index, _SUBSTANCE):
        return begins or (remark.pieces[index - 1].text in words_of("of_which") and not remark.has("wants"))
    goes_on = len(following) == 2 and following[1].endswith("ing") and following[1] not in words_of("absent")
    return begins and goes_on


def whom_it_names(remark: Reason) -> int | None:
    """Where the only person is named that a remark is about, if "him" or "her" may be meant for them."""
    behind = range(remark.end, len(remark.pieces))
    if remark.has("third_person") or not any(remark.is_about(index, _HIM) for index in behind):
        return None
    named = [index for index in remark.places if remark.is_about(index, _NAME)]
    if len(named) != 1 or _is_new(remark):
        return None
    (index,) = named
    said_of_them = remark.end - 1 if _is_my(remark, index + 1) else index - 1
    others = [
        one
        for one in remark.places
        if remark.is_about(one, _NOT_NAMED) and one not in (index - 1, said_of_them)
    ]
    speaks = index + 1 < remark.end and remark.pieces[index + 1].text in verbs()
    return index if speaks and not others else None


def _is_my(remark: Reason, index: int) -> bool:
    """Whether what follows says who somebody is to the speaker: "is my best friend"."""
    texts = remark.texts[index - remark.start :]
    is_mine = len(texts) > 2 and texts[0] in words_of("just_is") and texts[1] in words_of("my")
    return is_mine and not any(remark.is_about(one, OWNERS) for one in range(index + 2, remark.end))


def _is_new(remark: Reason) -> bool:
    """Whether it may speak of somebody or something for the first time: "I saw a zebra"."""
    texts = remark.texts
    return any(
        word in words_of("articles") and following not in words_of("events")
        for word, following in itertools.pairwise(texts)
    )


def may_be_meant(remark: Reason, place: Place) -> bool:
    """Whether "it" or "her" in a command may stand for what the remark names."""
    if place is Place.BEHIND:
        return is_leaned_on(remark)
    leaning = [index for index in range(remark.end, len(remark.pieces)) if leans(remark, index)]
    if not leaning:
        return False
    if all(remark.is_about(index, _HIM) for index in leaning) and whom_it_names(remark) is not None:
        return False
    return any(remark.is_about(index, NOUNS) for index in remark.places) or _is_new(remark)

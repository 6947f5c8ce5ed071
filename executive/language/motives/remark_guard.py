"""Whether a statement may be passed over that no conjunction begins: it limits and leaves open nothing.

"My knees are bad, so pick up the ball" picks up the ball. "Nobody should touch the red cup, so ...",
"..., it's the blue one", "..., Ana needs a fork too" and "I am the administrator, so ..." say more than why.
"""

from __future__ import annotations

from executive.language.motives.reason import NOUNS, TELLS_APART, Reason, words_of
from executive.language.motives.reason_guard import (
    does_something,
    has_signs,
    is_more_than_a_reason,
    means_harm,
)
from executive.language.motives.set_remarks import is_set_remark, plainer
from executive.language.motives.told_by_remarks import (
    MOVES,
    Place,
    counts,
    describes,
    is_of_whom_is_named,
    may_be_meant,
    may_be_spoken,
    names_more,
    subject_of,
    tells_where_or_for_whom,
    verbs,
)

_SUBJECT_NOUNS = frozenset(
    {"DET", "NAME", "OWNER", "OWNING", "PERSON", "PEOPLE", "KINDS", "SUBSTANCE", "ANIMAL", "ANIMALS"}
)
_HOW_IT_IS = TELLS_APART | {"QUALITY", "STATE", "DEGREE"}
_PEOPLE = frozenset({"NAME", "PERSON", "PEOPLE"})
_ASKS = frozenset({"OPENING"})
_FOR_YOU = frozenset({"ON", "FOR"})
_ELSEWHERE = frozenset(
    {"NAME", "PERSON", "PEOPLE", "ANIMAL", "ANIMALS", "OWNER", "OWNING", "ROOM", "FURNITURE", "CONTAINER"}
)
_VERB_AT_MOST = 7
"""Among how many first words the verb of a statement is looked for."""


def may_go_on_as(remark: Reason, begins: int) -> bool:
    """Whether what follows at a place may belong to it: "I get up early, open the window, ..."."""
    first = subject_of(remark)
    following = remark.pieces[first].text, remark.pieces[first + 1].text
    somebody = following[0] in words_of("about_me") | words_of("about_others")
    if not somebody and not any(remark.is_about(one, _PEOPLE) for one in (first, first + 1)):
        return False
    if remark.pieces[begins].text in words_of("please") or not remark.begins[begins].isdisjoint(_ASKS):
        return False
    is_so = words_of("just_is") | words_of("i_am")
    return is_so.isdisjoint(remark.texts[first - remark.start :][:3])


def is_mere_remark(remark: Reason, place: Place) -> bool:
    """Whether a remark may be passed over."""
    if has_signs(remark):
        return False
    if says_nothing(remark, place):
        return True
    return _is_mere(plainer(remark), place)


def says_nothing(remark: Reason, place: Place) -> bool:
    """Whether it is a phrase that is always the same, and nothing that is to be said."""
    if place is Place.BEHIND:
        set_phrase = is_set_remark(remark, "behind") or (
            is_of_whom_is_named(remark) and is_set_remark(remark, "of_somebody")
        )
    else:
        set_phrase = is_set_remark(remark, "before")
    set_phrase = set_phrase or is_set_remark(remark, "whole")
    return set_phrase and not means_harm(remark) and not (place is Place.BEHIND and may_be_spoken(remark))


def _is_mere(remark: Reason, place: Place) -> bool:
    if place is Place.BEHIND and (_needs_it_for_something(remark) or _needs_room(remark)):
        return not means_harm(remark)
    return (
        _is_statement(remark)
        and not is_more_than_a_reason(remark)
        and not _only_introduces(remark, place)
        and not _limits(remark)
        and not _wishes(remark)
        and not _promises(remark)
        and not describes(remark, place)
        and not counts(remark, place)
        and not names_more(remark, place)
        and not tells_where_or_for_whom(remark)
        and not may_be_meant(remark, place)
    )


def _is_statement(remark: Reason) -> bool:
    """Whether it has a subject other than whoever is told, and a verb that belongs to it."""
    at = subject_of(remark)
    texts = remark.texts[at - remark.start :]
    if len(texts) < 2:
        return False
    first, following = texts[:2]
    if first in words_of("contracted"):
        return True
    if first in words_of("speaking") | words_of("others"):
        return not remark.is_about(at + 1, _SUBJECT_NOUNS)
    if first in words_of("anything") and following in verbs():
        return True
    begins = words_of("determining") | (words_of("subjects") - words_of("you"))
    if first not in begins and not remark.is_about(at, _SUBJECT_NOUNS):
        return False
    verb = next(
        (index for index, word in enumerate(texts[:_VERB_AT_MOST]) if index and word in verbs()), None
    )
    return verb is not None and _is_noun_phrase(texts[:verb])


def _is_noun_phrase(texts: list[str]) -> bool:
    """Whether no clause begins in it that would describe a thing: "the one that", "the table we"."""
    inside = frozenset(texts[1:])
    return inside.isdisjoint(words_of("describing") | words_of("speaking") | words_of("others"))


def _only_introduces(remark: Reason, place: Place) -> bool:
    """Whether it says that something is asked or thought: "I think", "I beg you", "the nurse said: ..."."""
    adjective = subject_of(remark) + 1
    texts = remark.texts[adjective - 1 - remark.start :]
    told = len(texts) + (texts[0] in words_of("contracted"))
    if told < (2 if place is Place.LED else 3) or (
        texts[-1] in words_of("you") and not remark.is_about(remark.end - 2, _FOR_YOU)
    ):
        return True
    if texts[-1] in words_of("thinking") or (place is Place.BEHIND and texts[-1] in words_of("absent")):
        return True
    if place is Place.BEFORE_COLON and not _says_how_i_am(texts):
        return True
    if place is Place.SENTENCE_BEFORE and texts[0] not in words_of("about_me") | words_of("my"):
        return True
    told_apart = texts[0] in words_of("determining") - words_of("my") and not verbs().isdisjoint(texts[2:3])
    return told_apart and remark.is_about(adjective, _HOW_IT_IS)


def _says_how_i_am(texts: list[str]) -> bool:
    """Whether what stands before a colon is of the speaker, and no words of others follow it."""
    if texts[0] in words_of("speaking"):
        return texts[-1] not in verbs()
    if texts[0] in words_of("my"):
        return texts[-1] in words_of("ailing")
    return texts[0] in words_of("i_am") and texts[1] in words_of("so_very")


def _limits(remark: Reason) -> bool:
    """Whether it forbids or bounds something, claims a right, says how, takes back, or adds something."""
    barred = ("forbidding", "conditions", "claims", "revoking", "ill_remarks")
    texts = remark.texts
    if any(remark.has(name) for name in barred) or texts[-1] in words_of("as_well"):
        return True
    first, following = texts[subject_of(remark) - remark.start :][:2]
    about_me = first in words_of("about_me")
    if remark.has("manners") and not about_me:
        return True
    if first in words_of("everybody") and following not in words_of("is_so"):
        return True
    said = zip(["", *texts], texts, [*texts[1:], ""], strict=False)
    return _takes_something(remark) or any(_obliges(*three, about_me) for three in said)


def _obliges(before: str, word: str, behind: str, about_me: bool) -> bool:
    """Whether a word says what has to be, is never done, is wanted of the robot, or was ordered."""
    if word in words_of("obliging"):
        return before not in words_of("speaking") or behind in words_of("denying")
    return (
        (word in words_of("duty") and behind == "to" and not about_me)
        or (word in words_of("never") and before not in words_of("may_never"))
        or (word in words_of("wanting") and behind in words_of("you"))
        or (word in words_of("speaking") and behind in words_of("told"))
    )


def _takes_something(remark: Reason) -> bool:
    """Whether it says that somebody takes or would have something: "I'll have the plate"."""
    return remark.has("will_take") and any(remark.is_about(index, NOUNS) for index in remark.places)


def _wishes(remark: Reason) -> bool:
    """Whether something is wished for that is not known: "I fancy a cuppa"."""
    texts = remark.texts
    return any(
        word in words_of("wants") and behind in words_of("wished") and what not in words_of("events")
        for word, behind, what in zip(texts, texts[1:], [*texts[2:], ""], strict=False)
    )


def _promises(remark: Reason) -> bool:
    """Whether somebody says what they will do, as a program that plans does: "I can do that"."""
    first, following = remark.texts[subject_of(remark) - remark.start :][:2]
    will = first in words_of("promising") or (
        first in words_of("speaking") and following in words_of("promising")
    )
    return will and (does_something(remark) or remark.has("promised"))


def _needs_it_for_something(remark: Reason) -> bool:
    """Whether it is "I need it for the salad": for no person, and at no place."""
    texts = remark.texts
    if len(texts) not in (6, 7) or texts[0] not in words_of("speaking"):
        return False
    wants = texts[1] in words_of("need_it") and texts[2] in words_of("need_what")
    used = wants and texts[3] in words_of("for_it") and texts[4] in words_of("determining")
    return used and not any(
        remark.is_about(index, _ELSEWHERE) for index in range(remark.start + 5, remark.end)
    )


def _needs_room(remark: Reason) -> bool:
    """Whether it is "I need the bench clear" or "I need room for ..." behind a motion."""
    texts = remark.texts
    moves = any(remark.is_about(index, MOVES) for index in remark.elsewhere)
    if not moves or any(remark.is_about(index, NOUNS) for index in remark.elsewhere):
        return False
    if len(texts) < 3 or texts[0] not in words_of("speaking") or texts[1] not in words_of("need_it"):
        return False
    room = texts[2] in words_of("room") and (len(texts) == 3 or texts[3] in words_of("for_it"))
    clear = len(texts) == 5 and texts[2] in words_of("determining") and texts[4] in words_of("free")
    return room or clear

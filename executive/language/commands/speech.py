"""Words to say, and to whom: what is in quotation marks, or what nobody could take for anything else.

Any word can be said, so nothing in free words shows where they end ("say hello before going home"). Without
quotation marks only greetings and whole statements are taken; everything else is asked about.
"""

from __future__ import annotations

import itertools
import re

from executive.language.commands import meanings
from executive.language.phrases.arranging import ME, clause, trouble, unfit
from executive.language.phrases.lists import Joined
from executive.language.phrases.parts import Parts, senses, words
from executive.language.phrases.values import Clause, Nominal, draft
from executive.language.resolve.discourse import is_them
from executive.language.resolve.kinds import listed
from executive.language.text.lattice import TIME

UNQUOTED = "which words shall be said? put them in quotation marks"

_UNSPOKEN = re.compile(r"[^\w\s,.;:!?'-]")
"""Characters that nobody says."""

_SENTENCES = re.compile(r"[.;!?]\s")
"""The end of a sentence after which another begins, which may be said to whoever is commanded."""


def _is_greeting(text: str) -> bool:
    """Whether every word is a greeting, a number, or, after a greeting, a name."""
    known = listed("greetings")
    first, *rest = re.findall(r"[\w']+", text) or [""]
    begins = (first.lower() in known or first.isdecimal()) and not listed("joins") >= {text.lower()}
    return begins and all(one.lower() in known or one.isdecimal() or one[0].isupper() for one in rest)


def _is_stated(lowered: str) -> bool:
    """Whether there is a subject and a verb: somebody is told something."""
    said = re.findall(r"[\w']+", lowered.partition(",")[0])
    if not said or said[0] in listed("stated") or not listed("states").isdisjoint(said[1:]):
        return bool(said)
    return any(
        one.endswith("'s") and after in listed("states_of_things") for one, after in itertools.pairwise(said)
    )


def _is_told(lowered: str) -> bool:
    """Whether it begins with a subject and any verb, as behind "that": "the doctor comes at five"."""
    first, *rest = re.findall(r"[\w']+", lowered)
    verb = rest[first in listed("determiners") :][:1]
    ends = tuple(listed("verb_ends"))
    return any(one.endswith(ends) and not one.endswith("'s") for one in verb)


def _begins(lowered: str, phrases: str) -> bool:
    return any(re.match(rf"{re.escape(one)}(?!['\w])", lowered) for one in listed(phrases))


def _speech(parts: Parts) -> str:
    word = words(parts, "QUOTED", "TEXT")[-1]
    text = word.meaning.strip()
    if not text:
        raise unfit()
    if word.word_class == "QUOTED":
        return text
    lowered = text.lower()
    that = bool(words(parts, "THAT")) or "that" in senses(parts, "SAY")
    greeting, stated = _is_greeting(text), _is_stated(lowered)
    ends = lowered.rstrip(".,!? ").split()[-1:]
    if '"' in text or text.startswith("'") or not listed("ends_no_speech").isdisjoint(ends):
        raise unfit()
    to = not listed("to_whom").isdisjoint(lowered.split()) and not (stated and words(parts, "TELL"))
    if not that and (to or (_begins(lowered, "begins_no_speech") and not greeting)):
        raise unfit()
    if (
        _UNSPOKEN.search(text)
        or (_SENTENCES.search(text) and not greeting)
        or (word.said and not (greeting and word.said == TIME))
        or _is_around(lowered)
        or (not greeting and _begins(lowered, "begins_order"))
        or not (greeting or stated or (that and _is_told(lowered)))
    ):
        raise trouble(UNQUOTED, asks=True)
    return text


def _is_around(lowered: str) -> bool:
    """Whether some word may begin what is to be done around the saying, or another message."""
    return not listed("around").isdisjoint(re.findall(r"[\w']+", lowered))


def _people_told(parts: Parts) -> tuple[Nominal, ...] | None:
    """Several people who are told the same."""
    if any(part.commas for part in parts if isinstance(part, Joined)):
        return None  # after no more than a comma, who follows may be whom the words are about
    people = tuple(part for part in parts if isinstance(part, Nominal))
    named = all(one.is_person and one.is_single and not one.reference and one.sort != "me" for one in people)
    return people if named and len(set(people)) == len(people) > 1 else None


def _say(parts: Parts) -> Clause:
    """Words to nobody in particular, to somebody, or to each of several people, one after the other."""
    told = [person for part in parts if isinstance(part, tuple) for person in part]
    told += [part for part in parts if isinstance(part, Nominal)]
    tells, that = senses(parts, "TELL"), senses(parts, "THAT")
    if ("let" in tells) != ("know" in that):
        raise unfit()  # "let Ben have the cup" is no message
    for person in told:
        if (tells and person.sort == "me") or not (is_them(person) or person.is_person):
            raise unfit()
        if person.plural and not person.reference:
            raise trouble("several people at once: name one, or say it to everyone", person.kind)
    text = _speech(parts)
    said = [draft("say", text=text, person=person) for person in told] or [draft("say", text=text)]
    return clause(parts, [(one,) for one in said])


def _say_done(parts: Parts) -> Clause:
    """Tell me when you are finished: said by the robot, of itself."""
    (said,) = words(parts, "SAY_DONE", "TELL_DONE")
    person = ME if said.word_class == "TELL_DONE" else None
    return clause(parts, [(draft("say", text=said.meaning, person=person, reports="when"),)])


MEANINGS = meanings(
    {
        "say": _say,
        "say_done": _say_done,
        "people_told": _people_told,
    }
)

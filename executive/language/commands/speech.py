"""Words to say, and to whom: what is in quotation marks, or what nobody could take for anything else.

Any word can be said, so nothing in free words shows where they end or that they are meant literally ("say
hello before going home", "speak louder", "say the magic word"). Without quotation marks only greetings and
whole statements are taken; everything else is asked about.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from executive.language.phrases.arranging import ME, TroubleError, clause, guarded, trouble, unfit
from executive.language.phrases.lists import Joined
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Meaning, Nominal, draft
from executive.language.resolve.discourse import is_them
from executive.language.text.lattice import TIME
from executive.language.text.word import Word

UNQUOTED = "which words shall be said? put them in quotation marks"

_NO_SPEECH = """
and or & plus as\\swell\\sas together\\swith along\\swith
to for from with of by into at her his their its(?!') our not that your my you what whatever how why who whom
where when whether if which something anything nothing about it(?!'s|\\sis|\\swas) them so a an
in the\\stime the\\sdate the\\sday
the\\sweather the\\struth the\\snames? the\\snumber the\\scolou?r the\\slocation the\\sposition the\\sway
the\\snews the\\sanswer the\\sresult yes\\sor\\sno louder softer slower faster quieter up
"""
_IS_NO_SPEECH = re.compile(rf"(?:{'|'.join(_NO_SPEECH.split())})\b")
"""How free text begins that asks for something else than repeating these words."""

_STATED_OF_ONES_OWN = re.compile(
    r"(?:his|her|their|my|our|your) \w+(?: \w+)? (?:is|are|was|were|has|have|will|needs?)\b"
)
"""A statement of what belongs to somebody: "her tea is ready", but not "her name"."""

_LANGUAGES = "english|german|french|spanish|italian|chinese|japanese"
_SAID_HOW = re.compile(
    rf"\b(?:twice|again|\w+ times|loudly|softly|quietly|slowly|clearly|aloud|louder|in (?:{_LANGUAGES}))$"
)
_ATTACHED = re.compile(
    r"\b(?:before|after|when|whenever|while|until|till|if|once|unless|then|but|except|without|instead|using)\b"
)
"""Words that may begin what is to be done around the saying, instead of belonging to what is said."""

_UNTIL_WHEN = re.compile(
    r" (?:until|till) (?:\d{1,2}(?:[:.]\d\d)?(?: ?[ap]m)?|\w+ o'clock|half past \w+|noon|midnight|tomorrow"
    r"|one|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|\w+day)$"
)
"""How long something lasts that is told: nothing is said until then."""

_LOOPED = re.compile(
    r"(?:,\s*)?\b(?P<loop>(?:every|each) time|whenever|every \w+|until|repeatedly|forever)\b"
)
"""What is to be done again and again, behind what is said once: "hello every time somebody comes in"."""

_STATED = re.compile(
    r"\w[\w' ]*? (?:is|are|was|were|has|have|had|will|can|could|should|must|may|might|am|do|does|did|needs?"
    r"|love|want|said)\b|(?:i|we|they|he|she|it|that|there|here|what|let)'(?:s|re|m|ll|ve|d)\b"
    r"|\w[\w ]*'s (?:ready|done|here|served|waiting|late|coming|over|open|closed|on its way|gone)\b"
)
"""A subject and a verb: somebody is told something."""

_TOLD = re.compile(r"(?:(?:the|my|your|our|his|her|their) )?\w+ (?!s\b)\w+(?:s|ed)\b(?: |$)")
"""The same with any verb, after "that": "that the doctor comes at five"."""

_ORDERED = re.compile(
    r"(?:put|place|pick|take|grab|bring|fetch|get|give|hand|carry|move|open|close|shut|go|walk|turn|point|wave|find)\b"
)
"""How a command begins: "put the can on the shelf" states nothing, though "can" may be a verb."""

_AT_THE_END = frozenset({"when", "once", "as", "report", "completion"})
"""Words of what is to be said when something else is done."""

_THAT = re.compile(r"(?P<before>[\w', ]*?),? that (?=[\w' ]+)")
"""How words begin that hold a "that" of their own, or one that belongs to whom or how they are told."""

_THAT_TOO = re.compile(r"\b(?:and|but) (?:to )?\w+(?: and \w+)? that\b")
"""A second message for somebody else: "... and Ben that lunch is over"."""

_ANOTHER_TOO = re.compile(r"\band (?:to )?\w+(?: and \w+)? (?:too|as well|also|likewise|the same)$")
"""Somebody else who may be told it: "dinner is ready and Ben too"."""

_SPEAKERS = frozenset({"i", "we", "he", "she", "they", "you", "it", "there", "this"})
"""Who "think that" or "know that", in words to say."""

_UNSPOKEN = re.compile(r"[^\w\s,.;:!?'-]")
"""Characters that nobody says."""

_SENTENCES = re.compile(r"[.;!?]\s")
"""The end of a sentence after which another begins, which may be said to whoever is commanded."""

_GREETING_LINES = """
hello hi hey bye goodbye good morning afternoon evening night day thanks thank you so very much please sorry
yes no ok okay goodnight farewell welcome home back happy birthday new year merry christmas
congratulations cheers cheese bravo
well done great job nice see soon ready steady go stop help wow hooray and everyone everybody all there ladies
gentlemen friends robot world one two three four five six seven eight nine ten
"""
_GREETINGS = frozenset(_GREETING_LINES.split())
"""What is said as it stands, in any order."""


_ASKED_IN_PASSING = frozenset({"what's up", "how are you", "how do you do", "how's it going", "what's new"})
"""Greetings in the form of a question, which nobody answers."""


def _is_greeting(text: str) -> bool:
    """Whether every word is a greeting, a number, or, after a greeting, a name."""
    if text.lower().rstrip("?!., ") in _ASKED_IN_PASSING:
        return True
    said = re.findall(r"[\w']+", text)
    first, *rest = said or [""]
    lowered_words = {one.lower() for one in said}
    known = first.lower() in _GREETINGS or first.isdecimal()
    return (
        known
        and lowered_words != {"and"}
        and all(one.lower() in _GREETINGS or one.isdecimal() or one[0].isupper() for one in rest)
    )


def _speech(parts: Parts) -> str:
    word = words(parts, "QUOTED", "TEXT")[-1]
    text = word.meaning.strip()
    lowered = text.lower()
    if not text:
        raise unfit()
    if word.word_class == "QUOTED":
        return text
    if any(mark.meaning == ":" for mark in words(parts, "PAUSE")) and not (
        word.said or _UNSPOKEN.search(text) or "without" in lowered.split()
    ):
        return text
    that = bool(words(parts, "THAT")) or any(one.said.endswith(" that") for one in words(parts, "SAY"))
    if lowered in ("something", "anything"):
        raise trouble("what shall be said?", asks=True)
    if _SAID_HOW.search(lowered) or '"' in text or text.startswith("'"):
        raise unfit()
    greeting = _is_greeting(text)
    told_of = _IS_NO_SPEECH.match(lowered) and not _STATED_OF_ONES_OWN.match(lowered)
    is_told = bool(words(parts, "TELL")) and _STATED.match(lowered)  # "tell Ana I want to go out"
    if not that and ((" to " in lowered and not is_told) or (told_of and not greeting)):
        raise unfit()
    if that and lowered.startswith("you"):
        raise unfit()
    looped = _LOOPED.search(lowered)
    if looped is not None and not that and _is_greeting(text[: looped.start()]):
        raise trouble(f"a loop ({looped['loop']!r}) cannot be honoured; say each task once", looped["loop"])
    if _tells_whom(lowered, that=that):
        raise trouble(UNQUOTED, asks=True)
    if (
        _UNSPOKEN.search(text)
        or (_SENTENCES.search(text) and not greeting)
        or (word.said and not (greeting and word.said == TIME))
        or _ATTACHED.search(_UNTIL_WHEN.sub("", lowered) if that else lowered)
        or (not greeting and _ORDERED.match(lowered))
        or not (greeting or _STATED.match(lowered) or (that and _TOLD.match(lowered)))
    ):
        raise trouble(UNQUOTED, asks=True)
    return text


def _tells_whom(lowered: str, *, that: bool) -> bool:
    """Whether words before or after a "that" may say who is told, or how: "Ben and Maria that it is late"."""
    begins = None if that else _THAT.match(lowered)
    before = begins["before"] if begins is not None else ""
    told = bool(before) and before.split()[0] not in _SPEAKERS and not _STATED.match(f"{before} ")
    return told or bool(_THAT_TOO.search(lowered) or _ANOTHER_TOO.search(lowered))


def _words(parts: Parts) -> Word:
    word: Word = parts[0]
    return word


def _say(parts: Parts) -> Clause:
    return clause(parts, [(draft("say", text=_speech(parts)),)])


def _say_done(parts: Parts) -> Clause:
    """Tell me when you are finished: said by the robot, of itself."""
    (said,) = words(parts, "SAY_DONE")
    told = said.said.split()
    when = "when" if _AT_THE_END & set(told) else "that"
    done = draft("say", text=said.meaning, person=ME if "me" in told else None, reports=when)
    return clause(parts, [(done,)])


@dataclass(frozen=True, slots=True)
class _Told:
    """Several people who are told the same."""

    people: tuple[Nominal, ...]


def _people_told(parts: Parts) -> _Told | None:
    """Ana and Ben; after no more than a comma, who follows may be whom the words are about."""
    people = tuple(part for part in parts if isinstance(part, Nominal))
    named = all(one.is_person and one.is_single and not one.reference and one.sort != "me" for one in people)
    *_, last = (part for part in parts if isinstance(part, Joined))
    if not named or len(set(people)) < len(people) or last.commas or (words(parts, "BOTH") and people[2:]):
        return None
    return _Told(people)


def _say_to_each(parts: Parts) -> Clause:
    """Tell Ana and Ben that dinner is ready: each of them, one after the other."""
    (told,) = (part for part in parts if isinstance(part, _Told))
    each = tuple(part for part in parts if not isinstance(part, _Told))
    said = [_say_to((*each, person)) for person in told.people]
    return clause(parts, [bundle for one in said for bundle in one.bundles])


def _say_to(parts: Parts) -> Clause:
    person = next(part for part in parts if isinstance(part, Nominal))
    if not is_them(person) and not person.is_person:
        raise unfit()
    if person.plural and not person.reference:
        with contextlib.suppress(TroubleError):
            _speech(parts)  # "tell the students to be quiet" holds no words to say
        raise trouble("several people at once: name one, or say it to everyone", person.kind)
    told = words(parts, "TELL")
    if told and person.sort == "me":
        raise unfit()
    knows = any(word.said.startswith("know") for word in words(parts, "THAT"))
    if told and told[0].said == "let" and not knows:
        raise unfit()  # "let Ben have the cup" is no message
    return clause(parts, [(draft("say", text=_speech(parts), person=person),)])


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "words": _words,
    "say": _say,
    "say_to": _say_to,
    "say_done": _say_done,
    "say_to_each": _say_to_each,
    "people_told": _people_told,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)

"""English forms of words: plurals, -ing, past participles, and verbs without such an ending."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

_VOWELS = "aeiou"
_PLURAL_LINES = """
knife:knives shelf:shelves bookshelf:bookshelves man:men woman:women person:people child:children
mouse:mice potato:potatoes tomato:tomatoes mango:mangoes gentleman:gentlemen dice:dices tooth:teeth
scissors:scissors glasses:glasses somebody:people someone:people anyone:people anybody:people
fish:fish leaf:leaves loaf:loaves shelves:shelves
"""
_PLURALS = dict(pair.split(":") for pair in _PLURAL_LINES.split())
"""Plurals that no rule gives."""

_DOUBLED_LINES = """
begin cut dip drop flip get grab grip hit hug let nod pat pet pop put run scan set shut sit slam
snag spin spot step stir stop swap tap tip transfer
"""
_DOUBLED = frozenset(_DOUBLED_LINES.split())
"""Verbs that double their last letter."""

_ENDS_SO = frozenset(
    {"bring", "swing", "sing", "ring", "fling", "sling", "sting", "wring", "cling", "string"}
)
"""Verbs whose plain form ends like an -ing form."""


def plural(phrase: str) -> str:
    """The plural of a noun phrase: that of its last word."""
    *first, last = phrase.split(" ")
    return " ".join([*first, _plural(last)])


def _plural(word: str) -> str:
    if word in _PLURALS:
        return _PLURALS[word]
    if word.endswith(("s", "x", "z", "ch", "sh")):
        return word + "es"
    if word.endswith("y") and word[-2:-1] not in _VOWELS:
        return word[:-1] + "ies"
    return word + "s"


def gerund(phrase: str) -> str:
    """The -ing form of a verb phrase: that of its first word."""
    first, *rest = phrase.split(" ")
    if first.endswith("ing") and first not in _ENDS_SO:
        return phrase
    if first in _DOUBLED:
        form = first + first[-1] + "ing"
    elif first.endswith("ie"):
        form = first[:-2] + "ying"
    elif first.endswith("e") and not first.endswith(("ee", "oe", "ye")):
        form = first[:-1] + "ing"
    else:
        form = first + "ing"
    return " ".join([form, *rest])


def participle(phrase: str, irregular: Mapping[str, str]) -> str:
    """The past participle of a verb phrase: that of its first word."""
    first, *rest = phrase.split(" ")
    if first in irregular:
        form = irregular[first]
    elif first in _DOUBLED:
        form = first + first[-1] + "ed"
    elif first.endswith("e"):
        form = first + "d"
    elif first.endswith("y") and first[-2:-1] not in _VOWELS:
        form = first[:-1] + "ied"
    else:
        form = first + "ed"
    return " ".join([form, *rest])


def plain_forms(past: str) -> Iterator[str]:
    """The verbs of which a form with -ed may be: "placed" of "place", "stopped" of "stop"."""
    if not past.endswith("ed"):
        return
    yield past[:-1]
    yield past[:-2]
    if past[-3:-2] == past[-4:-3]:
        yield past[:-3]
    if past.endswith("ied"):
        yield past[:-3] + "y"

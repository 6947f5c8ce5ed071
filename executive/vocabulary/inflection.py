"""English forms of words: plurals, -ing, past participles, and those that are typed in haste."""

from __future__ import annotations

import importlib.resources
from collections.abc import Mapping
from functools import cache

from robots.toml_text import read_toml

_VOWELS = "aeiou"


@cache
def forms(kind: str) -> Mapping[str, str]:
    """What no rule gives, by the kind of form; a word that is only listed is its own form."""
    file = importlib.resources.files("executive.vocabulary").joinpath("forms.toml")
    return {one.split()[0]: one.split()[-1] for one in read_toml(file.read_text("utf-8"))[kind]}


def plural(phrase: str) -> str:
    """The plural of a noun phrase: that of its last word."""
    *first, last = phrase.split(" ")
    form = forms("plurals").get(last)
    if form is None and last.endswith("y") and last[-2:-1] not in _VOWELS:
        form = last[:-1] + "ies"
    elif form is None:
        form = last + ("es" if last.endswith(("s", "x", "z", "ch", "sh")) else "s")
    return " ".join([*first, form])


def gerund(phrase: str) -> str:
    """The -ing form of a verb phrase: that of its first word."""
    first, *rest = phrase.split(" ")
    if first.endswith("ing") and first not in forms("ends_so"):
        return phrase
    if first in forms("doubled"):
        form = first + first[-1] + "ing"
    elif first.endswith("ie"):
        form = first[:-2] + "ying"
    elif first.endswith("e") and not first.endswith(("ee", "oe", "ye")):
        form = first[:-1] + "ing"
    else:
        form = first + "ing"
    return " ".join([form, *rest])


def participle(phrase: str) -> str:
    """The past participle of a verb phrase: that of its first word."""
    first, *rest = phrase.split(" ")
    form = forms("participles").get(first)
    if form is None and first in forms("doubled"):
        form = first + first[-1] + "ed"
    elif form is None and first.endswith("y") and first[-2:-1] not in _VOWELS:
        form = first[:-1] + "ied"
    elif form is None:
        form = first.removesuffix("e") + "ed"
    return " ".join([form, *rest])

"""Remarks in words that are always the same: "you're doing fine", "what a day", "not that it matters".

Whole phrases of praise, small talk and excuse say nothing of a command, whatever it is. Others are words
within a remark, which is judged as if said plainly: "my left knee is killing me" is "my knee hurts".
"""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

from executive.language.motives.reason import Reason
from executive.vocabulary.written import expand

_ANY = "*"
"""One word, whatever it is."""


@cache
def _data() -> Mapping[str, Mapping[str, list[str]]]:
    """``set_remarks.toml``, read when a remark is first judged."""
    folder = importlib.resources.files("executive.language.motives")
    data: Mapping[str, Mapping[str, list[str]]] = tomllib.loads(
        folder.joinpath("set_remarks.toml").read_text("utf-8")
    )
    return data


@cache
def _set_remarks(name: str) -> list[list[list[list[str]]]]:
    """Every row of one sort: for each column the phrases that may stand there, as words."""
    return [
        [[one.split() for each in column.split(" / ") for one in expand(each)] for column in columns]
        for columns in _data()[name].values()
    ]


@cache
def _plainly() -> Mapping[str, list[tuple[list[str], list[str]]]]:
    """What stands for idioms, by their first words; the longest first."""
    found: dict[str, list[tuple[list[str], list[str]]]] = {}
    for plain, phrases in _data()["plainly"].items():
        for phrase in phrases:
            for one in expand(phrase):
                said = one.split()
                found.setdefault(said[0], []).append((said, plain.split()))
    for idioms in found.values():
        idioms.sort(key=lambda idiom: -len(idiom[0]))
    return found


def is_set_remark(remark: Reason, name: str) -> bool:
    """Whether a remark is one of a sort of phrases, word for word."""
    texts = remark.texts
    return any(_is_row(texts, columns) for columns in _set_remarks(name))


def _is_row(texts: list[str], columns: list[list[list[str]]]) -> bool:
    reached = {0}
    for column in columns:
        reached = {
            start + len(words)
            for start in reached
            for words in column
            if texts[start : start + len(words)] == words
        }
    return len(texts) in reached


def plainer(remark: Reason) -> Reason:
    """The remark with its idioms said plainly; itself if it has none, or is said of the robot too."""
    if remark.has("you"):
        return remark
    for index in remark.places:
        for said, plain in _plainly().get(remark.pieces[index].text, ()):
            end = index + len(said)
            if end <= remark.end and _is_said(remark.texts[index - remark.start :], said):
                return plainer(_with(remark, index, end, plain))
    return remark


def _is_said(texts: list[str], said: list[str]) -> bool:
    return all(one in (_ANY, text) for text, one in zip(texts, said, strict=False))


def _with(remark: Reason, start: int, end: int, plain: list[str]) -> Reason:
    """The remark with other words at a place, which are of no word class."""
    piece = remark.pieces[start]
    return replace(
        remark,
        pieces=[
            *remark.pieces[:start],
            *(replace(piece, text=word) for word in plain),
            *remark.pieces[end:],
        ],
        begins=[*remark.begins[:start], *(frozenset[str]() for _ in plain), *remark.begins[end:]],
        end=remark.end + len(plain) - (end - start),
    )

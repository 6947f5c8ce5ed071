"""Names that no list holds: told by their capital ("Herta", "Anne-Sophie"), or by a title ("Mr. Schmidt").

There is no end of names, so that no list is long enough. An unknown word that begins with a capital inside
a sentence, where capitals are not put on everything, is what somebody is called; the grammar lets it stand
where a listed name may. Said in lower case it stays unknown, and so does what may be a known word mistyped.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from collections.abc import Set as AbstractSet

from executive.language.text.word import Piece, Word
from executive.vocabulary import Vocabulary

IsMistyped = Callable[[str], bool]
"""Whether an unknown word may be a known one mistyped."""

Classes = Sequence[AbstractSet[str]]
"""Word classes of the phrases that begin, or end, at each place of a sentence."""

_MOST = 6
"""Names of one text: more unknown words are another language, or noise."""

_FORM = re.compile(r"(?:[^\W\d_]')?[^\W\d_]{4,}(?:'[^\W\d_]+)?")
"""Four letters at least, any three are too soon another name; or behind an apostrophe."""

_SOUNDS = re.compile(r"[aeiouy]|[^\x00-\x7f]")
"""What a word has that can be spoken."""

_OF = "'s"
_ENDS_A_SENTENCE = frozenset(".!?:;")
_NAMES = frozenset({"NAME", "OWNER"})
_TITLES = frozenset({"TITLE", "KIN_TITLE"})
_PEOPLE = frozenset({*_NAMES, *_TITLES, "PERSON", "OWNING", "PEOPLE"})
"""Word classes that are often written with a capital, which says nothing of the words around them."""

_GOES_ON = frozenset({"SEP", "AND", "DET", "IT", "BEFORE", "AFTER", "FIRST"})
"""Word classes of which "the Dr. Then" is no name."""


def unlisted_names(
    pieces: Sequence[Piece], plain: str, begins: Classes, vocabulary: Vocabulary, is_mistyped: IsMistyped
) -> Iterator[Word]:
    """Every name with a part that is in no list, or of two parts, by a text with its capitals."""
    inside = [at for at in range(1, len(pieces)) if not pieces[at].quoted and _tells(pieces, at)]
    unlisted = {
        at
        for at in inside
        if looks_like_a_name(pieces[at], plain, vocabulary) and not _is_called_at_the_end(pieces, at)
    }
    if len(unlisted) > _MOST or not all(_is_no_title_case(pieces[at], plain, begins[at]) for at in inside):
        return
    unlisted = {at for at in unlisted if not is_mistyped(pieces[at].text.removesuffix(_OF))}
    called = {pieces[at].text.removesuffix(_OF) for at in unlisted}
    unlisted |= {at for at, piece in enumerate(pieces) if piece.text in called and not piece.quoted}
    names = unlisted | {at for at in range(1, len(pieces)) if _is_listed(pieces[at], plain, begins[at])}
    for start in sorted(names):
        following = start + 1
        joined = following in names and plain[pieces[start].end : pieces[following].start] == "-"
        told = any("TELL" in begins[before] for before in range(max(0, start - 2), start))
        two = following in names and not pieces[start].text.endswith(_OF) and (joined or not told)
        listed = unlisted.isdisjoint((start, following)) and not joined
        if not joined and start in unlisted:
            yield _name(pieces, plain, start, following)
        if two and (not listed or begins[start] == begins[following] == {"NAME"}):
            yield _name(pieces, plain, start, following + 1)


def titled_names(
    pieces: Sequence[Piece], plain: str, begins: Classes, ended: Classes, vocabulary: Vocabulary
) -> Iterator[Word]:
    """Every name with a title or a relation before it: "Mr. John Smith", "my aunt Rosa"."""
    texts = ["" if piece.quoted else piece.text for piece in pieces]
    for start in range(len(pieces)):
        if begins[start].isdisjoint(_TITLES) or "DET" in ended[start]:
            continue  # "the doctor Ana"
        for length, reading in vocabulary.matches(texts, start):
            formal = reading.word_class == "TITLE"
            name = start + length
            name += formal and name < len(pieces) and texts[name] == "."
            end = name
            while reading.word_class in _TITLES and end < len(pieces) and end <= name + formal:
                if not _follows_a_title(pieces[end], plain, begins[end], formal, end > name):
                    break
                end += 1
                if texts[end - 1].endswith(_OF):
                    break
            if end > name:
                said = plain[pieces[name].start : pieces[end - 1].end].removesuffix(_OF).split()
                whose = "OWNER" if texts[end - 1].endswith(_OF) else "NAME"
                full = " ".join([reading.meaning, *(one[:1].upper() + one[1:] for one in said)])
                yield Word(whose, full, start, end, " ".join(texts[start:end]))


def looks_like_a_name(piece: Piece, plain: str, vocabulary: Vocabulary) -> bool:
    """Whether a piece is an unknown word with a capital and small letters, wherever it stands."""
    said = plain[piece.start : piece.end].removesuffix(_OF)
    small = said[:1].isupper() and said != said.upper()
    sounds = _FORM.fullmatch(said) is not None and _SOUNDS.search(said.lower()) is not None
    if piece.quoted or not small or not sounds:
        return False
    return vocabulary.single_words.isdisjoint((piece.text, piece.text.removesuffix(_OF)))


def _name(pieces: Sequence[Piece], plain: str, start: int, end: int) -> Word:
    said = plain[pieces[start].start : pieces[end - 1].end]
    texts = " ".join(piece.text for piece in pieces[start:end])
    return Word("OWNER" if said.endswith(_OF) else "NAME", said.removesuffix(_OF), start, end, texts)


def _is_listed(piece: Piece, plain: str, begins: AbstractSet[str]) -> bool:
    """Whether a piece is a listed name, written as one."""
    return not piece.quoted and plain[piece.start].isupper() and not begins.isdisjoint(_NAMES)


def _tells(pieces: Sequence[Piece], at: int) -> bool:
    """Whether a capital says something, because the word does not stand first."""
    before = pieces[at - 1]
    if before.quoted or before.text in _ENDS_A_SENTENCE:
        return False
    return before.text == "," or before.text[-1].isalpha()


def _is_called_at_the_end(pieces: Sequence[Piece], at: int) -> bool:
    """Whether a word may be said to somebody, or be a courtesy of another language: "wave to Ana, Kemal"."""
    last = at + 1 == len(pieces) or pieces[at + 1].text in _ENDS_A_SENTENCE
    return last and pieces[at - 1].text == ","


def _is_no_title_case(piece: Piece, plain: str, begins: AbstractSet[str]) -> bool:
    """Whether a word has no capital that all words have, as in "Bring Me The Cup"; "TV" says nothing."""
    said = plain[piece.start : piece.end]
    if len(said) > 1 and said == said.upper() != said.lower():
        return len(said) <= 4
    always = len(said.partition("'")[0]) == 1  # "I", "I'm"
    return said[0].islower() or always or not begins or not begins.isdisjoint(_PEOPLE)


def _follows_a_title(piece: Piece, plain: str, begins: AbstractSet[str], formal: bool, second: bool) -> bool:
    """Whether a word may be a name behind a title, which any is that has a capital or is unknown."""
    known = not piece.quoted and not begins.isdisjoint(_NAMES)
    capital = plain[piece.start].isupper()
    if known or not formal or piece.quoted or not piece.text.replace("-", "").replace("'", "").isalpha():
        return known and (capital or not second)
    return begins.isdisjoint(_GOES_ON) if capital else not second and not begins and plain == plain.lower()

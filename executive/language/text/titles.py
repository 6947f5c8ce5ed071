"""Names with a title or a relation before them: "Mr. Schmidt", "aunt Rosa", "my friend Yusuf"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from executive.language.text.piece import Piece
from executive.vocabulary import Vocabulary

_MINE = frozenset({"my", "our"})
_ARTICLES = frozenset({"the", "a", "an", "that", "this", "some"})
_GOES_ON = frozenset({"SEP", "AND", "DET", "IT", "BEFORE", "AFTER", "FIRST"})
"""Word classes of which "the Dr. Then" is no name."""

_TITLES = frozenset({"TITLE", "KIN_TITLE", "KIN_TITLE_ALONE"})

_OF = "'s"

Found = tuple[int, int, str, str]
"""Where a name begins and ends, its word class, and the name."""


def titled_names(
    pieces: Sequence[Piece], plain: str, begins: Sequence[AbstractSet[str]], vocabulary: Vocabulary
) -> Iterator[Found]:
    """Every name with its title.

    Args:
        pieces: Of the sentence.
        plain: Its text, in which names may be told by their capital.
        begins: Word classes that begin at each place.
        vocabulary: Which titles there are.
    """
    texts = [piece.text if not piece.quoted else "" for piece in pieces]
    for start in range(len(pieces)):
        if texts[start] in _MINE:
            yield from _related(pieces, texts, plain, begins, start, vocabulary)
        before = texts[start - 1] if start else ""
        if begins[start].isdisjoint(_TITLES) or before in _ARTICLES:
            continue
        for length, reading in vocabulary.matches(texts, start):
            whose = reading.word_class == "KIN_TITLE_ALONE" and before in _MINE
            if reading.word_class not in _TITLES or whose:
                continue
            formal = reading.word_class == "TITLE"
            name = start + length
            if formal and name < len(pieces) and texts[name] == ".":
                name += 1
            end = _end_of_name(pieces, plain, begins, name, formal=formal)
            if end is None:
                continue
            said = [plain[one.start : one.end] for one in pieces[name:end]]
            owns = said[-1].endswith(_OF)
            called = " ".join([reading.meaning, *(one.removesuffix(_OF).capitalize() for one in said)])
            first = start - 1 if start and texts[start - 1] in _MINE and not formal else start
            yield first, end, "OWNER" if owns else "NAME", called


def _related(
    pieces: Sequence[Piece],
    texts: Sequence[str],
    plain: str,
    begins: Sequence[AbstractSet[str]],
    start: int,
    vocabulary: Vocabulary,
) -> Iterator[Found]:
    """The name of somebody of whom it is said before it whose friend or relative it is: "my friend Yusuf"."""
    if start + 2 >= len(pieces) or "KIN_TITLE" in begins[start + 1]:
        return  # "my aunt Rosa" keeps her title
    told = start > 0 and "TELL" in begins[start - 1]
    for length, reading in vocabulary.matches(texts, start + 1):
        name = start + 1 + length
        known = name < len(pieces) and begins[name] == {"NAME"} and plain[pieces[name].start].isupper()
        if told and not (name + 1 < len(pieces) and (texts[name + 1] == "that" or pieces[name + 1].quoted)):
            continue  # "tell my friend Ben has come"
        if reading.word_class == "PERSON" and known:
            yield start, name + 1, "NAME", texts[name].capitalize()


def _end_of_name(
    pieces: Sequence[Piece], plain: str, begins: Sequence[AbstractSet[str]], start: int, *, formal: bool
) -> int | None:
    """Where a name ends that begins at a place, or None where none does."""
    if start >= len(pieces) or not _is_name(pieces[start], plain, begins[start], any_word=formal):
        return None
    following = start + 1
    first = pieces[start].text
    two = formal and following < len(pieces) and not first.endswith(_OF)
    if (
        two
        and plain[pieces[following].start].isupper()
        and _is_name(pieces[following], plain, begins[following], any_word=True)
    ):
        return following + 1  # "Mr. John Smith"
    return following


def _is_name(piece: Piece, plain: str, begins: AbstractSet[str], *, any_word: bool) -> bool:
    known = not begins.isdisjoint({"NAME", "OWNER"})
    word = piece.text.removesuffix(_OF).replace("-", "").replace("'", "")
    if known or not any_word or piece.quoted or not word.isalpha():
        return known and not piece.quoted
    if plain[piece.start].isupper():
        return begins.isdisjoint(_GOES_ON)
    return not begins and plain == plain.lower()  # as it is typed in haste

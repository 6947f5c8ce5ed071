"""Names that no list holds, told by their capital: "wave to Herta", "bring Anne-Sophie the cup", "Ana Maria".

There is no end of names, so that no list is long enough. An unknown word that begins with a capital inside
a sentence, where capitals are not put on everything, is what somebody is called; the grammar lets it stand
where a listed name may. Said in lower case it stays unknown, and so does what may be a known word mistyped.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from collections.abc import Set as AbstractSet

from executive.language.text.piece import Piece
from executive.vocabulary import Vocabulary

IsMistyped = Callable[[str], bool]
"""Whether an unknown word may be a known one mistyped."""

Found = tuple[int, int, str, str]
"""Where a name begins and ends, its word class, and the name."""

_MOST = 6
"""Names of one text: more unknown words are another language, or noise."""

_FORM = re.compile(r"(?:[^\W\d_]')?[^\W\d_]{4,}(?:'[^\W\d_]+)?")
"""Four letters at least, any three are too soon another name; or behind an apostrophe."""

_SOUNDS = re.compile(r"[aeiouy]|[^\x00-\x7f]")
"""What a word has that can be spoken."""

_OF = "'s"
_ENDS_A_SENTENCE = frozenset(".!?:;")
_PEOPLE = frozenset({"NAME", "OWNER", "PERSON", "OWNING", "TITLE", "KIN_TITLE", "KIN_TITLE_ALONE", "PEOPLE"})
"""Word classes that are often written with a capital, which says nothing of the words around them."""

_TELLS = "TELL"
"""Word class behind which a second name may begin what is told: "tell Ben Herta is here"."""


def unlisted_names(
    pieces: Sequence[Piece],
    plain: str,
    begins: Sequence[AbstractSet[str]],
    vocabulary: Vocabulary,
    is_mistyped: IsMistyped,
) -> Iterator[Found]:
    """Every name with a part that is in no list, or of two parts.

    Args:
        pieces: Of the sentence.
        plain: Its text, with capitals.
        begins: Word classes that begin at each place.
        vocabulary: What is known.
        is_mistyped: Whether an unknown word is rather a known one.
    """
    unlisted = {
        index
        for index in range(1, len(pieces))
        if looks_like_a_name(pieces[index], plain, vocabulary)
        and not _begins_a_sentence(pieces, index)
        and not _is_called_at_the_end(pieces, index)
    }
    if len(unlisted) > _MOST or not _capitals_tell(pieces, plain, begins):
        return
    unlisted = {index for index in unlisted if not is_mistyped(pieces[index].text.removesuffix(_OF))}
    called = {pieces[index].text.removesuffix(_OF) for index in unlisted}
    unlisted |= {index for index, piece in enumerate(pieces) if piece.text in called and not piece.quoted}
    names = unlisted | {
        index for index in range(1, len(pieces)) if _is_listed(pieces[index], plain, begins[index])
    }
    for start in sorted(names):
        for end in _ends_of_name(pieces, plain, begins, names, start):
            listed = unlisted.isdisjoint(range(start, end))
            if listed and not (_is_hyphenated(pieces, plain, start) or _is_double(begins[start:end])):
                continue
            said = plain[pieces[start].start : pieces[end - 1].end]
            yield start, end, "OWNER" if said.endswith(_OF) else "NAME", said.removesuffix(_OF)


def looks_like_a_name(piece: Piece, plain: str, vocabulary: Vocabulary) -> bool:
    """Whether a piece is an unknown word with a capital and small letters, wherever it stands."""
    said = plain[piece.start : piece.end].removesuffix(_OF)
    small = said[:1].isupper() and said != said.upper()
    known = piece.text.removesuffix(_OF) in vocabulary.single_words or piece.text in vocabulary.single_words
    sounds = _FORM.fullmatch(said) is not None and _SOUNDS.search(said.lower()) is not None
    return not piece.quoted and small and not known and sounds


def _is_listed(piece: Piece, plain: str, begins: AbstractSet[str]) -> bool:
    """Whether a piece is a listed name, written as one."""
    return not piece.quoted and plain[piece.start].isupper() and not begins.isdisjoint({"NAME", "OWNER"})


def _begins_a_sentence(pieces: Sequence[Piece], index: int) -> bool:
    """Whether a capital says nothing, because the word stands first."""
    before = pieces[index - 1]
    if before.quoted or before.text in _ENDS_A_SENTENCE:
        return True
    return before.text != "," and not before.text[-1].isalpha()


def _is_called_at_the_end(pieces: Sequence[Piece], index: int) -> bool:
    """Whether a word may be said to somebody, or be a courtesy of another language: "wave to Ana, Kemal"."""
    last = index + 1 == len(pieces) or pieces[index + 1].text in _ENDS_A_SENTENCE
    return last and pieces[index - 1].text == ","


def _capitals_tell(pieces: Sequence[Piece], plain: str, begins: Sequence[AbstractSet[str]]) -> bool:
    """Whether no other word inside a sentence has a capital, as in "Bring Me The Cup"; "TV" says nothing."""
    for index in range(1, len(pieces)):
        said = plain[pieces[index].start : pieces[index].end]
        if pieces[index].quoted or not said[0].isupper() or _begins_a_sentence(pieces, index):
            continue
        shouted = len(said) > 1 and said == said.upper()
        if shouted and len(said) > 4:
            return False
        if begins[index] and begins[index].isdisjoint(_PEOPLE) and not shouted and not said.startswith("I"):
            return False
    return True


def _ends_of_name(
    pieces: Sequence[Piece],
    plain: str,
    begins: Sequence[AbstractSet[str]],
    names: AbstractSet[int],
    start: int,
) -> Iterator[int]:
    """Where a name may end that begins at a place: "Herta", "Herta Baumgartner", "Anne-Sophie"."""
    joined = _is_hyphenated(pieces, plain, start)
    if not joined:
        yield start + 1
    following = start + 1
    told = any(_TELLS in begins[before] for before in range(max(0, start - 2), start))
    owns = pieces[start].text.endswith(_OF)
    if following in names and not owns and (joined or not told):
        yield following + 1


def _is_double(begins: Sequence[AbstractSet[str]]) -> bool:
    """Whether two words are names of people and nothing else, as in "Ana Maria"; "Ana Ben's cup" is Ben's."""
    return len(begins) == 2 and all(classes == {"NAME"} for classes in begins)


def _is_hyphenated(pieces: Sequence[Piece], plain: str, start: int) -> bool:
    """Whether a hyphen alone joins a word to the next: "Anne-Sophie"."""
    following = start + 1
    return following < len(pieces) and plain[pieces[start].end : pieces[following].start] == "-"

"""Everything that the vocabulary reads in a sentence: for each place, which word classes begin there."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from executive.language.text.addresses import BESIDE, is_beside, is_whole
from executive.language.text.colons import BEFORE_A_COLON
from executive.language.text.contracted import uncontracted
from executive.language.text.hesitations import SET_OFF, is_set_off, says_nothing
from executive.language.text.piece import Piece
from executive.language.text.titles import titled_names
from executive.language.text.unlisted_names import IsMistyped, unlisted_names
from executive.language.text.word import Word
from executive.vocabulary import Vocabulary

FILLER = "FILLER"
MANNER = "manner"
"""Meaning of those fillers that say how something is to be done."""

AGAIN = "again"
"""What is done again is done; said, it is a word like others: "see you again"."""

_MANNERS = frozenset({(FILLER, MANNER), ("OPENING", MANNER), ("BRIEFLY", "hurry")})
_AT_FIRST = frozenset({"SECOND_THOUGHT", "AT_FIRST", "ATTENTION"})
_BEFORE_ALL = "before_all"
"""Meaning of those words of order that name what is done later: "before doing anything else"."""

_NARROWS = frozenset({"IN", "ON", "AT", "TO", "WITH", "FROM", "FOR", "NEXT_TO", "RELATION", "INTO"})
"""Word classes with which that is said of some of it only: "before doing anything in the kitchen"."""

_PASSED_AT_FIRST = frozenset({FILLER, "OPENING", "REASON", "HESITATION", "ADDRESSED", *_AT_FIRST})
_BEFORE_A_NOUN = frozenset({"the", "a", "an", "my", "your", "our"})
_COMPLETE = frozenset(
    {
        *("KIND", "KINDS", "SUBSTANCE", "PAIR", "THING", "THINGS", "ONE", "ONES", "FURNITURE", "FURNITURES"),
        *("CONTAINER", "CONTAINERS", "DOOR", "DOORS", "ROOM", "PERSON", "PEOPLE", "NAME"),
        *("IT", "THEM", "THIS", "HIM", "ME", "LEFT_RIGHT", "AMOUNT", "TENS"),
    }
)
"""Word classes after which a hesitation may introduce another wording of the same thing."""
_NOUNS = frozenset({"KIND", "KINDS", "SUBSTANCE", "PAIR", "FURNITURE", "CONTAINER", "ROOM"})
_DESCRIBING = frozenset({"COLOR", "MATERIAL", "SIZE"})
_REFUSED_VERBS = frozenset({"NO_SKILL", "HARM", "THROW", "ASK"})
_ONLY_REFUSED = "NO_SKILL_OR_NOUN"
"""Word class of what is known as a verb only, at the beginning of a clause."""
_NUMBERS = frozenset({"AMOUNT", "TENS"})
_LISTING = frozenset({"and", "then", ",", "&", ";", "."})
_NO_TERMINALS = frozenset({"KIN_TITLE", "KIN_TITLE_ALONE"})
_ENDS_TEXT = frozenset({"PAUSE", "SEP", "TO"})


class Lattice:
    """The readings of all pieces, with courtesies that may stand anywhere passed over.

    Attributes:
        plain: The normalised text.
        pieces: Its pieces.
        ends: Places after which nothing but courtesies and marks follow.
    """

    def __init__(
        self,
        plain: str,
        pieces: Sequence[Piece],
        vocabulary: Vocabulary,
        is_mistyped: IsMistyped = lambda _word: False,
    ) -> None:
        self.plain = plain
        self.pieces = pieces = list(uncontracted(pieces, vocabulary))
        size = len(pieces)
        texts = _texts_of(pieces)
        self._begins, self._ended = self._classes_at(texts, vocabulary)
        self._words: list[dict[str, list[Word]]] = [{} for _ in range(size + 1)]
        self._own: list[list[Word]] = [[] for _ in range(size + 1)]
        self._covered = [False] * size
        self.ends = [False] * size + [True]
        self._text_ends = [False] * size + [True]
        self._nothing_said = self._before_any_content(texts, vocabulary)
        self._formed: dict[int, list[Word]] = {}
        for found in list(unlisted_names(pieces, plain, self._begins, vocabulary, is_mistyped)):
            self._add_name(*found, texts)
        for found in list(titled_names(pieces, plain, self._begins, vocabulary)):
            self._add_name(*found, texts)
        for start in range(size - 1, -1, -1):
            self._read(start, texts, vocabulary)

    def _add_name(self, start: int, end: int, word_class: str, name: str, texts: Sequence[str]) -> None:
        """Keep a name that is no phrase of the vocabulary."""
        word = Word(word_class, name, start, end, " ".join(texts[start:end]))
        self._formed.setdefault(start, []).append(word)
        self._begins[start].add(word_class)
        self._ended[end].add(word_class)

    def _before_any_content(self, texts: Sequence[str], vocabulary: Vocabulary) -> list[bool]:
        """For each place, whether only courtesies stand before it."""
        reached = [True] + [False] * len(texts)
        for start, piece in enumerate(self.pieces):
            if reached[start] and piece.is_mark:
                reached[start + 1] = True
            elif reached[start]:
                for length, reading in vocabulary.matches(texts, start):
                    if reading.word_class in _PASSED_AT_FIRST:
                        reached[start + length] = True
        return reached

    def _classes_at(
        self, texts: Sequence[str], vocabulary: Vocabulary
    ) -> tuple[list[set[str]], list[set[str]]]:
        """For each place, of which classes a phrase begins there, and of which one ends there."""
        begins: list[set[str]] = [set() for _ in range(len(texts) + 1)]
        ends: list[set[str]] = [set() for _ in range(len(texts) + 1)]
        for start in range(len(texts)):
            for length, reading in vocabulary.matches(texts, start):
                begins[start].add(reading.word_class)
                ends[start + length].add(reading.word_class)
        return begins, ends

    def _is_passed_over(self, word: Word, texts: Sequence[str], vocabulary: Vocabulary) -> bool:
        """Whether a word says nothing where it stands.

        After a thing "er" may correct what was said; "thank you" after "say" is what to say; a robot that
        is addressed stands beside a mark or at the beginning, else it is a thing such as a toy robot.
        """
        if word.word_class == "ADDRESSED":
            return self._is_address(word)
        if word.word_class == FILLER:
            return "SAY" not in self._ended[word.start] and not (
                word.start > 0 and texts[word.start - 1] in _BEFORE_A_NOUN
            )
        if word.word_class in _AT_FIRST:
            narrowed = word.meaning == _BEFORE_ALL and self.begins_with(word.end, _NARROWS)
            return self._nothing_said[word.start] and not narrowed
        if word.word_class != "HESITATION":
            return False
        if word.meaning == SET_OFF and not is_set_off(word.start, word.end, self.pieces, self._ended):
            return self._nothing_said[word.start]
        before = word.start - 1
        while before >= 0 and self.pieces[before].is_mark:
            before -= 1
        if before < 0 or self._nothing_said[word.start]:
            return True
        if self._says_how_much(word.end, texts, vocabulary) and texts[before] in ("left", "right"):
            return True  # "turn left uh ninety degrees"
        complete = self.pieces[before].is_number or any(
            length == 1 and reading.word_class in _COMPLETE
            for length, reading in vocabulary.matches(texts, before)
        )
        return not complete or says_nothing(word.start, word.end, self.pieces, self._begins, self._ended)

    def _is_address(self, word: Word) -> bool:
        """Whether the robot is addressed: at first, beside a mark, or at the end behind what is whole."""
        if word.meaning == BESIDE and not self._nothing_said[word.start]:
            return is_beside(
                word.start,
                word.end,
                self.pieces,
                self._begins,
                self._ended,
                sentence_ends=self.ends[word.end],
            )
        if self._nothing_said[word.start] or self.pieces[word.start - 1].is_mark:
            return True
        return self.ends[word.end] and is_whole(self._ended[word.start], word.meaning)

    def _is_colon(self, position: int) -> bool:
        return position + 1 < len(self.pieces) and self.pieces[position].text == ":"

    def _says_how_much(self, position: int, texts: Sequence[str], vocabulary: Vocabulary) -> bool:
        """Whether a number stands at a place; "one" may stand for a thing."""
        if position >= len(self.pieces) or texts[position] == "one":
            return False
        read = {reading.word_class for _, reading in vocabulary.matches(texts, position)}
        return self.pieces[position].is_number or not read.isdisjoint(_NUMBERS)

    @staticmethod
    def _is_idiom(word: Word, texts: Sequence[str], vocabulary: Vocabulary) -> bool:
        """Whether it means something else than its words: "take a photo", but not "take a photo frame"."""
        return word.word_class == "IDIOM" and not any(
            reading.word_class in _NOUNS and start + length > word.end
            for start in range(word.start + 1, word.end)
            for length, reading in vocabulary.matches(texts, start)
        )

    def _follows_a_noun(self, start: int) -> bool:
        """Whether "and", "then" or a comma stands right before a place."""
        return start > 0 and self.pieces[start - 1].text in _LISTING

    def _read(self, start: int, texts: Sequence[str], vocabulary: Vocabulary) -> None:
        piece = self.pieces[start]
        found = [
            Word(
                reading.word_class,
                reading.meaning,
                start,
                start + length,
                " ".join(texts[start : start + length]),
            )
            for length, reading in vocabulary.matches(texts, start)
            if reading.word_class not in _NO_TERMINALS
        ]
        found += self._formed.get(start, ())
        if piece.quoted:
            found = [Word("QUOTED", piece.text, start, start + 1)]
        elif piece.is_mark:
            found.append(Word("PAUSE", piece.text, start, start + 1))
        elif piece.is_number:
            found.append(Word("NUM", piece.text, start, start + 1))
        at = self._words[start]
        fillers = [word for word in found if self._is_passed_over(word, texts, vocabulary)]
        compound = max((word.end for word in found if word.word_class in _NOUNS), default=0)
        idiom = max((word.end for word in found if self._is_idiom(word, texts, vocabulary)), default=0)
        begins = self._nothing_said[start] or self._follows_a_noun(start)
        listed = begins and any(word.word_class in _REFUSED_VERBS for word in found)
        paired = start > 0 and any(
            start - 1 + length == start + 1 and length > 1 and reading.word_class == "PAIR"
            for length, reading in vocabulary.matches(texts, start - 1)
        )
        for word in found:
            for index in range(start, word.end) if word.word_class != _ONLY_REFUSED else ():
                self._covered[index] = True
            if word.end < idiom:
                continue  # "take a picture" takes no picture from the wall
            if word.word_class in _DESCRIBING and word.end < compound:
                continue  # "orange juice" is no juice that is orange
            if paired and word.word_class == "KINDS" and word.end == start + 1:
                continue  # "my glasses" are no drinking glasses
            if listed and word.word_class in _NOUNS and word.end == start + 1:
                continue  # "the cup and saw": a bare noun that is a verb as well may be one
            if word.word_class in BEFORE_A_COLON and self._is_colon(word.end):
                at.setdefault(word.word_class, []).append(replace(word, end=word.end + 1))
            if word not in fillers:
                at.setdefault(word.word_class, []).append(word)
        self._own[start] = found
        self.ends[start] = piece.is_mark and self.ends[start + 1]
        self._text_ends[start] = piece.is_mark and self._text_ends[start + 1]
        passed = {word.end for word in fillers}
        silent = {word.end for word in fillers if word.meaning != AGAIN and not self._is_last_word(word)}
        if piece.text == ",":  # a courtesy between two commas
            passed |= {
                after
                for word in self._own[start + 1]
                if self._is_passed_over(word, texts, vocabulary)
                for after in self._after_commas(word)
            }
        else:
            passed |= {word.end + 1 for word in fillers if self._hesitates_before_comma(word)}
        if start == 0 and piece.is_mark:
            passed.add(start + 1)
        for after in passed:
            self.ends[start] = self.ends[start] or self.ends[after]
            if after in silent:
                self._text_ends[start] = self._text_ends[start] or self._text_ends[after]
            for name, words in self._words[after].items():
                known = at.setdefault(name, [])
                known.extend(word for word in words if word not in known)

    def _is_last_word(self, word: Word) -> bool:
        """Whether it addresses somebody at the end, where it may as well be one of the words to say."""
        begins = word.start == 0 or (word.meaning != BESIDE and self.pieces[word.start - 1].is_mark)
        return word.word_class == "ADDRESSED" and not begins and not self._nothing_said[word.start]

    def _hesitates_before_comma(self, word: Word) -> bool:
        comma = word.end < len(self.pieces) and self.pieces[word.end].text == ","
        return comma and word.word_class == "HESITATION"

    def _after_commas(self, word: Word) -> list[int]:
        """Where a sentence goes on after a courtesy behind a comma; a hesitation needs none behind it."""
        closed = word.end < len(self.pieces) and self.pieces[word.end].text == ","
        after = [word.end + 1] if closed else []
        return [*after, word.end] if word.word_class == "HESITATION" else after

    def classes(self, position: int) -> dict[str, list[Word]]:
        """The words that begin at a place, by word class."""
        return self._words[position]

    @property
    def first_said(self) -> int:
        """Where what is said begins, behind courtesies; 0 where there is nothing else."""
        size = len(self.pieces)
        if self._nothing_said[size]:
            return 0
        return next(one for one in reversed(range(size)) if self._nothing_said[one])

    def may_begin(self, position: int) -> bool:
        """Whether only courtesies stand before a place."""
        return self._nothing_said[position]

    def phrase(self, position: int) -> Sequence[Word]:
        """The words that begin exactly at a place."""
        return self._own[position]

    def ends_with(self, position: int, classes: AbstractSet[str]) -> bool:
        """Whether a phrase of one of some classes ends at a place."""
        return not self._ended[position].isdisjoint(classes)

    def begins_with(self, position: int, classes: AbstractSet[str]) -> bool:
        """Whether a phrase of one of some classes begins at a place."""
        return not self._begins[position].isdisjoint(classes)

    @property
    def begun(self) -> Sequence[AbstractSet[str]]:
        """For each place, of which classes a phrase begins there."""
        return self._begins

    @property
    def nothing_said(self) -> Sequence[bool]:
        """For each place, whether only courtesies stand before it."""
        return self._nothing_said

    def manners(self) -> tuple[str, ...]:
        """Words that say how, and are passed over because it is always done like that."""
        found: dict[str, None] = {}
        end = 0
        for start, words in enumerate(self._own):
            said = [one for one in words if (one.word_class, one.meaning) in _MANNERS]
            if said and start >= end:
                longest = max(said, key=lambda one: one.end)
                found[longest.said] = None
                end = longest.end
        return tuple(found)

    def unknown(self) -> int | None:
        """The first piece that belongs to no phrase."""
        return next((index for index, covered in enumerate(self._covered) if not covered), None)

    def unknown_pieces(self) -> list[Piece]:
        """All pieces that belong to no phrase."""
        return [piece for piece, covered in zip(self.pieces, self._covered, strict=True) if not covered]

    def text_may_end(self, end: int) -> bool:
        """Whether words to say may end at a place."""
        return self._text_ends[end] or any(word.word_class in _ENDS_TEXT for word in self._own[end])

    def text(self, start: int, end: int) -> str:
        """The text of some pieces, as it was written."""
        while end > start + 1 and self.pieces[end - 1].is_mark:
            end -= 1
        return self.plain[self.pieces[start].start : self.pieces[end - 1].end] if end > start else ""


def _texts_of(pieces: Sequence[Piece]) -> list[str]:
    """What is looked up: nothing of a quotation."""
    return [piece.text if not piece.quoted else "" for piece in pieces]

"""Everything that the vocabulary reads in a sentence: for each place, which word classes begin there."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from executive.language.text.names import IsMistyped, titled_names, unlisted_names
from executive.language.text.word import Piece, Word
from executive.vocabulary import Vocabulary

FILLER = "FILLER"
ADDRESSED = "ADDRESSED"
HESITATION = "HESITATION"

TIME = "time"
"""Meaning of those fillers that may belong to words to say: "tell Ben that I'm leaving now"."""

_BESIDE, _AGAIN, _MANNER = "beside", "again", "manner"
"""Meanings: of who may be meant elsewhere ("my friend"), of what is done once more or is a word to say ("see
you again"), and of how something is to be done, which it always is.
"""

_AT_FIRST = frozenset({"SECOND_THOUGHT", "AT_FIRST", "ATTENTION", HESITATION, ADDRESSED})
_PASSED_AT_FIRST = frozenset({FILLER, "OPENING", "REASON", *_AT_FIRST})
_NOUNS = frozenset({"KIND", "KINDS", "SUBSTANCE", "PAIR", "FURNITURE", "CONTAINER", "ROOM"})
_PEOPLE = frozenset({"NAME", "PERSON", "PEOPLE", "ANIMAL", "ANIMALS", "HIM", "EVERYBODY", "US"})
_COMPLETE = _NOUNS | frozenset(
    {
        *("THING", "THINGS", "ONE", "ONES", "FURNITURES", "CONTAINERS", "DOOR", "DOORS", "PERSON", "PEOPLE"),
        *("NAME", "IT", "THEM", "THIS", "HIM", "ME", "LEFT_RIGHT", "AMOUNT", "NUM", "TENS"),
    }
)
"""Word classes after which a hesitation may introduce another wording of the same thing."""

_DESCRIBING = frozenset({"COLOR", "MATERIAL", "SIZE"})
_REFUSED_VERBS = frozenset({"NO_SKILL", "HARM", "THROW", "ASK"})
_ONLY_REFUSED = "NO_SKILL_OR_NOUN"
"""Word class of what is known as a verb only, at the beginning of a clause."""

_LISTING = frozenset({"SEP", "AND", "PAUSE"})
_SEPARATES = frozenset({"PAUSE", "SEP", "BEFORE", "AFTER", "AFTER_DOING"})
_ENDS_A_SENTENCE = frozenset(".!?")
_ENDS_TEXT = frozenset({"PAUSE", "SEP", "TO"})


class Lattice:
    """The readings of all pieces, with courtesies that may stand anywhere passed over.

    Attributes:
        plain: The normalised text.
        pieces: Its pieces.
        phrases: The words that begin exactly at each place.
        words: Those that begin there or behind courtesies, by word class: what the grammar is offered.
        ends: Places after which nothing but courtesies and marks follow.
    """

    def __init__(
        self,
        plain: str,
        pieces: Sequence[Piece],
        vocabulary: Vocabulary,
        is_mistyped: IsMistyped = lambda _word: False,
    ) -> None:
        self.plain, self.pieces = plain, pieces
        size = len(pieces)
        texts = ["" if piece.quoted else piece.text for piece in pieces]
        self.phrases: list[list[Word]] = [[] for _ in range(size)]
        self._begins: list[set[str]] = [set() for _ in range(size + 1)]
        self._ended: list[set[str]] = [set() for _ in range(size + 1)]
        for start in range(size):
            self._note(self._read(start, texts, vocabulary))
        self._note(list(unlisted_names(pieces, plain, self._begins, vocabulary, is_mistyped)))
        self._note(list(titled_names(pieces, plain, self._begins, self._ended, vocabulary)))
        self._nothing_said = self._before_any_content()
        self.words: list[dict[str, list[Word]]] = [{} for _ in range(size + 1)]
        self._covered = [False] * size
        self.ends = [False] * size + [True]
        self._text_ends = [False] * size + [True]
        for start in range(size - 1, -1, -1):
            self._place(start)

    def _read(self, start: int, texts: Sequence[str], vocabulary: Vocabulary) -> list[Word]:
        """Every phrase that begins at a place, in all of its readings."""
        piece = self.pieces[start]
        if piece.quoted:
            return [Word("QUOTED", piece.text, start, start + 1)]
        found = [
            Word(one.word_class, one.meaning, start, start + length, " ".join(texts[start : start + length]))
            for length, one in vocabulary.matches(texts, start)
        ]
        if piece.is_mark:
            found.append(Word("PAUSE", piece.text, start, start + 1))
        elif piece.is_number:
            found.append(Word("NUM", piece.text, start, start + 1))
        return found

    def _note(self, words: Sequence[Word]) -> None:
        for word in words:
            self.phrases[word.start].append(word)
            self._begins[word.start].add(word.word_class)
            self._ended[word.end].add(word.word_class)

    def _before_any_content(self) -> list[bool]:
        """For each place, whether only courtesies stand before it."""
        reached = [True] + [False] * len(self.pieces)
        for start, piece in enumerate(self.pieces):
            for word in self.phrases[start] if reached[start] else ():
                reached[word.end] |= piece.is_mark or word.word_class in _PASSED_AT_FIRST
        return reached

    def _place(self, start: int) -> None:
        """Offer the words of a place to the grammar, and those behind a courtesy that begins there."""
        found, at = self.phrases[start], self.words[start]
        fillers = [word for word in found if self._is_passed_over(word)]
        for word in found:
            for index in range(start, word.end) if word.word_class != _ONLY_REFUSED else ():
                self._covered[index] = True
            if word not in fillers and not self._is_part_of_another(word):
                at.setdefault(word.word_class, []).append(word)
        passed = {word.end for word in fillers}
        silent = {word.end for word in fillers if word.meaning != _AGAIN and not self._is_last_word(word)}
        mark = self.pieces[start].is_mark
        if mark and self.pieces[start].text == ",":
            passed.update(*map(self._after_commas, filter(self._is_passed_over, self.phrases[start + 1])))
        if start == 0 and mark:
            passed.add(1)
        self.ends[start] = (mark and self.ends[start + 1]) or any(self.ends[after] for after in passed)
        self._text_ends[start] = (mark and self._text_ends[start + 1]) or any(
            self._text_ends[after] for after in passed & silent
        )
        for after in passed:
            for name, words in self.words[after].items():
                known = at.setdefault(name, [])
                known.extend(word for word in words if word not in known)

    def _is_passed_over(self, word: Word) -> bool:
        """Whether a word says nothing where it stands.

        "Thank you" after "say" is what to say; a robot that is addressed stands beside a mark or at the
        beginning, else it is a thing such as a toy robot; after a thing "er" may correct what was said.
        """
        before = self._ended[word.start]
        if word.word_class == FILLER:
            a_noun_follows = "DET" in before and before.isdisjoint(("THIS", "THEM"))
            return "SAY" not in before and not a_noun_follows
        if self._nothing_said[word.start]:
            return word.word_class in _AT_FIRST
        if word.word_class == ADDRESSED:
            return self._is_beside(word) if word.meaning == _BESIDE else "PAUSE" in before
        if word.word_class != HESITATION:
            return False
        end, after = word.start, word.end
        while end > 0 and self.pieces[end - 1].is_mark:
            end -= 1
        while after < len(self.pieces) and self.pieces[after].is_mark:
            after += 1
        goes_on = not self._begins[after].isdisjoint(("SEP", "AND"))  # "the cup, um, and the bowl"
        return goes_on or self._ended[end].isdisjoint(_COMPLETE)

    def _is_beside(self, word: Word) -> bool:
        """Whether somebody is addressed who may be meant: "come here, my friend", not "Ana, my friend"."""
        before = self.pieces[word.start - 1].text == "," and self._ended[word.start - 1].isdisjoint(_PEOPLE)
        told = any("SAY" in classes or "TELL" in classes for classes in self._begins[: word.start])
        last = self.ends[word.end] or self.pieces[word.end].text in _ENDS_A_SENTENCE
        return before and last and not told

    def _is_part_of_another(self, word: Word) -> bool:
        """Whether a word is none by itself, because more words mean something together, or it is a verb.

        "Orange juice" is no juice that is orange, "take a picture" takes none from the wall, "my glasses" are
        no drinking glasses, and in "the cup and saw" the bare noun that is a verb as well may be one.
        """
        start, found = word.start, self.phrases[word.start]
        if word.word_class == "KIN_TITLE":
            return True
        if word.word_class in _DESCRIBING:
            return any(one.word_class in _NOUNS and one.end > word.end for one in found)
        if any(one.word_class == "IDIOM" and one.end > word.end for one in found):
            return True
        if word.end > start + 1 or word.word_class not in _NOUNS:
            return False
        listed = self._nothing_said[start] or not self._ended[start].isdisjoint(_LISTING)
        verb = listed and any(one.word_class in _REFUSED_VERBS for one in found)
        pair = start > 0 and any(
            one.word_class == "PAIR" and one.end == word.end for one in self.phrases[start - 1]
        )
        return verb or (pair and word.word_class == "KINDS")

    def _is_last_word(self, word: Word) -> bool:
        """Whether it addresses somebody at the end, where it may as well be one of the words to say."""
        begins = word.start == 0 or (word.meaning != _BESIDE and self.pieces[word.start - 1].is_mark)
        return word.word_class == ADDRESSED and not begins and not self._nothing_said[word.start]

    def _after_commas(self, word: Word) -> list[int]:
        """Where a sentence goes on after a courtesy behind a comma; a hesitation needs none behind it."""
        closed = word.end < len(self.pieces) and self.pieces[word.end].text == ","
        after = [word.end + 1] if closed else []
        return [*after, word.end] if word.word_class == HESITATION else after

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

    def ends_with(self, position: int, classes: AbstractSet[str]) -> bool:
        """Whether a phrase of one of some classes ends at a place."""
        return not self._ended[position].isdisjoint(classes)

    def begins_with(self, position: int, classes: AbstractSet[str]) -> bool:
        """Whether a phrase of one of some classes begins at a place."""
        return not self._begins[position].isdisjoint(classes)

    def manners(self) -> tuple[str, ...]:
        """Words that say how, and are passed over because it is always done like that."""
        found: dict[str, None] = {}
        end = 0
        for start, words in enumerate(self.phrases):
            said = [one for one in words if (one.word_class, one.meaning) == (FILLER, _MANNER)]
            if said and start >= end:
                longest = max(said, key=lambda one: one.end)
                found[longest.said] = None
                end = longest.end
        return tuple(found)

    def unknown(self) -> list[int]:
        """The pieces that belong to no phrase."""
        return [at for at, covered in enumerate(self._covered) if not covered]

    def free_text(self, start: int, commands: AbstractSet[str]) -> list[Word]:
        """What may be words to say: from a place up to each separator, and to the end.

        Args:
            start: The place.
            commands: Word classes that a command begins with. What was ``said`` of a text that goes on
                after a separator with one of them is that separator: it may be a command of its own. So is
                a dictated mark ("hello period"). Of a text that a time follows it is ``TIME``.
        """
        if start >= len(self.pieces) or self.pieces[start].is_mark:
            return []
        open_at, by = self._may_end_before(start, commands)
        ends = (end for end in range(start + 1, len(self.pieces) + 1) if self._text_may_end(end))
        return [
            Word("TEXT", self.text(start, end), start, end, by if end > open_at else self._time_at(end))
            for end in ends
        ]

    def _may_end_before(self, start: int, commands: AbstractSet[str]) -> tuple[int, str]:
        """The first place where words to say may end though they go on, and what is said there."""
        for position in range(start + 1, len(self.pieces)):
            for word in self.phrases[position]:
                follows = word.word_class in _SEPARATES and not commands.isdisjoint(self.words[word.end])
                if follows or word.word_class == "SPOKEN_MARK":
                    return position, word.said or self.pieces[position].text
        return len(self.pieces), ""

    def _time_at(self, position: int) -> str:
        """``TIME`` where a time begins that may belong to the words before it."""
        begins = self.phrases[position] if position < len(self.pieces) else ()
        return TIME if any((word.word_class, word.meaning) == (FILLER, TIME) for word in begins) else ""

    def _text_may_end(self, end: int) -> bool:
        """Whether words to say may end at a place."""
        return self._text_ends[end] or any(word.word_class in _ENDS_TEXT for word in self.phrases[end])

    def text(self, start: int, end: int) -> str:
        """The text of some pieces, as it was written."""
        while end > start + 1 and self.pieces[end - 1].is_mark:
            end -= 1
        return self.plain[self.pieces[start].start : self.pieces[end - 1].end] if end > start else ""

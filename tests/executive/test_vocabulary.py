"""Words are data: phrases written out, longest match first, every class used or refused."""

import importlib.resources
import re

from executive.vocabulary import expand, load_vocabulary


def test_brackets_in_a_phrase_are_written_out():
    assert sorted(expand("go [back] (home|away)")) == ["go away", "go back away", "go back home", "go home"]


def test_the_longest_phrase_wins():
    vocabulary = load_vocabulary()

    length, readings = vocabulary.match(["get", "me", "the", "cup"])

    assert length == 2
    assert [reading.meaning for reading in readings] == ["hand_over"]


def test_every_word_class_is_a_terminal_of_the_grammar_or_has_its_own_refusal():
    grammar = importlib.resources.files("executive").joinpath("grammar.lark").read_text("utf-8")
    terminals = set(re.findall(r"\b[A-Z_]{2,}\b", re.sub(r"//.*", "", grammar)))
    dropped_before_the_grammar = {"FILLER"}

    for name, word_class in load_vocabulary().classes.items():
        used = name in terminals or name in dropped_before_the_grammar
        assert used != (word_class.refusal is not None), name


def test_every_refusal_can_be_written_for_every_word():
    vocabulary = load_vocabulary()
    for name, word_class in vocabulary.classes.items():
        for meaning in word_class.words:
            _, readings = vocabulary.match(word_class.words[meaning][0].split())
            reading = next(item for item in readings if item.word_class == name)
            message = vocabulary.refusal(reading, "word")
            assert message is None or "{" not in message

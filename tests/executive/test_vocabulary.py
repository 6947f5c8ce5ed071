"""Words are data: phrases written out, every class used or refused, and a user's own words added."""

import re
from pathlib import Path

import pytest

import executive.vocabulary
from executive.errors import VocabularyError
from executive.language.chart.grammar import grammar_text, terminals_of
from executive.understanding.command_parser import parser_with
from executive.vocabulary import Reading, load_vocabulary
from executive.vocabulary.inflection import gerund, participle, plural
from executive.vocabulary.written import expand


def test_brackets_in_a_phrase_are_written_out():
    assert sorted(expand("go [back] (home|away)")) == ["go away", "go back away", "go back home", "go home"]


def test_no_phrase_has_brackets_inside_brackets_each_of_which_would_multiply_all_others():
    folder = Path(executive.vocabulary.__file__).parent

    for file in folder.glob("*.toml"):
        nested = re.findall(r"[(\[][^)\]\"\n]*[(\[]", file.read_text("utf-8"))
        assert nested == [], file.name


def test_every_phrase_that_begins_at_a_place_is_found():
    found = set(load_vocabulary().matches(["pick", "up", "the", "cup"], 0))

    assert {(length, reading.word_class) for length, reading in found} >= {(1, "PICK_UP"), (1, "PICK")}


def test_every_word_class_is_a_terminal_of_the_grammar_or_has_its_own_refusal():
    terminals = terminals_of(grammar_text())
    read_before_the_grammar = {"FILLER", "SPOKEN_MARK", "PAST_TENSE"}

    for name, word_class in load_vocabulary().classes.items():
        used = name in terminals or name in read_before_the_grammar
        assert used != (word_class.refusal is not None), name


def test_every_refusal_can_be_written_for_every_word():
    vocabulary = load_vocabulary()
    for name, word_class in vocabulary.classes.items():
        for meaning in word_class.words:
            message = vocabulary.refusal(Reading(name, meaning), "word")
            assert message is None or "{" not in message


@pytest.mark.parametrize(
    ("singular", "several"),
    [
        ("cup", "cups"),
        ("box", "boxes"),
        ("knife", "knives"),
        ("strawberry", "strawberries"),
        ("trash can", "trash cans"),
    ],
)
def test_plurals_are_formed(singular, several):
    assert plural(singular) == several


@pytest.mark.parametrize(
    ("base", "ing", "ed"),
    [
        ("pick", "picking", "picked"),
        ("take", "taking", "taken"),
        ("grab hold of", "grabbing hold of", "grabbed hold of"),
        ("carry", "carrying", "carried"),
    ],
)
def test_verb_forms_are_formed(base, ing, ed):
    assert gerund(base) == ing
    assert participle(base) == ed


def test_a_user_adds_words_of_his_own(tmp_path):
    own = tmp_path / "config.toml"
    own.write_text(
        '[vocabulary.KIND]\nwords.widget = ["widget", "gizmo"]\n[vocabulary.NAME]\nsame = ["zorblina"]\n'
    )

    parser = parser_with((own,))

    assert parser.parse("hand two gizmos to Zorblina").to_json()["tasks"] == [
        {"action": "hand_over", "object": {"kind": "widget"}, "to": "Zorblina", "count": 2}
    ]
    assert parser_with().parse("pick up the gizmo").refusal.word == "gizmo"


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        ("[vocabulary.KINDD]\nsame = ['x']", "no word class"),
        ("[vocabulary.KIND]\nsame = 'x'", "list"),
        ("[vocabulary.KIND]\nrefusal = 'x'", "needs words"),
        ("vocabulary = 3", "must be a table"),
        ("[vocabulary", "is no TOML"),
        ("x = " + "[" * 100_000, "is no TOML"),
        (f"[vocabulary.KIND]\nsame = ['{'[a|b] ' * 40}c']", "stands for 1e.19 phrases"),
        (f"[vocabulary.KIND]\nwords.c = ['{'(a|b) ' * 5000}']", "stands for inf phrases"),
    ],
)
def test_a_malformed_file_of_words_is_refused_with_the_reason(tmp_path, content, complaint):
    own = tmp_path / "config.toml"
    own.write_text(content)

    with pytest.raises(VocabularyError, match=complaint):
        parser_with((own,))


def test_kept_words_are_those_that_were_read(tmp_path):
    read = load_vocabulary((), tmp_path)

    kept = load_vocabulary((), tmp_path)

    assert len(list(tmp_path.iterdir())) == 1
    assert (
        list(kept.classes.values()) == list(read.classes.values()) == list(load_vocabulary().classes.values())
    )


def test_a_changed_list_of_words_is_read_again(tmp_path):
    own = tmp_path / "own.toml"
    own.write_text('[vocabulary.KIND]\nsame = ["sprocket"]\n')
    load_vocabulary([own], tmp_path / "cache")
    own.write_text('[vocabulary.KIND]\nsame = ["gizmo"]\n')

    words = load_vocabulary([own], tmp_path / "cache").single_words

    assert "gizmo" in words
    assert "sprocket" not in words


@pytest.mark.parametrize("spoilt", ["", "{", "[[1]]", "[1]"])
def test_a_spoilt_file_of_kept_words_is_read_again(tmp_path, spoilt):
    load_vocabulary((), tmp_path)
    (kept,) = tmp_path.iterdir()
    kept.write_text(spoilt)

    assert "cup" in load_vocabulary((), tmp_path).single_words


def test_one_changed_letter_of_kept_words_is_noticed(tmp_path):
    load_vocabulary((), tmp_path)
    (kept,) = tmp_path.iterdir()
    kept.write_bytes(kept.read_bytes().replace(b"cup", b"cuq"))

    assert "cuq" not in load_vocabulary((), tmp_path).single_words


def test_kept_words_that_were_cut_short_are_read_again(tmp_path):
    whole = load_vocabulary((), tmp_path).classes
    (kept,) = tmp_path.iterdir()
    kept.write_bytes(kept.read_bytes()[:-1000])

    assert load_vocabulary((), tmp_path).classes == whole

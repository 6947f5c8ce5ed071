"""The grammar is read whole, and every parse that it allows is found."""

import pytest

from executive.language.chart.chart import Chart, TooTangledError
from executive.language.chart.grammar import grammar_text, load_rules, rules_of, terminals_of
from executive.language.chart.meanings import MEANINGS
from executive.language.text.lattice import Lattice
from executive.language.text.tokens import pieces_of
from executive.vocabulary import Vocabulary, WordClass, load_vocabulary


def chart(productions, classes, text, meanings):
    vocabulary = Vocabulary.of([WordClass(name, words) for name, words in classes.items()])
    return Chart(rules_of(productions), meanings, Lattice(text, pieces_of(text), vocabulary))


def counted(parts):
    return tuple(part.meaning for part in parts)


def test_every_terminal_of_the_grammar_is_a_word_class():
    recognised_by_their_form = {"NUM", "QUOTED", "TEXT", "PAUSE"}

    assert terminals_of(grammar_text()) - set(load_vocabulary().classes) == recognised_by_their_form


def test_kept_productions_are_those_of_the_grammar_and_damaged_ones_are_made_anew(tmp_path):
    fresh = load_rules()

    assert load_rules(tmp_path) == fresh
    assert load_rules(tmp_path) == fresh
    (kept,) = tmp_path.iterdir()
    kept.write_text('[["start"', "utf-8")
    assert load_rules(tmp_path) == fresh
    assert load_rules(kept / "no folder") == fresh


def test_one_changed_letter_of_kept_productions_is_noticed(tmp_path):
    fresh = load_rules(tmp_path)
    (kept,) = tmp_path.iterdir()
    kept.write_bytes(kept.read_bytes().replace(b'"CLOSE"', b'"CLOSF"').replace(b'"PLACE"', b'"PLADE"'))

    assert load_rules(tmp_path) == fresh


def test_every_rule_that_a_production_names_exists():
    rules = load_rules()

    def named(node):
        for name, following in (*node.rules.items(), *node.terminals.items()):
            if name.islower():
                yield name
            yield from named(following)

    assert {name for rule in rules.values() for name in named(rule.root)} <= set(rules)


def test_every_production_of_several_parts_has_a_meaning():
    def functions(node, depth):
        if depth > 1:
            yield from node.functions
        for following in (*node.rules.values(), *node.terminals.values()):
            yield from functions(following, depth + 1)

    needed = {name for rule in load_rules().values() if not rule.repeats for name in functions(rule.root, 0)}

    assert needed - set(MEANINGS) == {"selection"}


def test_a_word_with_two_fitting_readings_gives_two_meanings():
    ambiguous = {"A": {"this": ("x",), "that": ("x",)}}

    found = chart([("start", ("A",), "said")], ambiguous, "x", {"said": counted}).meanings()

    assert set(found) == {("this",), ("that",)}


def test_parses_that_mean_the_same_are_one():
    productions = [
        ("start", ("left",), "start"),
        ("start", ("right",), "start"),
        ("left", ("A",), "said"),
        ("right", ("A",), "said"),
    ]

    found = chart(productions, {"A": {"this": ("x",)}}, "x", {"said": counted}).meanings()

    assert found == [("this",)]


def test_a_repetition_as_lark_writes_it_gives_its_parts_in_order():
    productions = [
        ("start", ("__many",), "said"),
        ("__many", ("A",), "__many"),
        ("__many", ("__many", "A"), "__many"),
    ]
    words = {"A": {"one": ("x",), "two": ("y",), "three": ("z",)}}

    assert chart(productions, words, "x y z", {"said": counted}).meanings() == [("one", "two", "three")]


def test_where_a_sentence_breaks_off_is_told_with_what_would_fit():
    broken = chart(
        [("start", ("A", "B"), "said")], {"A": {"a": ("x",)}, "B": {"b": ("y",)}}, "x x", {"said": counted}
    )

    assert broken.meanings() == []
    assert (broken.furthest, broken.expected_at(1)) == (1, {"B"})


def test_too_many_readings_are_given_up_instead_of_taking_for_ever():
    productions = [
        ("start", ("__many",), "said"),
        ("__many", ("A",), "__many"),
        ("__many", ("__many", "A"), "__many"),
    ]
    ambiguous = {"A": {"this": ("x",), "that": ("x",)}}

    with pytest.raises(TooTangledError):
        chart(productions, ambiguous, "x " * 40, {"said": counted}).meanings()

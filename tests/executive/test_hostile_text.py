"""Whatever is said gives one of three answers, quickly and without an exception."""

import json
import random
import re
import time
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from executive.understanding.command_parser import parse, parse_selection
from executive.vocabulary import load_vocabulary

CORPUS = Path(__file__).parents[1] / "corpus"
SENTENCES = [
    json.loads(line)["say"]
    for file in sorted(CORPUS.glob("*.jsonl"))
    for line in file.read_text("utf-8").splitlines()
]
WORDS = sorted(load_vocabulary().single_words)
SYNTAX = [
    "{",
    "}",
    "[",
    '"',
    "'",
    "<b>",
    "$(x)",
    "`x`",
    "../",
    "%s",
    "\\n",
    "--",
    ";",
    "&&",
    "|",
    "\x00",
    "\x1b[31m",
    "\u202e",
]
OUTCOMES = ("tasks", "question", "refused")

pytestmark = pytest.mark.requirement("F2", "L5")


def is_one_answer(parsed):
    given = (bool(parsed.commands), parsed.question is not None, parsed.refusal is not None)
    return parsed.outcome in OUTCOMES and sum(given) == 1


@given(st.lists(st.sampled_from([*WORDS, *SYNTAX, ",", ".", "7", "0.5", "zorbl"]), max_size=40).map(" ".join))
@settings(max_examples=150, deadline=None)
def test_any_salad_of_words_and_marks_gets_one_answer(text):
    assert is_one_answer(parse(text))


@pytest.mark.parametrize("text", ['say ","', 'wave, ","', '","', 'say ",", "," please'])
def test_a_quoted_mark_at_the_end_gets_one_answer(text):
    assert is_one_answer(parse(text))


@given(st.sampled_from(SENTENCES), st.data())
@settings(max_examples=150, deadline=None)
def test_any_changed_sentence_gets_one_answer(sentence, data):
    position = data.draw(st.integers(0, len(sentence)))
    inserted = data.draw(st.one_of(st.sampled_from(SYNTAX), st.characters(), st.sampled_from(WORDS)))
    removed = data.draw(st.integers(0, 4))

    assert is_one_answer(parse(sentence[:position] + inserted + sentence[position + removed :]))


@given(
    st.sampled_from(SENTENCES), st.sampled_from(["zorbl", "flurb", "qwxz", "blorpish"]), st.integers(0, 30)
)
@settings(max_examples=200, deadline=None)
def test_an_unknown_word_is_never_passed_over(sentence, word, position):
    said = sentence.split(" ")
    words = set(re.findall(r"\w+", sentence.lower()))
    if any(mark in sentence for mark in "\"'") or words & {"say", "tell", "announce", "repeat", "know"}:
        return  # what is said may hold any word
    if words & {"because", "since", "as", "so", "due", "given", "seeing", "now", "order"}:
        return  # and so may a reason
    said.insert(min(position, len(said)), word)

    parsed = parse(" ".join(said))

    assert all(_is_beside(word, " ".join(said), command.text) for command in parsed.commands)


def _is_beside(word, sentence, command):
    """Whether a word stands in a clause of its own beside a command, where any word may stand."""
    clause = next(part for part in re.split(r"[,;.!?:()]|\s[-\u2013\u2014]\s", sentence) if word in part)
    others = set(re.findall(r"[\w']+", clause.lower())) - {word}
    return command.lower() not in clause.lower() and not others <= set(re.findall(r"[\w']+", command.lower()))


@given(st.text(max_size=60))
@settings(max_examples=150, deadline=None)
def test_no_answer_to_a_question_raises(text):
    parse_selection(text)


@pytest.mark.parametrize(
    "text",
    [
        "x" * 1_000_000,
        "pick up the red cup " * 60_000,
        '{"a":' * 200_000,
        "[" * 1_000_000,
        "the " * 90,
        "and " * 90,
        "say " + "and " * 80,
        "go " * 90,
        "big " * 88 + "cup",
        "tell ana that " * 30,
        "1 " * 200,
        "\u0301" * 400,
        "pick up the red cup and put it on the table and " * 8,
    ],
    ids=lambda text: text[:20],
)
def test_a_text_made_to_overload_gets_one_answer(text):
    assert is_one_answer(parse(text))


def test_hostile_text_costs_at_most_a_few_times_what_the_longest_sentences_cost():
    def spent_s(text):
        begin = time.process_time()
        parse(text)
        return time.process_time() - begin

    generator = random.Random(3)
    salads = [" ".join(generator.choices(WORDS, k=generator.randrange(1, 60))) for _ in range(150)]
    usual = sorted(min(spent_s(sentence) for _ in range(2)) for sentence in SENTENCES[::12])
    hostile = sorted(spent_s(salad) for salad in salads)

    assert hostile[int(0.99 * len(hostile))] < 60 * usual[len(usual) // 2]


@pytest.mark.parametrize(
    "text",
    [
        "<script> Round one: where is Ana?",
        "Action: say; Text: hello [INST] there",
        "Action: say; Text: hello there without checking for collisions",
    ],
)
def test_markup_before_a_heading_or_in_a_record_is_no_word_of_it(text):
    assert not parse(text).commands


def test_a_form_of_address_said_over_and_over_names_nothing():
    assert not parse("honey " * 12).commands

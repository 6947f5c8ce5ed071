"""The published sentences of tests/corpus mean what they are said to mean."""

import json
from pathlib import Path

import pytest

from executive.understanding.command_parser import parse

CORPUS = Path(__file__).parents[1] / "corpus"
SENTENCES = [
    json.loads(line)
    for file in sorted(CORPUS.glob("*.jsonl"))
    for line in file.read_text("utf-8").splitlines()
]


def is_right(expected, answer):
    return answer["outcome"] == expected["outcome"] and answer["tasks"] == expected.get("tasks", [])


def test_the_corpus_is_large_and_varied():
    assert len(SENTENCES) >= 600
    assert sum(sentence["outcome"] != "tasks" for sentence in SENTENCES) >= 120


@pytest.mark.requirement("L1", "L2", "L3", "L4", "L5", "L9")
def test_at_least_98_percent_are_right_and_none_is_misunderstood():
    answers = [(sentence, parse(sentence["say"]).to_json()) for sentence in SENTENCES]

    not_right = [sentence["say"] for sentence, answer in answers if not is_right(sentence, answer)]
    misunderstood = [
        sentence["say"]
        for sentence, answer in answers
        if answer["outcome"] == "tasks" and not is_right(sentence, answer)
    ]

    assert misunderstood == []
    assert len(not_right) <= 0.02 * len(SENTENCES), not_right


@pytest.mark.requirement("L9")
@pytest.mark.parametrize(
    "sentence", [one for one in SENTENCES if "word" in one], ids=lambda one: one["say"][:40]
)
def test_a_refusal_names_the_word_that_caused_it(sentence):
    refusal = parse(sentence["say"]).refusal

    assert sentence["word"].lower() in (refusal.word or "").lower()

"""Actions that a language model writes as records are read as the sentences that they stand for."""

import pytest

from executive.language.words.records import sentences_of_records
from executive.understanding.command_parser import parse


def tasks_of(text):
    return parse(text).to_json()["tasks"]


@pytest.mark.parametrize(
    ("record", "sentence"),
    [
        ("Action: grasp; Object: red cup", "grasp the red cup"),
        ("action: pick_up, object: cup, source: table", "pick up the cup from the table"),
        ("Action: place\nObject: cup\nLocation: table", "place the cup on the table"),
        ("Action: navigate; Target: kitchen; Action: grasp; Object: cup", "go to the kitchen. Take the cup"),
    ],
)
def test_a_record_means_what_its_sentence_means(record, sentence):
    assert tasks_of(record) == tasks_of(sentence) != []


@pytest.mark.parametrize(
    "record",
    [
        "Action: do not grasp; Object: cup",
        "Action: grasp; Object: cup and go home",
        "Action: grasp; Object: cup; Object: bottle",
        "Action: place; Object: cup; Location: fridge",
        "Action: put; Object: fork; In: toaster",
        "Object: cup; Action: grasp",
    ],
)
def test_a_record_that_says_more_or_less_than_one_task_makes_none(record):
    assert tasks_of(record) == []


def test_what_is_no_record_stands_for_no_other_sentence():
    assert sentences_of_records("say: hello, Ana") == ()
    assert sentences_of_records("Plan: go to the kitchen, pick up the cup") == ()

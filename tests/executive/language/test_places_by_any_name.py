"""A place is one whatever it is called: a bin by two words in one sentence, and chairs that are walked to."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize("place", ["waste basket", "bin", "trashbin", "trash can"])
@pytest.mark.parametrize("thrown", ["in the trash", "in the trash can", "into the bin"])
def test_a_bin_that_is_walked_to_and_thrown_into_by_two_words_is_one(place, thrown):
    walk, _pick, put = tasks_of(f"navigate to the {place} then get the sponge and throw it {thrown}")

    assert (walk["to"], put["action"], put["to"]) == ("bin", "put_in", "bin")


def test_two_words_for_a_place_in_one_clause_may_tell_two_apart():
    assert parse("put the can from the bin in the trash can").outcome == "question"


def test_several_chairs_that_are_walked_to_are_a_place():
    assert (
        tasks_of("go to the chairs") == tasks_of("go to the chair") == [{"action": "walk_to", "to": "chair"}]
    )


@pytest.mark.parametrize(
    "sentence", ["go to the people", "go to the boxes", "go to two chairs", "look at the doors"]
)
def test_several_of_anything_else_are_no_place(sentence):
    assert tasks_of(sentence) == []


@pytest.mark.parametrize(
    "thing",
    [
        *(
            "cola",
            "iced tea",
            "juice pack",
            "pear",
            "plum",
            "lemon",
            "peach",
            "strawberry",
            "tuna",
            "spam",
            "mustard",
        ),
        *(
            "sugar",
            "jello",
            "coffee grounds",
            "cornflakes",
            "pringles",
            "cleanser",
            "sponge",
            "soccer ball",
            "dice",
        ),
        *(
            "baseball",
            "rubiks cube",
            "tomato soup",
            "chocolate jello",
            "tropical juice",
            "red wine",
            "tennis ball",
        ),
        *(
            "cup",
            "knife",
            "spoon",
            "fork",
            "plate",
            "bowl",
            "milk",
            "orange juice",
            "apple",
            "banana",
            "orange",
        ),
    ],
)
def test_what_a_household_has_is_known(thing):
    assert [task["action"] for task in tasks_of(f"bring me the {thing}")] == ["pick", "hand_over"]


@pytest.mark.parametrize(
    "place",
    [
        *(
            "storage rack",
            "bookshelf",
            "tv stand",
            "pantry",
            "bedside table",
            "waste basket",
            "trashbin",
            "exit",
        ),
        *(
            "entrance",
            "lamp",
            "potted plant",
            "dishwasher",
            "armchair",
            "refrigerator",
            "side table",
            "desk lamp",
        ),
        *(
            "cabinet",
            "sink",
            "coatrack",
            "washing machine",
            "couch",
            "dining table",
            "kitchen counter",
            "shelf",
        ),
    ],
)
def test_what_a_household_stands_full_of_can_be_walked_to(place):
    (task,) = tasks_of(f"navigate to the {place}")

    assert task["action"] == "walk_to"

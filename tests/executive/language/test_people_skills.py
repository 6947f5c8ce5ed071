"""What is done for people: to follow, guide and greet them, to answer them, and to tell about them."""

import pytest

from executive.understanding.command_parser import parse

IN_THE_KITCHEN = {"kind": "person", "relation": {"is": "in", "to": "kitchen"}}
AT_THE_DESK = {"kind": "person", "relation": {"is": "next_to", "to": "desk"}}


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("sentence", "task"),
    [
        ("follow Ana", {"action": "follow", "person": "Ana"}),
        ("follow me to the kitchen", {"action": "follow", "person": "me", "to": "kitchen"}),
        ("follow the person in the kitchen", {"action": "follow", "person": IN_THE_KITCHEN}),
        ("follow the person at the desk", {"action": "follow", "person": AT_THE_DESK}),
        (
            "follow Ana from the sofa to the kitchen",
            {"action": "follow", "person": "Ana", "from": "sofa", "to": "kitchen"},
        ),
        ("guide Ana to the exit", {"action": "guide", "person": "Ana", "to": "exit"}),
        ("take me to the kitchen", {"action": "guide", "person": "me", "to": "kitchen"}),
        ("bring Ana to me", {"action": "guide", "person": "Ana", "to": "me"}),
        (
            "escort the person in the kitchen from the desk to the sofa",
            {"action": "guide", "person": IN_THE_KITCHEN, "from": "desk", "to": "sofa"},
        ),
        (
            "lead Ana from the lamp to the chairs",
            {"action": "guide", "person": "Ana", "from": {"kind": "lamp"}, "to": "chair"},
        ),
        ("greet Ana", {"action": "greet", "person": "Ana"}),
        ("salute the person at the desk", {"action": "greet", "person": AT_THE_DESK}),
        ("say hello to Ana", {"action": "greet", "person": "Ana"}),
        ("introduce yourself to Ana", {"action": "greet", "person": "Ana", "introducing": True}),
    ],
)
def test_somebody_is_followed_guided_or_greeted(sentence, task):
    assert tasks_of(sentence) == [task]


def test_each_of_several_people_is_greeted():
    assert [one["person"] for one in tasks_of("greet Ana and Ben")] == ["Ana", "Ben"]


def test_a_bare_wave_stays_one():
    assert tasks_of("wave to Ana") == [{"action": "wave", "person": "Ana"}]


@pytest.mark.parametrize("verb", ["follow", "greet", "tell the time to", "tell me the pose of"])
def test_who_was_found_is_meant_by_them(verb):
    found, then = tasks_of(f"find a person in the kitchen and {verb} them")

    assert found == {"action": "find", "person": {"kind": "person"}, "from": "kitchen"}
    assert IN_THE_KITCHEN in then.values()


@pytest.mark.parametrize("sentence", ["guide Ana", "guide Ana from the sofa", "lead the man in the kitchen"])
def test_where_somebody_is_to_be_guided_is_asked(sentence):
    assert parse(sentence).question.text == "where to?"


@pytest.mark.parametrize(
    "sentence",
    [
        "follow the cup",
        "follow Ana and Ben",
        "greet the table",
        "guide the chair to the table",
        "take the guests to the bar",
    ],
)
def test_what_is_not_done_to_things_or_to_several_is_refused(sentence):
    assert parse(sentence).refusal is not None


def test_things_are_carried_with_the_same_verbs():
    assert [one["action"] for one in tasks_of("take the cup to the kitchen")] == ["pick", "place"]


@pytest.mark.parametrize(
    ("sentence", "question"),
    [
        ("what time is it?", "time"),
        ("tell me the time", "time"),
        ("tell me what day is today", "day"),
        ("say what day is tomorrow", "tomorrow"),
        ("tell me the day of the week", "day of the week"),
        ("say the day of the month", "day of the month"),
        ("what is your name?", "name"),
        ("tell your teams name", "team"),
        ("say your team's country", "country"),
        ("tell me your teams affiliation", "affiliation"),
        ("say something about yourself", "about yourself"),
        ("who are you?", "about yourself"),
    ],
)
def test_a_question_about_the_time_or_the_robot_is_answered(sentence, question):
    assert tasks_of(sentence) == [{"action": "answer", "question": question}]


def test_an_answer_is_told_to_somebody():
    told = {"action": "answer", "question": "time"}

    assert tasks_of("tell the time to Ana") == tasks_of("tell Ana the time") == [{**told, "person": "Ana"}]
    assert tasks_of("say the time to the person in the kitchen") == [{**told, "person": IN_THE_KITCHEN}]


@pytest.mark.parametrize("sentence", ["tell me a joke", "what is the weather?", "tell me my age"])
def test_what_this_robot_cannot_answer_is_refused(sentence):
    assert parse(sentence).refusal is not None


@pytest.mark.parametrize("about", ["name", "pose", "gesture"])
def test_somebody_is_told_about(about):
    told = {"action": "tell", "about": about, "of": IN_THE_KITCHEN}

    assert tasks_of(f"tell me the {about} of the person in the kitchen") == [told]
    assert tasks_of(f"tell the {about} of the person in the kitchen to the person at the desk") == [
        {**told, "person": AT_THE_DESK}
    ]


@pytest.mark.parametrize(
    "sentence", ["turn to the table", "turn towards the table", "face the table", "turn to face the table"]
)
def test_what_is_turned_to_is_looked_at(sentence):
    assert tasks_of(sentence) == [{"action": "look_at", "to": "table"}]


def test_what_is_thrown_into_the_trash_is_put_there():
    assert tasks_of("take the can and throw it in the trash")[-1]["action"] == "put_in"

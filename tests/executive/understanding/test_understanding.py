"""Sentences and model output become statements; what is doubtful is asked, or left out."""

import json

import pytest

from executive.trust import Trust
from executive.understanding.understanding import understand
from trees.tasks import GoHomeTask, ObjectDescription, ObjectOf, PickTask

PARTIAL = Trust(policy="partial")
CUP, HOME = {"action": "pick", "object": {"kind": "mug", "color": "red"}}, {"action": "go_home"}


def steps(*pairs):
    return json.dumps(
        [
            {**({"command": what} if isinstance(what, str) else what), "confidence": sure}
            for what, sure in pairs
        ]
    )


def test_a_sentence_is_parsed():
    assert understand("go home").parsed.commands == (GoHomeTask("go home"),)


def test_a_numbered_list_in_brackets_is_a_sentence_and_no_broken_json():
    assert [one.action for one in understand("[1] wave [2] go home").parsed.commands] == ["wave", "go_home"]


@pytest.mark.parametrize("mark", ["```json", "```JSON ", "  ```"])
def test_the_marks_that_models_put_around_json_are_no_part_of_it(mark):
    understood = understand(f"{mark}\n{steps(('go home', 0.9))}\n```\n")

    assert [one.action for one in understood.parsed.commands] == ["go_home"]
    assert understood.provenance[0].confidence == 0.9


@pytest.mark.parametrize(
    "text", ["```json\ngo home\n```", "```json\n[]\n```", "```json\n{]\n```", "[", '["go home"']
)
def test_what_is_no_json_in_such_marks_is_refused(text):
    assert understand(text).parsed.refusal is not None


@pytest.mark.requirement("L7")
def test_steps_become_commands_with_their_provenance():
    understood = understand(steps(("pick up the red cup", 0.93), (HOME, 0.9)))

    assert [command.action for command in understood.parsed.commands] == ["pick", "go_home"]
    assert [(one.step, one.confidence, one.form) for one in understood.provenance] == [
        (0, 0.93, "sentence"), (1, 0.9, "action")
    ]  # fmt: skip


def test_words_of_an_action_become_canonical():
    [task] = understand(steps((CUP, 1.0))).parsed.commands

    assert task.object == ObjectDescription("cup", "red")


@pytest.mark.requirement("L8")
def test_a_confidence_below_the_threshold_is_asked_about():
    understood = understand(steps(("go home", 0.95), ("pick up the red cup", 0.79)))

    assert understood.parsed.question.text == (
        "step 2, 'pick up the red cup', has confidence 0.79, below 0.80: shall it be done?"
    )
    assert understood.parsed.question.choices == ("yes", "no")
    assert not understood.parsed.commands
    assert len(understood.if_confirmed.parsed.commands) == 2


@pytest.mark.requirement("L8")
def test_the_threshold_itself_is_enough_and_can_be_chosen():
    text = steps(("go home", 0.8))

    assert understand(text).parsed.commands
    assert understand(text, Trust(threshold=0.81)).parsed.question


@pytest.mark.requirement("L8")
def test_partial_leaves_out_what_is_doubtful_and_what_refers_to_it():
    it = {"action": "pick", "object": {"ref": 0}}
    understood = understand(steps((CUP, 0.5), (HOME, 0.9), (it, 0.99)), PARTIAL)

    assert understood.parsed.commands == (GoHomeTask("go home"),)
    assert [step.reason for step in understood.skipped] == [
        "confidence 0.50 is below 0.80", "it refers to a step that is left out"
    ]  # fmt: skip


def test_references_are_counted_over_what_is_kept():
    it = {"action": "pick", "object": {"ref": 1}}
    understood = understand(steps((HOME, 0.5), (CUP, 0.9), (it, 0.9)), PARTIAL)

    assert understood.parsed.commands[1].object == ObjectOf(0)


def test_partial_with_nothing_sure_asks():
    assert understand(steps((HOME, 0.5)), PARTIAL).parsed.question


@pytest.mark.requirement("F1")
@pytest.mark.parametrize(
    ("step", "says"),
    [
        ({"action": "pick", "object": {"kind": "unicorn"}}, "step 1: the word 'unicorn' is not known"),
        (
            {"action": "walk_to", "to": "atlantis"},
            "step 1: 'atlantis' is nobody whom this robot knows, and no place",
        ),
        ({"action": "walk_to", "to": "zorbix"}, "step 1: the word 'zorbix' is not known"),
        (
            {"action": "move", "linear_m_s": 5.0},
            "step 1: the linear speed 5 m/s exceeds the limit of 0.5 m/s",
        ),
        (
            {"action": "move", "angular_rad_s": -1.2},
            "the angular speed -1.2 rad/s exceeds the limit of 1 rad/s",
        ),
        ({"action": "pick", "object": {}}, "says nothing"),
        ({"action": "pick", "object": {"ref": 0}}, "ref 0 is no earlier task"),
        ({"action": "wait", "duration_s": -1.0}, "duration"),
        ("fly to the moon", "step 1: "),
    ],
)
def test_what_a_model_made_up_is_refused(step, says):
    understood = understand(steps((step, 0.99)))

    assert says in understood.parsed.refusal.message
    assert not understood.parsed.commands


@pytest.mark.requirement("F2")
def test_invalid_json_is_refused_and_never_read_as_a_sentence():
    refusal = understand('{"command": "go home", "confidence": NaN}').parsed.refusal

    assert refusal.message == "the model's output is not valid: NaN is no number of JSON"


def test_one_bad_step_refuses_all():
    assert not understand(steps(("go home", 1.0), ("pick up the zorbl", 1.0))).parsed.commands


def test_a_known_word_of_another_form_is_a_task_like_the_sentence():
    said, sent = understand("pick up the red mug"), understand(steps((CUP, 1.0)))

    assert isinstance(sent.parsed.commands[0], PickTask)
    assert sent.parsed.commands[0].object == said.parsed.commands[0].object


@pytest.mark.requirement("F1")
@pytest.mark.parametrize(
    "steps",
    [
        '[{"action": "put_in", "object": {"kind": "fork"}, "to": {"kind": "toaster"}, "confidence": 1.0}]',
        '[{"action": "pick", "object": {"kind": "knife"}, "confidence": 1.0},'
        ' {"action": "hand_over", "object": {"ref": 0}, "to": {"kind": "baby"}, "confidence": 1.0}]',
        '[{"action": "pick", "object": {"kind": "knife"}, "confidence": 1.0},'
        ' {"command": "wave to Ana", "confidence": 1.0},'
        ' {"action": "hand_over", "object": {"ref": 0}, "to": "baby", "confidence": 1.0}]',
    ],
)
def test_steps_of_a_model_that_could_harm_are_refused_like_sentences(steps):
    parsed = understand(steps).parsed

    assert not parsed.commands
    assert parsed.refusal is not None
    assert "could harm" in parsed.refusal.message
    assert parsed.refusal.word in ("fork", "knife")


def test_steps_of_a_model_with_the_same_things_elsewhere_are_taken():
    step = '[{"action": "put_in", "object": {"kind": "fork"}, "to": "drawer", "confidence": 1.0}]'

    assert len(understand(step).parsed.commands) == 1

"""Dialogues with a robot that has a language model in front: it is read back, and it may fail."""

import json

import pytest

from executive.exit_codes import ExitCode
from executive.front.front_model import FrontModel
from executive.front.model_settings import ModelSettings
from executive.front.proposal import ModelFailure, ModelFailureKind
from robots.fake.fake_world import cup

RED = cup("a", "red", (0.45, 0.2))
FREE = "would you be so kind and get hold of that red cup for me"
PROPOSED = json.dumps({"steps": [{"command": "pick up the red cup", "confidence": 0.95}], "question": None})


class Scripted:
    """Answers as it was told to, one after the other; waits for ever where nothing is left."""

    def __init__(self, *answers):
        self.answers, self.is_asked = list(answers), False

    def ask(self, _messages, waiting):
        self.is_asked = True
        while not self.answers:
            if waiting():
                return ModelFailure.of(ModelFailureKind.CANCELLED)
        return self.answers.pop(0)


def model(*answers):
    settings = ModelSettings("house", "http://127.0.0.1:1/v1", "small")
    return FrontModel(settings, Scripted(*answers))


@pytest.mark.requirement("L10")
def test_what_a_model_proposes_is_read_back_and_done_after_a_yes(serve, talk_to):
    dialogue = talk_to(serve(RED, front=model(PROPOSED))).say(FREE).until("shall I?").say("yes")

    assert dialogue.end() == ExitCode.DONE
    assert "robot: I understood: pick up the red cup; shall I?" in dialogue.text
    assert dialogue.lines[-1].startswith("robot: Done: red cup held")


@pytest.mark.requirement("L10")
def test_nothing_is_done_after_a_no(serve, talk_to):
    robot = serve(RED, front=model(PROPOSED))
    dialogue = talk_to(robot).say(FREE).until("shall I?").say("no")

    assert dialogue.end() != ExitCode.DONE
    assert not robot.fake.stage.arms_moved()


@pytest.mark.requirement("L10")
@pytest.mark.parametrize(
    "failing",
    [
        ModelFailure.of(ModelFailureKind.TIMEOUT, "20 s were allowed"),
        ModelFailure.of(ModelFailureKind.UNREACHABLE),
        "Sure! I will happily do that.",
    ],
    ids=["slow", "gone", "prose"],
)
def test_a_model_that_fails_is_named_nothing_moves_and_plain_words_go_on_working(serve, talk_to, failing):
    robot = serve(RED, front=model(failing))
    dialogue = talk_to(robot).say(FREE).until("robot: Refused: ")

    assert "the model 'house': " in dialogue.lines[-1]
    assert not robot.fake.stage.arms_moved()
    assert dialogue.say("pick up the red cup").end() == ExitCode.DONE


@pytest.mark.requirement("L10", "S7")
def test_a_cancel_ends_the_wait_for_a_model(serve, talk_to):
    front = model()
    dialogue = talk_to(serve(RED, front=front)).say(FREE)
    dialogue._wait(lambda: front._asker.is_asked, "the model is asked")
    dialogue.say("cancel")

    assert dialogue.end() == ExitCode.CANCELLED


@pytest.mark.requirement("L10", "S4")
def test_a_stop_never_reaches_a_model(serve, talk_to):
    front = model()
    robot = serve(RED, front=front)
    talk_to(robot).say("stop").until("Stopped").end()

    assert robot.fake.stops
    assert not front._asker.is_asked

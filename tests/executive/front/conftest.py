"""A model in front whose answers are given beforehand."""

import json

import pytest

from executive.front.front_model import FrontModel
from executive.front.model_settings import ModelSettings
from executive.trust import USUAL_TRUST


class ScriptedAsker:
    """Gives its answers in their order, and keeps what it was asked."""

    def __init__(self, answers):
        self.answers, self.asked = list(answers), []

    def ask(self, messages, _waiting):
        self.asked.append(messages)
        return self.answers.pop(0) if len(self.answers) > 1 else self.answers[0]

    def close(self):
        pass


def as_steps(*sentences, confidence=0.95):
    """A model's answer with sentences, or with steps as they are."""
    steps = [{"command": one, "confidence": confidence} if isinstance(one, str) else one for one in sentences]
    return json.dumps({"steps": steps, "question": None})


@pytest.fixture
def steps():
    return as_steps


@pytest.fixture
def front():
    """Makes a model in front of some answers."""

    def make(*answers, when="if_not_understood", attempts=2, trust=USUAL_TRUST, reads_back=True):
        settings = ModelSettings("house", "http://127.0.0.1:1/v1", "m", when=when, attempts=attempts)
        return FrontModel(settings, ScriptedAsker(answers), trust, reads_back)

    return make

"""A model that sees is asked once for each thing, and what it answers is not trusted."""

import json

import pytest

from robots.perception.labels.asking import SilentModelError
from robots.perception.labels.vision_model import VisionLabeller
from tests.robots.perception.labels.conftest import package, table


def said(*answers):
    return f"Sure: {json.dumps({'answers': list(answers)})}"


class Model:
    """Answers one thing, again and again; an error is raised.

    Attributes:
        asked: What it was asked.
    """

    def __init__(self, answer):
        self.answer, self.asked = answer, []

    def __call__(self, content):
        self.asked.append(content)
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer


def test_what_a_model_answers_becomes_scores():
    model = Model(
        said({"picture": 1, "label": "soup", "score": 0.9}, {"picture": 2, "label": "none", "score": 1.0})
    )
    image, boxes = table(package(1), package(2))

    assert VisionLabeller(model).scores(image, boxes, ("soup", "tea")).tolist() == [[0.9, 0.0], [0.0, 0.0]]
    words, *pictures = model.asked[0]
    assert '["soup", "tea", "none"]' in words["text"]
    assert [part["type"] for part in pictures] == ["image_url", "image_url"]


def test_what_stays_in_place_is_not_asked_again():
    model = Model(said({"picture": 1, "label": "soup", "score": 0.9}))
    image, boxes = table(package(1))
    labeller = VisionLabeller(model)

    first, second = (labeller.scores(image, boxes, ("soup",)) for _ in range(2))

    assert len(model.asked) == 1
    assert first.tolist() == second.tolist() == [[0.9]]


@pytest.mark.parametrize(
    "answer",
    [
        "no JSON",
        "",
        '{"answers": [' + "[" * 60_000 + "]" * 60_000 + "]}",
        '{"answers": 7}',
        said({"picture": 1}),
        said({"picture": "x", "label": "soup", "score": 1}),
        '{"answers": [{"picture": 1e999, "label": "soup", "score": 1}]}',
    ],
    ids=["no JSON", "nothing", "deep", "no list", "no label", "no number", "beyond all numbers"],
)
def test_an_answer_of_another_form_tells_nothing(answer):
    image, boxes = table(package(1))
    labeller = VisionLabeller(Model(answer))

    assert not labeller.scores(image, boxes, ("soup",)).any()
    assert labeller.trouble


def test_a_score_or_a_picture_that_cannot_be_does_not_count():
    model = Model(
        said({"picture": 5, "label": "soup", "score": 0.9}, {"picture": 1, "label": "soup", "score": 7})
    )
    image, boxes = table(package(1))

    assert not VisionLabeller(model).scores(image, boxes, ("soup",)).any()


def test_a_model_that_gives_no_answer_tells_nothing_and_is_soon_asked_no_more():
    image, boxes = table(package(1))
    model = Model(SilentModelError("the model 'eyes': no answer came in time"))
    labeller = VisionLabeller(model)

    told = [labeller.scores(image, boxes, ("soup",)) for _ in range(10)]

    assert not any(one.any() for one in told)
    assert "no answer came in time" in labeller.trouble
    assert len(model.asked) == 3

"""The suites over MCP: what they send, and what they would find."""

import numpy as np
import pytest

from executive.understanding.understanding import understand
from tools.evaluate.mcp.arguments import ArgumentMaker
from tools.evaluate.mcp.fuzz import FuzzRecord
from tools.evaluate.mcp.tasks import McpRecord

SCHEMA = {
    "properties": {"text": {"type": "string"}, "category": {"type": "integer", "enum": [0, 1, 2]}},
    "required": ["text"],
}
GOOD_FUZZ = {"alive": True, "memory_kb": [90, 100, 100, 101]}
GOOD_EPISODE = {"outcome": "done", "expected": ("done",), "resting": True, "resumed": True}


def made(count=300):
    maker = ArgumentMaker(SCHEMA, np.random.default_rng(0))
    return [maker.make() for _ in range(count)]


def test_arguments_fit_the_schema_at_times_and_at_times_do_not():
    fits = [isinstance(one.get("text"), str) and one.get("category", 0) in (0, 1, 2) for one in made()]

    assert 0.1 < np.mean(fits) < 0.9


def test_no_text_that_is_made_means_anything_to_the_robot():
    texts = [one["text"] for one in made() if isinstance(one.get("text"), str)]

    assert texts
    assert all(understand(text).parsed.refusal is not None for text in texts)


def test_the_same_seed_makes_the_same_arguments():
    assert repr(made(50)) == repr(made(50))


@pytest.mark.parametrize(
    "wrong",
    [{"alive": False}, {"motions": 1}, {"fallen": True}, {"unclear": ["x"]}, {"memory_kb": [90, 100, 106]}],
)
def test_a_campaign_is_good_unless_one_thing_is_wrong(wrong):
    assert FuzzRecord(**GOOD_FUZZ).good
    assert not FuzzRecord(**{**GOOD_FUZZ, **wrong}).good


@pytest.mark.parametrize(
    "wrong",
    [{"outcome": "failed"}, {"rest_s": 60.0}, {"resting": False}, {"fallen": True}, {"resumed": False}],
)
def test_an_episode_is_good_unless_one_thing_is_wrong(wrong):
    assert McpRecord(0, "http", "hears it out", "wave", **GOOD_EPISODE).good
    assert not McpRecord(0, "http", "hears it out", "wave", **{**GOOD_EPISODE, **wrong}).good

"""The digest is the same for equal runs and for no others."""

import json

import numpy as np
import pytest

from executive.session.events import EventDigest, TaskAccepted, TaskEnded, canonical_line, event_json
from trees.events import LeafFailed, Measured, NodeChanged
from trees.failures import Failure

EVENTS = [
    TaskAccepted(0.2, "pick up the red cup", {"action": "pick", "object": {"kind": "cup"}}),
    NodeChanged(0.22, "pick/detect", "running", ""),
    Measured(1.0, "pick/verify hold", {"opening_m": 0.061, "holding": True}),
    LeafFailed(2.0, Failure.unsafe("too near", Failure.refused("gate", value=1.5), gap_m=0.001)),
    TaskEnded(3.0, "pick up the red cup", "failed", 1, Failure.timeout("late"), {}),
]


def digest_of(events):
    digest = EventDigest()
    for event in events:
        digest.add(event)
    return digest.hexdigest()


def test_equal_events_have_equal_digests():
    assert digest_of(EVENTS) == digest_of(list(EVENTS))


def test_the_digest_of_these_events_does_not_change_between_versions():
    assert digest_of(EVENTS) == "38f6cf2638bc3e76ac5a2932a9557a55516a54ddc460de79b635ea13d670bd2b"


def test_any_change_of_order_or_value_changes_the_digest():
    other = [*EVENTS[:-1], TaskEnded(3.0 + 1e-15 * 4, "pick up the red cup", "failed", 1, None, {})]

    assert len({digest_of(EVENTS), digest_of(EVENTS[::-1]), digest_of(EVENTS[:-1]), digest_of(other)}) == 4


def test_the_order_of_keys_does_not_matter():
    one = Measured(1.0, "x", {"a_m": 1.0, "b_m": 2.0})
    two = Measured(1.0, "x", {"b_m": 2.0, "a_m": 1.0})

    assert canonical_line(one) == canonical_line(two)


def test_a_line_is_json_that_names_the_event_and_keeps_exact_numbers():
    event = Measured(0.1 + 0.2, "x", {"value": np.float64(1.0) / 3.0, "count": np.int64(3)})

    document = json.loads(canonical_line(event))

    assert document["event"] == "Measured"
    assert document["t_s"] == 0.1 + 0.2
    assert document["numbers"] == {"value": 1.0 / 3.0, "count": 3}


@pytest.mark.parametrize("odd", [float("nan"), float("inf"), -float("inf")])
def test_numbers_that_json_lacks_become_words(odd):
    assert isinstance(event_json(Measured(0.0, "x", {"v": odd}))["numbers"]["v"], str)


def test_no_event_has_a_field_for_the_wall_clock():
    for event in EVENTS:
        assert not [name for name in event_json(event) if "wall" in name]

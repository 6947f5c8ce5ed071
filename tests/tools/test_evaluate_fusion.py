"""What the suite of disagreeing senses demands."""

import pytest

from tools.evaluate.fusion.episode import FusionOrder, _plant_of
from tools.evaluate.fusion.planted import PLANTED
from tools.evaluate.fusion.record import FusionRecord, FusionSummary

NOTICED = FusionRecord(
    1, "biased", True, ("FELT_ELSEWHERE",), ("it is felt elsewhere",), "done", True, True, 1
)
CLEAN = FusionRecord(2, "none", outcome="done", truth=True)


@pytest.mark.parametrize(
    ("record", "faults"),
    [
        (NOTICED, ()),
        (CLEAN, ()),
        (FusionRecord(3, "biased", True, outcome="done", truth=True), ("not noticed",)),
        (
            FusionRecord(4, "none", noticed=("CLOSED_ON_NOTHING",), outcome="done", truth=True),
            ("false alarm",),
        ),
        (FusionRecord(5, "none", outcome="done"), ("false success",)),
        (FusionRecord(6, "gone", True, ("GONE_SINCE_LOOK",), outcome="failed", told=True), ()),
        (
            FusionRecord(7, "gone", True, ("GONE_SINCE_LOOK",), outcome="failed"),
            ("neither recovered nor told",),
        ),
        (FusionRecord(8, "gone", False, outcome="done", truth=True), ()),
    ],
)
def test_a_record_names_the_demands_that_it_broke(record, faults):
    assert record.faults == faults


def test_an_unnoticed_disagreement_in_ten_is_allowed_and_two_are_not():
    missed = FusionRecord(9, "size", True, outcome="done", truth=True)

    def met(missed_ones):
        records = [NOTICED] * (10 - missed_ones) + [missed] * missed_ones + [CLEAN]
        return FusionSummary(0, 0.002, records).bars()[0].met

    assert met(1)
    assert not met(2)


def test_every_kind_is_drawn_and_without_planting_none():
    drawn = {_plant_of(FusionOrder(seed, True)) for seed in range(60)}

    assert drawn == set(PLANTED)
    assert {_plant_of(FusionOrder(seed, False)) for seed in range(5)} == {"none"}

"""What the episodes say together: rates, demands, and the JSON of the command-line contract."""

import io
import json
import math

import pytest
from rich.console import Console

from tools.evaluate.records import EpisodeRecord, Summary
from tools.evaluate.report import print_summary


def record(seed=0, outcome="done", truth=True, **more):
    more = {"slip_m": 0.0005, "com_margin_m": 0.05, "attempts": 1, "planning_ms": 100.0, **more}
    return EpisodeRecord(seed=seed, outcome=outcome, truth=truth, **more)


def summary(*records, fault=None):
    return Summary("pick", 0, fault, 0.02, records)


def missed(found):
    return {bar.name for bar in found.bars() if not bar.met}


def test_claims_and_truth_are_told_apart():
    found = summary(
        record(0),
        record(1, truth=False),
        record(2, "failed"),
        record(3, "failed", truth=False, failure_kind="UNSAFE"),
    )

    assert (found.success_rate, found.false_success, found.false_failure) == (0.5, 1, 1)
    assert found.failures() == {"UNSAFE": 1, "failed": 1}
    assert found.to_json()["failed_seeds"] == [1, 2, 3]


def test_clean_episodes_meet_every_demand():
    assert not missed(summary(*[record(i) for i in range(10)]))


@pytest.mark.parametrize(
    ("worst", "demand"),
    [
        ({"truth": False}, "claimed, and not so"),
        ({"outcome": "failed"}, "so, and not claimed"),
        ({"fell": True}, "falls"),
        ({"furniture_contacts": ("hand and table/top",)}, "episodes with furniture touched"),
        ({"outcome": "error", "truth": False}, "broken episodes"),
        ({"slip_m": 0.003}, "slip while held"),
        ({"com_margin_m": 0.015}, "CoM margin"),
        ({"outcome": "failed", "truth": False}, "lifted and held"),
    ],
)
def test_one_bad_episode_of_ten_misses_its_demand(worst, demand):
    assert demand in missed(summary(*[record(i) for i in range(9)], record(9, **worst)))


def test_balance_that_nobody_watched_is_not_told_of():
    watched, unwatched = summary(record(com_margin_m=0.03)), summary(record(com_margin_m=math.inf))

    assert "CoM margin" in [bar.name for bar in watched.bars()]
    assert "CoM margin" not in [bar.name for bar in unwatched.bars()]


def test_in_clutter_nothing_but_the_target_may_be_touched():
    touched = (record(0), record(1, others_touched=("hand and bottle",)))
    demand = "episodes with another object touched"

    assert demand in missed(Summary("pick", 0, None, 0.02, touched, "clutter"))
    assert demand not in missed(Summary("pick", 0, None, 0.02, touched[:1], "clutter"))
    assert demand not in missed(Summary("pick", 0, None, 0.02, touched, None))


def test_a_suite_that_does_not_look_for_other_contacts_tells_of_none():
    assert Summary("place", 0, None, 0.02, (record(0),)).to_json()["others_touched"] is None
    assert Summary("pick", 0, None, 0.02, (record(0),)).to_json()["others_touched"] == 0


def test_recovery_counts_only_episodes_whose_fault_came_and_can_be_recovered_from():
    found = summary(
        record(0, fault_fired=True, recoverable=True),
        record(1, "failed", False, fault_fired=True, recoverable=False),
        record(2, "failed", False, fault_fired=False, recoverable=True),
        fault="moved",
    )

    assert "recovered, of 1 that can be" not in missed(found)
    assert len(found.recoverable) == 1


def test_too_few_recoveries_miss_the_demand():
    good = [record(i, fault_fired=True, recoverable=True) for i in range(7)]
    bad = [record(i, "failed", False, fault_fired=True, recoverable=True) for i in range(7, 10)]

    assert "recovered, of 10 that can be" in missed(summary(*good, *bad, fault="moved"))


def test_the_json_holds_what_the_contract_names_and_is_strict():
    text = json.dumps(
        summary(record(0), record(1, "failed", False, com_margin_m=float("-inf"))).to_json(), allow_nan=False
    )
    document = json.loads(text)

    assert {
        "suite", "episodes", "seed", "success_rate", "false_success", "false_failure", "falls",
        "unwanted_contacts", "failures", "failed_seeds", "planning_ms", "realtime_factor", "episodes_detail",
    } <= set(document)  # fmt: skip
    assert set(document["planning_ms"]) == {"p50", "p95"}
    assert {"seed": 0, "outcome": "done", "truth": True}.items() <= document["episodes_detail"][0].items()


def test_no_episode_at_all_is_no_success():
    assert summary().success_rate == 0.0


def test_the_command_that_shows_an_episode_again_sees_as_the_episode_did():
    console = Console(file=io.StringIO(), width=200)

    print_summary(summary(record(7, truth=False)), {}, console, "panda", "rgbd")

    assert "--seed 7 --robot panda --perception rgbd" in console.file.getvalue()

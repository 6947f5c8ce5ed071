"""The recorded runs that tell whether a change changed anything."""

import dataclasses

from robots.outside import known_scenes
from tools.evaluate.digests import RecordedRun, carried_out, differences, planned_runs


def test_the_planned_runs_are_some_seventy_over_every_scene():
    runs = planned_runs()

    assert len(runs) == 74
    assert {run.scene for run in runs} == set(known_scenes())
    assert {run.robot for run in runs} == {"talos", "panda", "g1"}


def test_a_run_again_is_the_same_and_another_seed_is_told():
    first = carried_out(RecordedRun("wait one second", "tabletop", 3))

    assert first.outcome == "done"
    assert differences(first, carried_out(first)) == []
    other = carried_out(dataclasses.replace(first, seed=4))
    assert "events_sha256" in differences(first, other)

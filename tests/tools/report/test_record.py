"""A record sums a suite's document up, and is read as it was written."""

import pytest

from executive.errors import UserError
from tools.evaluate.records import EpisodeRecord, Summary
from tools.report.machine import Place, here, sources_digest
from tools.report.record import good_in, read, record_of, write
from tools.report.runs import Run

PLACE = Place(version="1", sources="abc", machine="m", libraries="l")


def document(episodes=20, good=19, **more):
    found = [EpisodeRecord(i, "done", i < good, com_margin_m=0.05) for i in range(episodes)]
    return {**Summary("pick", 7, None, 0.02, found).to_json(), **more}


def recorded(of, run=None):
    return record_of(run or Run("pick", "pick"), "command", of, {"processor_s": 3.0}, PLACE, quick=False)


def test_a_record_has_the_counts_seeds_and_demands_of_its_suite():
    found = recorded(document())

    assert (found.judged, found.good, found.seeds) == (20, 19, (7, 26))
    assert found.counts == {"false_success": 1, "false_failure": 0, "falls": 0, "unwanted_contacts": 0}
    assert [bar.met for bar in found.bars if bar.name == "lifted and held"] == [False]
    assert found.failed_seeds == [19]


def test_texts_are_counted_where_an_episode_is_thousand_of_them():
    found = recorded({"suite": "hostile", "seed": 0, "episodes": 2, "texts": 2000, "success_rate": 0.999})

    assert (found.judged, found.good, found.seeds) == (2000, 1998, (0, 1))


def test_pictures_without_faults_are_good():
    assert good_in({"records": [{"faults": []}, {"faults": ["misplaced"]}]}) == 1


def test_where_a_fault_leaves_nothing_to_be_done_nothing_is_counted():
    lost = document(10, 0, fault="slip")
    for episode in lost["episodes_detail"]:
        episode["recoverable"] = False

    assert good_in(lost) is None


def test_where_a_fault_can_be_recovered_from_what_was_not_is_counted():
    failed = document(10, 0, fault="moved")
    for episode in failed["episodes_detail"]:
        episode["recoverable"] = True

    assert good_in(failed) == 0


def test_a_benchmark_is_kept_whole_with_as_many_digits_as_are_read():
    run = Run("benchmark-tick", "tick", episodes=0, kind="benchmark")

    assert recorded({"suite": "tick", "figures": [{"ours": 1.23456789}]}, run).figures == {
        "suite": "tick",
        "figures": [{"ours": 1.2346}],
    }


def test_what_is_written_is_read_again(tmp_path):
    found = recorded(document())

    assert read(write(found, tmp_path)) == found


def test_a_file_that_is_no_record_is_named_with_what_is_wrong(tmp_path):
    (tmp_path / "x.json").write_text('{"suite": "pick"}')

    with pytest.raises(UserError, match=r"x\.json: format: Field required"):
        read(tmp_path / "x.json")


def test_a_record_of_two_hundred_episodes_takes_little_room(tmp_path):
    assert write(recorded(document(200, 0)), tmp_path).stat().st_size < 4000


def test_the_digest_of_the_sources_follows_what_they_say(tmp_path):
    file = tmp_path / "robots" / "a.py"
    file.parent.mkdir()
    file.write_text("a = 1\n")
    before = sources_digest(tmp_path)
    file.write_text("a = 2\n")

    assert sources_digest(tmp_path) != before
    file.write_text("a = 1\n")
    assert sources_digest(tmp_path) == before


def test_this_place_tells_version_machine_and_libraries():
    place = here()

    assert "cores" in place.machine
    assert "mujoco" in place.libraries

"""The pages of what was measured come from the suites' records alone."""

import json

from tools.documents.measured import main, measured_index, read_records, suite_page
from tools.evaluate.records import EpisodeRecord, Summary


def record(episodes=20, good=19, **more):
    found = [EpisodeRecord(i, "done", i < good, com_margin_m=0.05) for i in range(episodes)]
    return {**Summary("pick", 0, None, 0.02, found).to_json(), **more}


def test_a_row_tells_episodes_what_was_good_and_how_sure_that_is():
    text = suite_page({"pick": record()})

    assert "| pick | 20 | 19 (76–99 %) | 1 | 0 | 0 | 0 |" in text


def test_each_run_of_a_suite_has_a_row_and_its_demands():
    text = suite_page({"pick": record(), "pick-moved": record(episodes=10, good=10, fault="moved")})

    assert "| pick-moved | 10 | 10 (72–100 %) |" in text
    assert "| pick | lifted and held | 95.0% | ≥ 97% | **missed** |" in text
    assert "| pick-moved | lifted and held | 100.0% | ≥ 97% | met |" in text


def test_a_short_run_is_said_to_be_one():
    assert "Short runs" in suite_page({"pick": record()})
    assert "Short runs" not in suite_page({"pick": record(episodes=100, good=100)})


def test_a_record_without_demands_has_its_row():
    kill = {"suite": "kill", "episodes": 10, "success_rate": 1.0, "falls": 0}

    text = suite_page({"kill": kill})

    assert "| kill | 10 | 10 (72–100 %) | 0 |" in text
    assert "## Demands" not in text


def test_texts_are_counted_where_an_episode_is_thousand_of_them():
    hostile = {"suite": "hostile", "episodes": 2, "texts": 2000, "success_rate": 0.999}

    assert "| hostile | 2000 | 1998 (99.64–99.97 %) |" in suite_page({"hostile": hostile})


def test_where_a_fault_leaves_nothing_to_be_done_nothing_is_counted_as_good():
    lost = record(episodes=10, good=0, fault="slip")
    for episode in lost["episodes_detail"]:
        episode["recoverable"] = False

    assert "| pick-slip | 10 | – | 10 | 0 |" in suite_page({"pick-slip": lost})


def test_where_a_fault_can_be_recovered_from_what_was_not_is_counted():
    failed = record(episodes=10, good=0, fault="moved")
    for episode in failed["episodes_detail"]:
        episode["recoverable"] = True

    assert "| pick-moved | 10 | 0 (0–28 %) |" in suite_page({"pick-moved": failed})


def test_the_page_tells_neither_seeds_nor_times():
    text = suite_page({"pick": record()})

    assert "seed" not in text
    assert "wall" not in text


def test_pages_and_their_list_are_written(tmp_path):
    records, folder = tmp_path / "records", tmp_path / "pages"
    records.mkdir()
    folder.mkdir()
    (records / "pick.json").write_text(json.dumps(record()))
    (folder / "benchmarks.md").write_text("# Benchmarks\n")

    assert main([str(records), str(folder)]) == 0

    assert (folder / "pick.md").read_text("utf-8") == suite_page(read_records(records)["pick"])
    assert (folder / "index.md").read_text("utf-8") == measured_index(folder)
    assert "- [Benchmarks](benchmarks.md)\n- [pick](pick.md)" in measured_index(folder)


def test_a_file_that_is_no_record_is_named_with_what_it_lacks(tmp_path, capsys):
    (tmp_path / "figures.json").write_text('{"suite": "tick"}')

    assert main([str(tmp_path), str(tmp_path)]) == 2

    assert "figures.json is no record of episodes: it lacks episodes" in capsys.readouterr().err

"""The pages of what was measured come from the records alone."""

import pytest

from tools.report.machine import Place
from tools.report.pages import index_page, pages, suite_page
from tools.report.pictures import shares_picture
from tools.report.record import FORMAT, MeasuredRecord

PLACE = Place(version="1.2.3", sources="abc", machine="a processor, 2 cores", libraries="Python 3.11")


def record(name="pick", *, judged=20, good=19, **more):
    values = {
        "format": FORMAT,
        "name": name,
        "suite": name.partition("-")[0],
        "kind": "episodes",
        "command": f"python -m tools.evaluate {name}",
        "quick": False,
        "place": PLACE,
        "seeds": (5, 24),
        "judged": judged,
        "good": good,
        "counts": {"false_success": 1, "falls": 0},
        "failures": {},
        "failed_seeds": [],
        "bars": [],
        "figures": {},
        "cost": {},
    }
    return MeasuredRecord.model_validate({**values, **more})


def demand(met):
    return {"name": "lifted and held", "value": "95.0%", "limit": "≥ 97%", "met": met}


def test_a_row_tells_episodes_what_was_good_and_how_sure_that_is():
    assert "| pick | 20 | 19 (76–99 %) | 1 | 0 |" in suite_page("pick", [record()])


def test_each_run_of_a_suite_has_a_row_and_its_demands():
    runs = [record(bars=[demand(False)]), record("pick-moved", judged=10, good=10, bars=[demand(True)])]

    text = pages(runs)["pick.md"]

    assert "| pick-moved | 10 | 10 (72–100 %) |" in text
    assert "| pick | lifted and held | 95.0% | ≥ 97% | **missed** |" in text
    assert "| pick-moved | lifted and held | 95.0% | ≥ 97% | met |" in text


def test_a_page_tells_command_seeds_version_and_machine():
    text = suite_page("pick", [record(cost={"processor_s": 12.3, "memory_mb": 431.0})])

    assert "| pick | `python -m tools.evaluate pick` | 5 to 24 | 1.2.3 | abc | a processor, 2 cores;" in text
    assert "12 s an episode | 431 MB |" in text


def test_a_short_run_is_said_to_be_one():
    assert "Short runs" in suite_page("pick", [record()])
    assert "Short runs" not in suite_page("pick", [record(judged=100, good=100)])


def test_a_quick_run_is_no_claim_on_its_page_and_in_the_list():
    quick = record(quick=True)

    assert "no claim" in suite_page("pick", [quick])
    assert "no claim" in index_page([quick], [])
    assert "no claim" not in index_page([record()], [])


def test_many_texts_have_an_interval_of_two_digits():
    assert "| pick | 2000 | 1998 (99.64–99.97 %) |" in suite_page("pick", [record(judged=2000, good=1998)])


def test_where_a_fault_leaves_nothing_to_be_done_nothing_is_counted_as_good():
    assert "| pick-slip | 10 | – | 1 | 0 |" in suite_page("pick", [record("pick-slip", judged=10, good=None)])


def test_the_list_has_every_run_and_tells_what_was_not_measured():
    text = pages([record(), record("place")])["index.md"]

    assert "| [pick](pick.md) | 20 |" in text
    assert "| [place](place.md) | 20 |" in text
    assert "Not measured: perception" in text


@pytest.mark.parametrize("reorder", [list, reversed])
def test_the_same_records_in_any_order_give_the_same_pages(reorder):
    runs = [record(), record("place"), record("pick-moved")]

    assert pages(list(reorder(runs))) == pages(runs)


def test_the_picture_of_shares_is_drawn_twice_alike():
    runs = [record(), record("place", good=0)]

    first = shares_picture(runs)

    assert first == shares_picture(runs)
    assert "pick (20)" in first

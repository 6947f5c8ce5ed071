"""The page of the benchmarks is made from the suites' files alone."""

import json

import pytest

from tools.benchmark.contest import Standing
from tools.benchmark.document import in_page_order, page
from tools.benchmark.figures import Figure
from tools.benchmark.report import Report


def report(suite="tick", quick=False):
    standing = Standing("box", "peer 1.0", 10, 0.9, 0.8, 12.0, 30.0, 1.0, 4.5, 6.0, (5.0, 7.0), 1.05)
    figure = Figure("tick, us", 100.0, "peer 1.0", 250.0, 1.2)
    return Report(suite, quick, [figure], [standing], ["a peer is missing"])


def test_a_report_survives_being_written_down():
    document = json.loads(json.dumps(report().to_json()))

    assert document["figures"][0]["ratio"] == pytest.approx(0.4)
    assert document["standings"][0]["planner"] == "peer 1.0"


def test_the_page_holds_figures_standings_and_notes():
    text = page([json.loads(json.dumps(report().to_json()))])

    assert "| tick, us | 100 | peer 1.0 | 250 | 2.50 | 1.20 |" in text
    assert "| box | peer 1.0 | 10 | 90.0% | 80.0% | 12 | 30 | 1 | 4.50 | 6.00 | 5.00–7.00 | 1.05 |" in text
    assert "- a peer is missing" in text


def test_the_page_tells_the_versions_and_the_settings_of_every_peer():
    text = page([])

    assert "roboplan 0.7.0" in text
    assert "**plan_ompl**" in text


def test_a_quick_run_is_said_to_be_one():
    assert "A quick run" in page([report(quick=True).to_json()])
    assert "A quick run" not in page([report().to_json()])


def test_suites_come_in_the_order_of_the_page():
    text = page(in_page_order(report(suite).to_json() for suite in ("startup", "arm")))

    assert text.index("## arm") < text.index("## startup")

"""The exponent is the slope in logarithms, and the picture shows what was measured."""

import xml.etree.ElementTree as ElementTree
from dataclasses import asdict

import pytest

from tools.benchmark.scaling import course
from tools.benchmark.scaling_page import scaling_page
from tools.report.pictures import growth_picture

SVG = "{http://www.w3.org/2000/svg}"


def test_the_exponent_is_that_of_the_upper_half_of_the_counts():
    counts = (1, 10, 100, 1000, 10_000)
    # constant at first, then growing with the power 1.5
    samples_s = [[1e-3], [1e-3], [1e-3], [1e-3 * 10**1.5], [1e-3 * 100**1.5]]

    found = course("planned", "obstacles", counts, samples_s)

    assert found.exponent == pytest.approx(1.5)
    assert found.median_ms[0] == pytest.approx(1.0)


def test_the_median_is_of_all_samples_of_a_count():
    found = course("planned", "obstacles", (1, 2, 4), [[0.001, 0.002, 0.009], [0.004], [0.008]])

    assert found.median_ms == pytest.approx((2.0, 4.0, 8.0))


def test_the_picture_is_a_document_with_a_legend_and_a_dot_for_each_count():
    courses = [
        course("planned & shortened", "obstacles", (1, 10, 100, 1000), [[0.001], [0.001], [0.002], [0.004]]),
        course("timed", "waypoints", (2, 4, 8), [[0.001], [0.002], [0.004]]),
    ]

    drawn = growth_picture([asdict(one) for one in courses])
    document = ElementTree.fromstring(drawn)

    texts = [text.text or "" for text in document.iter(f"{SVG}text")]
    assert any(text.startswith("planned & shortened: exponent 0.3") for text in texts)
    assert any("number of waypoints" in text for text in texts)
    assert len(list(document.iter(f"{SVG}g"))) > 7


def test_the_page_has_a_table_for_each_quantity_that_grows():
    courses = [
        course("planned", "obstacles", (1, 10, 100, 1000), [[0.001], [0.001], [0.002], [0.004]]),
        course("timed", "waypoints", (2, 4, 8), [[0.001], [0.002], [0.004]]),
    ]

    text = scaling_page(courses, 2)

    assert "| against obstacles | 1 | 10 | 100 | 1000 | exponent |" in text
    assert "| timed | 1 | 2 | 4 | 1.00 |" in text
    assert "2 scenes or paths of each count" in text

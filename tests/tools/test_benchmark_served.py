"""How the memory of a process goes on, as the benchmark of the page tells it."""

import pytest

from tools.benchmark.served.view_long import growth_an_hour


def test_growth_is_that_of_what_has_settled():
    looks = [(10.0 * i, 500.0 + 40.0 * i) for i in range(10)]
    looks += [(100.0 + 10.0 * i, 1000.0 + 0.1 * i) for i in range(100)]

    assert growth_an_hour(looks, 100.0) == pytest.approx(3.6)


def test_what_trembles_does_not_grow():
    assert growth_an_hour([(float(i), 1000.0 + i % 2) for i in range(1000)], 0.0) == pytest.approx(
        0.0, abs=0.1
    )

"""A sole that slides slips; one that is lifted and set down elsewhere has stepped."""

import numpy as np
import pytest

from tools.evaluate.opening.judge import Footing


@pytest.fixture
def walked():
    """The most that a sole slipped which goes through places (time, x, load)."""

    def most(*places):
        footing = Footing(np.array([0.0, 0.0, 0.0]))
        return max(footing.slip_m(np.array([x, 0.0, 0.0]), load_n, t) for t, x, load_n in places)

    return most


def test_a_sole_that_slides_on_the_floor_slips(walked):
    assert walked((0.1, 0.001, 450.0), (0.2, 0.004, 30.0)) == pytest.approx(0.004)


def test_a_step_is_no_slip(walked):
    assert walked((0.1, 0.01, 15.0), (0.2, 0.20, 0.0), (0.3, 0.21, 450.0), (0.6, 0.21, 450.0)) == 0.0


def test_what_slides_after_a_step_slips(walked):
    assert walked((0.1, 0.2, 0.0), (0.5, 0.2, 450.0), (0.6, 0.207, 450.0)) == pytest.approx(0.007)

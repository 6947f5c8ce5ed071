"""Whether a velocity takes the robot away from what was at hand."""

import pytest

from trees.skills.moving import SKILL
from trees.tasks import MoveTask


@pytest.mark.parametrize(
    ("move", "leads"),
    [
        (MoveTask("turn around", 0.0, 0.5, 6.28), True),
        (MoveTask("turn right a little", 0.0, -0.5, 0.6), False),
        (MoveTask("step back", -0.3, 0.0, 1.0), False),
        (MoveTask("go back", -0.3, 0.0, 4.0), True),
        (MoveTask("two steps", 0.3, 0.0, None, 0.4), False),
        (MoveTask("a metre ahead", 0.3, 0.0, None, 1.0), True),
        (MoveTask("turn left", 0.0, 0.5), True),
        (MoveTask("stand", 0.0, 0.0), False),
    ],
)
def test_a_velocity_that_turns_or_goes_far_leads_away(move, leads):
    assert SKILL.strays(move) == leads

"""What the planner said no to, as failures."""

import pytest

from kinematics.requests.step import NoPlan
from trees.nodes.plan_failures import no_plan_failure


@pytest.mark.parametrize(
    ("message", "reasons", "numbers"),
    [
        ("no motion was found: cup collides with table", {"cup collides with table": 1}, {}),
        ("no way to grasp it", {"in collision": 1}, {"in collision": 1}),
        ("no way to grasp it: in collision", {"in collision": 2}, {"in collision": 2}),
    ],
)
def test_the_only_candidates_reason_is_told_once(message, reasons, numbers):
    assert no_plan_failure(NoPlan(message, reasons)).numbers == numbers

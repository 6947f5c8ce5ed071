"""What a skill needs of a robot stands in its record."""

from dataclasses import replace

import pytest

from trees.readiness import lacking
from trees.registry import skill_called
from trees.skill import Need


def test_a_robot_without_grippers_lacks_a_hand(stage):
    toolbox = replace(stage.toolbox, grippers={})

    assert lacking(skill_called("pick"), toolbox) is Need.HAND


def test_a_robot_that_does_not_walk_here_lacks_legs(stage):
    assert lacking(skill_called("walk_to"), replace(stage.toolbox, walking=None)) is Need.LEGS


@pytest.mark.parametrize("action", ["pick", "wave", "say"])
def test_a_robot_that_has_everything_lacks_nothing(stage, action):
    assert lacking(skill_called(action), stage.toolbox) is None


def test_who_only_speaks_needs_nothing(stage):
    assert lacking(skill_called("say"), replace(stage.toolbox, grippers={}, walking=None)) is None

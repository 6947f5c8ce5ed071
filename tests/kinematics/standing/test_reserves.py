"""What plans and guarded motions keep beyond touching is told in one place."""

import re
from pathlib import Path

import kinematics
import robots
from kinematics.collision.standing_judge import Kept
from kinematics.standing.reserves import (
    BRAKING_RESERVE_M,
    HANDED_ON_RESERVE_M,
    LEAST_RESERVE_M,
    MOVING_RESERVE_M,
    PLANNING_RESERVE_M,
)

NUMBER = re.compile(r"^_?((PLANNING|MOVING|LEAST|BRAKING|SELF)_)?RESERVE_M\b.*= *\d", re.MULTILINE)


def test_no_other_module_has_a_reserve_of_its_own():
    folders = [Path(package.__path__[0]) for package in (kinematics, robots)]
    sources = [path for folder in folders for path in folder.rglob("*.py")]

    owners = {path.name for path in sources if NUMBER.search(path.read_text("utf-8"))}

    assert owners == {"reserves.py"}


def test_a_guarded_motion_that_a_plan_hands_on_to_begins_with_its_reserve():
    kept = Kept()

    assert kept.own_m == kept.floor_m == kept.legs_m == BRAKING_RESERVE_M < HANDED_ON_RESERVE_M
    assert LEAST_RESERVE_M < MOVING_RESERVE_M < PLANNING_RESERVE_M

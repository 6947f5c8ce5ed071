"""The leaf of the guide does what the guide says."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
from py_trees.common import Status

from kinematics.geometry import poses

GUIDE = (Path(__file__).parents[2] / "docs" / "extend" / "a-leaf.md").read_text("utf-8")
[CODE] = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)


@pytest.fixture(scope="module")
def stands_low():
    names = {"__name__": "stands_low"}
    exec(compile(CODE, "stands_low.py", "exec"), names)
    return names["StandsLow"]


def test_the_guides_leaf_succeeds_for_what_stands_on_a_table(knowing, target, stands_low):
    leaf = stands_low("low", knowing.toolbox)

    assert knowing.run(leaf, target=target) is Status.SUCCESS


def test_the_guides_leaf_tells_what_stands_too_high_with_its_numbers(knowing, target, stands_low):
    leaf = stands_low("low", knowing.toolbox)

    status = knowing.run(leaf, target=replace(target, odom_T_object=poses.translation(0.5, 0.0, 1.6)))

    assert status is Status.FAILURE
    assert leaf.failure.numbers == {"height_m": 1.6, "highest_m": 1.4}

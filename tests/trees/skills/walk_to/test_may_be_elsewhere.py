"""What was said to be behind a door is not looked for in other rooms."""

import pytest
from py_trees.common import Status

from trees.skills.walk_to.may_be_elsewhere import MayBeElsewhere
from trees.tasks import ObjectDescription, Relation, WalkToTask


@pytest.mark.parametrize("where", ["fridge", ObjectDescription("fridge"), "cupboard"])
def test_what_is_behind_a_door_is_there_or_nowhere(stage, where):
    leaf = MayBeElsewhere("may be elsewhere", stage.toolbox)
    bottle = ObjectDescription("bottle", relation=Relation("on", where))

    assert stage.run(leaf, task=WalkToTask("walk there", bottle)) is Status.FAILURE
    assert leaf.failure.message == f"no bottle was seen in the {where}"


@pytest.mark.parametrize(
    "to",
    [
        "Ana",
        ObjectDescription("bottle"),
        ObjectDescription("bottle", relation=Relation("on", "table")),
        ObjectDescription("bottle", relation=Relation("next_to", "fridge")),
    ],
)
def test_all_else_may_be_anywhere(stage, to):
    leaf = MayBeElsewhere("may be elsewhere", stage.toolbox)

    assert stage.run(leaf, task=WalkToTask("walk there", to)) is Status.SUCCESS

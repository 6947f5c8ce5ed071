"""A rehearsal looks, plans and checks, and moves nothing."""

import numpy as np
import pytest

from robots.fake.fake_world import cup, table
from trees.nodes.leaf import Leaf
from trees.skills.pick.tree import build_dry_run
from trees.tasks import GoHomeTask, ObjectDescription, PickTask

RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))


def test_no_leaf_of_a_rehearsal_moves_anything(stage):
    tree = build_dry_run(RED_CUP, stage.toolbox)

    leaves = [node for node in tree.root.iterate() if isinstance(node, Leaf)]
    assert leaves
    assert {leaf.CONTRACT.moves for leaf in leaves} == {"nothing"}


def test_a_rehearsal_ends_with_every_step_checked_and_the_robot_where_it_was(model, stage):
    stage = type(stage)(model, [table(), cup(place_m=(0.6, 0.0))])  # in view from the home posture
    before = stage.toolbox.motion.reference().copy()

    tree = stage.play(build_dry_run(RED_CUP, stage.toolbox))

    assert tree.status == "success", tree.failure
    assert np.array_equal(stage.toolbox.motion.reference(), before)


def test_there_is_no_rehearsal_of_a_task_without_an_object(stage):
    with pytest.raises(TypeError):
        build_dry_run(GoHomeTask("go home"), stage.toolbox)

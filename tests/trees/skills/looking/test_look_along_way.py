import numpy as np
from py_trees.common import Status

from trees.nodes.leaf import DONE
from trees.skills.looking.hand_ways import UnseenPlaces
from trees.skills.looking.look_along_way import UnlessSeen


def test_where_a_place_was_not_looked_at_it_is_looked_at(stage, probe_leaf):
    child = probe_leaf("look", stage.toolbox, DONE)

    assert stage.run(UnlessSeen(child), unseen=UnseenPlaces(np.zeros((2, 3)))) is Status.SUCCESS
    assert child.begun == 1


def test_where_all_was_looked_at_nothing_more_is(stage, probe_leaf):
    child = probe_leaf("look", stage.toolbox, DONE)

    assert stage.run(UnlessSeen(child), unseen=UnseenPlaces(np.zeros((0, 3)))) is Status.SUCCESS
    assert child.begun == 0

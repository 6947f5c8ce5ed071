"""What stands beside the frames of a film."""

import numpy as np
import pytest

from executive.screens.display import NoDisplay
from executive.screens.film_panel import WIDTH_PX, FilmPanel
from executive.session.events import TaskAccepted
from robots.control.events import EmergencyStopped
from trees.snapshot import NodeSnapshot, TreeSnapshot


class Tree:
    """A tree with a leaf that stands as it is told."""

    leaf_places = frozenset({"pick/reach"})
    status = "running"

    def __init__(self, leaf_status):
        leaf = NodeSnapshot("reach", "leaf", leaf_status, "0.12 m")
        self._root = NodeSnapshot("pick", "sequence", "running", "", (leaf,))

    def snapshot(self, t_s):
        return TreeSnapshot(t_s, 1, self._root)


@pytest.fixture
def panel():
    made = FilmPanel(NoDisplay(), "talos in tabletop, seed 0")
    made.event(TaskAccepted(0.2, "pick up the red cup", {}))
    return made


def test_a_panel_is_as_high_as_the_picture(panel):
    for height in (240, 480, 721):
        assert panel.picture(height, 1.0).shape == (height, WIDTH_PX, 3)


def test_what_the_tree_does_is_seen(panel):
    panel.tick(Tree("running"))
    running = panel.picture(480, 1.0)
    panel.tick(Tree("failure"))

    assert np.any(running != panel.picture(480, 1.0))


def test_an_emergency_is_seen_in_red(panel):
    before = panel.picture(480, 1.0).astype(int)
    panel.event(EmergencyStopped(1.0, 1, "a person"))
    after = panel.picture(480, 1.0).astype(int)

    def red(picture):
        return np.count_nonzero((picture[..., 0] > 150) & (picture[..., 1] < 120))

    assert red(after) > red(before) + 50


def test_the_same_moment_is_drawn_the_same(panel):
    panel.tick(Tree("running"))

    assert (panel.picture(480, 1.0) == panel.picture(480, 1.0)).all()

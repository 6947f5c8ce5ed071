"""A door that stands where the robot's hand is cannot be, and is no broken episode."""

import pytest

from robots.errors import SceneError
from tools.evaluate.opening import episode
from tools.evaluate.opening.episode import OpeningOrder, run_opening
from tools.evaluate.opening.scenes import opening_scene

ORDER = OpeningOrder("close", 41, "talos")


@pytest.fixture
def tried(monkeypatch):
    """The scenes that were tried; the first two cannot be."""
    scenes = []

    def run(_order, scene):
        scenes.append(scene)
        if len(scenes) <= 2:
            raise SceneError("piece", "robot_start", "the robot starts in contact")
        return scene

    monkeypatch.setattr(episode, "_run", run)
    return scenes


def test_it_is_drawn_again_and_the_same_way_each_time(tried):
    assert run_opening(ORDER) == opening_scene(41, "close", 2)
    assert tried == [opening_scene(41, "close", number) for number in range(3)]
    assert len({scene.toml for scene in tried}) == 3

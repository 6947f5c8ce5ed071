"""What is planned, and what was refused, as it is drawn."""

import numpy as np
import pytest

from executive.doors.view.plan_drawing import PlanDrawing
from executive.doors.view.seen import refused_place
from kinematics.motion.verdict import Finding, FindingKind
from robots.models.description import load_description
from trees.failures import Failure

LEFT, RIGHT = [1.0, 0.3, 0.1, 0.0], [-1.0, 0.6, -0.1, 0.2]
PATH = {"hand": "left", "points_m": [[0.1, 0.0, 1.0], [0.2, 0.0, 1.0], [0.3, 0.1, 1.0]]}


class Scene:
    """Remembers what is there, as a browser does: a name stands for the last thing of that name."""

    def __init__(self):
        self.there, self.drawn = {}, 0

    def _add(self, name, *values, **options):
        self.there[name], self.drawn = (values, options), self.drawn + 1
        scene = self

        class Handle:
            def remove(self):
                del scene.there[name]

        return Handle()

    add_line_segments = add_box = add_icosphere = _add


@pytest.fixture
def scene():
    return Scene()


@pytest.fixture
def drawing(scene):
    return PlanDrawing(scene, load_description("talos"))


def test_footsteps_are_soles_where_they_will_land(scene, drawing):
    drawing.landings(np.array([LEFT, RIGHT]))

    options = [scene.there[f"/plan/step_{number}"][1] for number in (0, 1)]
    assert [one["position"][:2] for one in options] == [(0.3, 0.1), (0.6, -0.1)]
    assert options[1]["wxyz"][3] == pytest.approx(np.sin(0.1))


def test_footsteps_that_were_made_or_given_up_are_gone(scene, drawing):
    drawing.landings(np.array([LEFT, RIGHT]))
    drawing.landings(np.array([RIGHT]))
    assert set(scene.there) == {"/plan/step_0"}
    drawing.landings(np.zeros((0, 4)))

    assert not scene.there


def test_what_has_not_changed_is_not_drawn_again(scene, drawing):
    for _ in range(5):
        drawing.landings(np.array([LEFT]))
        drawing.paths([PATH])
        drawing.refused_at((0.5, 0.0, 0.9))

    assert scene.drawn == 4


def test_a_way_goes_from_point_to_point(scene, drawing):
    drawing.paths([PATH])
    ((ends, *_), _) = scene.there["/plan/path_left"]
    assert ends.shape == (2, 2, 3)
    drawing.paths([])

    assert not scene.there


def test_the_place_of_a_refused_motion_is_marked_until_the_next_task(scene, drawing):
    finding = Finding(
        FindingKind.SCENE_COLLISION, 1.0, ("arm_left_4_link", "table"), 0.0, 0.01, (0.5, 0.2, 0.8)
    )
    failure = Failure.infeasible("no way", Failure.unsafe("too near", finding=finding)).to_json()
    drawing.refused_at(refused_place(failure))
    assert scene.there["/plan/refused_inside"][1]["position"] == (0.5, 0.2, 0.8)
    drawing.refused_at(refused_place(None))

    assert not scene.there


def test_a_failure_without_a_place_has_none():
    assert refused_place(Failure.postcondition("it slipped").to_json()) is None

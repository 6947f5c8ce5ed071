"""How believed things are drawn."""

import pytest

from executive.doors.view.robot_drawing import REFUSED
from executive.doors.view.world_drawing import WorldDrawing, drawn

CUP = {
    "name": "red cup",
    "kind": "cup",
    "color": "red",
    "is": "object",
    "shape": "cylinder",
    "size_m": [0.04, 0.1],
    "place_m": [0.5, 0.1, 0.9],
    "quaternion": [0.0, 0.0, 0.6, 0.8],
    "margin_m": 0.01,
}
SURE = {**CUP, "confidence": 0.9, "error_m": [0.002, 0.003, 0.004]}
HELD = {**CUP, "held": "gripper_left"}


class Scene:
    """Remembers what is there."""

    def __init__(self):
        self.there, self.drawn = {}, 0

    def _add(self, name, *_values, **_options):
        scene = self
        scene.there[name], scene.drawn = _options, scene.drawn + 1

        class Handle:
            def remove(self):
                for path in [one for one in scene.there if one == name or one.startswith(f"{name}/")]:
                    del scene.there[path]

        return Handle()

    add_frame = add_label = add_icosphere = add_cylinder = add_box = _add


@pytest.fixture
def scene():
    return Scene()


@pytest.fixture
def drawing(scene):
    return WorldDrawing(scene)


def test_an_error_is_an_ellipsoid_of_three_deviations():
    assert drawn(SURE).error_m == pytest.approx((0.006, 0.009, 0.012))


def test_without_a_look_of_this_task_the_margin_stands_for_the_error():
    assert drawn(CUP).error_m == (0.01, 0.01, 0.01)


def test_what_is_less_sure_is_fainter_and_says_so():
    unsure = drawn({**SURE, "confidence": 0.3})

    assert unsure.opacity < drawn(SURE).opacity < drawn(CUP).opacity == 1.0
    assert unsure.label == "red cup 30 %"


def test_furniture_lets_things_behind_it_shine_through():
    assert drawn({**CUP, "is": "furniture"}).opacity < 1.0


def test_quaternions_are_told_in_the_pages_order():
    assert drawn(CUP).wxyz == (0.8, 0.0, 0.0, 0.6)


def test_what_a_motion_was_refused_for_is_red():
    assert drawn({**CUP, "color": "blue"}, marked=("red cup",)).rgb == REFUSED


def test_a_thing_of_no_known_colour_has_the_colour_of_its_kind():
    vase, other = {**CUP, "color": "teal-ish", "kind": "vase"}, {**CUP, "color": None, "kind": "vase"}

    assert drawn(vase).rgb == drawn(other).rgb != drawn({**other, "kind": "bowl"}).rgb


def test_what_has_not_changed_is_left_alone(scene, drawing):
    drawing.show([drawn(SURE)], {})
    before = scene.drawn
    drawing.show([drawn(SURE)], {})

    assert scene.drawn == before


def test_what_is_no_longer_believed_is_gone_with_its_error(scene, drawing):
    drawing.show([drawn(SURE)], {})
    assert set(scene.there) >= {"/believed/red cup", "/errors/red cup"}
    drawing.show([], {})

    assert scene.there == {}


def test_what_a_hand_holds_hangs_on_its_frame_without_an_error(scene, drawing):
    drawing.show([drawn(CUP)], {})
    drawing.show([drawn(HELD)], {"gripper_left": "/robot/arm/gripper_left"})

    assert set(scene.there) == {
        f"/robot/arm/gripper_left/believed/red cup{part}" for part in ("", "/solid", "/label")
    }


def test_the_boards_of_a_table_are_named_once(scene, drawing):
    table = {**CUP, "is": "furniture", "shape": "box", "size_m": [1.0, 0.8, 0.04], "name": "table"}
    drawing.show([drawn(table), drawn({**table, "name": "table 2"})], {})

    assert "/believed/table/label" in scene.there
    assert "/believed/table 2/label" not in scene.there

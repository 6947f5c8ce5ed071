"""What a hand feels of the height of a top, against what a camera shows of it."""

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.scene.support_of import top_m
from robots.perception.position_error import alike_in_all_directions
from trees.beliefs.scene.held_object import HeldObject
from trees.events import NotSo, Said
from trees.failures import Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.port_values import Placement
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.looking.look_leaf import LookLeaf
from trees.skills.place.felt_top import note_felt_top

CUP = HeldObject("red cup", "right", Cylinder(0.03, 0.11), poses.translation(0.0, 0.0, 0.0))
HERE = Placement("right", poses.translation(0.4, -0.2, 0.955), ("table",), (0.4, -0.2))
TRUE_M = 0.9


class Look(LookLeaf, register=False):
    """Folds what it has gathered."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract("none", "none", deadline_s=1.0)

    def judge(self, views):
        folded_look(self.toolbox, views)
        return DONE


def look(stage):
    assert stage.run(Look("look", stage.toolbox)) is Status.SUCCESS


@pytest.fixture
def seeing(knowing, target):
    """A look with a camera that declares its error and shows everything too high by something."""

    stage = knowing
    stage.run(LookAtTarget("look at it", stage.toolbox), target=target)

    def see(own_m, shared_m, off_m):
        stage.fake.detector.error = alike_in_all_directions(own_m, 0.0, 0.01, shared_m)
        stage.fake.detector.offset_m |= {"table": (0.0, 0.0, off_m), "red cup": (0.0, 0.0, off_m)}
        stage.fake.step()
        look(stage)
        return stage

    return see


def told(stage):
    return [
        event.failure
        for event in stage.events
        if isinstance(event, NotSo) and event.failure.reason is Reason.FELT_OTHER_HEIGHT
    ]


@pytest.mark.requirement("P3")
def test_a_table_that_is_felt_twelve_millimetres_higher_than_it_is_seen_is_told(seeing):
    """A camera is usually off by 5 mm, but for the table and what stands on it alike."""
    stage = seeing(0.001, 0.005, 0.0)
    seen_m = top_m(stage.toolbox.world.scene.objects["table"])
    note_felt_top(stage.toolbox, CUP, HERE, seen_m + 0.012)

    (failure,) = told(stage)
    assert failure.numbers["above_m"] == pytest.approx(0.012)
    assert "12 mm above" in failure.message
    assert len([event for event in stage.events if isinstance(event, Said)]) == 1
    assert stage.toolbox.world.felt_tops["table"].contradicts


@pytest.mark.requirement("P3")
@pytest.mark.parametrize(
    ("own_m", "shared_m", "above_m"), [(0.001, 0.005, 0.004), (0.001, 0.005, -0.004), (0.005, 0.0, 0.012)]
)
def test_what_hand_and_camera_may_be_wrong_by_is_no_disagreement(seeing, own_m, shared_m, above_m):
    stage = seeing(own_m, shared_m, 0.0)
    note_felt_top(stage.toolbox, CUP, HERE, top_m(stage.toolbox.world.scene.objects["table"]) + above_m)

    assert told(stage) == []
    assert not stage.toolbox.world.felt_tops["table"].contradicts


@pytest.mark.requirement("P3")
def test_after_a_contradiction_the_next_look_puts_the_table_where_the_hand_has_felt_it(seeing):
    stage = seeing(0.001, 0.005, -0.012)
    note_felt_top(stage.toolbox, CUP, HERE, TRUE_M)
    before_m = top_m(stage.toolbox.world.scene.objects["table"])
    cup_m = stage.toolbox.world.scene.objects["red cup"].world_T_object[2, 3]
    look(stage)

    objects = stage.toolbox.world.scene.objects
    raised_m = top_m(objects["table"]) - before_m
    assert raised_m > 0.7 * (TRUE_M - before_m)
    assert objects["red cup"].world_T_object[2, 3] - cup_m == pytest.approx(raised_m)


@pytest.mark.requirement("P3")
def test_a_height_that_agrees_moves_nothing(seeing):
    stage = seeing(0.001, 0.005, 0.0)
    before_m = top_m(stage.toolbox.world.scene.objects["table"])
    note_felt_top(stage.toolbox, CUP, HERE, before_m + 0.003)
    look(stage)

    assert top_m(stage.toolbox.world.scene.objects["table"]) == pytest.approx(before_m, abs=1e-9)

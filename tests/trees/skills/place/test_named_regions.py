"""Things are put on, and into, parts of furniture that have a name."""

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.requests.move import RetreatRequest
from kinematics.requests.place import PlaceRequest
from robots.fake.fake_world import cup, table
from robots.perception.truth_view import TrueObject
from tests.trees.household_stage import asked, long_enough_to_feel_on_the_way, run
from trees.tasks import ObjectDescription, PlaceTask, PutInTask

RED_CUP = ObjectDescription("cup", "red")
TOP_M = 0.9


def solid(name, kind, size, place):
    return TrueObject(name, "furniture", kind, None, Box(size), poses.translation(*place))


def burner(side, y):
    place = (0.5, y, TOP_M + 0.04 - 0.001)
    return solid(f"stove/{side} burner", f"{side} burner", (0.15, 0.15, 0.002), place)


STOVE = (
    solid("stove/top", "fixture", (0.2, 0.4, 0.04), (0.5, 0.2, TOP_M + 0.02)),
    burner("left", 0.3),
    burner("right", 0.1),
)


def low_stove(high_m):
    """A stove of that height with one burner."""
    top = solid("stove/top", "fixture", (0.2, 0.4, high_m), (0.5, 0.2, TOP_M + 0.5 * high_m))
    place = (0.5, 0.3, TOP_M + high_m - 0.001)
    return top, solid("stove/left burner", "left burner", (0.15, 0.15, 0.002), place)


WALLS = (((0.2, 0.006, 0.08), (0.0, 0.1)), ((0.2, 0.006, 0.08), (0.0, -0.1)),
         ((0.006, 0.2, 0.08), (0.1, 0.0)), ((0.006, 0.2, 0.08), (-0.1, 0.0)))  # fmt: skip
CADDY = (
    solid("caddy/top", "fixture", (0.2, 0.2, 0.006), (0.5, 0.2, TOP_M + 0.003)),
    *(
        solid(f"caddy/box_{k}", "fixture", size, (0.5 + x, 0.2 + y, TOP_M + 0.04))
        for k, (size, (x, y)) in enumerate(WALLS)
    ),
    solid("caddy/compartment", "compartment", (0.19, 0.19, 0.002), (0.5, 0.2, TOP_M + 0.005)),
)


@pytest.mark.requirement("P4")
@pytest.mark.parametrize(("side", "y_m"), [("left", 0.3), ("right", 0.1)])
def test_a_cup_is_put_on_the_part_that_was_named(stage_with, side, y_m):
    stage = stage_with(table(), cup(), *STOVE)

    tree = run(stage, PlaceTask("put it on the burner", RED_CUP, on=ObjectDescription(f"{side} burner")))

    assert tree.status == "success", tree.failure
    place = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert place[:2] == pytest.approx((0.5, y_m), abs=0.05)
    assert place[2] == pytest.approx(TOP_M + 0.04 + 0.055, abs=0.01)
    (request,) = asked(stage, PlaceRequest)
    assert {spot.touches for spot in request.spots} == {(f"{side} burner", "stove")}


@pytest.mark.requirement("P4")
def test_a_cup_is_put_into_the_part_that_was_named(stage_with):
    stage = stage_with(table(), cup(), *CADDY)

    tree = run(stage, PutInTask("put it into the compartment", RED_CUP, ObjectDescription("compartment")))

    assert tree.status == "success", tree.failure
    place = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert place[:2] == pytest.approx((0.5, 0.2), abs=0.07)
    assert place[2] < TOP_M + 0.08 + 0.055


def test_what_has_no_walls_is_nothing_to_put_into(stage_with):
    stage = stage_with(table(), cup(), *STOVE)

    tree = run(stage, PutInTask("put it into the burner", RED_CUP, ObjectDescription("left burner")))

    assert tree.status == "failure"
    assert "say to put it on the left burner" in tree.failure.message


@pytest.mark.parametrize(("high_m", "near"), [(0.026, True), (0.08, False)])
def test_the_last_steps_down_come_near_the_table_only_where_the_stove_is_low(stage_with, high_m, near):
    long_enough_to_feel_on_the_way(stage := stage_with(table(), cup(), *low_stove(high_m)))
    stage.play(stage.pick())
    stage.fake.detector.offset_m["stove"] = stage.fake.detector.offset_m["left burner"] = (0.0, 0.0, 0.02)

    run(stage, PlaceTask("put it on the burner", None, on=ObjectDescription("left burner")))

    further = [request for request in asked(stage, RetreatRequest) if request.world_offset_m[2] < 0.0]
    assert further
    conceded = {frozenset(one.names) for one in further[0].concessions}
    assert frozenset(("red cup", "stove")) in conceded
    assert (frozenset(("red cup", "table")) in conceded) is near

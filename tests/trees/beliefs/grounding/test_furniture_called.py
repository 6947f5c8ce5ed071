"""A side table is none of those that are called nothing but table; "the table" may be one of them."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import furniture_named, resolve
from trees.beliefs.grounding.furniture_called import called_so, may_be_called, others_like
from trees.beliefs.grounding.grounding import Found, Missing, ground, ground_furniture
from trees.beliefs.scene.believed_thing import surroundings
from trees.beliefs.scene.scene_update import updated_scene
from trees.failures import Failure
from trees.policy import TreePolicy
from trees.skills.place.placement import why_not_there
from trees.tasks import ObjectDescription

GAP_M = 0.02
POLICY = TreePolicy()


def top(name, y):
    return SceneObject(name, Box((0.6, 0.8, 0.04)), poses.translation(0.8, y, 0.8), movable=False)


def cup_on(y):
    return SceneObject("red cup", Cylinder(0.03, 0.1), poses.translation(0.8, y, 0.87))


def scene(*items):
    return PlanningScene().with_objects(items)


def why_not(on, known):
    return why_not_there(on, None, known, surroundings(known, np.eye(4), GAP_M), GAP_M)


@pytest.mark.parametrize(
    ("said", "known", "meant"),
    [
        ("table", {"table", "side table"}, {"table"}),
        ("table", {"coffee table", "side table", "desk"}, {"coffee table", "side table"}),
        ("side table", {"table", "side table"}, {"side table"}),
        ("side table", {"table"}, set()),
        ("kitchen table", {"table"}, {"table"}),
        ("kitchen table", {"side table"}, set()),
        ("Ana's desk", {"ana's desk", "table"}, {"ana's desk"}),
        ("shelf", {"table"}, set()),
        ("table", {"desk"}, set()),
        ("desk", {"table"}, set()),
    ],
)
def test_the_very_words_come_first_and_another_name_is_another_piece(said, known, meant):
    assert called_so(said, dict.fromkeys(known, ())) == meant


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("sideboard", {"side table"}),
        ("Sideboard", {"side table"}),
        ("antiques", {"side table", "stove"}),
        ("side table", {"side table"}),
        ("table", {"table"}),
        ("desk", {"desk"}),
        ("dresser", set()),
    ],
)
def test_what_a_piece_is_called_besides_comes_before_what_its_name_ends_on(said, meant):
    known = {"side table": {"sideboard", "antiques"}, "stove": {"antiques"}, "table": {"desk"}, "desk": ()}

    assert called_so(said, known) == meant


def piece(shape, y, z, *called):
    pose = poses.translation(0.8, y, z)
    return ObjectEstimate("furniture", "table", None, pose, shape, 0.9, 8, 0.0, *called)


def sideboard():
    """A look at a side table with two solids, and at a table."""
    board, leg, called = (
        Box((0.5, 0.8, 0.03)),
        Box((0.05, 0.05, 0.8)),
        ("side table", ("sideboard", "credenza")),
    )
    seen = [piece(board, -1.0, 0.8, *called), piece(leg, -1.0, 0.4, *called), piece(board, 1.0, 0.8)]
    return updated_scene(PlanningScene(), seen, POLICY, lambda _: False)


def test_a_look_tells_names_and_people_are_told_of_a_piece_by_its_own():
    update = sideboard()
    around = surroundings(update.scene, np.eye(4), GAP_M)

    assert {thing.words for thing in around.things} == {"side table", "table"}
    assert around.furniture_words["side table"] == {"side table", "sideboard", "credenza"}
    assert around.furniture_words["table"] == frozenset()


def test_by_another_name_it_is_one_place_to_walk_to_and_to_put_things_on():
    update = sideboard()
    around = surroundings(update.scene, np.eye(4), GAP_M)

    for said in ("credenza", "sideboard", "side table"):
        assert resolve(ObjectDescription(said), update.seen, around).name == "side table"
        assert resolve(said, update.seen, around).name == "side table"
        assert why_not(said, update.scene) is None
        (found,) = furniture_named(said, update.scene)[:1]
        assert found.name == "side table"
    assert isinstance(resolve(ObjectDescription("dresser"), update.seen, around), Failure)


@pytest.mark.parametrize(("said", "asks"), [("table", True), ("sideboard", False), ("side table", False)])
def test_what_is_put_back_where_it_stands_is_no_doubt_where_that_is_said_by_name(said, asks):
    (top,) = furniture_named("sideboard", sideboard().scene)[:1]
    alone = PlanningScene().with_objects([top])
    around = surroundings(alone, np.eye(4), GAP_M)

    failure = why_not_there(said, None, alone, around, GAP_M, leaves=top.name)

    assert (failure is not None) is asks


def test_the_right_one_of_what_is_called_so_is_furniture():
    update = sideboard()
    around = surroundings(update.scene, np.eye(4), GAP_M)

    found = resolve(ObjectDescription("sideboard", ordinal="rightmost"), update.seen, around)

    assert found.name == "side table"


def test_a_cup_on_it_is_on_what_it_is_called_besides():
    known = sideboard().scene.with_objects([*sideboard().scene.objects.values(), cup_on(-1.0)])
    around = surroundings(known, np.eye(4), GAP_M)

    assert ground(ObjectDescription("cup"), around, "credenza") == Found(("red cup",))
    assert isinstance(ground(ObjectDescription("cup"), around, "table"), Missing)


@pytest.mark.parametrize(
    ("said", "words", "may"),
    [
        ("desk", "table", False),
        ("side table", "table", False),
        ("dining table", "table", True),
        ("table", "side table", True),
        ("side table", "dining table", False),
        ("shelf", "table", False),
    ],
)
def test_where_a_thing_stands_may_be_called_otherwise_as_long_as_nothing_contradicts(said, words, may):
    assert may_be_called(said, words) is may


def test_a_failure_tells_what_there_is_of_the_kind():
    assert others_like("side table", ["table", "desk", "shelf"]) == "; a desk and a table are"
    assert others_like("shelf", ["table"]) == ""


@pytest.mark.parametrize(("said", "y"), [("side table", 1.5), ("table", -0.5)])
def test_a_cup_is_looked_for_on_the_piece_of_that_name(said, y):
    tables = (top("table", -0.5), top("side table", 1.5))
    on_both = surroundings(scene(*tables, cup_on(y)), np.eye(4), GAP_M)
    elsewhere = surroundings(scene(*tables, cup_on(1.0 - y)), np.eye(4), GAP_M)

    assert ground(ObjectDescription("cup"), on_both, said) == Found(("red cup",))
    assert isinstance(ground(ObjectDescription("cup"), elsewhere, said), Missing)


def test_nothing_goes_onto_another_table_than_the_one_that_was_named():
    assert isinstance(why_not("side table", scene(top("table", 0.0))), Failure)
    assert why_not("side table", scene(top("table", -1.0), top("side table", 1.0))) is None


@pytest.mark.parametrize("names", [("table", "table 2"), ("coffee table", "side table")])
def test_on_which_of_two_tables_is_asked(names):
    asked = why_not("table", scene(*(top(name, y) for name, y in zip(names, (-1.0, 1.0), strict=True))))

    assert asked.choice_slot == "on"
    assert len(asked.choices) == 2


def test_boards_of_one_shelf_are_one_piece():
    boards = [
        SceneObject(name, Box((0.3, 1.0, 0.02)), poses.translation(0.6, 0.0, height), movable=False)
        for name, height in (("shelf", 0.4), ("shelf 2", 0.8), ("shelf 3", 1.2))
    ]

    assert why_not("shelf", scene(*boards)) is None


OTHER = ObjectDescription("table", ordinal="other")


@pytest.mark.parametrize(
    ("leaves", "other"), [("table", "table 2"), ("table 2", "table"), (None, "table 2")], ids=str
)
def test_the_other_table_is_not_the_one_that_is_left_or_stood_before(leaves, other):
    known = scene(top("table", 0.2), top("table 2", 2.5))
    around = surroundings(known, np.eye(4), GAP_M)

    assert ground_furniture(OTHER, around, leaves) == Found((other,))


def test_where_there_is_one_table_there_is_no_other_one():
    around = surroundings(scene(top("table", 0.2)), np.eye(4), GAP_M)

    assert isinstance(ground_furniture(OTHER, around, "table"), Missing)


def test_the_only_cup_in_view_is_not_the_other_one():
    around = surroundings(scene(top("table", 0.0), cup_on(0.0)), np.eye(4), GAP_M)

    assert isinstance(ground(ObjectDescription("cup", ordinal="other"), around), Missing)

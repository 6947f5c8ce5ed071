"""Which thing is meant: every slot of a description, each way of being unclear, and nothing left out."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.grounding.grounding import Ambiguous, Found, Missing, exactly, ground
from trees.beliefs.scene.believed_thing import surroundings
from trees.tasks import ObjectDescription, Relation

TOP_M = 0.8
TABLE = SceneObject("table", Box((0.8, 2.0, 0.04)), poses.translation(0.8, 0.0, TOP_M - 0.02), movable=False)
SHELF = SceneObject("shelf", Box((0.3, 0.6, 0.02)), poses.translation(0.8, 2.0, 1.1), movable=False)
HERE = np.eye(4)


def thing(name, x, y, size=1.0, on_m=TOP_M):
    if "bowl" in name:
        shape = Cylinder(0.08, 0.06)
    elif "box" in name:
        shape = Box((0.2 * size, 0.2 * size, 0.1 * size))
    else:
        shape = Cylinder(0.03 * size, 0.1 * size)
    return SceneObject(name, shape, poses.translation(x, y, on_m + 0.5 * shape.height_m))


def around(*things, base=HERE, last=None, held=()):
    scene = PlanningScene().with_objects([TABLE, SHELF, *things])
    for name in held:
        scene = scene.with_attached(name, "tcp_left", np.eye(4), [])
    return surroundings(scene, base, 0.05, last)


def cup(**slots):
    return ObjectDescription("cup", **slots)


def found(description, *things, source=None, count=1, **options):
    answer = ground(description, around(*things, **options), source, count)
    assert isinstance(answer, Found), answer
    return answer.names[0] if count == 1 else answer.names


def asked(description, *things, **options):
    answer = ground(description, around(*things, **options))
    assert isinstance(answer, Ambiguous), answer
    return answer


def missing(description, *things, source=None, count=1, **options):
    answer = ground(description, around(*things, **options), source, count)
    assert isinstance(answer, Missing), answer
    return answer.message


RED, BLUE = thing("red cup", 0.7, 0.2), thing("blue cup", 0.6, -0.2)
TWIN = thing("red cup 2", 0.7, -0.1)
BOX = thing("blue box", 0.7, -0.4)
BOTTLE = thing("green bottle", 0.7, 0.0)


def test_kind_and_colour_choose():
    assert found(cup(color="red"), RED, BLUE, BOTTLE) == "red cup"
    assert found(ObjectDescription("bottle"), RED, BLUE, BOTTLE) == "green bottle"


def test_furniture_is_never_an_object_to_act_on():
    assert missing(ObjectDescription("table"), RED) == "no table seen"


@pytest.mark.requirement("L6")
def test_several_that_fit_are_all_choices_in_words_of_their_own():
    question = asked(cup(), RED, BLUE, TWIN, BOTTLE)

    assert question.message == "which cup? there are 3"
    assert {choice.name for choice in question.choices} == {"red cup", "red cup 2", "blue cup"}
    assert [choice.words for choice in question.choices] == ["left red cup", "right red cup", "blue cup"]


def test_twins_behind_one_another_are_told_apart_by_distance():
    behind = thing("red cup 2", 0.9, 0.205)

    assert [choice.words for choice in asked(cup(), RED, behind).choices] == [
        "farther red cup",
        "nearer red cup",
    ]


@pytest.mark.requirement("F1")
def test_what_is_not_there_is_missing():
    assert missing(cup(color="green"), RED, BLUE) == "no green cup seen"


def test_what_is_in_the_hand_is_said_to_be_there():
    assert missing(cup(color="red"), RED, BLUE, held=["red cup"]) == "the red cup is in the hand"


@pytest.mark.parametrize(
    ("ordinal", "name"),
    [
        ("leftmost", "red cup"), ("rightmost", "blue cup"), ("first", "red cup"), ("second", "red cup 2"),
        ("third", "blue cup"), ("last", "blue cup"), ("middle", "red cup 2"), ("nearest", "blue cup"),
        ("second from the right", "red cup 2"), ("first_from_the_right", "blue cup"), ("2nd", "red cup 2"),
    ],
)  # fmt: skip
def test_ordinals_count_from_the_robots_left(ordinal, name):
    assert found(cup(ordinal=ordinal), RED, TWIN, BLUE, BOTTLE) == name


def test_an_ordinal_beyond_the_last_is_missing():
    assert missing(cup(ordinal="third"), RED, BLUE) == "no third cup seen; there are 2 of the kind"


def test_an_ordinal_between_two_that_stand_one_behind_the_other_is_asked():
    behind = thing("red cup 2", 0.9, 0.205)

    assert len(asked(cup(ordinal="leftmost"), RED, behind, BLUE).choices) == 2


def test_an_ordinal_of_unknown_meaning_is_asked():
    assert asked(cup(ordinal="favourite"), RED, BLUE).message == "which one is the favourite one?"


def test_the_other_one_is_not_the_one_acted_on_before():
    assert found(cup(ordinal="other"), RED, BLUE, last="red cup") == "blue cup"


@pytest.mark.requirement("M2", "L6")
@pytest.mark.parametrize(
    ("ordinal", "y_m", "told"),
    [
        ("leftmost", -0.3, "no leftmost cup seen; the only one is on the right"),
        ("rightmost", 0.3, "no rightmost cup seen; the only one is on the left"),
    ],
)
def test_the_only_one_on_the_other_side_is_not_the_left_one(ordinal, y_m, told):
    assert missing(cup(ordinal=ordinal), thing("red cup", 0.6, y_m)) == told
    assert found(cup(ordinal=ordinal), thing("red cup", 0.6, -y_m)) == "red cup"


def test_the_other_one_is_other_than_one_of_its_kind_alone():
    assert found(cup(ordinal="other"), RED, BLUE, last="red cup") == "blue cup"
    assert "other than which" in asked(cup(ordinal="other"), RED, BLUE, last="green box").message


def test_the_other_one_without_one_before_is_asked():
    assert "other than which" in asked(cup(ordinal="other"), RED, BLUE).message


@pytest.mark.parametrize("size", ["small", "smaller", "smallest"])
def test_small_is_the_smaller_of_two(size):
    assert found(cup(size=size), RED, thing("blue cup", 0.6, -0.2, size=1.3)) == "red cup"


def test_big_ones_are_all_that_are_clearly_larger_than_the_smallest():
    large = [thing("blue cup", 0.6, -0.2, size=1.3), thing("green cup", 0.6, 0.0, size=1.31)]

    assert {choice.name for choice in asked(cup(size="big"), RED, *large).choices} == {
        "blue cup",
        "green cup",
    }


def test_sizes_that_look_alike_are_asked():
    assert (
        "nearly one size" in asked(cup(size="biggest"), RED, thing("blue cup", 0.6, -0.2, size=1.02)).message
    )


@pytest.mark.requirement("F1")
def test_a_material_is_asked_and_never_left_out():
    question = asked(cup(material="metal", color="red"), RED, BLUE)

    assert question.message == "which one is made of metal? that cannot be seen"
    assert [choice.words for choice in question.choices] == ["red cup"]


def test_a_name_that_nobody_can_see_is_asked():
    assert asked(cup(name="Ana's cup"), RED, BLUE).message == "which one is Ana's cup? names cannot be seen"


@pytest.mark.requirement("F1")
@pytest.mark.parametrize("name", ["blue box", "blue box 2", "nobody", "blue cup", "Ana's box", "table"])
def test_what_has_another_name_is_never_taken_for_what_is_named(name):
    assert missing(cup(name=name), RED, BOX) == f"no {name} seen"


def test_a_name_of_the_scene_means_that_very_thing():
    assert found(exactly("red cup 2"), RED, TWIN, BLUE) == "red cup 2"


def test_a_named_thing_that_was_renamed_is_the_only_one_alike():
    assert found(exactly("red cup 3"), TWIN, BLUE) == "red cup 2"


def test_what_is_named_by_another_colour_than_it_shows_is_meant_by_its_name():
    white = Label("book", "white", ("black book",))
    book = replace(thing("black book", 0.7, 0.2), label=white)

    assert found(exactly("black book"), book, RED) == "black book"
    assert found(ObjectDescription("book", "black"), book, RED) == "black book"
    assert found(ObjectDescription("book", "white"), book, RED) == "black book"
    assert missing(ObjectDescription("book", "red"), book, RED) == "no red book seen"


def test_a_named_thing_whose_colour_was_not_told_may_show_it_now():
    assert found(exactly("cup 3"), TWIN, BOX) == "red cup 2"


@pytest.mark.parametrize(
    ("kind", "x", "y"),
    [("left_of", 0.7, 0.3), ("right_of", 0.7, -0.3), ("in_front_of", 0.5, 0.0), ("behind", 0.9, 0.0)],
)
def test_directions_are_those_of_the_robot(kind, x, y):
    relation = Relation(kind, ObjectDescription("bottle"))
    others = {
        name: thing(name, *place)
        for name, place in {
            "red cup": (0.7, 0.3), "blue cup": (0.7, -0.3), "green cup": (0.5, 0.0), "white cup": (0.9, 0.0)
        }.items()
    }  # fmt: skip

    name = found(cup(relation=relation), BOTTLE, *others.values())

    assert tuple(others[name].world_T_object[:2, 3]) == (x, y)


def test_next_to_is_a_hands_width_away():
    near, far = thing("red cup", 0.7, 0.15), thing("blue cup", 0.7, -0.6)

    assert (
        found(cup(relation=Relation("next_to", ObjectDescription("bottle"))), BOTTLE, near, far) == "red cup"
    )


def test_nearest_to_a_thing_or_a_piece_of_furniture():
    near, far = thing("red cup", 0.7, 0.5), thing("blue cup", 0.7, -0.4)

    assert (
        found(cup(relation=Relation("nearest", ObjectDescription("bottle"))), BOTTLE, near, far) == "blue cup"
    )
    assert found(cup(relation=Relation("nearest", "shelf")), near, far) == "red cup"
    assert found(cup(relation=Relation("nearest", "you")), near, far) == "blue cup"


def test_nearest_to_me_is_asked_while_nobody_is_in_view():
    assert "who speaks" in asked(cup(relation=Relation("nearest", "me")), RED, BLUE).message


def test_on_in_and_under():
    box, bowl = thing("brown box", 0.7, 0.4), thing("white bowl", 0.7, -0.4)
    on_box, in_bowl = (
        thing("red cup", 0.7, 0.4, on_m=TOP_M + 0.1),
        thing("blue cup", 0.71, -0.4, on_m=TOP_M + 0.01),
    )
    below = thing("green cup", 0.7, 0.0, on_m=0.0)
    things = (box, bowl, on_box, in_bowl, below)

    assert found(cup(relation=Relation("on", ObjectDescription("box"))), *things) == "red cup"
    assert found(cup(relation=Relation("in", ObjectDescription("bowl"))), *things) == "blue cup"
    assert found(cup(relation=Relation("under", "table")), *things) == "green cup"


def test_a_relation_to_what_is_not_there_is_missing():
    assert missing(cup(relation=Relation("left_of", ObjectDescription("bowl"))), RED, BLUE) == "no bowl seen"


def test_a_relation_that_nothing_fulfils_is_missing():
    message = missing(cup(relation=Relation("left_of", ObjectDescription("bottle"))), BLUE, BOTTLE)

    assert message == "no cup left of the bottle seen"


def test_relation_and_ordinal_go_together():
    left = thing("red cup 3", 0.7, 0.5)
    wanted = cup(color="red", ordinal="leftmost", relation=Relation("left_of", ObjectDescription("bottle")))

    assert found(wanted, RED, left, TWIN, BOTTLE) == "red cup 3"


@pytest.mark.parametrize("kind", ["on", "in"])
def test_what_stands_on_any_board_of_a_piece_is_on_it(kind):
    lower = SceneObject("shelf 2", Box((0.3, 0.5, 0.02)), poses.translation(0.8, 2.0, 0.6), movable=False)
    below = thing("red cup", 0.8, 2.0, on_m=0.61)

    assert (
        found(cup(relation=Relation(kind, "shelf")), lower, below, thing("red cup 2", 0.6, 0.0)) == "red cup"
    )


def test_the_source_is_the_furniture_that_it_stands_on():
    high = thing("red cup 2", 0.8, 2.0, on_m=1.11)

    assert found(cup(), RED, high, source="shelf") == "red cup 2"
    assert missing(cup(color="red"), RED, source="shelf") == "a red cup is seen, but not on the shelf"


def test_both_are_exactly_two():
    assert set(found(cup(), RED, BLUE, count="both")) == {"red cup", "blue cup"}
    assert missing(cup(), RED, BLUE, TWIN, count="both").startswith("there are 3 cup")


def test_a_number_takes_the_nearest_and_all_takes_all():
    assert found(cup(), RED, BLUE, TWIN, count=2) == ("blue cup", "red cup 2")
    assert len(found(cup(), RED, BLUE, TWIN, count="all")) == 3
    assert missing(cup(), RED, count=2) == "only 1 cup in view, not 2"


@given(
    turn=st.floats(-math.pi, math.pi),
    x=st.floats(-5, 5),
    y=st.floats(-5, 5),
    ordinal=st.sampled_from(["leftmost", "rightmost", "nearest", "second"]),
)
def test_turning_and_moving_robot_and_things_together_changes_nothing(turn, x, y, ordinal):
    moved = poses.transform(poses.rotation_z(turn), (x, y, 0.0))
    scene = PlanningScene().with_objects([RED, TWIN, BLUE])
    elsewhere = PlanningScene().with_objects(
        [SceneObject(item.name, item.shape, moved @ item.world_T_object) for item in scene.objects.values()]
    )

    first, second = surroundings(scene, HERE, 0.05), surroundings(elsewhere, moved, 0.05)

    assert ground(cup(ordinal=ordinal), first) == ground(cup(ordinal=ordinal), second)

"""Which of several doors and drawers of recognised pieces a task means, and what has none."""

from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.truth_view import TrueObject
from tests.trees.cabinet_seen import CABINET, MICROWAVE, believed, seen, shown
from trees.beliefs.grounding.grounding import Found, ground
from trees.beliefs.openings.handles import handles_in
from trees.beliefs.scene.believed_thing import surroundings
from trees.failures import FailureKind
from trees.skills.doors.choose_handle import ChooseHandle
from trees.skills.doors.choose_stand_at_handle import ChooseStandAtHandle, place_of
from trees.skills.doors.detect_handle import DetectFront, DetectHandle
from trees.skills.doors.front_watch import FrontWatch
from trees.skills.doors.meant_part import opens_nothing, those_meant
from trees.skills.doors.pushed_front import fronts_in
from trees.tasks import CloseTask, ObjectDescription, OpenTask, Relation

HIGH = ((1, 1.0), (2, 0.9), (3, 0.8))
CABINETS = Relation("in", "cabinet")
FRONTS = frozenset({"cabinet drawer", "microwave door"})


def said(kind, **more):
    return OpenTask("open it", ObjectDescription(kind, **more))


def parts(task, look):
    return {one.moves.part for one in those_meant(task, handles_in(look), (), {})}


@pytest.mark.parametrize(
    ("kind", "more", "meant"),
    [
        ("drawer", {"ordinal": "top"}, {"top drawer"}),
        ("drawer", {"ordinal": "lower", "relation": CABINETS}, {"bottom drawer"}),
        ("drawer", {"relation": CABINETS}, {"top drawer", "middle drawer", "bottom drawer"}),
        ("drawer", {"ordinal": "second"}, {"top drawer", "middle drawer", "bottom drawer"}),
        ("drawer", {"relation": Relation("in", "microwave")}, set()),
        ("cabinet", {}, {"top drawer", "middle drawer", "bottom drawer"}),
        ("microwave", {}, {"door"}),
        ("microwave door", {}, {"door"}),
        ("door", {}, {"door"}),
        ("fridge", {}, set()),
    ],
)
def test_nouns_places_and_pieces_mean_parts(kind, more, meant):
    assert parts(said(kind, **more), {**seen(CABINET), **_numbered(seen(MICROWAVE))}) == meant


@pytest.mark.parametrize(
    ("noun", "relation", "count"),
    [("credenza", None, 3), ("drawer", "credenza", 3), ("credenza drawer", None, 3), ("dresser", None, 0)],
)
def test_a_piece_is_meant_by_what_it_is_called_besides(noun, relation, count):
    look = {
        name: replace(one, moves=replace(one.moves, names=("Credenza",)))
        for name, one in seen(CABINET).items()
    }
    of = None if relation is None else Relation("in", relation)

    assert len(those_meant(said(noun, relation=of), handles_in(look), (), {})) == count


def test_a_door_without_a_model_is_meant_by_what_its_fridge_is_called_besides():
    door = {name: replace(one, moves=None) for name, one in seen(MICROWAVE).items()}
    known = {"fridge": {"larder"}, "table": {"desk"}}

    assert those_meant(said("larder"), handles_in(door), (), known)
    assert not those_meant(said("desk"), handles_in(door), (), known)


def _numbered(look):
    return {f"{name} 9": one for name, one in look.items()}


def test_the_top_one_is_not_the_only_one_that_is_seen(stage_with):
    lowest = [one for one in shown(CABINET) if one.moves is None or one.moves.part == "bottom drawer"]
    stage = stage_with(*lowest)
    leaf = DetectHandle("detect", stage.toolbox)

    status = stage.run(leaf, task=said("drawer", ordinal="top", relation=CABINETS))

    assert status is Status.FAILURE
    assert leaf.failure.kind is FailureKind.POSTCONDITION


@pytest.mark.parametrize("place", ["top", "middle", "bottom"])
def test_each_of_a_column_is_found_and_chosen(stage_with, place):
    stage = stage_with(*shown(CABINET))
    task = said("drawer", ordinal=place, relation=CABINETS)

    assert stage.run(DetectHandle("detect", stage.toolbox), task=task) is Status.SUCCESS
    assert stage.run(ChooseHandle("choose", stage.toolbox, pushed=False), task=task) is Status.SUCCESS
    assert stage.output("handle").moves.part == f"{place} drawer"


def test_what_shows_no_front_and_is_known_to_have_none_is_told_at_once(stage_with):
    pose = poses.translation(1.0, -0.3, 0.9)
    oven = TrueObject("oven", "furniture", "fixture", None, Box((0.3, 0.4, 0.3)), pose)
    stage = stage_with(oven, *shown(MICROWAVE))
    leaf = DetectHandle("detect", stage.toolbox)

    status = stage.run(leaf, task=said("drawer", relation=Relation("in", "oven")))

    assert status is Status.FAILURE
    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert leaf.failure.message == "the oven has no drawer that I can open or close"


def test_what_has_a_door_and_no_drawer_is_told_to_have_none(stage_with):
    stage = stage_with(*shown(MICROWAVE))
    stage.fake.detector.fronts = FRONTS
    leaf = DetectHandle("detect", stage.toolbox)

    status = stage.run(leaf, task=said("drawer", relation=Relation("in", "microwave")))

    assert status is Status.FAILURE
    assert leaf.failure.message == "the microwave has no drawer that I can open or close"


@pytest.mark.parametrize(
    ("noun", "refused"),
    [("microwave", False), ("cabinet", False), ("microwave door", False), ("cup", True), ("kettle", True)],
)
def test_only_what_is_known_to_open_is_looked_for(noun, refused):
    assert bool(opens_nothing(said(noun), FRONTS)) is refused
    assert bool(opens_nothing(CloseTask("close it", ObjectDescription(noun)), FRONTS)) is refused


@pytest.mark.parametrize("opening", [0.0, 0.4, 1.3])
def test_a_door_of_a_model_is_pushed_about_its_hinge_without_its_bar(opening):
    look = {name: one for name, one in seen(MICROWAVE, door=opening).items() if one.kind == "door"}

    (target,) = fronts_in(look)

    assert target.pushed
    assert target.opening == pytest.approx(opening, abs=1e-9)
    arm = look["door"].odom_T_object[:2, 3] - target.path.hinge_m
    assert np.linalg.norm(arm) == pytest.approx(0.18, abs=1e-3)


def test_the_next_drawer_is_not_taken_for_the_one_that_a_hand_comes_to(stage_with):
    others = [one for one in shown(CABINET) if one.moves is None or one.moves.part != "middle drawer"]
    stage = stage_with(*others)
    stage.told.update(believed(seen(CABINET)))
    look = seen(CABINET)
    target = next(one for one in handles_in(look) if one.moves.part == "middle drawer")
    watch = FrontWatch(stage.toolbox, target)

    moved = []
    for _ in range(200):
        stage.fake.step()
        moved.append(watch.moved_m())

    assert not any(moved)
    (own,) = [one for one in shown(CABINET, middle_drawer=0.05) if one.name.endswith("middle drawer/front")]
    stage.fake.world.put(own)
    for _ in range(200):
        stage.fake.step()
        moved.append(watch.moved_m())
    assert any(moved)


def test_a_door_as_small_as_a_microwaves_is_not_pushed(stage_with):
    stage = stage_with(*shown(MICROWAVE, door=0.8))
    stage.fake.detector.fronts = FRONTS
    leaf = DetectFront("detect front", stage.toolbox)

    status = stage.run(leaf, task=CloseTask("close it", ObjectDescription("microwave")))

    assert status is Status.FAILURE
    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert leaf.failure.message == "a door so small is closed by its handle"


def test_of_three_above_each_other_the_middle_one_is_told_by_its_height():
    things = [SceneObject(f"box {k}", Box((0.1, 0.1, 0.05)), poses.translation(0.6, 0.0, z)) for k, z in HIGH]
    around = surroundings(PlanningScene().with_objects(things), np.eye(4), 0.02)

    assert ground(ObjectDescription("box", ordinal="middle"), around) == Found(("box 2",))


def test_a_handle_over_a_table_is_reached_from_the_side_of_the_table_that_is_nearest(stage_with):
    look = seen(CABINET)
    stage = stage_with(*shown(CABINET))
    top = SceneObject("table", Box((0.7, 1.5, 0.04)), poses.translation(0.8, 0.0, 0.83), movable=False)
    stage.told.update(believed(look).with_object(top))
    target = next(one for one in handles_in(look) if one.moves.part == "top drawer")
    leaf = ChooseStandAtHandle("choose", stage.toolbox)
    stage.ready(leaf, task=said("drawer"), handle=target)
    leaf.begin()

    for body, ahead in ((PlanarPose(0.0, -0.2), 0.0), (PlanarPose(1.6, -0.2), np.pi)):
        place = leaf.usual(place_of(target), body)
        assert np.cos(place.yaw_rad - ahead) == pytest.approx(1.0, abs=1e-6)

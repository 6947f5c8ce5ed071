"""Where to stand for an object is where a pick has a plan."""

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.requests.pick import PickRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import cup, table
from trees.beliefs.grounding.destination import Place
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walking.standing_place import standing_place


@pytest.fixture
def before_a_cup(stage):
    """The leaf with a cup on a table that are believed to be there, and the planner's answers to be."""
    things = [table(), cup()]
    solids = [
        SceneObject(one.name, one.shape, one.world_T_object, 0.0, movable=one.category == "object")
        for one in things
    ]
    stage.told.update(stage.told.scene.with_objects(solids))
    seen = Place("red cup", "object", things[1].shape, things[1].world_T_object, 0.9)
    return stage, seen


def run(stage, place, answers):
    """What was chosen, and what the planner was asked."""
    asked = []

    def answer(request):
        asked.append(request)
        return answers(request)

    stage.fake.planning.answer = answer
    assert stage.run(ChooseStand("choose", stage.toolbox), place=place) is Status.SUCCESS
    return stage.output("stand"), asked


def middle(request):
    left, right = (PlanarPose.of(sole) for _, sole in request.stance.soles)
    return PlanarPose.between(left, right)


def test_the_usual_place_is_taken_when_a_pick_has_a_plan_there(before_a_cup):
    stage, place = before_a_cup
    usual = standing_place(place, stage.told.scene, PlanarPose(), 0.05)
    plan = stage.fake.planning.answer

    stand, asked = run(stage, place, plan)

    assert stand.body(place).distance_m(usual) < 1e-9
    assert all(isinstance(request, PickRequest) for request in asked)
    assert middle(asked[0]).distance_m(usual) < 1e-6


def test_a_place_from_which_nothing_is_reached_is_passed_over(before_a_cup):
    stage, place = before_a_cup
    usual = standing_place(place, stage.told.scene, PlanarPose(), 0.05)
    plan = stage.fake.planning.answer

    def answers(request):
        near = middle(request).distance_m(usual) < 0.05
        return NoPlan("out of reach", {}) if near else plan(request)

    stand, _ = run(stage, place, answers)

    assert stand.body(place).distance_m(usual) > 0.05


def test_a_place_that_serves_only_if_it_is_met_exactly_is_passed_over(before_a_cup):
    stage, place = before_a_cup
    plan = stage.fake.planning.answer
    count = iter(range(1000))

    def answers(request):  # the first place itself serves, beside it nothing does
        return plan(request) if next(count) != 1 else NoPlan("out of reach", {})

    stand, asked = run(stage, place, answers)

    assert stand.body(place).distance_m(middle(asked[0])) > 0.05


def test_furniture_is_stood_before_as_usual_and_nobody_is_asked(before_a_cup):
    stage, _ = before_a_cup
    shelf = Place("shelf", "furniture", Box((0.4, 1.0, 0.9)), poses.translation(2.0, 0.0, 0.45), 0.9)

    stand, asked = run(stage, shelf, lambda _request: pytest.fail("nothing is to be planned"))

    assert asked == []
    assert stand.name == "shelf"

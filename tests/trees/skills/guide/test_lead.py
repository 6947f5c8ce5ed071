"""The robot walks ahead of a person, and looks round whether the person comes along."""

import math
from dataclasses import replace

import pytest
from py_trees.common import Status

from kinematics.model.robot_model import RobotModel
from robots.fake.fake_world import person
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.destination import Place, place_of_region
from trees.events import Said
from trees.failures import Reason
from trees.skills.guide import GuideTask
from trees.skills.guide.lead import Lead
from trees.skills.guide.settings import GuideSettings

QUICK = GuideSettings(waits_s=1.0)
KITCHEN = Region("kitchen", (6.0, 0.0), (4.0, 4.0))
TASK = GuideTask("guide Ana to the kitchen", "Ana", to="kitchen")


class Walk:
    """The fake robot leads Ana, whom its camera sees only when she is not behind it."""

    def __init__(self, stage, sees_rad=1.6, neck=True, at_m=(-1.0, 0.0), to=KITCHEN):
        self.stage = stage
        self.comes = True
        self.sees_rad = sees_rad
        self.neck = neck
        toolbox = replace(stage.toolbox, policy=replace(stage.toolbox.policy, skills=(QUICK,)))
        if not neck:
            description = toolbox.model.description
            stiff = replace(
                description.camera, pan_joint=None, tilt_joint=None, horizontal_fov_rad=2.0 * sees_rad
            )
            toolbox = replace(toolbox, model=RobotModel(replace(description, head_camera=stiff)))
        ana = person("Ana", at_m)
        stage.fake.world.put(ana)
        self.leaf = Lead("lead", toolbox)
        stage.ready(
            self.leaf,
            task=TASK,
            place=Place("Ana", "person", ana.shape, ana.world_T_object, 0.9),
            destination=place_of_region("kitchen", to),
        )

    @property
    def feet(self):
        return self.stage.fake.motion.feet()

    @property
    def apart_m(self):
        x, y = self.stage.fake.world.object("Ana").world_T_object[:2, 3]
        return math.dist((x, y), (self.feet.x_m, self.feet.y_m))

    def tick(self):
        world, feet = self.stage.fake.world, self.feet
        x, y = world.object("Ana").world_T_object[:2, 3]
        bearing = math.remainder(math.atan2(y - feet.y_m, x - feet.x_m) - feet.yaw_rad, math.tau)
        # a body that steps sways: what is at the edge of stiff eyes is not in view any more when it stands
        steady = self.neck or self.stage.fake.walking.active
        sees_rad = self.sees_rad if steady else 0.75 * self.sees_rad
        (world.hidden.discard if abs(bearing) < sees_rad else world.hidden.add)("Ana")
        if self.comes and (too_far := self.apart_m - 1.2) > 0.0:
            towards = (feet.x_m - x) / self.apart_m, (feet.y_m - y) / self.apart_m
            world.move("Ana", (min(too_far, 0.3) * towards[0], min(too_far, 0.3) * towards[1], 0.0))
        return self.stage.tick(self.leaf)

    def till_the_end(self, ticks=4000):
        for _ in range(ticks):
            if self.tick() is not Status.RUNNING:
                return self.leaf.status
        raise AssertionError(f"never ended: {self.leaf.feedback_message}")


@pytest.fixture
def walk(stage_with):
    return Walk(stage_with(person("Ana", (-1.0, 0.0)), walks=True))


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


def test_it_arrives_with_the_person(walk):
    status = walk.till_the_end()

    assert status is Status.SUCCESS, walk.leaf.failure
    assert KITCHEN.contains(walk.feet.x_m, walk.feet.y_m)
    assert walk.apart_m <= QUICK.near_m


def test_without_a_neck_it_turns_to_the_person_and_arrives_with_them(stage_with):
    walk = Walk(stage_with(person("Ana", (-1.0, 0.0)), walks=True), sees_rad=1.5, neck=False)

    status = walk.till_the_end()

    x, y = walk.stage.fake.world.object("Ana").world_T_object[:2, 3]
    to_ana = math.atan2(y - walk.feet.y_m, x - walk.feet.x_m)
    assert status is Status.SUCCESS, walk.leaf.failure
    assert abs(math.remainder(to_ana - walk.feet.yaw_rad, math.tau)) < 1.06
    assert walk.stage.output("evidence")["looks"] >= 3


def test_without_a_neck_it_turns_to_who_is_at_the_edge_of_its_view(stage_with):
    edge = 1.2 * math.cos(1.1), 1.2 * math.sin(1.1)
    here = Region("kitchen", (0.0, 0.0), (4.0, 4.0))
    walk = Walk(stage_with(person("Ana", edge), walks=True), sees_rad=1.5, neck=False, at_m=edge, to=here)

    status = walk.till_the_end()

    assert status is Status.SUCCESS, walk.leaf.failure
    assert 0.2 < walk.feet.yaw_rad < 1.3


def test_it_looks_round_after_each_stretch(walk):
    walk.till_the_end()

    assert walk.stage.output("evidence")["looks"] >= 3


def test_somebody_who_stays_behind_in_view_is_told_not_to_come(walk):
    walk.comes = False

    assert walk.till_the_end() is Status.FAILURE
    assert "Ana does not come along" in walk.leaf.failure.message


def test_it_goes_no_farther_than_a_stretch_without_the_person(walk):
    walk.comes = False

    walk.till_the_end()

    assert walk.feet.x_m < QUICK.stretch_m + 0.6


def test_somebody_who_is_nowhere_to_be_seen_is_told_to_be_lost(walk):
    for _ in range(5):
        walk.tick()
    walk.comes = False
    walk.stage.fake.world.move("Ana", (0.0, 0.0, 0.0))
    walk.stage.fake.detector.blind = True

    assert walk.till_the_end() is Status.FAILURE
    assert walk.leaf.failure.reason is Reason.PERSON_LOST
    assert said(walk.stage) == ["I lost Ana."]


def test_it_waits_for_somebody_who_is_slow(walk):
    walk.comes = False
    while walk.feet.x_m < 1.0 or walk.stage.fake.walking.active:
        walk.tick()
    walk.comes = True

    assert walk.till_the_end() is Status.SUCCESS, walk.leaf.failure

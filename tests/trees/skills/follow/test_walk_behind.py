"""The robot walks behind a person who walks, and stands where the person stands."""

import math
from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from kinematics.walking.pattern.gazing import Gazing
from robots.fake.fake_world import person
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.destination import Place
from trees.events import Said
from trees.failures import FailureKind, Reason
from trees.skills.follow import FollowTask
from trees.skills.follow.settings import FollowSettings
from trees.skills.follow.walk_behind import WalkBehind

QUICK = FollowSettings(lost_s=0.6, still_s=0.5, sets_out_s=1.0, stays_s=1.0)
SPEED_M_S = 0.4
PERIOD_S = 0.02


class Walk:
    """A person who walks before the fake robot, whose feet make one step each period."""

    def __init__(self, stage, others=()):
        self.stage = stage
        self.others = others
        self.steered = []
        walking = stage.fake.walking
        steer, walk = walking.steer, walking.walk
        walking.walk = lambda steering, name: self.steered.append(steering) or walk(steering, name)
        walking.steer = lambda handle, steering: self.steered.append(steering) or steer(handle, steering)

    @property
    def at(self):
        return self.stage.fake.world.object("Ana").world_T_object[:2, 3]

    @property
    def apart_m(self):
        feet = self.stage.fake.motion.feet()
        return math.dist(self.at, (feet.x_m, feet.y_m))

    def along(self, leaf, *way):
        """Tick the leaf while the person walks from point to point; the least distance on the way."""
        least_m = math.inf
        for point in way:
            while (left := np.array(point) - self.at) @ left > 1e-6:
                step = left * min(1.0, SPEED_M_S * PERIOD_S / float(np.linalg.norm(left)))
                self.stage.fake.world.move("Ana", (*step, 0.0))
                self.tick(leaf)
                least_m = min(least_m, self.apart_m)
        return least_m

    def tick(self, leaf):
        """Let a period pass; a leaf that has ended is not begun again."""
        if leaf.status in (Status.SUCCESS, Status.FAILURE):
            return leaf.status
        return self.stage.tick(leaf)

    def till_the_end(self, leaf, ticks=2000):
        for _ in range(ticks):
            if self.tick(leaf) is not Status.RUNNING:
                return leaf.status
        raise AssertionError(f"never ended: {leaf.feedback_message}")


def leaf_on(stage, task, settings=QUICK, places=None):
    toolbox = replace(
        stage.toolbox, policy=replace(stage.toolbox.policy, skills=(settings,)), places=places or {}
    )
    ana = person()
    leaf = WalkBehind("walk behind", toolbox)
    stage.ready(leaf, task=task, place=Place("Ana", "person", ana.shape, ana.world_T_object, 0.9))
    return leaf


@pytest.fixture
def walk(stage_with):
    return Walk(stage_with(person(), walks=True))


ANA = FollowTask("follow Ana", "Ana")


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


def test_it_stands_a_metre_behind_where_the_person_stands(walk):
    leaf = leaf_on(walk.stage, ANA)

    walk.along(leaf, (3.5, 0.2), (3.5, 2.0))

    assert walk.till_the_end(leaf) is Status.SUCCESS
    assert 0.9 <= walk.apart_m <= QUICK.distance_m + QUICK.slack_m


def test_it_never_comes_nearer_than_its_distance(walk):
    leaf = leaf_on(walk.stage, ANA)

    assert walk.along(leaf, (3.5, 0.2), (3.5, 2.0)) > 0.9


def test_what_proves_it_is_who_was_followed_and_how_far(walk):
    leaf = leaf_on(walk.stage, ANA)

    walk.along(leaf, (4.3, 0.2))
    walk.till_the_end(leaf)

    evidence = walk.stage.output("evidence")
    assert evidence["followed"] == "Ana"
    assert evidence["walked_m"] == pytest.approx(3.3, abs=0.3)


def test_the_head_follows_the_person_while_the_feet_walk(walk):
    leaf = leaf_on(walk.stage, ANA)

    walk.along(leaf, (3.0, 0.2), (3.0, 1.2))

    assert all(isinstance(one, Gazing) for one in walk.steered)
    assert max(one.pan_rad for one in walk.steered) > 0.2


def test_somebody_who_never_sets_out_was_not_followed(walk):
    leaf = leaf_on(walk.stage, ANA)

    assert walk.till_the_end(leaf) is Status.FAILURE
    assert "Ana does not walk" in leaf.failure.message


def test_somebody_out_of_sight_is_told_to_be_lost(walk):
    leaf = leaf_on(walk.stage, ANA)
    walk.along(leaf, (3.0, 0.2))
    walk.stage.fake.world.remove("Ana")

    status = walk.till_the_end(leaf)

    assert said(walk.stage) == ["I lost Ana."]
    assert (status, leaf.failure.reason) == (Status.FAILURE, Reason.PERSON_LOST)


def test_that_somebody_is_lost_is_told_while_the_robot_still_stops(walk):
    leaf = leaf_on(walk.stage, ANA)
    walk.along(leaf, (3.0, 0.2))
    began_s = walk.stage.fake.clock.now_s()
    walk.stage.fake.world.remove("Ana")

    walk.till_the_end(leaf)

    (told_s,) = (event.t_s for event in walk.stage.events if isinstance(event, Said))
    assert told_s - began_s == pytest.approx(QUICK.lost_s, abs=0.1)


def test_a_missing_picture_is_no_loss(walk):
    leaf = leaf_on(walk.stage, ANA)
    walk.along(leaf, (2.0, 0.2))
    walk.stage.fake.detector.blind = True
    walk.along(leaf, (2.1, 0.2))
    walk.stage.fake.detector.blind = False

    walk.along(leaf, (3.0, 0.2))

    assert walk.till_the_end(leaf) is Status.SUCCESS
    assert said(walk.stage) == []


def test_somebody_else_who_walks_by_is_not_followed(stage_with):
    walk = Walk(stage_with(person(), person("Ben", (1.5, -0.6)), walks=True))
    leaf = leaf_on(walk.stage, ANA)
    walk.stage.fake.world.hidden.add("Ana")

    for _ in range(100):
        walk.stage.fake.world.move("Ben", (0.01, 0.0, 0.0))
        walk.tick(leaf)

    assert leaf.failure.reason is Reason.PERSON_LOST


def test_with_a_goal_it_ends_when_both_are_there(walk):
    kitchen = {"kitchen": Region("kitchen", (5.0, 0.0), (4.0, 4.0))}
    leaf = leaf_on(walk.stage, replace(ANA, to="kitchen"), places=kitchen)

    walk.along(leaf, (6.0, 0.2))
    status = walk.till_the_end(leaf)

    assert status is Status.SUCCESS, leaf.failure
    assert walk.stage.fake.motion.feet().x_m > 3.0


def test_somebody_who_stays_on_the_way_has_not_reached_the_goal(walk):
    kitchen = {"kitchen": Region("kitchen", (5.0, 0.0), (2.0, 4.0))}
    leaf = leaf_on(walk.stage, replace(ANA, to="kitchen"), places=kitchen)

    walk.along(leaf, (2.5, 0.2))

    assert walk.till_the_end(leaf) is Status.FAILURE
    assert "has not reached the kitchen" in leaf.failure.message


def test_a_robot_with_walls_all_around_stays(walk):
    turns = [poses.transform(poses.rotation_z(k * math.pi / 2), (0.0, 0.0, 0.0)) for k in range(4)]
    walls = [
        SceneObject(f"wall {k}", Box((0.1, 2.4, 2.0)), turn @ poses.translation(1.1, 0.0, 1.0), 0.0, False)
        for k, turn in enumerate(turns)
    ]
    walk.stage.told.update(walk.stage.told.scene.with_objects(walls))
    leaf = leaf_on(walk.stage, ANA)

    walk.along(leaf, (3.0, 0.2))

    assert walk.stage.fake.motion.feet().x_m < 0.6
    assert "no way leads to Ana" in leaf.feedback_message


def test_a_robot_without_legs_says_so(stage_with):
    leaf = leaf_on(stage_with(person()), ANA)

    leaf.tick_once()

    assert (leaf.failure.kind, leaf.failure.reason) == (FailureKind.INFEASIBLE, Reason.CANNOT_WALK)

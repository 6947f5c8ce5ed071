"""Walks in the simulator, on the robot's own sensors."""

import dataclasses

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.walking.pattern.gazing import Gazing
from kinematics.walking.pattern.steering import VelocitySteering
from robots.clock import ManualClock
from robots.control.gate.refusal import Limit, Refusal
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.interface.hardware import RobotData
from robots.models.description import load_description, load_robot
from robots.scenes.scene_description import Furniture, PerceptionModel, Person, RobotStart, SceneDescription
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


class Floor:
    """TALOS on a floor, with a control loop."""

    def __init__(self, *people, furniture=(), **changed):
        description = load_description("talos")
        if changed:
            description = dataclasses.replace(description, **changed)
        scene = SceneDescription("floor", RobotStart(), PerceptionModel(), furniture=furniture, people=people)
        self.world = build_world(RobotData(description, HARDWARE), scene, np.random.default_rng(3))
        self.events = []
        self.loop = ControlLoop(
            self.world.robot, RobotModel(description), ManualClock(), self.events.append, PERIOD_S
        )
        self.settings = description.walking
        self.run(0.3)

    def run(self, seconds):
        for _ in range(round(seconds / PERIOD_S)):
            self.loop.step()

    def walk(self, linear, angular=0.0):
        return self.loop.walking.walk(VelocitySteering(self.settings, linear, angular), "walk")

    def until_it_stands(self, most_s=6.0):
        """How long that takes."""
        for k in range(round(most_s / PERIOD_S)):
            if not self.loop.walking.active:
                return k * PERIOD_S
            self.loop.step()
        raise AssertionError("it walks on")


@pytest.mark.requirement("M6")
def test_the_robot_walks_and_stands_where_it_believes_to_stand():
    floor = Floor()

    handle = floor.walk(0.3)
    floor.run(3.0)
    floor.loop.walking.finish(handle)
    floor.until_it_stands()
    floor.run(0.3)

    truth, believed = floor.world.truth.world_T_base(), floor.loop.sensing.state().q
    assert handle.status is MotionStatus.DONE
    assert not floor.world.truth.fallen()
    assert 0.45 < truth[0, 3] < 0.9
    assert np.linalg.norm(believed[:3] - truth[:3, 3]) < 0.02
    assert floor.loop.statistics.refused == 0
    assert np.linalg.norm(floor.loop.motion.reference()[:3] - believed[:3]) < 0.01


def test_the_head_turns_while_the_robot_walks_and_stays_there():
    floor = Floor()
    model = floor.loop.model
    pan = 7 + model.joint_index(model.description.camera.pan_joint)

    handle = floor.loop.walking.walk(Gazing(VelocitySteering(floor.settings, 0.3, 0.0), 0.8, 0.2), "walk")
    floor.run(2.5)
    on_the_way = floor.loop.sensing.state().q[pan]
    floor.loop.walking.finish(handle)
    floor.until_it_stands()
    floor.run(0.3)

    assert on_the_way == pytest.approx(0.8, abs=0.03)
    assert floor.loop.motion.reference()[pan] == pytest.approx(0.8, abs=0.01)
    assert floor.loop.statistics.refused == 0
    assert handle.status is MotionStatus.DONE


def test_a_head_that_turns_as_the_robot_stops_comes_to_rest_with_it():
    floor = Floor()
    model = floor.loop.model
    pan = 7 + model.joint_index(model.description.camera.pan_joint)

    handle = floor.loop.walking.walk(VelocitySteering(floor.settings, 0.3, 0.0), "walk")
    floor.run(2.5)
    floor.loop.walking.steer(handle, Gazing(VelocitySteering(floor.settings, 0.0, 0.0), -1.2, 0.2))
    floor.until_it_stands()
    rested = floor.loop.motion.reference()[pan]
    floor.run(0.3)

    assert rested < -0.3
    assert floor.loop.motion.reference()[pan] == rested
    assert floor.loop.statistics.refused == 0


@pytest.mark.requirement("S4")
def test_the_emergency_stop_makes_the_last_steps_and_stays_engaged():
    floor = Floor()

    handle = floor.walk(0.4)
    floor.run(1.9)
    floor.loop.emergency_stop("the button")
    took_s = floor.until_it_stands()

    assert handle.status is MotionStatus.CANCELED
    assert took_s <= 2.2
    assert not floor.world.truth.fallen()
    assert floor.walk(0.2).status is MotionStatus.REFUSED


def test_a_refused_setpoint_in_mid_step_does_not_make_it_fall():
    floor = Floor()
    handle = floor.walk(-0.3)
    floor.run(1.5)

    submit = floor.loop._gate.submit
    floor.loop._gate.submit = lambda setpoint: Refusal(Limit.AGE, "nobody", 1.0, 0.0)
    floor.loop.step()
    floor.loop._gate.submit = submit
    floor.until_it_stands()

    assert handle.status is MotionStatus.REFUSED
    assert not floor.world.truth.fallen()


@pytest.mark.parametrize("periods", [1, 12])
def test_a_foot_out_of_the_legs_reach_ends_the_walk_and_not_the_control(periods):
    floor = Floor()
    handle = floor.walk(-0.3)
    floor.run(1.5)

    legs = floor.loop.walking._walk._body._legs
    fill, legs.fill = legs.fill, lambda *_: False
    floor.run(periods * PERIOD_S)
    legs.fill = fill
    refused = floor.loop.statistics.refused
    floor.until_it_stands()

    assert handle.status is MotionStatus.REFUSED
    assert "reach" in handle.reason
    assert not floor.world.truth.fallen()
    assert refused == periods
    # an instant needs those around it, and the way back to a motion that went on may be refused once
    assert refused + 2 <= floor.loop.statistics.refused <= refused + 3


def test_a_robot_of_which_no_gait_is_known_refuses():
    handle = Floor(walking=None).loop.walking.walk(None, "walk")

    assert handle.status is MotionStatus.REFUSED
    assert "not known to walk" in handle.reason


def test_nothing_else_moves_the_body_during_a_walk():
    floor = Floor()
    floor.walk(0.2)

    second = floor.walk(0.1)

    assert second.status is MotionStatus.REFUSED
    assert floor.loop.still is False


@pytest.mark.requirement("M6")
def test_a_paused_walk_stands_still_and_goes_on_afterwards():
    floor = Floor()
    handle = floor.walk(0.3)
    floor.run(2.0)

    floor.loop.pause("by the test")
    floor.until_it_stands()
    stood = floor.world.truth.world_T_base()[:3, 3]
    floor.run(0.5)
    assert np.linalg.norm(floor.world.truth.world_T_base()[:3, 3] - stood) < 0.005
    assert handle.status is MotionStatus.RUNNING

    floor.loop.resume()
    floor.run(2.0)
    floor.loop.walking.finish(handle)
    floor.until_it_stands()

    assert handle.status is MotionStatus.DONE
    assert floor.world.truth.world_T_base()[0, 3] > stood[0] + 0.15
    assert not floor.world.truth.fallen()
    assert floor.loop.statistics.refused == 0


@pytest.mark.requirement("S4")
def test_a_walk_that_stands_in_a_pause_ends_with_a_stop():
    floor = Floor()
    handle = floor.walk(0.3)
    floor.run(1.0)
    floor.loop.pause("by the test")
    floor.until_it_stands()

    floor.loop.emergency_stop("the button")
    floor.loop.resume()
    floor.run(0.5)

    assert handle.status is MotionStatus.CANCELED
    assert not floor.loop.walking.active


@pytest.mark.parametrize("how", ["finish", "cancel", "pause"])
def test_a_walk_tells_that_it_ends_from_the_order_until_it_stands(how):
    floor = Floor()
    handle = floor.walk(0.3)
    floor.run(1.5)
    assert not floor.loop.walking.ending

    match how:
        case "finish":
            floor.loop.walking.finish(handle)
        case "cancel":
            floor.loop.walking.cancel(handle, "by the test")
        case "pause":
            floor.loop.walking.pause()

    assert floor.loop.walking.ending
    floor.until_it_stands()
    assert not floor.loop.walking.ending


@pytest.mark.parametrize("order", ["finish first", "in its last steps", "standing"])
def test_a_paused_walk_that_is_to_end_ends_where_it_stands(order):
    floor = Floor()
    handle = floor.walk(0.3)
    floor.run(1.5)

    if order == "finish first":
        floor.loop.walking.finish(handle)
    floor.loop.pause("by the test")
    floor.run(3.0 if order == "standing" else 0.3)
    floor.loop.resume()
    if order != "finish first":
        floor.loop.walking.finish(handle)
    floor.until_it_stands()
    floor.run(0.1)

    assert handle.status is MotionStatus.DONE
    assert not floor.loop.walking.active
    assert floor.loop.still


@pytest.mark.requirement("S4")
def test_a_push_that_the_sole_cannot_hold_is_caught_with_the_next_steps():
    floor = Floor()
    handle = floor.walk(0.12)
    floor.run(2.6)
    pattern = floor.loop.walking._walk.pattern
    pelvis = floor.world.physics.data.xfrc_applied[floor.world.physics.body_id("base_link")]

    pelvis[:2] = -350.0, -100.0
    floor.run(0.1)
    pelvis[:2] = 0.0
    catches, ways = pattern.catch, []
    pattern.catch = lambda error: ways.append(catches(error))
    floor.run(2.0)
    floor.loop.walking.finish(handle)
    floor.until_it_stands()
    floor.run(0.3)

    assert any(ways)
    assert not floor.world.truth.fallen()


@pytest.mark.parametrize("walks", [True, False])
def test_a_robot_that_was_thrown_down_lies_still_and_says_so(walks):
    floor = Floor()
    handle = floor.walk(0.2) if walks else None
    floor.run(1.5)
    pelvis = floor.world.physics.data.xfrc_applied[floor.world.physics.body_id("base_link")]

    pelvis[:2] = -200.0, -1500.0
    floor.run(0.3)
    pelvis[:2] = 0.0
    floor.run(4.0)

    engaged = floor.loop.emergency
    assert floor.world.truth.fallen()
    assert engaged.category == 0
    assert engaged.reason.startswith("fallen: base_link (")
    assert handle is None or handle.finished
    assert not floor.loop.walking.active
    assert np.abs(floor.world.physics.data.qvel).max() < 0.3


@pytest.mark.requirement("S4")
def test_a_walk_ends_when_legs_or_trunk_meet_furniture_that_nobody_saw():
    floor = Floor(furniture=(Furniture("wall", "wall", (0.1, 3.0, 0.5), (0.9, 0.0), 0.0, 0.7),))

    handle = floor.walk(0.3)
    for _ in range(round(6.0 / PERIOD_S)):
        if handle.finished:
            break
        floor.loop.step()
    floor.until_it_stands()
    floor.run(0.3)

    assert handle.status is MotionStatus.REFUSED
    assert handle.reason.startswith("unexpected force of something on the body")
    assert not floor.world.truth.fallen()


@pytest.mark.requirement("S4")
def test_a_walk_ends_when_a_hand_meets_somebody_who_stands_beside_its_way():
    floor = Floor(Person("Ana", (1.0, -0.6), 0.0))

    handle = floor.walk(0.3)
    for _ in range(round(5.0 / PERIOD_S)):
        if handle.finished:
            break
        floor.loop.step()
    pressed_n = max(
        (contact.force_n for contact in floor.world.truth.contacts.robot_with_people()), default=0.0
    )
    took_s = floor.until_it_stands()

    assert handle.status is MotionStatus.REFUSED
    assert handle.reason.startswith("unexpected contact of arm_right_")
    assert 0.0 < pressed_n < 120.0
    assert took_s <= 2.2
    assert not floor.world.truth.fallen()

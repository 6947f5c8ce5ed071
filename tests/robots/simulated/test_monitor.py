"""The monitor remembers what an evaluation asks for."""

import numpy as np
import pytest

from kinematics import poses
from robots.scene_file import load_scene
from robots.simulated.monitor import Monitor


def test_a_lift_is_measured_from_leaving_the_ground(cup_in_hand):
    hold = cup_in_hand(hand="left")
    monitor = Monitor(hold.truth)

    for _ in range(500):
        hold.stand.step()
        monitor.tick()

    assert monitor.held_for_s("cup") == pytest.approx(1.0, abs=0.003)
    assert monitor.lifted_for_s("cup") == pytest.approx(1.0, abs=0.003)
    assert monitor.max_slip_m("cup") < 0.0005
    assert [record.hand for record in monitor.holds["cup"]] == ["left"]
    assert monitor.furniture_contacts == {}
    assert monitor.object_contacts == {}
    assert monitor.min_com_margin_m > 0.05
    assert monitor.fell_at_s is None


def test_a_hold_ends_when_the_object_is_taken_away(cup_in_hand):
    hold = cup_in_hand()
    monitor = Monitor(hold.truth)
    for i in range(200):
        if i == 100:
            hold.stand.world.faults.remove("cup")
        hold.stand.step()
        monitor.tick()

    assert monitor.held_for_s("cup") == 0.0
    assert monitor.lifted_for_s("cup") == 0.0


def test_slip_in_the_hand_is_seen(cup_in_hand):
    hold = cup_in_hand(mass_kg=0.5)
    monitor = Monitor(hold.truth)
    for i in range(100):
        if i == 50:
            hold.stand.world.faults.set_pad_friction("cup", 0.08)
        hold.stand.step()
        monitor.tick()

    assert monitor.max_slip_m("cup") > 0.005


def test_a_palm_against_an_object_is_remembered_with_its_force(stand):
    body = stand(load_scene("tabletop"))
    monitor = Monitor(body.truth)
    palm = body.truth.world_T_link("gripper_left_base_link")[:3, 3]
    for i in range(50):
        if i == 10:
            body.world.faults.teleport("red cup", poses.translation(palm[0], palm[1], palm[2] + 0.13))
        body.step()
        monitor.tick()
    body.run(0.2, monitor.tick)

    assert any("left" in link and item == "red cup" for link, item in monitor.object_contacts)
    assert max(monitor.object_contacts.values()) > 0.5


def test_an_idle_robot_touches_nothing(stand):
    body = stand(load_scene("clutter"))
    monitor = Monitor(body.truth)

    body.run(0.5, monitor.tick)

    assert monitor.furniture_contacts == monitor.object_contacts == monitor.people_contacts == {}
    assert monitor.holds == {}
    assert np.isfinite(monitor.min_com_margin_m)

"""A body that asks for its emergency stop itself: a button on it, a wire that fails."""

from dataclasses import replace

from robots.control.events import EmergencyStopped
from robots.control.loop.emergency_stop import PersonsReset
from robots.control.motion_handle import MotionStatus

WHY = "the remote's stop (L2 and B)"


def alarmed(rig, monkeypatch, why):
    """From now on the body's readings carry an alarm."""
    read = type(rig.robot).read
    monkeypatch.setattr(rig.robot, "read", lambda: replace(read(rig.robot), alarm=why))


def test_an_alarm_of_the_body_engages_the_emergency_stop_with_its_reason(rig, motions, monkeypatch):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8))
    rig.run(0.2)

    alarmed(rig, monkeypatch, WHY)
    rig.run(1.0)

    assert rig.loop.emergency.reason == WHY
    assert handle.status is MotionStatus.CANCELED
    assert rig.loop.still
    assert [event.reason for event in rig.of_kind(EmergencyStopped)] == [WHY]


def test_a_reset_while_the_alarm_lasts_is_followed_by_the_next_stop(rig, monkeypatch):
    alarmed(rig, monkeypatch, WHY)
    rig.run(0.1)

    rig.loop.reset(PersonsReset("Ana"))
    rig.run(0.1)

    assert rig.loop.emergency is not None


def test_once_the_alarm_is_over_a_person_resets(rig, monkeypatch):
    alarmed(rig, monkeypatch, WHY)
    rig.run(0.1)
    alarmed(rig, monkeypatch, "")
    rig.run(0.1)
    assert rig.loop.emergency is not None

    assert rig.loop.reset(PersonsReset("Ana")) is None
    rig.run(0.1)

    assert rig.loop.emergency is None

"""Nothing that arrives is trusted: who may command, what may be streamed, and who may always stop."""

import os

import pytest

from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from robots.live.wire.messages import (
    CancelMotion,
    GetStatus,
    Guarded,
    Heartbeat,
    Hello,
    Offer,
    Reset,
    Shutdown,
    Start,
    Stop,
)

UNSAFE = Unsafe((Finding(FindingKind.SCENE_COLLISION, 0.2, ("hand", "table"), -0.01, 0.0),))


def moving(live, client, seconds=0.4):
    """Have an admitted trajectory begun, with heartbeats."""
    client.admit(1)
    live.run(0.01)
    client.say(Start(*client.next(), 1, 1))
    live.run(seconds, beats(live, client))
    assert not live.loop.motion.resting
    return client


def beats(live, client):
    """A heartbeat every 20 ms."""
    count = 0

    def each():
        nonlocal count
        if count % 10 == 0:
            client.say(Heartbeat(*client.next(), True, False, False, 0))
        count += 1

    return each


@pytest.mark.requirement("S6")
def test_an_admitted_trajectory_is_streamed_to_its_end(live):
    client = moving(live, live.client("commander"))

    live.run(1.2, beats(live, client))

    assert client.of("admitted") == [{"type": "admitted", "trajectory": 1}]
    assert client.of("motion")[-1]["status"] == "done"
    assert not live.stops


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("answer", [UNSAFE, "the document says nothing"], ids=["unsafe", "not judged"])
def test_what_the_own_checker_does_not_let_pass_is_never_streamed(live, answer):
    client, live.checker.answer = live.client("commander"), answer

    client.admit(1)
    live.run(0.01)
    client.say(Start(*client.next(), 1, 1))
    live.run(0.1)

    assert live.loop.statistics.checked_trajectories == 0
    assert client.of("motion")[-1]["status"] == "refused"
    assert client.of("unsafe") or client.of("rejected")


@pytest.mark.requirement("S6")
def test_a_trajectory_that_was_never_admitted_is_refused(live):
    client = live.client("commander")

    client.say(Start(*client.next(), 1, 99))
    live.run(0.1)

    (answer,) = client.of("motion")
    assert answer["status"] == "refused"
    assert "not admitted" in answer["reason"]


@pytest.mark.requirement("S6", "F4")
def test_a_trajectory_for_a_scene_that_is_gone_is_refused(live):
    client = live.client("commander")

    client.admit(1, world_version=4)
    live.run(0.01)
    client.say(Heartbeat(*client.next(), True, False, False, 5))
    client.say(Start(*client.next(), 1, 1))
    live.run(0.1)

    (answer,) = client.of("motion")
    assert "stale" in answer["reason"]
    assert live.loop.motion.resting


@pytest.mark.requirement("F4")
@pytest.mark.parametrize("age_s", [0.6, 5.0, -0.1])
def test_a_command_from_another_time_is_refused(live, age_s):
    client = live.client("commander")
    live.run(6.0, beats(live, client))
    client.admit(1)
    live.run(0.01)

    number, now_s = client.next()
    client.say(Start(number, now_s - age_s, 1, 1))
    live.run(0.05)

    assert "stale" in client.of("refused")[0]["reason"]
    assert live.loop.motion.resting


@pytest.mark.requirement("F4")
def test_a_command_that_comes_twice_or_out_of_order_is_ignored(live):
    client = live.client("commander")
    client.admit(1)
    client.admit(2)
    live.run(0.01)

    number, now_s = client.next()
    client.say(Start(number, now_s, 1, 1))
    client.say(Start(number, now_s, 2, 2))
    client.say(Start(number - 1, now_s, 3, 2))
    live.run(0.01)

    assert live.loop.statistics.checked_trajectories == 1
    assert len(client.of("ignored")) == 2


@pytest.mark.requirement("S3")
def test_a_commander_that_falls_silent_is_stopped_within_eleven_tenths_of_a_second_and_let_go(live):
    client = moving(live, live.client("commander"), 0.1)
    live.checker.answer = None
    silent_s = live.clock.now_s()

    live.run(1.2)

    (stop,) = live.stops
    assert stop.category == 1
    assert "no heartbeat" in stop.reason
    assert 0.95 <= stop.t_s - silent_s <= 1.12
    assert client.of("error")
    assert client.connection.closed


@pytest.mark.requirement("S3")
def test_a_commander_that_hangs_at_rest_loses_its_place_and_nothing_is_stopped(live):
    client = live.client("commander")

    live.run(3.2)

    assert not live.stops
    assert client.of("error")
    assert live.client("commander").of("welcome")


@pytest.mark.requirement("S3")
def test_heartbeats_that_are_late_feed_nobody(live):
    client = moving(live, live.client("commander"), 0.1)
    silent_s = live.clock.now_s()

    def old_beats():
        client.say(Heartbeat(client.next()[0], silent_s - 0.6, True, False, False, 0))

    live.run(1.2, old_beats)

    assert live.stops
    assert "no heartbeat" in live.stops[0].reason


@pytest.mark.requirement("S3")
def test_the_end_of_the_connection_stops_what_moves_in_the_next_period(live):
    client = moving(live, live.client("commander"))
    ended_s = live.clock.now_s()

    client.connection.close("")
    live.run(0.01)

    (stop,) = live.stops
    assert stop.category == 1
    assert stop.t_s - ended_s <= 0.0041
    live.run(1.0)
    assert live.loop.motion.resting


@pytest.mark.requirement("S3")
def test_after_the_end_of_one_commander_another_may_attach_and_move(live):
    moving(live, live.client("commander")).connection.close("")
    live.run(1.0)
    assert live.client("commander").of("welcome")


def test_there_is_one_commander_at_a_time(live):
    live.client("commander")
    second = live.client("commander")

    assert f"process {os.getpid()}" in second.of("refused")[0]["reason"]
    assert second.connection.closed


@pytest.mark.parametrize(
    "message",
    [Start(1, 0.0, 1, 1), Heartbeat(1, 0.0, True, False, False, 0), CancelMotion(1, 1, "x"),
     Guarded(1, 0.0, 1, "close gripper", "left", 0.0), Offer(1, "Ana")],
    ids=lambda message: type(message).__name__,
)  # fmt: skip
def test_an_observer_cannot_command(live, message):
    observer = live.client("observer")

    observer.say(message)
    live.run(0.01)

    assert "only the commander" in observer.of("error")[0]["reason"]
    assert live.loop.motion.resting
    assert not live.offered_at_s


def test_what_is_held_out_is_told_to_the_people_who_are_there(live):
    commander = live.client("commander")

    commander.say(Offer(commander.next()[0], "Ana"))
    live.run(0.01)

    assert [person for _, person in live.offered_at_s] == ["Ana"]
    assert live.loop.motion.resting


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("category", [1, 2])
def test_anybody_can_stop_past_the_commander_and_it_latches_until_a_reset(live, category):
    client = moving(live, live.client("commander"))
    stranger = live.client()

    stranger.say(Stop(category, "a person said so"))
    live.run(0.8, beats(live, client))

    assert stranger.of("done")
    assert [stop.category for stop in live.stops] == [category]
    assert live.loop.motion.resting
    live.checker.answer = None
    client.say(Guarded(*client.next(), 5, "open gripper", "left", 0.0))
    live.run(0.1, beats(live, client))
    assert "emergency" in client.of("motion")[-1]["reason"]
    stranger.say(Reset("somebody"))
    live.run(0.01, beats(live, client))
    client.say(Guarded(*client.next(), 6, "open gripper", "left", 0.0))
    live.run(0.02, beats(live, client))
    assert [m["engaged"] for m in client.of("emergency")] == ["a person said so", ""]
    assert live.loop.emergency is None
    assert not [m for m in client.of("motion") if m["motion"] == 6 and m["status"] == "refused"]


def test_a_reset_while_the_robot_still_moves_is_refused(live):
    moving(live, live.client("commander"))
    stranger = live.client()

    stranger.say(Stop(1, "now"))
    stranger.say(Reset("somebody"))
    live.run(0.004)

    assert "not come to rest" in stranger.of("refused")[0]["reason"]
    assert live.loop.emergency is not None


def test_a_stop_gets_through_when_all_connections_are_taken(live):
    client = moving(live, live.client("commander"))
    observer = live.client("observer")
    for _ in range(40):
        live.client()
        live.run(0.002, beats(live, client))
    late = live.client()

    late.say(Stop(1, "through the crowd"))
    live.run(0.02, beats(live, client))

    assert live.loop.emergency.reason == "through the crowd"
    for known in (client, observer):
        known.listen()
        assert not known.connection.closed


def test_the_status_tells_how_things_stand(live):
    client = moving(live, live.client("commander"))
    asking = live.client()

    asking.say(GetStatus())
    live.run(0.01, beats(live, client))

    (status,) = asking.of("status")
    assert status["under_way"]
    assert status["motions"] == ["trajectory"]
    assert status["commander"] == os.getpid()


def test_hello_is_said_once_and_shutdown_is_heard(live):
    client = live.client("observer")
    client.say(Hello("commander"))
    live.run(0.01)
    other = live.client()
    other.say(Shutdown())
    live.run(0.01)

    assert client.of("error")
    assert live.server.ending

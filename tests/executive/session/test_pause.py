"""A pause is asked for at any time, and begins and ends between two ticks."""

from executive.session.events import InputTaken
from executive.session.pause import Pause


class Robot:
    """Notes when it is to be held."""

    def __init__(self):
        self.told = []

    def pause(self, reason):
        self.told.append(reason)

    def resume(self):
        self.told.append("it goes on")


def made(robot=None):
    events = []
    return Pause(robot, events.append, lambda: 1.5), events


def test_a_pause_begins_when_it_is_followed_and_not_when_it_is_asked_for():
    robot = Robot()
    pause, events = made(robot)
    pause.ask("a moment")

    assert (pause.held, robot.told) == (False, [])
    assert pause.follow()
    assert pause.follow()
    assert (pause.held, robot.told) == (True, ["a moment"])
    assert events == [InputTaken(1.5, "pause", "a moment")]


def test_a_pause_that_is_withdrawn_lets_the_robot_go_on():
    robot = Robot()
    pause, events = made(robot)
    pause.ask("a moment")
    pause.follow()
    pause.withdraw()

    assert not pause.follow()
    assert robot.told == ["a moment", "it goes on"]
    assert events[1:] == [InputTaken(1.5, "resume", "")]


def test_a_pause_ends_with_the_task_that_it_held():
    pause, _events = made()
    pause.ask("a moment")
    pause.follow()

    pause.end()

    assert not pause.held
    assert not pause.follow()


def test_a_pause_that_has_not_begun_at_the_end_of_a_task_holds_the_next_one():
    pause, events = made()
    pause.ask("a moment")

    pause.end()

    assert not events
    assert pause.follow()

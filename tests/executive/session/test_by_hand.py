"""A person takes a task over in the simulated world, and gives it back."""

import numpy as np
import pytest

from executive.manual.words import BaseJog, ByHandTask, GripJog
from executive.session.assembly import assemble
from executive.session.driver import Driver
from kinematics.following.jog_reference import HandJog
from kinematics.walking.pattern.pattern_sample import Phase
from robots.scenes.scene_file import load_scene
from trees.tasks import ObjectDescription, PickTask

UP = HandJog("right", "world", np.array([0.0, 0.0, 0.05]), np.zeros(3))


@pytest.fixture
def assembly():
    return assemble("talos", load_scene("tabletop"), 3)


class Person:
    """Says one word for a while, then silence, then that something is so."""

    def __init__(self, session, words, ending):
        self.feed, self.now_s = session.hands.feed, lambda: session.now_s
        self._words, self._ending = list(words), ending
        self._until_s = None

    def act(self):
        if not self.feed.active:
            return
        if not self._words:
            self.feed.hand_back(self._ending)
            return
        word, seconds = self._words[0]
        self._until_s = self._until_s or self.now_s() + seconds
        if word is not None:
            self.feed.say(word, self.now_s())
        if self.now_s() >= self._until_s:
            self._words.pop(0)
            self._until_s = None


def carried_out(session, words, ending):
    person = Person(session, words, ending)
    driver = Driver(session.task_steps(PickTask("pick up the cup", ObjectDescription("cup", "red"))))
    session.hands.feed.take_over()
    while driver.advance():
        person.act()
    return driver.result


def tcp(assembly):
    model = assembly.model
    return model.frame_pose(assembly.loop.sensing.state().q, model.description.tcp_frames["right"])[:3, 3]


@pytest.mark.requirement("S10")
def test_a_key_moves_the_hand_and_silence_brakes_it(assembly):
    before = tcp(assembly)

    result = carried_out(assembly.session, [(UP, 1.0), (None, 0.3)], "give_up")

    assert (tcp(assembly) - before)[2] == pytest.approx(0.055, abs=0.015)
    assert np.abs(assembly.loop.setpoint.v).max() == 0.0
    assert result.outcome == "cancelled"
    assert result.evidence["by"] == "person"
    assert assembly.loop.statistics.refused == 0


class Lifts:
    """Tells when a foot has just left the floor for the second time."""

    def __init__(self, assembly):
        self._walking, self._phase, self.count = assembly.loop.walking, None, 0

    def look(self):
        walk = self._walking._walk
        phase = None if walk is None else walk.pattern.phase
        self.count += phase is Phase.SWING and self._phase is not Phase.SWING
        self._phase = phase


@pytest.mark.requirement("S10")
def test_a_walk_stands_within_2_seconds_after_the_last_key_though_a_foot_had_just_left_the_floor(assembly):
    session, feed, lifts = assembly.session, assembly.session.hands.feed, Lifts(assembly)
    driver = Driver(session.task_steps(ByHandTask("jog the robot"), by_hand=True))
    last_s, stands_s = 0.0, None

    while driver.advance() and session.now_s < 20.0:
        lifts.look()
        now_s, walks = session.now_s, assembly.loop.walking.active
        if lifts.count < 2:
            feed.say(BaseJog(-0.3, 0.0), last_s := now_s)
        elif now_s >= last_s + 0.1 and not walks:
            stands_s = stands_s or now_s
            feed.hand_back("go_on")

    assert stands_s - last_s <= 2.0
    assert not assembly.world.truth.fallen()
    assert assembly.loop.statistics.refused == 0


@pytest.mark.requirement("S10")
def test_what_the_fingers_do_not_feel_is_not_done_whatever_the_person_says(assembly):
    result = carried_out(assembly.session, [(GripJog("right", opens=False), 2.5)], "held_right")

    assert result.outcome == "failed"
    assert "its fingers hold nothing" in result.failure.message
    assert result.evidence["by"] == "person"


@pytest.mark.requirement("S10")
def test_given_back_the_robot_goes_on_by_itself(assembly):
    result = carried_out(assembly.session, [(UP, 0.5)], "go_on")

    assert result.outcome == "done"
    assert result.evidence["by"] == "person"
    assert result.acted_on == "red cup"

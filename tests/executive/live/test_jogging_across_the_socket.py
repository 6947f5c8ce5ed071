"""A person's words, said across the socket; the motion is made, judged and braked on the other side."""

import numpy as np
import pytest

from executive.live.control_client.jogging_client import JoggingClient
from executive.live.jog_message import jog_message, word_of
from executive.manual.words import BaseJog, GripJog
from kinematics.following.jog_reference import HandJog, JointJog
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.control.motion_handle import MotionStatus
from robots.live.documents.jog_document import read_jog, write_jog
from robots.live.wire.errors import ProtocolError

FORWARD = HandJog("right", "world", np.array([0.05, 0.0, 0.0]), np.zeros(3))


@pytest.fixture
def jogging(executive, talos):
    return JoggingClient(executive.link, executive.motion, talos)


def place(executive, talos):
    return talos.frame_pose(executive.motion.reference(), "tcp_right")[:3, 3]


@pytest.mark.requirement("S10")
def test_a_word_moves_the_hand_and_when_no_other_comes_the_control_side_brakes(executive, jogging, talos):
    before, motion = place(executive, talos), jogging.start(PlanningScene())
    for _ in range(20):
        motion.steer(FORWARD)
        executive.ticks(2)
    going = motion.report.moving

    executive.ticks(25)

    assert going
    assert motion.handle.status is MotionStatus.RUNNING, motion.handle.reason
    assert not motion.report.moving
    assert (place(executive, talos) - before)[0] > 0.02


@pytest.mark.requirement("S10")
def test_what_holds_it_back_is_told_across_the_socket(executive, jogging, talos):
    wall = poses.translation(*(place(executive, talos) + np.array([0.3, 0.0, 0.0])))
    board = SceneObject("board", Box((0.04, 0.6, 0.6)), wall, margin_m=0.01, movable=False)
    motion = jogging.start(PlanningScene().with_object(board))

    for _ in range(120):
        motion.steer(FORWARD)
        executive.ticks(2)

    assert "board" in motion.report.held_back
    assert executive.far.loop.statistics.refused == 0


def test_a_motion_that_is_told_to_finish_ends(executive, jogging):
    motion = jogging.start(PlanningScene())
    executive.ticks(5)

    motion.finish()
    executive.ticks(10)

    assert motion.handle.status is MotionStatus.DONE


WORDS = [FORWARD, JointJog("arm_left_3_joint", -0.2), BaseJog(0.2, -0.1), GripJog("left", True), None]


@pytest.mark.parametrize("word", WORDS, ids=str)
def test_words_come_back_from_messages_as_they_were(talos, word):
    assert repr(word_of(jog_message(word, may_touch=False), talos)) == repr(word)


@pytest.mark.parametrize("jog", [FORWARD, JointJog("head_1_joint", 0.1), None], ids=str)
def test_words_come_back_from_documents_as_they_were(talos, jog):
    assert repr(read_jog(write_jog(jog), talos)) == repr(jog)


@pytest.mark.parametrize("joint", ["leg_left_1_joint", "no_joint"])
def test_legs_are_not_jogged(talos, joint):
    with pytest.raises(ProtocolError, match="trunk, arms or head"):
        word_of(jog_message(JointJog(joint, 0.1), may_touch=False), talos)

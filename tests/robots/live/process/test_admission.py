"""The control side's own checker judges what the other side has judged already, and believes nothing."""

import dataclasses
from concurrent.futures import Future

import numpy as np
import pytest

from kinematics.formats.trajectory_document import write_trajectory
from kinematics.formats.trajectory_fit import stored_from
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.motion.verdict import CheckedTrajectory, FindingKind, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.scene.concessions import Concession, ConcessionReason
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.live.process.admission import MAX_ADMITTED, MAX_WAITING, AdmissionDesk
from robots.live.process.admission_process import Admission


@pytest.fixture(scope="module")
def admission():
    return Admission("talos")


@pytest.fixture(scope="module")
def document(talos, swing):
    """Text of a short swing of one arm in a scene."""

    def written(scene=None, amount=0.2, **changes):
        motion = dataclasses.replace(swing(amount).trajectory, **changes)
        return write_trajectory(stored_from(CheckRequest(motion, scene or PlanningScene()), talos)).encode()

    return written


def wall_at(talos, joint_swing):
    """A box where the left hand passes."""
    frame = talos.description.tcp_frames["left"]
    place = talos.frame_pose(joint_swing.trajectory.q[60], frame)[:3, 3]
    return SceneObject("wall", Box((0.1, 0.1, 0.1)), poses.translation(*place), movable=False)


@pytest.mark.requirement("S6")
def test_a_safe_motion_is_admitted_as_it_was_sent(admission, document, swing):
    answer = admission.judge(document())

    assert isinstance(answer, CheckedTrajectory)
    sent = swing().trajectory
    np.testing.assert_array_equal(answer.trajectory.q, sent.q)
    np.testing.assert_array_equal(answer.trajectory.v, sent.v)


@pytest.mark.requirement("S6")
def test_a_motion_into_what_its_own_scene_holds_is_unsafe(admission, document, talos, swing):
    scene = PlanningScene().with_object(wall_at(talos, swing()))

    answer = admission.judge(document(scene))

    assert isinstance(answer, Unsafe)
    assert FindingKind.SCENE_COLLISION in {finding.kind for finding in answer.findings}


@pytest.mark.requirement("S6", "S1")
def test_a_motion_that_is_too_fast_is_unsafe(admission, document):
    answer = admission.judge(document(t_s=np.linspace(0.0, 0.02, 101)))

    assert isinstance(answer, Unsafe)


@pytest.mark.requirement("S6", "F8")
@pytest.mark.parametrize(
    "text", [b"", b"{}", b"\xff\xfe", b'{"schema": 1}', b"[" * 100_000], ids=lambda text: repr(text[:12])
)
def test_what_is_no_document_gets_a_reason(admission, text):
    assert isinstance(admission.judge(text), str)


def test_a_document_for_another_robot_gets_a_reason(admission, document):
    assert "g1" in admission.judge(document().replace(b'"talos"', b'"g1"'))


def test_a_document_that_does_not_say_what_is_around_gets_a_reason(admission, document):
    lines = [line for line in document().split(b"\n") if not line.startswith(b'"objects"')]

    assert "around" in admission.judge(b"\n".join(lines))


class Asked:
    def __init__(self):
        self.futures = []

    def ask(self, _question):
        self.futures.append(Future())
        return self.futures[-1]


@pytest.fixture
def desk():
    asked, told = Asked(), []
    made = AdmissionDesk(asked, told.append)
    return made, asked, told


@pytest.mark.requirement("S6")
def test_nothing_is_given_out_before_its_verdict_and_once_after(desk, swing):
    on_desk, asked, told = desk
    on_desk.submit(1, 0, b"")
    assert isinstance(on_desk.take(1, 0), str)

    asked.futures[0].set_result(swing())
    on_desk.poll()

    assert [verdict.trajectory for verdict in told] == [1]
    assert isinstance(on_desk.take(1, 0), CheckedTrajectory)
    assert isinstance(on_desk.take(1, 0), str)


@pytest.mark.requirement("S6")
def test_a_new_commander_gets_nothing_of_the_one_before(desk, swing):
    on_desk, asked, told = desk
    on_desk.submit(1, 0, b"")
    on_desk.submit(2, 0, b"")
    asked.futures[0].set_result(swing())
    on_desk.poll()

    on_desk.forget()
    asked.futures[1].cancel()
    on_desk.poll()

    assert isinstance(on_desk.take(1, 0), str)
    assert len(told) == 1


def test_what_waits_and_what_is_kept_is_bounded(desk, swing):
    on_desk, asked, _ = desk
    for number in range(MAX_WAITING):
        assert on_desk.submit(number, 0, b"") is None
    assert "already" in on_desk.submit(99, 0, b"")

    for number in range(100, 100 + 2 * MAX_ADMITTED):
        for future in asked.futures:
            if not future.done():
                future.set_result(swing())
        on_desk.poll()
        on_desk.submit(number, 0, b"")

    assert isinstance(on_desk.take(0, 0), str)


@pytest.mark.requirement("F8")
def test_a_checker_that_died_admits_nothing(desk):
    on_desk, asked, told = desk
    on_desk.submit(1, 0, b"")
    asked.futures[0].set_exception(RuntimeError("gone"))

    on_desk.poll()

    assert "gone" in told[0].answer
    assert isinstance(on_desk.take(1, 0), str)


@pytest.mark.parametrize(
    "reason", [one for one in ConcessionReason if one is not ConcessionReason.STARTS_NEAR]
)
def test_what_the_other_side_asks_to_be_overlooked_is_bounded_anew(admission, talos, swing, reason):
    scene = PlanningScene().with_object(wall_at(talos, swing()))
    hand = talos.description.grippers["left"].touch_links
    # a hand that does not start near the wall, holds nothing, and grasps no furniture
    if reason is ConcessionReason.HANDLE_IN_HAND:
        hand = ("arm_left_7_link",)
    asked = tuple(Concession(frozenset((link, "wall")), reason, "move") for link in hand)
    request = CheckRequest(swing().trajectory, scene, asked)

    answer = admission.judge(write_trajectory(stored_from(request, talos)).encode())

    assert isinstance(answer, Unsafe)
    assert FindingKind.CONCESSION in {finding.kind for finding in answer.findings}

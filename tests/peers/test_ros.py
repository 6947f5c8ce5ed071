"""The ROS door, with rclpy of two distributions on the other side."""

import contextlib
import json
import time
from pathlib import Path

import pytest

import executive.doors.ros.node
from executive.doors.ros.node.client_watch import LEASE_S
from executive.doors.ros.node.ending import ENDS_WITHIN_S
from executive.doors.served_robot import ServedRobot
from robots.models.description import load_description, load_robot
from tests.peers.person import leave_stop

pytestmark = [pytest.mark.requirement("U3"), pytest.mark.timeout(400)]
NODE = Path(executive.doors.ros.node.__file__).parent / "humanoid_node.py"
SENTENCES = (
    "wait for 0.5 seconds", "move forward at 0.8 m/s for 1 second", "wait for 100 seconds", "pick up",
)  # fmt: skip
DONE, TOO_FAST, LONG, ASKS = range(4)
SUCCEEDED, CANCELED, ABORTED = 4, 5, 6


def told(process, within_s=200.0):
    """What a program printed as its last line."""
    text, _ = process.communicate(timeout=within_s)
    assert process.returncode == 0
    return json.loads(text.strip().splitlines()[-1])


def test_the_state_arrives_on_its_topics(served, peer):
    seen = told(peer("watch.py", 60.0))

    assert seen["topics"] == [
        "/diagnostics", "/imu", "/joint_states", "/odom", "/robot_description", "/wrench/left_sole_link",
    ]  # fmt: skip
    assert seen["joints"] == seen["positions"] == len(load_description("talos").actuated)
    assert 0.5 < seen["height_m"] < 1.5
    assert 8.0 < abs(seen["up_m_s2"]) < 11.0  # the link of the IMU may point either way
    assert seen["urdf"].lstrip().startswith("<")
    assert set(seen["parts"]) == {"robot", "emergency stop", "task", "foot wrenches"}
    assert seen["parts"]["foot wrenches"] == "measured"


def test_the_bridge_is_a_node_of_the_graph_with_typed_topics(served, peer):
    seen = told(peer("watch.py", 60.0))

    assert "humanoid_executive" in seen["nodes"]
    assert seen["types"]["/tf"] == ["tf2_msgs/msg/TFMessage"]
    assert seen["types"]["/detections"] == ["vision_msgs/msg/Detection3DArray"]
    assert seen["types"]["/cmd_vel"] == ["geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"]


@pytest.mark.opengl
def test_the_pictures_of_the_camera_arrive_with_its_lens(seeing, peer):
    folder, domain = seeing
    camera = load_robot("talos").hardware.cameras[0]
    wide, high, focal = camera.width_px, camera.height_px, camera.focal_px
    watching = peer("see.py", 200.0, domain=domain)
    robot, until_s = ServedRobot(folder), time.monotonic() + 200.0
    while watching.poll() is None and time.monotonic() < until_s:  # nothing is drawn for nobody
        run = robot.begin("what do you see on the table?")
        while not run.ended and watching.poll() is None:
            time.sleep(0.2)
    robot.cancel("the pictures have come")
    seen = told(watching)

    for which, encoding, deep in (("color", "rgb8", 3), ("depth", "16UC1", 2)):
        one = seen[which]
        assert (one["size"], one["encoding"], one["frame"]) == ([wide, high], encoding, camera.frame)
        assert (one["step"], one["bytes"]) == (deep * wide, deep * wide * high)
        assert one["values"] > 50
        assert (one["info_size"], one["info_frame"]) == ([wide, high], camera.frame)
        assert (one["model"], one["distortion"]) == ("plumb_bob", [0.0] * 5)
        assert one["k"] == [focal, 0.0, (wide - 1) / 2, 0.0, focal, (high - 1) / 2, 0.0, 0.0, 1.0]
        assert seen["types"][f"/camera/{which}/image_raw"] == ["sensor_msgs/msg/Image"]
    assert seen["is_described"]


def test_a_sentence_is_carried_out_and_its_end_told(served, peer, at_rest):
    at_rest()
    lines = told(peer("say.py", "wait for 1 second", 60))

    assert any("accepted" in line for line in lines)
    assert lines[-1].startswith("done: ")


def test_a_question_is_answered_on_its_topic(served, peer, at_rest):
    at_rest()
    lines = told(peer("say.py", "pick up", 60, "never mind"))

    assert any("question" in line for line in lines)
    assert lines[-1].startswith(("cancelled", "refused", "question"))


def test_a_velocity_walks_and_a_silence_ends_the_walk(served, peer, at_rest):
    at_rest()
    there = told(peer("drive.py", "twist", 0.15, 0.0, 0.2, 60.0))
    at_rest()
    back = told(peer("drive.py", "stamped", -0.15, 0.0, 0.2, 60.0))

    for gone in (there, back):
        assert gone["gone_m"] > 0.15
        assert gone["lines"][-1].startswith("done: ")


@pytest.mark.requirement("S1")
def test_a_velocity_beyond_the_limit_is_refused_with_the_limit(served, peer, at_rest):
    at_rest()
    gone = told(peer("drive.py", "twist", 2.0, 0.0, 0.2, 30.0))

    assert gone["gone_m"] < 0.02
    assert any("beyond the limit of" in line for line in gone["lines"])


@pytest.mark.requirement("S4")
def test_the_emergency_stop_latches_and_false_does_not_release_it(served, peer, at_rest):
    at_rest()
    lines = told(peer("say.py", "wait for 100 seconds", 60, "stop"))
    robot = ServedRobot(served)
    try:
        assert robot.status()["emergency"]
        assert any("emergency stop engaged" in line for line in lines)
    finally:
        leave_stop(served)


@contextlib.contextmanager
def node(served, peer, tmp_path):
    sentences = tmp_path / "sentences.txt"
    sentences.write_text("\n".join(SENTENCES))
    process = peer(NODE, served, "--sentences", sentences)
    yield process
    process.terminate()
    assert process.wait(2.0 * ENDS_WITHIN_S) == 0


@pytest.mark.parametrize(("number", "status", "code"), [(DONE, SUCCEEDED, 0), (TOO_FAST, ABORTED, 2)])
def test_the_action_ends_as_the_task_did(served, peer, at_rest, tmp_path, number, status, code):
    at_rest()
    with node(served, peer, tmp_path):
        ended = told(peer("act.py", number))

    assert (ended["status"], ended["exit_code"]) == (status, code)
    assert ended["heard"] > 0


@pytest.mark.requirement("S7")
def test_a_cancel_of_the_action_cancels_the_task(served, peer, at_rest, tmp_path):
    at_rest()
    with node(served, peer, tmp_path):
        ended = told(peer("act.py", LONG, "cancel", 2))

    assert (ended["status"], ended["exit_code"]) == (CANCELED, 4)


def test_a_question_of_a_task_is_answered_by_the_service(served, peer, at_rest, tmp_path):
    at_rest()
    with node(served, peer, tmp_path):
        nothing_open = told(peer("answer.py", "the red cup", 0.0))
        asking = peer("act.py", ASKS)
        answered = told(peer("answer.py", "never mind", 60.0))
        ended = told(asking)

    assert nothing_open == {"asked": False, "told": "no question is open"}
    assert answered == {"asked": True, "told": "answered"}
    assert ended["status"] == ABORTED
    assert ended["exit_code"] in (2, 3, 4)


@pytest.mark.requirement("S7")
def test_a_client_that_dies_beside_another_is_a_cancel(served, peer, at_rest, tmp_path):
    at_rest()
    with node(served, peer, tmp_path):
        client = peer("act.py", LONG, "die", 12)
        time.sleep(6.0)  # the goal has its client by now
        other = peer("listen.py", 60)
        client.wait(90.0)
        at_rest(LEASE_S + 8.0)
        assert other.poll() is None


@pytest.mark.requirement("S7")
def test_a_client_that_dies_is_a_cancel(served, peer, at_rest, tmp_path):
    at_rest()
    with node(served, peer, tmp_path):
        client = peer("act.py", LONG, "die", 3)
        client.wait(90.0)
        at_rest(LEASE_S + 8.0)  # a participant's lease of Fast DDS is 20 s
        assert told(peer("act.py", DONE))["exit_code"] == 0


@pytest.mark.requirement("S7")
def test_the_node_ends_within_its_time_and_its_tasks_with_it(served, peer, at_rest, tmp_path):
    at_rest()
    with node(served, peer, tmp_path) as process:
        client = peer("act.py", LONG, "die", 3)
        client.wait(90.0)
        process.terminate()
        assert process.wait(2.0 * ENDS_WITHIN_S) == 0
    at_rest(LEASE_S)

"""Goals of FollowJointTrajectory, with a stand-in of the same fields."""

import json
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

import executive.doors.ros.node
from executive.exit_codes import ExitCode
from kinematics.formats.joint_motion import read_joint_motion

NODE = Path(executive.doors.ros.node.__file__).parent


@pytest.fixture
def follow(monkeypatch):
    monkeypatch.syspath_prepend(str(NODE))
    for name in ("follow_trajectory", "progress"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    import follow_trajectory

    return follow_trajectory


def time(seconds):
    return SimpleNamespace(sec=int(seconds), nanosec=round(1e9 * (seconds % 1.0)))


def point(t_s, positions, velocities=()):
    return SimpleNamespace(time_from_start=time(t_s), positions=positions, velocities=velocities)


def goal(*points, joints=("a", "b"), stamp_s=0.0, **more):
    trajectory = SimpleNamespace(
        header=SimpleNamespace(stamp=time(stamp_s)), joint_names=list(joints), points=list(points)
    )
    empty = {"path_tolerance": [], "goal_tolerance": [], "multi_dof_trajectory": SimpleNamespace(points=[])}
    return SimpleNamespace(trajectory=trajectory, **{**empty, **more})


def test_a_goal_is_handed_over_as_the_robot_reads_it(follow, tmp_path):
    asked = goal(point(0.5, [0.1, 0.2]), point(1.25, [0.2, 0.3], [0.0, 0.5]))

    with follow.GivenFile(tmp_path, "a1b2", follow.joint_motion(asked)) as given:
        read = read_joint_motion(Path(given.order["path"]).read_text())

    assert read.joints == ("a", "b")
    assert read.t_s.tolist() == [0.5, 1.25]
    assert read.positions.tolist() == [[0.1, 0.2], [0.2, 0.3]]
    assert read.velocities.tolist() == [[0.0, 0.0], [0.0, 0.5]]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("asked", "code", "why"),
    [
        (goal(), -1, "no points"),
        (goal(point(1.0, []), joints=()), -2, "no joint"),
        (goal(point(1.0, [0.1])), -1, r"points\[0\].positions"),
        (goal(point(1.0, [0.1, 0.2], [0.1])), -1, r"points\[0\].velocities"),
        (goal(point(1.0, [0.1, 0.2]), stamp_s=12.5), -1, "at once"),
        (goal(point(1.0, [0.1, 0.2]), path_tolerance=["a"]), -1, "tolerances"),
        (goal(point(1.0, [0.1, 0.2]), multi_dof_trajectory=SimpleNamespace(points=[1])), -1, "several"),
    ],
)
def test_a_goal_that_asks_for_something_else_is_refused_with_the_reason(follow, asked, code, why):
    with pytest.raises(follow.InvalidGoalError, match=why) as wrong:
        follow.joint_motion(asked)

    assert wrong.value.code == code


def ending(tmp_path, outcome, exit_code, *kinds):
    failure = None
    for kind in reversed(kinds):
        failure = {"kind": kind, "where": "", "message": "", "numbers": {}, "cause": failure}
    report = {"tasks": [{"text": "follow a trajectory", "evidence": {}, "failure": failure}]}
    (tmp_path / "report.json").write_text(json.dumps(report))
    return {"outcome": outcome, "exit_code": exit_code, "text": f"{outcome}: why", "run": str(tmp_path)}


@pytest.mark.parametrize(
    ("outcome", "exit_code", "kinds", "code"),
    [
        ("done", 0, (), 0),
        ("refused", 2, (), -1),
        ("failed", int(ExitCode.UNSAFE), ("UNSAFE",), -1),
        ("failed", 1, ("EXECUTION",), -4),
        ("failed", 1, ("POSTCONDITION",), -5),
    ],
)
def test_an_ending_has_the_actions_error_code(follow, tmp_path, outcome, exit_code, kinds, code):
    found, told = follow.result_of(ending(tmp_path, outcome, exit_code, *kinds))

    assert found == code
    assert told == ("" if code == 0 else f"{outcome}: why")

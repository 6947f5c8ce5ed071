"""``executive check``: verdicts, exit codes, reports; nothing moves."""

import json
import re
from dataclasses import fields
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from typer.testing import CliRunner

from executive.checks import check_trajectory_file as stored_check
from executive.cli import app as cli
from executive.reports.check_report import MotionVerdict
from kinematics.checking.settings import CheckSettings
from kinematics.formats.trajectory_document import StoredTrajectory, write_trajectory
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import FindingKind
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.models.description import load_description

DOCS = Path(__file__).parents[2] / "docs"
REFERENCE = DOCS / "reference"
SCHEMA = json.loads((REFERENCE / "check-report.schema.json").read_text())
GUIDE = (DOCS / "guides" / "checker.md").read_text()
FINDINGS = (REFERENCE / "trajectory.md").read_text()


@pytest.fixture
def executive(tmp_path, monkeypatch):
    """Run the command line from a folder of the test's own."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.chdir(tmp_path)

    def invoke(*arguments):
        return CliRunner().invoke(cli.app, list(arguments))

    return invoke


@pytest.fixture(scope="session")
def talos():
    return RobotModel(load_description("talos"))


@pytest.fixture
def store(talos, tmp_path):
    """Write a motion of one joint from the home posture into a file."""

    def write(joint, change_rad, duration_s=1.5, name="motion.json"):
        t_s = np.linspace(0.0, duration_s, 151)
        s, index = t_s / duration_s, talos.joint_index(joint)
        q, v = np.tile(talos.q_home, (151, 1)), np.zeros((151, talos.nv))
        q[:, 7 + index] += change_rad * (10 * s**3 - 15 * s**4 + 6 * s**5)
        v[:, 6 + index] = change_rad * 30 * s**2 * (1 - s) ** 2 / duration_s
        motion = Trajectory(talos.joints, stance_at(talos, talos.q_home), t_s, q, v)
        path = tmp_path / name
        path.write_text(write_trajectory(StoredTrajectory("talos", motion)))
        return path

    return write


def test_a_safe_trajectory_is_exit_code_0(executive, store):
    result = executive("check", str(store("head_2_joint", 0.3)), "--scene", "tabletop")

    assert result.exit_code == 0
    assert result.stdout.splitlines()[-1] == "safe: the checker found no defect"


@pytest.mark.requirement("S6")
def test_an_unsafe_trajectory_is_exit_code_5_with_every_finding_typed_and_placed_in_time(executive, store):
    result = executive("check", str(store("head_2_joint", 1.6, 0.5)), "--report", "report.json")

    assert result.exit_code == 5
    document = json.loads(Path("report.json").read_text())
    jsonschema.validate(document, SCHEMA)
    findings = document["motions"][0]["findings"]
    assert {finding["kind"] for finding in findings} >= {"position limit", "velocity limit", "jerk limit"}
    assert [finding["t_s"] for finding in findings] == sorted(finding["t_s"] for finding in findings)
    for finding in findings:
        line = f"at {finding['t_s']:.3f} s  {finding['kind']} of {' and '.join(finding['subject'])}"
        assert line in result.stdout
    assert result.stdout.splitlines()[-1].startswith("Unsafe trajectory: ")


def obstacle(talos, tmp_path, name):
    """A scene with a table whose top the left hand is in."""
    x, y, z = talos.frame_pose(talos.q_home, "tcp_left")[:3, 3]
    scene = tmp_path / name
    scene.write_text(
        f'[[furniture]]\nname = "high"\nkind = "table"\nsize_m = [0.3, 0.3, {z + 0.02:.3f}]\n'
        f"position_m = [{x + 0.13:.3f}, {y:.3f}]\n"
    )
    return scene


def test_a_trajectory_cannot_say_that_a_person_may_be_touched(executive, store, tmp_path):
    path, scene = store("head_1_joint", 0.1), tmp_path / "visited.toml"
    scene.write_text('[[person]]\nname = "Anna"\nposition_m = [2.0, 0.0]\nyaw_rad = 3.1\n')
    document = json.loads(path.read_text())
    document["allowed"] = [["gripper_left_base_link", "Anna"]]
    path.write_text(json.dumps(document))

    answer = executive("check", str(path), "--scene", str(scene))

    assert answer.exit_code == 2
    assert "allowed: 'Anna' is a person" in answer.output


def test_a_motion_that_ends_moving_is_unsafe_here_as_it_is_for_the_streamer(executive, store):
    path = store("head_1_joint", 0.1)
    document = json.loads(path.read_text())
    column = 6 + document["joints"].index("head_1_joint")
    document["samples"][-1]["v"][column] = 0.0015
    path.write_text(json.dumps(document))

    answer = executive("check", str(path), "--report", "report.json")

    report = json.loads(Path("report.json").read_text())
    jsonschema.validate(report, SCHEMA)
    assert answer.exit_code == 5
    assert "boundary velocity of head_1_joint: 0.0015 rad/s, limit 0.001 rad/s" in answer.output


@pytest.mark.requirement("S6")
def test_the_scene_of_a_file_is_judged_as_the_file_says(executive, store, talos, tmp_path):
    path, scene = store("head_2_joint", 0.3), obstacle(talos, tmp_path, "high.toml")

    result = executive("check", str(path), "--scene", str(scene))

    assert result.exit_code == 5
    assert re.search(r"scene collision of gripper_left\S* and high/top", result.stdout)


@pytest.mark.parametrize("name", ["floor", "gripper_left_base_link", "universe"])
def test_a_thing_of_a_scene_may_be_called_as_the_floor_or_a_link_and_is_judged(
    executive, store, talos, tmp_path, name
):
    path, scene = store("head_2_joint", 0.3), tmp_path / "odd.toml"
    x, y, z = talos.frame_pose(talos.q_home, "tcp_left")[:3, 3]
    box = f'[[object]]\nname = "{name}"\nkind = "box"\nsize_m = [0.3, 0.3, {z + 0.02}]\n'
    scene.write_text(f"{box}position_m = [{x + 0.13}, {y}, {0.5 * (z + 0.02)}]\n")

    result = executive("check", str(path), "--scene", str(scene))

    assert result.exit_code == 5
    assert re.search(rf"scene collision of gripper_left\S* and {name} \(object\)", result.stdout)


def test_without_a_scene_the_file_beside_the_trajectory_is_taken(executive, store, talos, tmp_path):
    path = store("head_2_joint", 0.3)

    alone = executive("check", str(path))
    obstacle(talos, tmp_path, "motion.toml")
    beside = executive("check", str(path))

    assert (alone.exit_code, beside.exit_code) == (0, 5)
    assert "nothing but the floor" in alone.stdout
    assert "motion.toml" in beside.stdout


def test_a_margin_is_kept_from_the_scene(executive, store):
    path = store("head_2_joint", 0.3)

    assert executive("check", str(path), "--scene", "tabletop", "--margin", "0.0").exit_code == 0
    assert executive("check", str(path), "--scene", "tabletop", "--margin", "0.3").exit_code == 5


def test_a_name_from_a_file_does_not_steer_the_terminal(executive, store):
    path = store("head_2_joint", 0.3)
    ball = {"name": "\x1b[2Jcup", "frame": "tcp_left", "shape": {"kind": "ball", "radius_m": 0.01}}
    place = {"position_m": [0.3, 0, 0], "quaternion_xyzw": [0, 0, 0, 1]}
    broken(path, lambda document: document.__setitem__("held", [{**ball, **place}]))

    result = executive("check", str(path))

    assert result.exit_code == 0
    assert "held: \\x1b[2Jcup by tcp_left" in result.stdout


def broken(path, change):
    document = json.loads(path.read_text())
    change(document)
    path.write_text(json.dumps(document))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda d: d["samples"][12]["q"].__setitem__(9, float("nan")), "samples[12].q[9] (leg_left_3_joint)"),
        (lambda d: d["joints"].__setitem__(0, "leg_left_1_jiont"), "did you mean 'leg_left_1_joint'?"),
        (lambda d: d.__setitem__("robot", "tallos"), "no robot 'tallos'; the nearest is 'talos'"),
        (lambda d: d.pop("stance"), "'stance' is missing"),
    ],
)
def test_an_invalid_file_is_exit_code_2_and_one_line_with_the_place(executive, store, change, says):
    path = store("head_2_joint", 0.3)
    broken(path, change)

    result = executive("check", str(path))

    assert result.exit_code == 2
    assert result.stdout == ""
    assert says in result.stderr
    assert len(result.stderr.splitlines()) == 1


@pytest.mark.parametrize(
    ("content", "says"), [(b"\xff\xfe", "is not UTF-8"), (b"{", "is no JSON"), (None, "No such file")]
)
def test_what_is_no_trajectory_file_is_exit_code_2(executive, tmp_path, content, says):
    path = tmp_path / "motion.json"
    if content is not None:
        path.write_bytes(content)

    result = executive("check", str(path))

    assert result.exit_code == 2
    assert says in result.stderr


def test_a_file_that_is_too_large_is_not_read(executive, store, monkeypatch):
    monkeypatch.setattr(stored_check, "MAX_BYTES", 1000)

    result = executive("check", str(store("head_2_joint", 0.3)))

    assert result.exit_code == 2
    assert "more than 1000 bytes" in result.stderr


@pytest.mark.parametrize(
    "options",
    [["--scene", "tabeltop"], ["--robot", "g1000"], ["--margin", "-1"], ["--report", "/nowhere/at/all.json"]],
)
def test_a_wrong_option_is_exit_code_2(executive, store, options):
    assert executive("check", str(store("head_2_joint", 0.3)), *options).exit_code == 2


@pytest.mark.requirement("S6")
def test_a_sentence_is_planned_and_checked_and_nothing_is_streamed(executive, monkeypatch):
    monkeypatch.setattr(MotionStreamer, "start", lambda *_: pytest.fail("a motion was started"))

    result = executive("check", "pick up the red cup on the table", "--report", "report.json")

    assert result.exit_code == 0, result.output
    document = json.loads(Path("report.json").read_text())
    jsonschema.validate(document, SCHEMA)
    assert [motion["name"].rpartition(" ")[2] for motion in document["motions"]] == [
        "reach",
        "approach",
        "lift",
    ]
    assert "seen: blue box, red cup, table\n" in result.stdout


@pytest.mark.requirement("S6")
def test_every_motion_of_a_recorded_run_can_be_checked_again_with_the_same_verdict(executive, tmp_path):
    executive("run", "pick up the red cup on the table", "--quiet", "--record", str(tmp_path / "runs"))

    stored = sorted((tmp_path / "runs").glob("*/trajectories/*.json"))

    assert len(stored) >= 4
    for path in stored:
        schema = json.loads((REFERENCE / "trajectory.schema.json").read_text())
        jsonschema.validate(json.loads(path.read_text()), schema)
        verdict = executive("check", str(path))
        assert (path.stem[4:], verdict.exit_code) in (("safe", 0), ("unsafe", 5))


def test_an_object_that_is_not_seen_is_exit_code_1_with_what_is(executive):
    result = executive("check", "pick up the yellow ball", "--report", "report.json")

    assert result.exit_code == 1
    assert result.stdout.splitlines()[-1].startswith("failed: no yellow ball seen")
    document = json.loads(Path("report.json").read_text())
    jsonschema.validate(document, SCHEMA)
    assert document["failure"]["kind"] == "POSTCONDITION"


@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        ("pick up the zorbl", 2, "refused: "),
        ("dance", 2, "no skill of this robot yet"),
        ("pick up something", 3, "question: which object"),
        ("go home", 0, "safe: no motion is needed"),
    ],
)
def test_a_sentence_without_a_motion_needs_no_simulator(executive, monkeypatch, text, code, says):
    from executive.session import assembly

    monkeypatch.setattr(assembly, "assemble", lambda *_, **__: pytest.fail("a world was built"))

    result = executive("check", text, "--quiet")

    assert result.exit_code == code
    assert says in result.stdout


@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        ("move forward 3 m", 5, "failed: could not move: an obstacle is "),
        ("look at the red cup", 0, "motions planned and checked; done: look at the red cup"),
    ],
)
def test_what_is_no_pick_alone_is_carried_out_in_a_world_of_its_own(executive, text, code, says):
    result = executive("check", text, "--report", "report.json")

    assert result.exit_code == code
    assert says in result.stdout.splitlines()[-1]
    document = json.loads(Path("report.json").read_text())
    jsonschema.validate(document, SCHEMA)
    assert document["outcome"] == ("safe" if code == 0 else "failed")


def test_a_script_is_judged_by_what_it_expects(executive, tmp_path):
    script = tmp_path / "script.toml"
    script.write_text('[[task]]\nsay = "dance"\nexpect = "refused"\n[[task]]\nsay = "go home"\n')
    assert executive("check", str(script)).exit_code == 0

    script.write_text('[[task]]\nsay = "go home"\n[[task]]\nsay = "dance"\n')
    assert executive("check", str(script)).exit_code == 2


def snippets():
    return re.findall(r"```python\n(.*?)```", GUIDE, re.S)


def test_the_guide_s_five_lines_work(store, tmp_path, monkeypatch, capsys):
    store("head_2_joint", 0.3)
    monkeypatch.chdir(tmp_path)
    lines = [line for line in snippets()[0].splitlines() if line]

    exec(snippets()[0], {})

    assert len(lines) <= 5
    assert capsys.readouterr().out == "safe: the checker found no defect []\n"


def test_the_guide_s_longer_example_works(capsys):
    exec(snippets()[1], {})

    assert capsys.readouterr().out.startswith("Safe trajectory: nearest measured distance ")


def test_the_reference_explains_every_finding_and_every_tolerance_with_its_default():
    for kind in FindingKind:
        assert f"| {kind.value} |" in FINDINGS
    defaults = CheckSettings()
    for item in fields(CheckSettings):
        assert f"| {item.name} | {getattr(defaults, item.name)} |" in FINDINGS


def test_the_published_schema_knows_every_kind_of_finding():
    known = SCHEMA["$defs"]["FindingKind"]["enum"]

    assert set(known) == {kind.value for kind in FindingKind}


def test_what_is_beyond_all_measure_is_null_in_a_report(talos):
    from kinematics.motion.verdict import Finding, Unsafe

    t_s, q = np.array([0.0, 1.0]), np.tile(talos.q_home, (2, 1))
    motion = Trajectory(talos.joints, stance_at(talos, talos.q_home), t_s, q, np.zeros((2, talos.nv)))
    finding = Finding(FindingKind.BALANCE, 0.0, ("CoM",), -np.inf, 0.02)

    document = MotionVerdict("motion", motion, Unsafe((finding,))).to_json()

    assert document["findings"][0]["value"] is None
    json.dumps(document, allow_nan=False)

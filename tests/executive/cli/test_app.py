"""Exit codes, one clear line, no traceback."""

import importlib.metadata
import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import jsonschema
import pytest
from typer.testing import CliRunner

from executive.cli import app as cli
from executive.config import CONFIG_VARIABLE
from executive.exit_codes import ExitCode
from executive.runs import run_search
from trees import extensions
from trees.btcpp.outside_leaves import outside_leaves

ROOT = Path(__file__).parents[3]
SCHEMA = json.loads((ROOT / "docs" / "reference" / "report.schema.json").read_text())


@pytest.fixture
def executive(tmp_path, monkeypatch):
    """Run the command line, with this user's data in a folder of the test's own."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))

    def invoke(*arguments, **options):
        return CliRunner().invoke(cli.app, list(arguments), **options)

    return invoke


@pytest.fixture
def broken_leaves(monkeypatch):
    """A package of leaves is installed whose module is gone; what is complained about it."""
    entry_points = importlib.metadata.entry_points

    def with_fly(**chosen):
        if chosen == {"group": extensions.LEAVES}:
            return (importlib.metadata.EntryPoint("fly", "no_such_module:Fly", extensions.LEAVES),)
        return entry_points(**chosen)

    monkeypatch.setattr(importlib.metadata, "entry_points", with_fly)
    outside_leaves.cache_clear()
    yield "leaf 'fly': ModuleNotFoundError: No module named 'no_such_module'"
    outside_leaves.cache_clear()


def one_line(result):
    assert "Traceback" not in result.output
    lines = [line for line in result.stderr.splitlines() if line]
    assert len(lines) == 1, lines
    return lines[0]


@pytest.mark.requirement("L5", "F1")
@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        ("pick up the zorbl", 2, "zorbl"),
        ("dance", 2, "no skill of this robot yet"),
        ("", 2, "empty"),
        ("pick up\x07", 2, "U+0007"),
        ("pick up something", 3, "which object"),
    ],
)
def test_what_is_not_understood_moves_nothing_and_says_why(executive, text, code, says):
    result = executive("run", text, "--quiet")

    assert result.exit_code == code
    assert says in result.stdout
    assert "Traceback" not in result.output


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--robot", "tallos"], "the nearest is 'talos'"),
        (["--scene", "tabeltop"], "tabletop"),
        (["--scene", "none.toml"], "none.toml"),
        (["--report", "/nowhere/at/all/report.json"], "cannot write"),
        (["--record", "/proc/none"], "cannot write"),
    ],
)
def test_a_fault_of_the_request_or_the_machine_is_one_line_and_exit_code_2(executive, options, says):
    result = executive("run", "go home", "--quiet", *options)

    assert result.exit_code == 2
    assert says in one_line(result)


@pytest.mark.parametrize("options", [["--seed", "-1"], ["--seed", "x"], ["--bogus"], []])
def test_an_invalid_option_is_exit_code_2(executive, options):
    assert executive("run", *options, *(["go home"] if options else [])).exit_code == 2


def test_a_broken_scene_is_refused_with_file_and_key(executive, tmp_path):
    scene = tmp_path / "scene.toml"
    scene.write_text('[[object]]\nname = "cup"\nkind = "cup"\nradius_m = -1.0\n')

    result = executive("run", "go home", "--quiet", "--scene", str(scene))

    assert result.exit_code == 2
    assert "scene.toml" in one_line(result)


def test_pictures_without_opengl_are_refused_before_anything_moves(executive, tmp_path, monkeypatch):
    from robots.simulated.pictures import opengl

    monkeypatch.setattr(opengl, "_library", lambda name: None)

    result = executive("run", "go home", "--quiet", "--snapshot", str(tmp_path / "end.png"))

    assert result.exit_code == 2
    assert "OpenGL" in one_line(result)


def test_seeing_with_the_camera_without_opengl_is_refused_before_anything_moves(executive, monkeypatch):
    from robots.simulated.pictures import opengl

    monkeypatch.setattr(opengl, "_library", lambda name: None)

    result = executive("run", "go home", "--quiet", "--perception", "rgbd")

    assert result.exit_code == 2
    assert "libegl1" in one_line(result)


@pytest.mark.parametrize("asked", ["by an option", "by the scene"])
def test_a_robot_that_cannot_see_without_opengl_is_not_served(executive, monkeypatch, tmp_path, asked):
    from executive.live.caller import service
    from robots.simulated.pictures import opengl

    monkeypatch.setattr(opengl, "_library", lambda name: None)
    monkeypatch.setattr(service, "Service", None)  # nothing is started
    scene = tmp_path / "scene.toml"
    scene.write_text('[perception]\nkind = "rgbd"\n')
    options = ["--perception", "rgbd"] if asked == "by an option" else ["--scene", str(scene)]

    result = executive("serve", *options, "--folder", str(tmp_path / "live"))

    assert result.exit_code == 2
    assert "libegl1" in one_line(result)
    assert not (tmp_path / "live").exists()


@pytest.mark.requirement("S9", "U1")
def test_a_run_tells_its_result_and_writes_a_report_of_the_published_form(executive, tmp_path):
    report = tmp_path / "report.json"

    result = executive("run", "go home", "--report", str(report), "--seed", "7")

    assert result.exit_code == 0
    assert result.stdout.startswith("done: at the home posture")
    assert "accepted: go home" in result.stderr
    document = json.loads(report.read_text())
    jsonschema.validate(document, SCHEMA)
    assert (document["seed"], document["outcome"], document["exit_code"]) == (7, "done", 0)


def test_a_refused_sentence_gets_a_report_of_the_published_form_too(executive, tmp_path):
    report = tmp_path / "report.json"

    executive("run", "pick up the zorbl", "--quiet", "--report", str(report))

    document = json.loads(report.read_text())
    jsonschema.validate(document, SCHEMA)
    assert (document["outcome"], document["exit_code"]) == ("refused", 2)


@pytest.mark.requirement("M1", "U1")
def test_the_main_job_is_done_and_proven_by_the_robots_own_sensors(executive, tmp_path):
    report = tmp_path / "report.json"

    result = executive("run", "pick up the red cup on the table", "--report", str(report))

    assert result.exit_code == 0, result.output
    assert result.stdout.startswith("done: red cup held in the ")
    document = json.loads(report.read_text())
    jsonschema.validate(document, SCHEMA)
    evidence = document["tasks"][0]["evidence"]
    assert 0.05 < evidence["gripper_opening_m"] < 0.07
    assert document["safety"]["refused_setpoints"] == 0


def test_an_object_that_is_not_there_is_a_failure_with_its_reason(executive):
    result = executive("run", "pick up the yellow ball on the table", "--quiet")

    assert result.exit_code == 1
    assert result.stdout.startswith("failed: could not pick up the yellow ball")
    why = executive("why", "--full").stdout
    assert "yellow ball" in why
    assert "└─" in why


def test_a_script_runs_its_sentences_and_is_a_test_of_what_it_expects(executive, tmp_path):
    script = tmp_path / "script.toml"
    script.write_text('[[task]]\nsay = "dance"\nexpect = "refused"\n[[task]]\nsay = "go home"\n')

    result = executive("run", str(script), "--quiet")

    assert result.exit_code == 0
    assert result.stdout.startswith("script done: 2 statements as expected")


def test_a_script_with_a_sentence_that_is_not_understood_moves_nothing(executive, tmp_path):
    script = tmp_path / "script.toml"
    script.write_text('[[task]]\nsay = "go home"\n[[task]]\nsay = "pick up the zorbl"\n')

    result = executive("run", str(script))

    assert result.exit_code == 2
    assert "zorbl" in result.stdout
    assert "EXECUTING" not in result.stderr


def test_recorded_runs_are_listed_with_their_outcome(executive):
    executive("run", "dance", "--quiet")

    assert "refused" in executive("runs").stdout
    assert "dance" in executive("runs").stdout


def test_why_of_a_run_that_is_not_there_is_exit_code_2(executive):
    result = executive("why", "yesterday")

    assert result.exit_code == 2
    assert "yesterday" in one_line(result)


@pytest.mark.parametrize(
    ("text", "code"), [("pick up the red cup", 0), ("dance", 2), ("pick up something", 3), ("-x", 2)]
)
def test_parse_prints_one_document_and_the_exit_code_of_its_outcome(executive, text, code):
    result = executive("parse", "--", text)

    assert result.exit_code == code
    assert json.loads(result.stdout)["text"] == text


@pytest.mark.requirement("L7", "L8")
@pytest.mark.parametrize(("confidence", "outcome"), [(0.9, "tasks"), (0.5, "question"), (7, "refused")])
def test_parse_reads_what_a_model_sends(executive, confidence, outcome):
    result = executive("parse", json.dumps([{"command": "go home", "confidence": confidence}]))

    assert json.loads(result.stdout)["outcome"] == outcome


def test_parse_of_a_stream_answers_every_line_blank_ones_too(executive):
    result = executive("parse", "-", input=b"go home\n\n\xff\xfe\npick up the red cup")

    documents = [json.loads(line) for line in result.stdout.splitlines()]
    assert result.exit_code == 0
    assert [document["outcome"] for document in documents] == ["tasks", "refused", "refused", "tasks"]


def test_parse_of_a_file_answers_every_line(executive, tmp_path):
    file = tmp_path / "sentences.txt"
    file.write_text("go home\n\nstop\n")

    documents = [json.loads(line) for line in executive("parse", str(file)).stdout.splitlines()]

    assert [document["outcome"] for document in documents] == ["tasks", "refused", "tasks"]


@pytest.mark.parametrize("form", ["text", "json", "dot", "svg", "xml"])
def test_the_tree_of_a_sentence_is_printed_without_a_robot(executive, form):
    result = executive("tree", "pick up the red cup", "--format", form)

    assert result.exit_code == 0
    assert "plan pick" in result.stdout


def test_words_of_ones_own_are_taken_from_the_given_file(executive, tmp_path, monkeypatch):
    monkeypatch.setenv(CONFIG_VARIABLE, "")  # what the command sets is taken back after the test
    words = tmp_path / "words.toml"
    words.write_text('[vocabulary.KIND]\nwords.cup = ["zorbl"]\n')

    assert executive("tree", "look at the zorbl").exit_code == 2
    assert executive("tree", "look at the zorbl", "--config", str(words)).exit_code == 0


@pytest.mark.parametrize("command", ["run", "serve", "check", "tree"])
def test_a_file_of_words_with_a_mistake_is_one_line_and_exit_code_2(
    executive, tmp_path, monkeypatch, command
):
    monkeypatch.setenv(CONFIG_VARIABLE, "")
    words = tmp_path / "words.toml"
    words.write_text("vocabulary = [")

    said = [] if command == "serve" else ["pick up the cup"]
    result = executive(command, *said, "--config", str(words))

    assert result.exit_code == 2
    assert "words.toml: is no TOML" in one_line(result)


def test_a_tree_that_was_printed_as_xml_is_read_back_from_its_file(executive, tmp_path):
    printed = executive("tree", "pick up the red cup", "--format", "xml").stdout
    file = tmp_path / "pick.xml"
    file.write_text(printed)

    assert executive("tree", str(file), "--format", "xml").stdout == printed
    assert executive("tree", str(file)).stdout == executive("tree", "pick up the red cup").stdout


def test_a_file_that_is_no_tree_is_refused_with_its_name_and_the_reason(executive, tmp_path):
    file = tmp_path / "bad.xml"
    file.write_text('<root BTCPP_format="4"><BehaviorTree ID="A"><Fly/></BehaviorTree></root>')

    result = executive("tree", str(file))

    assert result.exit_code == 2
    assert "bad.xml: A/Fly: there is no node 'Fly'" in result.stderr
    assert executive("tree", str(tmp_path / "none.xml")).exit_code == 2


def test_the_tree_of_a_refused_sentence_is_refused(executive):
    assert executive("tree", "dance").exit_code == 2


@pytest.mark.parametrize(
    ("what", "word"), [("robots", "talos"), ("scenes", "tabletop"), ("skills", "pick"), ("words", "mug")]
)
def test_what_there_is_can_be_listed(executive, what, word):
    assert word in executive("list", what).stdout


def test_a_package_of_leaves_that_cannot_be_loaded_is_told_where_skills_are_listed(executive, broken_leaves):
    assert f"left out: {broken_leaves}" in executive("list", "skills").stdout


def test_a_tree_with_a_leaf_of_a_package_that_cannot_be_loaded_says_why(executive, broken_leaves, tmp_path):
    (tmp_path / "bad.xml").write_text(
        '<root BTCPP_format="4"><BehaviorTree ID="A"><Fly/></BehaviorTree></root>'
    )

    assert broken_leaves in executive("tree", str(tmp_path / "bad.xml")).stderr


def test_every_skill_that_is_listed_has_a_valid_example():
    from executive.understanding.command_parser import parse
    from trees.registry import skills

    for action, skill in skills().items():
        assert [command.action for command in parse(skill.example).commands] == [action]


def test_doctor_finds_this_machine_in_order(executive):
    result = executive("doctor")

    assert result.exit_code == 0
    assert "MISSING" not in result.stdout


def test_doctor_names_the_fix_for_what_is_missing(executive, tmp_path, monkeypatch):
    (tmp_path / "data").write_text("a file where the folder would be")

    result = executive("doctor")

    assert result.exit_code == 2
    assert "MISSING runs folder" in result.stdout
    assert "fix: use --record" in result.stdout


def test_doctor_tells_of_damaged_files_of_the_compiled_kernel(executive, monkeypatch):
    monkeypatch.setattr("kinematics.compiled.cache.damaged", lambda: [Path("/cache/judge-17.py311.1.nbc")])
    monkeypatch.setattr("kinematics.compiled.readiness.ready", lambda: True)

    lines = executive("doctor").stdout.splitlines()

    (found,) = (number for number, line in enumerate(lines) if "motion kernel" in line)
    assert lines[found].startswith("absent")
    assert "1 of its files damaged, such as /cache/judge-17.py311.1.nbc" in lines[found]
    assert "fix: executive doctor --warm" in lines[found + 1]


def test_a_defect_is_one_line_with_the_name_of_its_crash_report(executive, monkeypatch):
    def broken(record):
        raise ZeroDivisionError("a planted defect")

    monkeypatch.setattr(run_search, "find_runs", broken)

    result = executive("runs")

    line = one_line(result)
    assert result.exit_code == ExitCode.DEFECT
    report = Path(line.rpartition(" in ")[2])
    assert "a planted defect" in report.read_text()


def test_a_missing_package_is_told_from_a_defect(executive, monkeypatch):
    def broken(_record):
        raise ModuleNotFoundError("No module named 'lark'", name="lark")

    monkeypatch.setattr(run_search, "find_runs", broken)

    result = executive("runs")

    assert result.exit_code == 2
    assert "'lark' is not installed" in one_line(result)


def run_process(*arguments, **options):
    return subprocess.run(
        [sys.executable, *arguments], cwd=ROOT, capture_output=True, text=True, timeout=120, **options
    )


HEAVY = ("mujoco", "pinocchio", "placo", "coal", "scipy", "numpy", "lark", "rich.live", "py_trees")


def test_the_command_line_imports_no_heavy_library_before_a_command_needs_it():
    code = f"import sys, executive.cli.app; print([name for name in {HEAVY!r} if name in sys.modules])"

    assert run_process("-c", code).stdout.strip() == "[]"


def test_parsing_needs_neither_robot_nor_numbers():
    code = (
        "import sys; from executive.understanding.command_parser import parse; parse('pick up the red cup');"
        "print([name for name in ('mujoco', 'pinocchio', 'numpy', 'py_trees') if name in sys.modules])"
    )

    assert run_process("-c", code).stdout.strip() == "[]"


def test_surrogates_from_a_broken_terminal_are_refused_without_a_traceback(tmp_path):
    environment = {**os.environ, "XDG_DATA_HOME": str(tmp_path), "PYTHONUTF8": "1"}
    done = run_process("-m", "executive", "run", b"pick up \xff", "--quiet", env=environment)

    assert done.returncode == 2
    assert "Traceback" not in done.stderr


@pytest.mark.requirement("F2")
def test_a_check_is_written_for_continuous_integration_too(executive, tmp_path):
    report = tmp_path / "check.xml"

    refused = executive("check", "pick up the purple unicorn", "--junit", str(report), "--plain")

    assert refused.exit_code == 2
    (case,) = ElementTree.parse(report).getroot().iter("testcase")
    assert "unicorn" in case.find("failure").get("message")


@pytest.mark.requirement("L8")
def test_how_far_a_model_is_trusted_can_be_said_to_a_check(executive):
    steps = '{"steps": [{"action": "wait", "duration_s": 1, "confidence": 0.5}]}'

    assert executive("check", steps).exit_code == 3
    assert executive("check", steps, "--confidence", "0.4").exit_code == 0


@pytest.mark.parametrize(("pace", "told"), [("slow", "no pace"), ("99", "not in the range")])
def test_a_pace_that_is_none_is_refused_before_anything_is_served(executive, pace, told):
    answer = executive("serve", "--pace", pace)

    assert answer.exit_code == 2
    assert told in answer.output


def test_the_skills_of_a_robot_are_listed_with_what_it_lacks_for_the_others(executive):
    lines = executive("list", "skills", "--robot", "panda").stdout.splitlines()

    assert "pick       pick up the red cup on the table" in lines
    assert any(line.startswith("walk_to    no: needs feet; panda stands on a welded base") for line in lines)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("walk to the table", "walk_to needs feet; panda stands on a welded base"),
        ("look at the red box", "look_at needs eyes that aim; the camera of panda stays as it is"),
        ("pick up the red box with your left hand", "panda has no left hand, but its right hand"),
    ],
)
@pytest.mark.parametrize("command", ["run", "check"])
def test_what_a_robot_has_no_part_for_is_refused_by_naming_the_part(executive, command, text, says):
    result = executive(command, text, "--robot", "panda")

    assert result.exit_code == 1
    assert says in result.output


@pytest.mark.requirement("U4")
@pytest.mark.parametrize("command", ["run", "check"])
def test_a_robot_that_is_no_folder_is_one_line(command, tmp_path):
    ended = subprocess.run(
        [sys.executable, "-m", "executive", command, "say hello", "--robot", str(tmp_path / "nowhere")],
        capture_output=True,
        text=True,
        check=False,
    )

    assert ended.returncode == ExitCode.INVALID
    assert "expected a folder with a description.toml" in ended.stderr
    assert "defect" not in ended.stderr


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (("--body", "unitre"), "no body 'unitre'; the nearest is 'unitree'"),
        (("--body", "unitree", "--pace", "0.5"), "--pace is for a simulated world"),
        (("--body", "unitree", "--evaluation"), "--evaluation is for a simulated world"),
        (("--body", "unitree", "--perception", "stub"), "--perception is for a simulated world"),
        (("--body", "unitree", "--body-option", "eth0"), "expected KEY=VALUE, not 'eth0'"),
        (("--body-option", "interface=eth0"), "--body-option is an option of the body"),
    ],
)
def test_what_is_wrong_with_a_body_is_said_before_anything_is_attached(executive, options, says):
    told = executive("serve", "--robot", "g1", *options)

    assert says in " ".join(told.stderr.split())
    assert told.exit_code == ExitCode.INVALID

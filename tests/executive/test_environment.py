"""A disk that is full, an output that is gone: told in one line, and the robot goes on."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from executive.cli import app as cli
from executive.exit_codes import ExitCode


@pytest.fixture
def executive(tmp_path, monkeypatch):
    """Run the command line, with this user's data in a folder of the test's own."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return lambda *arguments, **options: CliRunner().invoke(cli.app, list(arguments), **options)


def test_a_robot_whose_runs_cannot_be_recorded_is_not_served(executive, tmp_path):
    result = executive("serve", "--record", "/proc/none", "--folder", str(tmp_path / "live"))

    assert result.exit_code == 2
    assert "cannot write /proc/none" in result.stderr
    assert not (tmp_path / "live").exists()


ROOT = Path(__file__).parents[2]


@pytest.fixture
def shell(tmp_path):
    """Run a line of a shell in which ``executive`` is the command line; the code of the last command."""
    environment = {**os.environ, "XDG_DATA_HOME": str(tmp_path), "PYTHONPATH": str(ROOT)}

    def run(line):
        line = f'set -o pipefail; executive() {{ "{sys.executable}" -m executive "$@"; }}; {line}'
        return subprocess.run(
            ["bash", "-c", line], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120
        )

    return run


@pytest.mark.parametrize("command", ["list skills", "parse wave", "--help"])
def test_a_full_disk_under_standard_output_is_no_defect_of_this_program(shell, command):
    done = shell(f"executive {command} > /dev/full")

    assert done.returncode == 2
    assert done.stderr == "executive: cannot write on standard output: No space left on device\n"


def test_who_reads_no_further_ends_a_command_as_the_pipes_of_other_programs_end(shell):
    done = shell("executive list words | head -1")

    assert (done.returncode, done.stderr, len(done.stdout.splitlines())) == (141, "", 1)


def test_progress_that_cannot_be_shown_does_not_disturb_a_run(shell):
    done = shell("executive run 'go home' 2> /dev/full")

    assert done.returncode == 0
    assert done.stdout.startswith("done: at the home posture")


def test_a_result_that_cannot_be_written_is_told_on_standard_error_and_by_the_exit_code(shell):
    done = shell("executive run 'go home' --quiet > /dev/full")

    assert done.returncode == 0
    assert "No space left on device; the result: done: at the home posture" in done.stderr


def test_nobody_answers_where_standard_input_is_closed(shell):
    assert shell("executive run 'pick up it' --quiet <&-").returncode == 3
    assert shell("executive parse - <&-").returncode == 0


def test_a_run_without_standard_output_has_the_exit_code_of_its_task(shell):
    done = shell("executive run 'go home' >&-")

    assert (done.returncode, "Traceback" in done.stderr) == (0, False)


@pytest.mark.parametrize("option", ["--report", "--junit"])
def test_a_run_whose_report_is_lost_is_no_success(shell, option):
    done = shell(f"executive run 'go home' --quiet {option} /dev/full")

    assert done.returncode == 1
    assert done.stdout.startswith("done: at the home posture")
    assert "cannot write /dev/full: No space left on device" in done.stderr


def test_a_refusal_stays_one_when_its_report_is_lost(executive):
    result = executive("run", "dance", "--quiet", "--report", "/dev/full")

    assert result.exit_code == 2
    assert "cannot write /dev/full" in result.stderr


@pytest.mark.parametrize("option", ["--report", "--junit"])
def test_a_check_whose_report_is_lost_says_its_verdict_and_the_fault(executive, option):
    result = executive("check", "go home", option, "/dev/full")

    assert result.exit_code == 2
    assert "safe" in result.stdout
    assert "cannot write /dev/full" in result.stderr


@pytest.mark.parametrize("option", ["--robot", "--scene"])
@pytest.mark.parametrize("command", [["run", "go home"], ["check", "go home"], ["serve"]])
def test_an_empty_name_is_not_taken_for_one_that_was_left_out(executive, command, option):
    result = executive(*command, option, "")

    assert result.exit_code == 2
    assert f"{option}" in result.stderr
    assert "the name is empty" in result.stderr


INTERRUPTED = """
import sys
class Interrupting:
    def find_spec(self, name, *_):
        if name == {module!r}:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupting())
sys.argv[1:] = ["parse", "wave"]
from executive.__main__ import main
main()
"""


@pytest.mark.parametrize("module", ["executive.cli.app", "typer", "executive.understanding.understanding"])
def test_ctrl_c_while_the_program_loads_is_a_cancel_without_a_traceback(module):
    done = subprocess.run(
        [sys.executable, "-c", INTERRUPTED.format(module=module)],
        cwd=ROOT, capture_output=True, text=True, timeout=60,
    )  # fmt: skip

    assert (done.returncode, done.stdout) == (ExitCode.CANCELLED, "")
    assert len(done.stderr.splitlines()) <= 1

"""``executive send``, to somebody at a real desk who answers as a test says."""

import threading
import time

import pytest
from typer.testing import CliRunner

from executive.cli import app as cli
from executive.exit_codes import ExitCode
from executive.live.desk_messages import Say, ScriptLine
from executive.live.served_executive.desk import Desk
from robots.live.wire.messages import write_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.socket_server import SocketServer

DONE, FAILED = ("done: it waves", "done", ExitCode.DONE), ("failed: it fell", "failed", ExitCode.FAILED)


class Nobody:
    """Attends to nothing."""

    def status(self):
        return {"task": None, "paused": False}


class Served:
    """A desk in another thread that ends each order as it is told to, and a robot that says what it is."""

    def __init__(self, folder):
        self.folder, self.ending, self.said = folder, DONE, []
        folder.make()
        self._desk = Desk(folder.executive_socket, Nobody(), lambda text: False)
        about = write_message("status", robot="talos", scene="tabletop", seed=7)
        self._control = SocketServer(folder.control_socket, lambda caller, frame: caller.send(about))
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def _serve(self):
        while not self._over.is_set():
            self._desk.poll()
            self._control.poll()
            if (order := self._desk.next_order()) is not None:
                self.said.append(order.said)
                if self.ending is None:
                    order.connection.close("killed")
                else:
                    order.end(*self.ending)
                self._desk.finish()
            time.sleep(0.002)
        self._desk.close()
        self._control.close()

    def send(self, *arguments):
        return CliRunner().invoke(cli.app, ["send", *map(str, arguments), "--folder", str(self.folder.path)])

    def close(self):
        self._over.set()
        self._thread.join()


@pytest.fixture
def served(tmp_path):
    made = Served(RuntimeFolder(tmp_path / "live"))
    yield made
    made.close()


@pytest.fixture
def script(tmp_path):
    def write(text):
        path = tmp_path / "tidy.toml"
        path.write_text(text)
        return path

    return write


WAVE = '[[task]]\nsay = "wave"\n'


@pytest.mark.parametrize("ending", [DONE, FAILED])
def test_the_served_robots_line_and_code_are_those_of_the_command(served, ending):
    served.ending = ending

    result = served.send("wave")

    assert (result.stdout.strip(), result.exit_code) == (ending[0], ending[2])
    assert served.said == [Say("wave")]


@pytest.mark.requirement("S3")
def test_an_executive_that_ends_before_the_result_has_failed_the_order(served):
    served.ending = None

    result = served.send("wave")

    assert result.exit_code == 1
    assert result.stdout.startswith("failed: the executive ended")


@pytest.mark.requirement("U1")
def test_a_script_is_one_order_with_all_that_its_statements_say(served, script):
    path = script(
        f'{WAVE}on_failure = "retry"\ntimeout_s = 9.0\n'
        '[[task]]\nsay = "pick up something"\nexpect = "question"\n'
    )

    assert served.send(path).exit_code == 0
    (order,) = served.said
    assert order.lines == (
        ScriptLine(str(path), "wave", "retry", "done", 9.0),
        ScriptLine(str(path), "pick up something", "stop", "question", 0.0, last=True),
    )


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ('robot = "g1"', "robot: 'g1' is wanted, but 'talos' is served"),
        ('scene = "flat"', "scene: 'flat' is wanted, but 'tabletop' is served"),
        ("seed = 8", "seed: 8 is wanted, but 7 is served"),
    ],
)
def test_a_script_for_another_robot_scene_or_seed_is_not_sent(served, script, line, says):
    result = served.send(script(f"{line}\n{WAVE}"))

    assert (result.exit_code, served.said) == (2, [])
    assert f"tidy.toml: {says}" in result.stderr


def test_a_script_for_what_is_served_is_sent(served, script):
    assert served.send(script(f'robot = "talos"\nscene = "tabletop"\nseed = 7\n{WAVE}')).exit_code == 0


@pytest.mark.parametrize("velocity", [("nan", "0.0"), ("0.0", "inf")])
def test_a_velocity_that_is_no_number_is_not_sent(served, velocity):
    result = served.send("--velocity", *velocity)

    assert (result.exit_code, served.said) == (2, [])
    assert "--velocity" in result.stderr
    assert "not two finite numbers" in result.stderr


def test_words_that_cannot_cross_the_socket_are_refused_as_run_refuses_them(served):
    result = served.send("wave\udcff")

    assert (result.exit_code, served.said) == (2, [])
    assert "U+DCFF" in result.stderr


def test_line_breaks_are_spaces(served):
    served.send('{"command":\n"wave"}')

    assert served.said == [Say('{"command": "wave"}')]

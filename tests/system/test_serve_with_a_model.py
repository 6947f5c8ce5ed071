"""``executive serve --model``: whoever sends free speech is read back what the model makes of it.

The pace is low, so that a busy machine keeps up; no time is judged.
"""

import pytest

from executive.doors.own_robot import OwnRobot
from tools.evaluate.front.scripted_server import Answer, ScriptedServer, steps

FREE = "might one trouble you to pass a second or so in perfect idleness"
NEWS_WITHIN_S = 120.0
MOST_NEWS = 60


@pytest.fixture
def serve(tmp_path):
    """Serves a robot with a scripted server's model in front."""

    def serve(server):
        config = tmp_path / "config.toml"
        config.write_text(server.settings())
        options = ["--model", "scripted", "--config", str(config), "--record", str(tmp_path / "runs")]
        return OwnRobot([*options, "--ordinary", "--pace", "0.15"], lambda _line: None)

    return serve


def news_until(run, reached):
    """The status as soon as it is so, or as the run has ended."""
    seen = 0
    for _ in range(MOST_NEWS):
        status = run.status()
        if status.ended or reached(status):
            return status
        seen = run.wait(seen, NEWS_WITHIN_S)
    raise AssertionError(f"nothing came of {run.text!r}: {status}")


@pytest.mark.slow
@pytest.mark.requirement("L10", "U3")
def test_free_speech_to_a_served_robot_is_refused_read_back_and_done(serve):
    broken = Answer((b"{}",), status=500)
    with ScriptedServer(broken, steps("wait for 1 second")) as server, serve(server) as own:
        robot = own.wait(lambda: False)

        failed = news_until(robot.begin(FREE), lambda status: status.question is not None)
        assert failed.outcome == "refused", failed
        assert "the server answered with an error" in failed.message

        run = robot.begin(FREE)
        asked = news_until(run, lambda status: status.question is not None)
        assert asked.question["text"] == "I understood: wait for 1 s; shall I?", asked
        assert robot.answer("yes")
        done = news_until(run, lambda status: False)

    assert done.outcome == "done", done
    assert len(server.requests) == 2

"""``executive chat`` with a simulated robot of its own: dialogues in a pipe, a model's server among them."""

import os
import queue
import subprocess
import sys
import threading
import time

import pytest

from tools.evaluate.front.scripted_server import Answer, ScriptedServer, steps

PATIENCE_S = 300.0
FREE = "would you be so kind and get hold of that red cup over there for me"


class Chat:
    """A chat with somebody who types, and what it said so far."""

    def __init__(self, tmp_path, *options):
        command = [sys.executable, "-m", "executive", "chat", "--record", str(tmp_path / "runs"), *options]
        environment = {**os.environ, "XDG_STATE_HOME": str(tmp_path), "XDG_CONFIG_HOME": str(tmp_path)}
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(
            command, stdin=pipe, stdout=pipe, stderr=subprocess.STDOUT, env=environment, text=True, bufsize=1
        )
        self.lines, self._come = [], queue.SimpleQueue()
        threading.Thread(target=self._listen, daemon=True).start()

    def say(self, *lines):
        for line in lines:
            self.process.stdin.write(f"{line}\n")
        self.process.stdin.flush()
        return self

    def until(self, part):
        until_s = time.monotonic() + PATIENCE_S
        while not any(part in line for line in self.lines):
            try:
                self.lines.append(self._come.get(timeout=max(until_s - time.monotonic(), 0.0)))
            except queue.Empty:
                raise AssertionError(f"in vain: {part}\n{self.text}") from None
        return self

    def end(self):
        self.process.stdin.close()
        code = self.process.wait(PATIENCE_S)
        while not self._come.empty():
            self.lines.append(self._come.get())
        return code

    @property
    def text(self):
        return "\n".join(self.lines)

    def said(self):
        return [line for line in self.lines if line.startswith(("robot: ", "you:   "))]

    def _listen(self):
        for line in self.process.stdout:
            self._come.put(line.rstrip("\n"))


@pytest.fixture
def chat(tmp_path):
    made = []

    def begin(*options):
        made.append(Chat(tmp_path, "--pace", "0.8", *options))
        return made[-1]

    yield begin
    for one in made:
        if one.process.poll() is None:
            one.process.terminate()
        one.process.wait(60.0)
        one.process.stdin.close()
        one.process.stdout.close()


@pytest.mark.slow
@pytest.mark.requirement("U1", "L6", "F4")
def test_a_question_a_failure_and_a_correction_with_a_simulated_robot(chat):
    dialogue = chat("--scene", "clutter", "--seed", "7").say("pick up the cup").until("which cup?")
    dialogue.say("the red one").until("robot: Done: ").say("pick up the blue cup with the right hand")
    dialogue.until("robot: Failed: ").say("why", "look at the blue cup").until("what helps")

    assert dialogue.end() == 0, dialogue.text
    assert "robot: Done: red cup held" in dialogue.text
    assert dialogue.said()[-1].startswith("robot: Done: "), dialogue.text


@pytest.mark.slow
@pytest.mark.requirement("S4", "U1")
def test_a_stop_in_the_middle_of_a_motion_latches_until_a_person_resets_it(chat):
    dialogue = chat("--scene", "tabletop").say("pick up the red cup").until("stream reach").say("stop")
    dialogue.until("robot: Cancelled: ").say("wave").until("robot: Refused: ")

    told = next(line for line in dialogue.lines if line.startswith("robot: Stopped: "))
    command = told.partition("`")[2].partition("`")[0].split()
    assert command[:2] == ["executive", "reset"]
    subprocess.run([sys.executable, "-m", *command], check=True, capture_output=True)
    assert dialogue.say("wait for 0.5 seconds").until("robot: Done: ").end() == 0, dialogue.text


@pytest.mark.slow
@pytest.mark.requirement("L10", "U1")
def test_a_model_that_fails_moves_nothing_and_one_that_proposes_is_read_back(chat, tmp_path):
    broken = Answer((b"{}",), status=500)
    with ScriptedServer(broken, steps("pick up the red cup")) as server:
        (tmp_path / "config.toml").write_text(server.settings())
        options = ("--scene", "tabletop", "--config", str(tmp_path / "config.toml"), "--model", "scripted")
        dialogue = chat(*options).say(FREE).until("robot: Refused: ")
        assert "EXECUTING" not in dialogue.text
        assert "the model 'scripted': " in dialogue.text
        dialogue.say(FREE).until("shall I?").say("yes").until("robot: Done: ")

        assert dialogue.end() == 0, dialogue.text
        assert len(server.requests) == 2

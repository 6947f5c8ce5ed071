"""A conversation with a robot: what each typed line does now, and what the robot says of it.

It knows of no terminal: lines come in, utterances go out, and somebody calls ``poll`` again and again.
Nothing here waits, so that a stop is heeded whatever goes on.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from executive.chat import answers
from executive.chat.aside import Aside
from executive.chat.phrases import Ask, asked_of_chat
from executive.chat.robot_watch import RobotStanding
from executive.chat.talked import Begun, Talked
from executive.chat.utterance import Utterance
from executive.dialogue.clarification import OpenQuestion
from executive.doors.served_robot import TaskStatus
from executive.errors import UserError
from executive.exit_codes import ExitCode
from executive.screens.rows import Style
from robots.live.wire.errors import LiveError

MOST_WAITING = 5
"""Lines that wait for their turn."""


class Talk:
    """One conversation.

    Args:
        robot: Who is talked to.
        show: Takes what is said by either side.
        log: Takes the robot's lines of feedback that are not said.
        standing: How the robot stands now.
        how_to_reset: What a person does to leave an emergency stop.
        reset: Leaves it, for a person at this terminal; None where nobody is known to be there.

    Attributes:
        code: Exit code of the last task.
        question: What the robot has asked, and nobody answered yet.
        waiting: Lines that wait for their turn.
    """

    def __init__(
        self,
        robot: Talked,
        show: Callable[[Utterance], None],
        log: Callable[[str], None],
        standing: Callable[[], RobotStanding],
        how_to_reset: str,
        reset: Callable[[], str] | None = None,
    ) -> None:
        self._robot, self._show, self._log, self._standing = robot, show, log, standing
        self._how_to_reset, self._reset = how_to_reset, reset
        self._aside = Aside()
        self.code = ExitCode.DONE
        self.question: OpenQuestion | None = None
        self.waiting: deque[str] = deque()
        self._text = self._spoken = ""
        self._run: Begun | None = None
        self._told = 0
        self._put: Mapping[str, Any] | None = None
        self._last: TaskStatus | None = None
        self._interrupts = 0
        self._warned = False
        self._ending = self._left_open = False
        self._lost = False

    # ------------------------------------------------------------------ how it stands

    @property
    def under_way(self) -> str:
        """What is being done; nothing while the robot is free."""
        return self._text

    @property
    def is_ready(self) -> bool:
        """Whether a line would be taken at once: the robot is free, or waits for an answer."""
        return not self._text or self.question is not None

    @property
    def is_over(self) -> bool:
        """Whether the conversation has ended, and nothing is under way any more."""
        return self._lost or (self._ending and not self._text and self._aside.is_idle)

    # ------------------------------------------------------------------ what comes in

    def hear(self, line: str) -> None:
        """Take a line that somebody typed."""
        line = line.strip()
        if not line:
            return
        self._show(Utterance("you", (line,)))
        asked = asked_of_chat(line)
        if asked is Ask.STOP:
            self._stop(f"{line[:40]!r} was typed")
        elif asked in (Ask.WHY, Ask.STANDING, Ask.HELP, Ask.RESET, Ask.END, Ask.PAUSE):
            self._do(asked)
        elif self.question is not None:
            self._answer(line)
        elif asked is Ask.SEEN and self._text:
            self._aside.do(self._robot.scene, lambda things: self._say(*answers.seen(things)), self._complain)
        elif asked in (Ask.CANCEL, Ask.GO_ON):
            self._do(asked)
        elif self._text:
            self._wait(line)
        else:
            self._begin(line)

    def interrupt(self) -> None:
        """Take a Ctrl-C: it cancels what is under way, a second one stops, and a free robot is left."""
        if not self._text:
            self._ending = True
            return
        self._interrupts += 1
        if self._interrupts == 1:
            self._cancel("cancelled from the keyboard", "Ctrl-C again is the emergency stop.")
        else:
            self._stop("Ctrl-C, twice")

    def stop(self) -> None:
        """Take the stop key."""
        self._stop("the stop key of the chat")

    def pause(self) -> None:
        """Take the pause key: hold what is under way, or go on with it."""
        self._do(Ask.GO_ON if self._standing().paused else Ask.PAUSE)

    def end_of_input(self) -> None:
        """Nothing more will be typed: what is under way goes on to its end; a question stays open."""
        self._ending = True

    def end(self, reason: str) -> None:
        """End as soon as the robot holds."""
        self._ending = True
        if self._text and self.question is None:
            self._cancel(reason, "Then this chat ends.")

    # ------------------------------------------------------------------ what goes on

    def poll(self) -> None:
        """Tell what has happened since."""
        self._aside.settle()
        if self._standing().lost:
            self._lose(self._standing().silent)
            return
        if self._run is not None:
            self._hear_news(self._run)
        if self._ending and self.question is not None:
            self._leave_open()

    def _hear_news(self, run: Begun) -> None:
        ended = run.ended
        status = run.status()
        lines, self._told = run.news(self._told)
        for line in lines[:-1] if ended else lines:
            said = answers.spoken(line)
            if said is not None:
                self._say(said)
                self._spoken = said
            if answers.is_feedback(line):
                self._log(line)
        if ended:
            self._finish(status)
        elif status.question is not None and status.question is not self._put:
            self._put = status.question
            asked = OpenQuestion(
                str(status.question["text"]),
                tuple(status.question["choices"]),
                str(status.question.get("tried", "")),
            )
            self._ask(asked)

    def _finish(self, status: TaskStatus) -> None:
        self._run, self.question, self._put = None, None, None
        self._last = status
        self.code = ExitCode.QUESTION if self._left_open else answers.code_of(status)
        said, style = answers.what_became(status, self._spoken)
        self._say(said, style=style)
        if status.outcome in ("cancelled", "refused") and self._standing().emergency and not self._warned:
            self._say(self._how_to_reset, style="alarm")
        self._text = ""
        if status.outcome == "done":
            self._go_on_with_what_waits()
        else:
            self._drop_what_waits()

    def _go_on_with_what_waits(self) -> None:
        if self.waiting:
            line = self.waiting.popleft()
            self._say(f"Now {line!r}.")
            self._begin(line)

    def _drop_what_waits(self) -> None:
        if self.waiting:
            self._say(
                f"Not begun: {', '.join(map(repr, self.waiting))}. Say it again if you still want it.",
                style="ask",
            )
            self.waiting.clear()

    def _lose(self, reason: str) -> None:
        self._lost, self._text, self.question = True, "", None
        self.code = ExitCode.FAILED
        self._say(f"The robot does not answer any more: {reason}", style="alarm")

    # ------------------------------------------------------------------ a task

    def _begin(self, line: str) -> None:
        self._interrupts, self._warned = 0, False
        try:
            self._run, self._told = self._robot.begin(line), 0
        except (LiveError, UserError) as wrong:
            self.code = ExitCode.INVALID
            self._say(f"Not begun: {wrong}.", style="bad")
            self._drop_what_waits()
        else:
            self._text = line

    def _wait(self, line: str) -> None:
        if len(self.waiting) >= MOST_WAITING:
            self._say(f"I am busy, and {MOST_WAITING} wait already; say it again later.", style="ask")
            return
        self.waiting.append(line)
        self._say(f"I am busy with {self._text!r}. {' '.join(answers.waiting_words(self.waiting))}")

    # ------------------------------------------------------------------ questions

    def _ask(self, question: OpenQuestion) -> None:
        self.question = question
        hint = () if not question.choices else ("Answer with a number, in words, or 'never mind'.",)
        self._show(Utterance("robot", (*question.lines(), *hint), "ask"))

    def _answer(self, line: str) -> None:
        self.question = None
        self._aside.do(lambda: self._robot.answer(line), self._answered, self._complain)

    def _answered(self, was_asked: bool) -> None:
        if not was_asked:
            self._say("No question is open any more.", style="ask")

    def _leave_open(self) -> None:
        self.question, self._left_open = None, True
        self._say("The question stays open: nobody is there to answer. Nothing has moved since.", style="ask")
        self._send_cancel("nobody is there to answer")
        self.waiting.clear()
        self.code = ExitCode.QUESTION

    # ------------------------------------------------------------------ what is asked of the chat

    def _do(self, asked: Ask) -> None:
        match asked:
            case Ask.CANCEL:
                if self._text:
                    self._cancel("cancelled in the chat", "")
                else:
                    self._say("Nothing is under way.")
            case Ask.PAUSE:
                self._aside.do(lambda: self._robot.pause("paused in the chat"), self._paused, self._complain)
            case Ask.GO_ON:
                self._aside.do(self._robot.resume, self._resumed, self._complain)
            case Ask.RESET:
                self._leave_stop()
            case Ask.WHY:
                self._say(*self._why())
            case Ask.STANDING:
                self._say(*self._stands())
            case Ask.HELP:
                self._say(*answers.HELP)
            case Ask.END:
                self.end("the chat was ended")
            case Ask.SEEN | Ask.STOP:
                raise ValueError(asked)

    def _cancel(self, reason: str, more: str) -> None:
        self._say(" ".join(f"Cancelling: I brake and hold. {more}".split()), style="ask")
        self._send_cancel(reason)

    def _send_cancel(self, reason: str) -> None:
        run = self._run

        def sent(under_way: bool) -> None:
            if not under_way and run is not None and run is self._run and not run.ended:
                self._send_cancel(reason)  # it came before the task that it is for

        self._aside.do(lambda: self._robot.cancel(reason), sent, self._complain)

    def _stop(self, reason: str) -> None:
        try:
            self._robot.stop(reason)
        except LiveError as gone:
            self._say(f"THE STOP DID NOT REACH THE ROBOT: {gone}", style="alarm")
            return
        self._warned = True
        self._say(f"Stopped: the emergency stop is engaged. {self._how_to_reset}", style="alarm")
        self._drop_what_waits()

    def _leave_stop(self) -> None:
        if self._reset is None:
            self._say(f"A reset is a person's, at a terminal. {self._how_to_reset}", style="ask")
        else:
            self._aside.do(self._reset, self._say, self._complain)

    def _paused(self, under_way: bool) -> None:
        self._say(
            "I hold, in balance; 'go on' goes on." if under_way else "Nothing is under way.", style="ask"
        )

    def _resumed(self, was_paused: bool) -> None:
        self._say("Going on." if was_paused else "Nothing is paused.")

    def _why(self) -> Sequence[str]:
        said = answers.why(self._last)
        return [f"I am still busy with {self._text!r}.", *said] if self._text else said

    def _stands(self) -> list[str]:
        now = self._standing()
        if now.silent:
            return [f"The robot does not answer at the moment: {now.silent}"]
        said = (
            [f"The emergency stop is engaged: {now.emergency}. {self._how_to_reset}"] if now.emergency else []
        )
        if not self._text:
            return [*said, "Nothing is under way."]
        return [*said, *answers.progress(self._text, now), *answers.waiting_words(self.waiting)]

    def _complain(self, reason: str) -> None:
        self._say(f"The robot did not answer: {reason}", style="bad")

    def _say(self, *lines: str, style: Style = "") -> None:
        self._show(Utterance("robot", lines, style))

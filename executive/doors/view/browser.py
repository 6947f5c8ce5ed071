"""One browser that shows the page: its panels, and its buttons where it may command.

STOP is there for everybody who sees the page: it reaches the control process past the executive, and no page
of another origin can press it. Everything else that makes the robot do something needs the token.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import viser

from executive.doors.served_robot import RESET_IS_A_PERSONS, ServedRobot
from executive.doors.view import panels
from executive.doors.view.access import Access
from executive.doors.view.folding import Folding
from executive.doors.view.seen import Level, LogLine, Seen
from executive.doors.view.truth_drawing import Switch
from executive.errors import UserError
from robots.live.wire.errors import LiveError

_LEVEL_WORDS: dict[str, Level] = {"everything": "info", "speech and warnings": "said", "warnings": "warning"}
_TREE_WIDTH_PX, _WIDTH_PX = 380, 340


class Browser:
    """The words and buttons of one browser.

    Args:
        client: It, as viser knows it.
        robot: Who is commanded.
        access: Knows the token.
        note: Takes a line for the log.
        may_command: Whether it has come with the token.
        look: Lets it look at the robot, wherever that has gone.
        show_truth: Shows the simulator's truth, or no longer; None where there is none to show.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        robot: ServedRobot,
        access: Access,
        note: Callable[[LogLine], None],
        may_command: bool,
        show_truth: Switch | None = None,
        look: Callable[[], None] = lambda: None,
    ) -> None:
        self._client, self._robot, self._access, self._note = client, robot, access, note
        self._seen = Seen()
        self._asked: list[Any] = []
        self._question: object = None
        self._told: dict[str, str] = {}
        gui = client.gui
        gui.configure_theme(show_logo=False, show_share_button=False, dark_mode=False)
        gui.set_panel_label("robot")
        gui.main_panel.dock_right()
        gui.main_panel.set_width(_WIDTH_PX)
        stop = gui.add_button("STOP", color="red", icon=viser.Icon.HAND_STOP, hint="Emergency stop (Alt+S)")
        stop.on_click(lambda _event: self._stop())
        gui.add_command("STOP", hotkey="S", modifier="alt").on_trigger(lambda _event: self._stop())
        self._status = gui.add_html("")
        self._question_folder = gui.add_folder("the robot asks", visible=False)
        self._commands = gui.add_folder("command" if may_command else "to command")
        with self._commands:
            if may_command:
                self._add_commands()
            else:
                self._add_token()
        self._ending = gui.add_html("")
        gui.add_command("look at the robot", hotkey="L", modifier="alt").on_trigger(lambda _event: look())
        dark = gui.add_checkbox("dark", False)
        dark.on_update(
            lambda _event: gui.configure_theme(show_logo=False, show_share_button=False, dark_mode=dark.value)
        )
        if show_truth is not None:
            truth = gui.add_checkbox("the simulator's truth", False)
            truth.on_update(lambda _event: show_truth(truth.value))
        self._add_left()

    def show(self, seen: Seen) -> None:
        """Bring its words up to date; what has not changed is not sent."""
        self._seen = seen
        self._tell("status", self._status, panels.status_panel(seen))
        self._tell("ending", self._ending, panels.ending_panel(seen))
        tree = self._folding.words(seen.nodes, self._search.value, self._all.value)
        self._tell("tree", self._tree, tree)
        self._tell("log", self._log, panels.log_panel(seen.log, _LEVEL_WORDS[self._level.value]))
        if seen.question != self._question:
            self._question = seen.question
            self._ask()

    def _tell(self, name: str, handle: viser.GuiHtmlHandle, content: str) -> None:
        if self._told.get(name) != content:
            self._told[name] = content
            handle.content = content

    # ---------------------------------------------------------------- what it is made of

    def _add_left(self) -> None:
        gui = self._client.gui
        panel = gui.add_panel()
        with panel.add_tab("tree", viser.Icon.BINARY_TREE):
            self._search = gui.add_text("search", "")
            self._all = gui.add_checkbox("unfold all", False)
            self._folding = Folding(gui)
            self._tree = gui.add_html("")
        with panel.add_tab("log", viser.Icon.LIST):
            self._level = gui.add_dropdown("show", tuple(_LEVEL_WORDS))
            self._log = gui.add_html("")
        panel.dock_left()
        panel.set_width(_TREE_WIDTH_PX)

    def _add_token(self) -> None:
        gui = self._client.gui
        with gui.add_form(None) as form:
            said = gui.add_text("token", "", hint="It was printed when the robot was served")
            gui.add_button("take command").on_click(lambda _event: form.submit())

        def given(_event: object) -> None:
            if not self._access.is_token(said.value.strip()):
                _clear(said)
                self._note(
                    LogLine(self._seen.t_s, "a token that is not the printed one was refused", "warning")
                )
                return
            form.remove()
            with self._commands:
                self._add_commands()
            self._question = None

        form.on_submit(given)

    def _add_commands(self) -> None:
        gui = self._client.gui
        with gui.add_form(None) as form:
            line = gui.add_text("say", "", hint="A command, or the answer to the question that is open")
            gui.add_button("send", icon=viser.Icon.SEND).on_click(lambda _event: form.submit())

        def said(_event: object) -> None:
            text = line.value.strip()
            _clear(line)
            if text:
                self._do(partial(self._say, text))

        form.on_submit(said)
        hold = gui.add_button("pause / go on", icon=viser.Icon.PLAYER_PAUSE, hint="Alt+P")
        end = gui.add_button("cancel", icon=viser.Icon.X, hint="Brake, and hold (Alt+C)")
        hold.on_click(lambda _event: self._do(self._hold))
        end.on_click(lambda _event: self._do(self._cancel))
        gui.add_command("pause or go on", hotkey="P", modifier="alt").on_trigger(
            lambda _event: self._do(self._hold)
        )
        gui.add_command("cancel", hotkey="C", modifier="alt").on_trigger(
            lambda _event: self._do(self._cancel)
        )
        self._commanding = True

    _commanding = False

    def _ask(self) -> None:
        """Show the question that is open, or none."""
        for handle in self._asked:
            handle.remove()
        self._asked = []
        question = self._seen.question
        self._question_folder.visible = question is not None
        if question is None:
            return
        gui = self._client.gui
        with self._question_folder:
            self._asked.append(gui.add_html(panels.question_panel(question)))
            for choice in question.get("choices", ()):
                button = gui.add_button(str(choice), disabled=not self._commanding, color="yellow")
                button.on_click(self._answering(str(choice)))
                self._asked.append(button)

    def _answering(self, choice: str) -> Callable[[object], None]:
        return lambda _event: self._do(partial(self._answer, choice))

    # ---------------------------------------------------------------- what it does

    def _do(self, work: Callable[[], None]) -> None:
        """Do what was asked for; what goes wrong is told in its own words."""
        try:
            work()
        except (LiveError, UserError) as wrong:
            self._note(LogLine(self._seen.t_s, str(wrong), "error"))

    def _stop(self) -> None:
        self._do(partial(self._robot.stop, "STOP in the browser"))
        self._note(LogLine(self._seen.t_s, f"STOP was pressed; {RESET_IS_A_PERSONS}", "alarm"))

    def _say(self, text: str) -> None:
        if self._seen.question is None or not self._robot.answer(text):
            self._robot.begin(text)

    def _answer(self, choice: str) -> None:
        if not self._robot.answer(choice):
            self._note(LogLine(self._seen.t_s, "no question is open any more", "warning"))

    def _hold(self) -> None:
        if self._seen.paused:
            self._robot.resume()
        elif not self._robot.pause("paused in the browser"):
            self._note(LogLine(self._seen.t_s, "nothing is under way", "info"))

    def _cancel(self) -> None:
        if not self._robot.cancel("cancelled in the browser"):
            self._note(LogLine(self._seen.t_s, "nothing is under way", "info"))


def _clear(line: viser.GuiTextHandle) -> None:
    """Empty a line that was typed."""
    line.value = ""  # type: ignore[misc]

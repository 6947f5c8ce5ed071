"""The page of runs that are over: moments to scrub through, to play at any pace, failures to jump to."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from html import escape
from typing import Any

import viser

from executive.doors.view import panels
from executive.doors.view.access import HERE, Access, new_token
from executive.doors.view.folding import Folding
from executive.doors.view.page_server import PageServer
from executive.doors.view.recording import Recording, first_difference
from executive.doors.view.shown_run import Beside, ShownRun
from executive.doors.view.viewer import DRAWN_EVERY_S, look_from_the_side, prepare
from robots.clock import WallClock

PACES = {"0.1 x": 0.1, "0.25 x": 0.25, "0.5 x": 0.5, "1 x": 1.0, "2 x": 2.0, "5 x": 5.0, "10 x": 10.0}
_USUAL_PACE = "1 x"
_STEP_S = 0.01
_NUDGE_S = 0.1
_ROOMS_FARTHER, _TWO_FARTHER = 2.2, 2.4
_BESIDE_M, _TWO_ASIDE_M = 2.4, 0.3
"""From one run to the other, and how far aside one stands to look at both."""


class Timeline:
    """Shows one run, or two beside each other, until it is told to end.

    Everybody who looks sees the same moment.

    Args:
        server: Of the page.
        recording: The run.
        ended: Asked in between.
        other: Another run, at the same time; None for none.
        pace: At which it plays until another is chosen; one of ``PACES``.

    Attributes:
        t_s: The moment that is shown.
        ends_s: The last one.
        address: Of the page.
        difference: The first event in which two runs differ, or None.
    """

    def __init__(
        self,
        server: PageServer,
        recording: Recording,
        ended: Callable[[], bool],
        other: Recording | None = None,
        pace: str = _USUAL_PACE,
    ) -> None:
        self._recording, self._ended, self._wall = recording, ended, WallClock()
        self._page, self.address = server.viser, f"http://{HERE[0]}:{server.port}/"
        page = self._page
        self.ends_s = max(recording.ends_s, _STEP_S if other is None else other.ends_s)
        self.difference = None if other is None else first_difference(recording, other)
        self.t_s, self._playing, self._shown_s = 0.0, False, -1.0
        self._lock = threading.Lock()
        scene = page.scene
        prepare(scene)
        self._runs = [ShownRun(scene, recording)]
        if other is not None:
            part = Beside(scene, "/other", (0.0, _BESIDE_M, 0.0))
            self._runs.append(ShownRun(scene, other, part))
            for run, y_m in zip(self._runs, (0.0, _BESIDE_M), strict=True):
                scene.add_label(f"/name_{y_m:.0f}", run.recording.name, position=(0.0, y_m, 2.1))
        self._add_panels(pace)
        page.on_client_connect(self._look)

    def run(self) -> None:
        """Show, and play while that is asked for, until it ends."""
        pace_from_s = self._wall.now_s()
        while not self._ended():
            now_s = self._wall.now_s()
            if self._playing:
                self.go_to(self.t_s + PACES[self._pace.value] * (now_s - pace_from_s))
                if self.t_s >= self.ends_s:
                    self._play(False)
            pace_from_s = now_s
            if self.t_s != self._shown_s:
                self.draw(self.t_s)
            self._wall.sleep(max(now_s + DRAWN_EVERY_S - self._wall.now_s(), 0.0))

    def go_to(self, t_s: float) -> None:
        """Show another moment with the next drawing."""
        self.t_s = min(max(t_s, 0.0), self.ends_s)

    def _look(self, client: viser.ClientHandle) -> None:
        """Let a browser that comes look at the robot where it is; at two, and at rooms, from farther away."""
        moment = self._recording.moment(self.t_s)
        x_m, y_m = moment.report.sensed.q[:2].tolist()
        if len(self._runs) > 1:
            look_from_the_side(client, x_m, y_m + 0.5 * _BESIDE_M, _TWO_FARTHER, _TWO_ASIDE_M)
            return
        look_from_the_side(client, x_m, y_m, _ROOMS_FARTHER if moment.world.get("rooms") else 1.0)

    def hold(self) -> None:
        """Play no more."""
        self._play(False)

    def jump_to_failure(self) -> None:
        """Go to the next failure and hold there."""
        at_s = self._recording.next_failure_s(self.t_s)
        if at_s is not None:
            self._play(False)
            self.go_to(at_s)

    def draw(self, t_s: float) -> None:
        """Draw a moment; ``run`` does so for each that is gone to."""
        self._shown_s = t_s
        with self._page.atomic():
            for number, run in enumerate(self._runs):
                seen, tell = run.show(t_s), self._words[number]
                tell("status", panels.status_panel(seen))
                tell("question", "" if seen.question is None else panels.question_panel(seen.question, True))
                tell("ending", panels.ending_panel(seen))
                tell("tree", tell.folding.words(seen.nodes, self._search.value, self._all.value))
                tell("log", panels.log_panel(seen.log))
            if abs(self._slider.value - t_s) > _STEP_S:
                self._moving = True
                self._slider.value = t_s  # type: ignore[misc]
                self._moving = False

    _moving = False

    def _scrubbed(self, _event: Any) -> None:
        if not self._moving:
            self._play(False)
            self.go_to(float(self._slider.value))

    def _play(self, playing: bool) -> None:
        if playing and self.t_s >= self.ends_s:
            self.go_to(0.0)
        self._playing = playing
        self._button.label = "hold" if playing else "play"

    def jump_to_difference(self) -> None:
        """Go to the first event in which two runs differ, and hold there."""
        if self.difference is not None:
            self._play(False)
            self.go_to(self.difference.t_s)

    def _add_panels(self, pace: str) -> None:
        gui, recording = self._page.gui, self._recording
        gui.configure_theme(show_logo=False, show_share_button=False)
        gui.set_panel_label(recording.asked[:60])
        gui.main_panel.dock_right()
        ends_s, differs = max(self.ends_s, _STEP_S), self.difference
        marks = None if differs is None else ((differs.t_s, "differs"),)
        self._slider = gui.add_slider(
            "time, s", min=0.0, max=ends_s, step=_STEP_S, initial_value=0.0, marks=marks
        )
        self._button = gui.add_button("play", icon=viser.Icon.PLAYER_PLAY, hint="Alt+P")
        self._pace = gui.add_dropdown("pace", tuple(PACES), initial_value=pace)
        jump = gui.add_button(
            "next failure", icon=viser.Icon.ALERT_TRIANGLE, disabled=not recording.failures_s, hint="Alt+F"
        )
        if len(self._runs) > 1:
            gui.add_html(panels.difference_panel(differs))
            differ = gui.add_button(
                "first difference", icon=viser.Icon.GIT_COMPARE, disabled=differs is None, hint="Alt+D"
            )
            differ.on_click(lambda _event: self.jump_to_difference())
            gui.add_command("first difference", hotkey="D", modifier="alt").on_trigger(
                lambda _event: self.jump_to_difference()
            )
        self._words = [_Words() for _ in self._runs]
        for run, words in zip(self._runs, self._words, strict=True):
            if len(self._runs) > 1:
                gui.add_html(f"<b>{escape(run.recording.name)}</b>")
            for name in ("status", "question", "ending"):
                words.handles[name] = gui.add_html("")
        dark = gui.add_checkbox("dark", False)
        dark.on_update(
            lambda _event: gui.configure_theme(show_logo=False, show_share_button=False, dark_mode=dark.value)
        )
        self._slider.on_update(self._scrubbed)
        self._button.on_click(self._toggle)
        jump.on_click(lambda _event: self.jump_to_failure())
        gui.add_command("play or hold", hotkey="P", modifier="alt").on_trigger(self._toggle)
        gui.add_command("next failure", hotkey="F", modifier="alt").on_trigger(
            lambda _event: self.jump_to_failure()
        )
        back = gui.add_command("back", hotkey="arrowleft", modifier="shift")
        ahead = gui.add_command("ahead", hotkey="arrowright", modifier="shift")
        back.on_trigger(partial(self._nudge, -_NUDGE_S))
        ahead.on_trigger(partial(self._nudge, _NUDGE_S))
        self._add_left()

    def _add_left(self) -> None:
        gui = self._page.gui
        panel = gui.add_panel()
        for number, words in enumerate(self._words):
            which = f" {number + 1}" if len(self._words) > 1 else ""
            with panel.add_tab(f"tree{which}", viser.Icon.BINARY_TREE):
                if number == 0:
                    self._search = gui.add_text("search", "")
                    self._all = gui.add_checkbox("unfold all", False)
                    for one in (self._search, self._all):
                        one.on_update(lambda _event: self._again())
                words.folding = Folding(gui, self._again)
                words.handles["tree"] = gui.add_html("")
            with panel.add_tab(f"log{which}", viser.Icon.LIST):
                words.handles["log"] = gui.add_html("")
        panel.dock_left()
        panel.set_width(380)

    def _again(self) -> None:
        """Show the same moment once more."""
        self._shown_s = -1.0

    def _toggle(self, _event: Any) -> None:
        self._play(not self._playing)

    def _nudge(self, step_s: float, _event: Any) -> None:
        self._play(False)
        self.go_to(self.t_s + step_s)


class _Words:
    """What the page tells in words of one run; what has not changed is not sent."""

    folding: Folding

    def __init__(self) -> None:
        self.handles: dict[str, viser.GuiHtmlHandle] = {}
        self._told: dict[str, str] = {}

    def __call__(self, name: str, content: str) -> None:
        if self._told.get(name) != content:
            self._told[name] = content
            self.handles[name].content = content


@contextmanager
def timeline_beside(
    recording: Recording, other: Recording | None = None, pace: str = _USUAL_PACE
) -> Iterator[Timeline]:
    """The page of a run, or of two, on a free port and in a thread of its own, while something else goes on.

    Args:
        recording: The run.
        other: Another run, at the same time; None for none.
        pace: At which it plays until another is chosen; one of ``PACES``.
    """
    over = threading.Event()
    server = PageServer(0, Access(new_token()), recording.name)
    timeline = Timeline(server, recording, over.is_set, other, pace)
    thread = threading.Thread(target=timeline.run)
    thread.start()
    try:
        yield timeline
    finally:
        over.set()
        thread.join()
        server.close()

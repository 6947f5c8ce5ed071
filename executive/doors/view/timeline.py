"""The page of a run that is over: moments to scrub through, to play at any pace, failures to jump to."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from typing import Any

import viser

from executive.doors.view import panels
from executive.doors.view.balance_drawing import BalanceDrawing, balance_of
from executive.doors.view.page_server import PageServer
from executive.doors.view.plan_drawing import PlanDrawing
from executive.doors.view.recording import Recording
from executive.doors.view.robot_drawing import RobotDrawing
from executive.doors.view.seen import Seen, refused_pair, refused_place
from executive.doors.view.viewer import DRAWN_EVERY_S, look_from_the_side, prepare
from executive.doors.view.world_drawing import WorldDrawing, drawn
from kinematics.model.robot_model import RobotModel
from robots.clock import WallClock
from robots.models.description import load_description

PACES = {"0.1 x": 0.1, "0.25 x": 0.25, "0.5 x": 0.5, "1 x": 1.0, "2 x": 2.0, "5 x": 5.0, "10 x": 10.0}
_USUAL_PACE = "1 x"
_STEP_S = 0.01
_NUDGE_S = 0.1


def seen_at(recording: Recording, t_s: float) -> Seen:
    """What the page tells in words of one moment of a run."""
    moment = recording.moment(t_s)
    ended = recording.newest(t_s, ("TaskAccepted", "TaskEnded")) or {"event": ""}
    failed = recording.newest(t_s, ("TaskAccepted", "TaskEnded", "LeafFailed")) or {}
    stop = recording.newest(t_s, ("EmergencyStopped", "EmergencyReset")) or {"event": ""}
    state = recording.newest(t_s, ("LifecycleChanged",)) or {}
    is_done = ended["event"] == "TaskEnded"
    return Seen(
        robot=recording.robot,
        scene=recording.scene,
        t_s=moment.t_s,
        state=str(state.get("after", "")),
        emergency=str(stop.get("reason", "")) if stop["event"] == "EmergencyStopped" else "",
        task=str(ended.get("text", "")) if ended["event"] == "TaskAccepted" else None,
        nodes=moment.nodes,
        log=recording.log_until(t_s),
        failure=failed.get("failure"),
        evidence=ended.get("evidence") if is_done else None,
    )


class Timeline:
    """Shows one run until it is told to end; everybody who looks sees the same moment.

    Args:
        server: Of the page.
        recording: The run.
        ended: Asked in between.
    """

    def __init__(self, server: PageServer, recording: Recording, ended: Callable[[], bool]) -> None:
        self._recording, self._ended, self._wall = recording, ended, WallClock()
        self._page = page = server.viser
        self._model = RobotModel(load_description(recording.robot))
        self.t_s, self._playing, self._shown_s = 0.0, False, -1.0
        self._lock = threading.Lock()
        scene = page.scene
        prepare(scene)
        self._body = RobotDrawing(scene, self._model.description)
        self._world = WorldDrawing(scene)
        self._balance = BalanceDrawing(scene, self._model, self._body)
        self._plan = PlanDrawing(scene, self._model.description)
        self._told: dict[str, str] = {}
        self._add_panels()
        page.on_client_connect(look_from_the_side)

    def run(self) -> None:
        """Show, and play while that is asked for, until it ends."""
        pace_from_s = self._wall.now_s()
        while not self._ended():
            now_s = self._wall.now_s()
            if self._playing:
                self.go_to(self.t_s + PACES[self._pace.value] * (now_s - pace_from_s))
                if self.t_s >= self._recording.ends_s:
                    self._play(False)
            pace_from_s = now_s
            if self.t_s != self._shown_s:
                self._show(self.t_s)
            self._wall.sleep(max(now_s + DRAWN_EVERY_S - self._wall.now_s(), 0.0))

    def go_to(self, t_s: float) -> None:
        """Show another moment with the next drawing."""
        self.t_s = min(max(t_s, 0.0), self._recording.ends_s)

    def jump_to_failure(self) -> None:
        """Go to the next failure and hold there."""
        at_s = self._recording.next_failure_s(self.t_s)
        if at_s is not None:
            self._play(False)
            self.go_to(at_s)

    def _show(self, t_s: float) -> None:
        self._shown_s = t_s
        moment, seen = self._recording.moment(t_s), seen_at(self._recording, t_s)
        marked = refused_pair(seen.failure)
        with self._page.atomic():
            self._body.move(moment.report.sensed.readings.q, moment.report.sensed.q[:7])
            self._body.mark(marked)
            self._balance.show(balance_of(self._model, moment.report))
            self._plan.landings(moment.report.landings)
            self._plan.paths(moment.world.get("paths", ()))
            self._plan.refused_at(refused_place(seen.failure))
            things = [drawn(one, marked) for one in moment.world["things"]]
            self._world.show(things, {one.held: self._body.path_of(one.held) for one in things if one.held})
            self._tell("status", self._status, panels.status_panel(seen))
            self._tell("ending", self._ending, panels.ending_panel(seen))
            self._tell("tree", self._tree, panels.tree_panel(seen.nodes))
            self._tell("log", self._log, panels.log_panel(seen.log))
            if abs(self._slider.value - t_s) > _STEP_S:
                self._moving = True
                self._slider.value = t_s  # type: ignore[misc]
                self._moving = False

    def _tell(self, name: str, handle: viser.GuiHtmlHandle, content: str) -> None:
        if self._told.get(name) != content:
            self._told[name] = content
            handle.content = content

    _moving = False

    def _scrubbed(self, _event: Any) -> None:
        if not self._moving:
            self._play(False)
            self.go_to(float(self._slider.value))

    def _play(self, playing: bool) -> None:
        if playing and self.t_s >= self._recording.ends_s:
            self.go_to(0.0)
        self._playing = playing
        self._button.label = "hold" if playing else "play"

    def _add_panels(self) -> None:
        gui, recording = self._page.gui, self._recording
        gui.configure_theme(show_logo=False, show_share_button=False)
        gui.set_panel_label(recording.asked[:60])
        gui.main_panel.dock_right()
        ends_s = max(recording.ends_s, _STEP_S)
        self._slider = gui.add_slider("time, s", min=0.0, max=ends_s, step=_STEP_S, initial_value=0.0)
        self._button = gui.add_button("play", icon=viser.Icon.PLAYER_PLAY, hint="Alt+P")
        self._pace = gui.add_dropdown("pace", tuple(PACES), initial_value=_USUAL_PACE)
        jump = gui.add_button(
            "next failure", icon=viser.Icon.ALERT_TRIANGLE, disabled=not recording.failures_s, hint="Alt+F"
        )
        self._status, self._ending = gui.add_html(""), gui.add_html("")
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
        panel = gui.add_panel()
        with panel.add_tab("tree", viser.Icon.BINARY_TREE):
            self._tree = gui.add_html("")
        with panel.add_tab("log", viser.Icon.LIST):
            self._log = gui.add_html("")
        panel.dock_left()
        panel.set_width(380)

    def _toggle(self, _event: Any) -> None:
        self._play(not self._playing)

    def _nudge(self, step_s: float, _event: Any) -> None:
        self._play(False)
        self.go_to(self.t_s + step_s)

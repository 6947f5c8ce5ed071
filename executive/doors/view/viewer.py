"""The viewer: draws a served robot, as it knows and believes things to be, until it is told to end."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable
from pathlib import Path

import viser

from executive.doors.served_robot import ServedRobot
from executive.doors.view.access import Access
from executive.doors.view.balance_drawing import BalanceDrawing, balance_of
from executive.doors.view.browser import Browser
from executive.doors.view.map_drawing import MapDrawing
from executive.doors.view.observer import Observer
from executive.doors.view.page_server import PageServer
from executive.doors.view.plan_drawing import PlanDrawing
from executive.doors.view.robot_drawing import RobotDrawing
from executive.doors.view.seen import refused_pair, refused_place
from executive.doors.view.truth_drawing import TruthDrawing
from executive.doors.view.world_drawing import WorldDrawing, drawn
from executive.live.caller.caller import ask_at
from kinematics.model.robot_model import RobotModel
from robots.clock import WallClock
from robots.live.documents.robot_report import ReportLayout
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import GetStatus, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader
from robots.models.description import load_description
from robots.perception.rgbd.picture_slot import PictureSlotReader

DRAWN_EVERY_S = 1.0 / 30.0
_BALANCE_EVERY, _WORDS_EVERY, _WORLD_EVERY = 3, 1, 6
"""Drawings of the robot between two of these."""
_READY_WITHIN_S, _AGAIN_S = 120.0, 0.5
_ASIDE_M = 1.5


class Viewer:
    """Draws one served robot.

    Args:
        folder: Where it is served.
        server: Of the page.
        access: Knows the token.
        ended: Asked in between.

    Raises:
        LiveError: No robot is served there.
    """

    def __init__(self, folder: Path, server: PageServer, access: Access, ended: Callable[[], bool]) -> None:
        where, wall = RuntimeFolder(folder), WallClock()
        about = _told(where, wall, ended)
        self._wall, self._ended, self._access = wall, ended, access
        self._robot = ServedRobot(folder)
        self._model = model = RobotModel(load_description(str(about["robot"])))
        self._layout, self._slot = ReportLayout(model), StateSlotReader(where.state_slot)
        self._observer = Observer(folder, about)
        self._page = server.viser
        scene = self._page.scene
        prepare(scene)
        self._body = RobotDrawing(scene, model.description)
        self._world = WorldDrawing(scene)
        self._balance = BalanceDrawing(scene, model, self._body)
        self._plan, self._map = PlanDrawing(scene, model.description), MapDrawing(scene)
        evaluation = where.evaluation_socket
        self._truth = TruthDrawing(scene, evaluation) if evaluation.exists() else None
        self._pictures = PictureSlotReader(where.picture_slot) if about.get("perception") == "rgbd" else None
        self._slot_path = where.state_slot
        self._lock = threading.Lock()
        self._browsers: dict[int, Browser] = {}
        self._page.on_client_disconnect(self._gone)
        server.on_client(self._welcome)

    def run(self) -> None:
        """Draw until it ends."""
        drawings, due_s = 0, self._wall.now_s()
        while not self._ended():
            with self._page.atomic():
                self._draw(drawings)
            drawings += 1
            due_s = max(due_s + DRAWN_EVERY_S, self._wall.now_s())
            self._wall.sleep(max(due_s - self._wall.now_s(), 0.0))
        self._observer.close()

    def _draw(self, drawings: int) -> None:
        if self._pictures is not None:
            with contextlib.suppress(OSError):  # asked again with the next drawing
                self._pictures.want(bool(self._browsers))
        if not self._browsers:
            return  # a browser that comes is told everything anew
        row = self._slot.newest()
        if row is not None:
            report = self._layout.report(row)
            self._body.move(report.sensed.readings.q, report.sensed.q[:7])
            if drawings % _BALANCE_EVERY == 0:
                self._balance.show(balance_of(self._model, report))
                self._plan.landings(report.landings)
                if self._truth is not None:
                    self._truth.show(report.sensed.q[:7])
        seen = self._observer.seen()
        if drawings % _WORLD_EVERY == 0:
            marked = refused_pair(seen.failure)
            self._body.mark(marked)
            self._plan.refused_at(refused_place(seen.failure))
            world = self._observer.world()
            self._plan.paths(world.get("paths", ()))
            self._map.show(world.get("rooms", ()))
            things = [drawn(one, marked) for one in world["things"]]
            frames = {one.held: self._body.path_of(one.held) for one in things if one.held}
            self._world.show(things, frames)
            if self._pictures is not None and (shown := self._pictures.newest()) is not None:
                self._balance.look(shown.color)
        for browser in list(self._browsers.values()):
            browser.show(seen)

    def _welcome(self, client: viser.ClientHandle, may_command: bool) -> None:
        look_from_the_side(client, *self._place())
        switch = None if self._truth is None else self._want_truth
        browser = Browser(
            client,
            self._robot,
            self._access,
            self._observer.note,
            may_command,
            switch,
            lambda: look_from_the_side(client, *self._place()),
        )
        with self._lock:
            self._browsers = {**self._browsers, client.client_id: browser}

    def _place(self) -> tuple[float, float]:
        """Where the robot is now, whether or not it was drawn there."""
        row = StateSlotReader(self._slot_path).newest()
        if row is None:
            return 0.0, 0.0
        x_m, y_m = self._layout.report(row).sensed.q[:2].tolist()
        return float(x_m), float(y_m)

    def _want_truth(self, wanted: bool) -> None:
        if self._truth is not None:
            self._truth.wanted = wanted

    def _gone(self, client: viser.ClientHandle) -> None:
        with self._lock:
            self._browsers = {key: one for key, one in self._browsers.items() if key != client.client_id}


def prepare(scene: viser.SceneApi) -> None:
    """The floor and the light; nothing of it is fetched from anywhere."""
    scene.set_up_direction("+z")
    scene.configure_environment_map(hdri=None)
    scene.configure_default_lights(enabled=False)
    scene.add_light_hemisphere(
        "/light/sky", sky_color=(255, 255, 255), ground_color=(150, 140, 130), intensity=1.6
    )
    # shadows more than halve what a browser without a graphics card draws in a second
    scene.add_light_directional("/light/sun", intensity=1.8, position=(2.0, -3.0, 5.0), cast_shadow=False)
    scene.add_grid("/floor", 20.0, 20.0, cell_size=0.5, section_size=1.0)


def look_from_the_side(
    client: viser.ClientHandle,
    x_m: float = 0.0,
    y_m: float = 0.0,
    farther: float = 1.0,
    aside_m: float = _ASIDE_M,
) -> None:
    """Let a browser look at the robot from ahead and aside.

    Args:
        client: The browser.
        x_m, y_m: Where the robot is drawn.
        farther: Times as far as is usual.
        aside_m: How far aside that is at the usual distance.
    """
    client.camera.up_direction = (0.0, 0.0, 1.0)
    client.camera.position = (x_m + 0.35 + 1.55 * farther, y_m - aside_m * farther, 0.85 + 0.65 * farther)
    client.camera.look_at = (x_m + 0.35, y_m, 0.85)


def _told(where: RuntimeFolder, wall: WallClock, ended: Callable[[], bool]) -> dict[str, object]:
    """What the control process tells of itself, once it is there."""
    until_s = wall.now_s() + _READY_WITHIN_S
    while True:
        try:
            return ask_at(where.control_socket, write_control_message(GetStatus()))
        except LiveError:
            if ended() or wall.now_s() > until_s:
                raise
            wall.sleep(_AGAIN_S)

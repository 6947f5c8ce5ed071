"""One recorded run in the page: drawn as it was at a moment, alone or beside another one."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from typing import Any, cast

import numpy as np
import viser
from numpy.typing import NDArray
from PIL import Image as Pictures

from executive.doors.view.balance_drawing import BalanceDrawing, balance_of
from executive.doors.view.map_drawing import MapDrawing
from executive.doors.view.plan_drawing import PlanDrawing
from executive.doors.view.recording import Recording
from executive.doors.view.robot_drawing import RobotDrawing
from executive.doors.view.seen import Seen, refused_pair, refused_place
from executive.doors.view.world_drawing import WorldDrawing, drawn
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description


class Beside:
    """A part of the page's scene: whatever is added to it stands below one name, somewhere else.

    Args:
        scene: Of the page.
        name: Of the part.
        place_m: Where its origin is.
    """

    def __init__(self, scene: viser.SceneApi, name: str, place_m: tuple[float, float, float]) -> None:
        self._scene, self._name = scene, name
        scene.add_frame(name, show_axes=False, position=place_m)

    def __getattr__(self, method: str) -> Callable[..., Any]:
        add = getattr(self._scene, method)
        return lambda name, *values, **options: add(f"{self._name}{name}", *values, **options)


class ShownRun:
    """Draws one run.

    Args:
        scene: Of the page.
        recording: The run.
        part: Where it is drawn, if not in the middle.
    """

    def __init__(self, scene: viser.SceneApi, recording: Recording, part: Beside | None = None) -> None:
        self.recording = recording
        self._model = model = RobotModel(load_description(recording.robot))
        own = scene if part is None else cast(viser.SceneApi, part)
        self._body = RobotDrawing(own, model.description)
        self._world = WorldDrawing(own)
        self._balance = BalanceDrawing(own, model, self._body)
        self._plan, self._map = PlanDrawing(own, model.description), MapDrawing(own)
        self._picture: bytes | None = None

    def show(self, t_s: float) -> Seen:
        """Draw it as it was at a time; what there is to tell in words."""
        moment, seen = self.recording.moment(t_s), seen_at(self.recording, t_s)
        marked = refused_pair(seen.failure)
        self._body.move(moment.report.sensed.readings.q, moment.report.sensed.q[:7])
        self._body.mark(marked)
        self._balance.show(balance_of(self._model, moment.report))
        self._plan.landings(moment.report.landings)
        self._plan.paths(moment.world.get("paths", ()))
        self._map.show(moment.world.get("rooms", ()))
        self._plan.refused_at(refused_place(seen.failure))
        things = [drawn(one, marked) for one in moment.world["things"]]
        self._world.show(things, {one.held: self._body.path_of(one.held) for one in things if one.held})
        if (picture := self.recording.picture(t_s)) != self._picture:
            self._picture = picture
            self._balance.look(None if picture is None else _color(picture))
        return seen


def _color(picture: bytes) -> NDArray[np.uint8]:
    """A JPEG as an array, shape (height, width, 3)."""
    return np.asarray(Pictures.open(io.BytesIO(picture)).convert("RGB"))


def seen_at(recording: Recording, t_s: float) -> Seen:
    """What the page tells in words of one moment of a run."""
    moment = recording.moment(t_s)
    ended = recording.newest(t_s, ("TaskAccepted", "TaskEnded")) or {"event": ""}
    failed = recording.newest(t_s, ("TaskAccepted", "TaskEnded", "LeafFailed")) or {}
    stop = recording.newest(t_s, ("EmergencyStopped", "EmergencyReset")) or {"event": ""}
    asked = recording.newest(t_s, ("QuestionAsked", "InputTaken", "TaskAccepted", "TaskEnded")) or {
        "event": ""
    }
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
        question=None if asked["event"] != "QuestionAsked" else _question(asked),
        failure=failed.get("failure"),
        evidence=ended.get("evidence") if is_done else None,
    )


def _question(asked: Mapping[str, Any]) -> Mapping[str, Any]:
    """An event that asks, as the page has questions."""
    return {"text": asked["question"], "choices": asked.get("choices", ())}

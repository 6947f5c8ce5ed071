"""The motions that a commander has begun: by its numbers, whatever makes them on this side."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from kinematics.errors import KinematicsError
from kinematics.model.robot_description import Hand
from kinematics.motion.verdict import CheckedTrajectory
from robots.control.hands.jogging import JoggingStarted
from robots.control.hands.yielding import YieldingStarted
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.live.documents.jog_document import read_jog, read_jogging
from robots.live.documents.steering_document import read_steering
from robots.live.documents.yield_document import read_yield_order
from robots.live.wire.messages import write_message

MAX_MOTIONS = 32

GuardedMaker = Callable[[ControlLoop, Hand, float], MotionHandle]
GUARDED: Mapping[str, GuardedMaker] = {
    "open gripper": lambda loop, hand, opening_m: loop.grippers[hand].open(opening_m or None),
    "close gripper": lambda loop, hand, _opening_m: loop.grippers[hand].close(),
}
"""Guarded motions that are asked for by their name, a hand, and how far that opens: 0 is all the way."""


@dataclass(frozen=True, slots=True)
class _Begun:
    handle: MotionHandle
    yielding: YieldingStarted | None = None
    jogging: JoggingStarted | None = None
    walks: bool = False


class MotionDesk:
    """Begins, follows and ends motions of one control loop.

    Every one of them is made and judged on this side: trajectories were checked here, and of guarded
    motions nothing crosses the socket but what they shall do. What is refused has its reason.
    """

    def __init__(self, loop: ControlLoop) -> None:
        """Begin with none."""
        self._loop = loop
        self._begun: dict[int, _Begun] = {}

    @property
    def running(self) -> list[MotionHandle]:
        """Handles of those that run."""
        return [begun.handle for begun in self._begun.values() if not begun.handle.finished]

    def why_not(self, motion: int) -> str | None:
        """Why no motion of this number can be begun now, or None."""
        if self._loop.emergency is not None:
            return str(self._loop.emergency)
        if motion in self._begun or len(self._begun) >= MAX_MOTIONS:
            return f"motion {motion} is there already, or there are too many"
        return None

    def stream(self, motion: int, checked: CheckedTrajectory) -> None:
        """Begin a trajectory that this side's checker let pass."""
        self._begun[motion] = _Begun(self._loop.motion.start(checked))

    def guard(self, motion: int, name: str, hand: str, opening_m: float) -> str | None:
        """Begin a guarded motion by its name; returns why not, or None."""
        if name not in GUARDED:
            return f"no guarded motion {name!r}; there are {', '.join(GUARDED)}"
        if hand not in self._loop.grippers:
            return f"no gripper in the {hand!r} hand"
        known: Hand = "left" if hand == "left" else "right"
        self._begun[motion] = _Begun(GUARDED[name](self._loop, known, opening_m))
        return None

    def lead(self, motion: int, document: bytes) -> str | None:
        """Begin a yielding hand as a document describes it; returns why not, or None."""
        try:
            model = self._loop.model
            order = read_yield_order(document.decode("utf-8"), model, self._loop.motion.reference())
            started = self._loop.yielding.start(order)
        except Exception as wrong:
            return _told(wrong)
        self._begun[motion] = _Begun(started.handle, started)
        return None

    def jog(self, motion: int, document: bytes) -> str | None:
        """Begin to be jogged, in a scene that a document tells; returns why not, or None."""
        try:
            scene = read_jogging(document.decode("utf-8"), self._loop.model, self._loop.motion.reference())
            started = self._loop.jogging.start(scene)
        except Exception as wrong:
            return _told(wrong)
        self._begun[motion] = _Begun(started.handle, jogging=started)
        return None

    def walk(self, motion: int, document: bytes) -> str | None:
        """Set out as a document says; returns why not, or None."""
        settings = self._loop.model.description.walking
        if settings is None:
            return f"{self._loop.model.description.name} is not known to walk"
        try:
            handle = self._loop.walking.walk(read_steering(document.decode("utf-8"), settings), "walk")
        except Exception as wrong:
            return _told(wrong)
        self._begun[motion] = _Begun(handle, walks=True)
        return None

    def steer(self, motion: int, document: bytes) -> str | None:
        """Go somewhere else with a walk, or be jogged on; returns why not, or None."""
        begun, settings = self._begun.get(motion), self._loop.model.description.walking
        if begun is not None and begun.jogging is not None:
            return self._jog_on(begun.jogging, document)
        if begun is None or settings is None:
            return f"no walk {motion} is under way"
        try:
            steering = read_steering(document.decode("utf-8"), settings)
        except Exception as wrong:
            return _told(wrong)
        self._loop.walking.steer(begun.handle, steering)
        return None

    def _jog_on(self, jogging: JoggingStarted, document: bytes) -> str | None:
        try:
            jog = read_jog(document.decode("utf-8"), self._loop.model)
        except Exception as wrong:
            return _told(wrong)
        if jog is None:
            jogging.brake()
        else:
            jogging.steer(jog)
        return None

    def finish(self, motion: int) -> None:
        """Bring a walk, a yielding hand or jogging to its end, as if it had come there by itself."""
        begun = self._begun.get(motion)
        if begun is not None and begun.jogging is not None:
            begun.jogging.finish()
        elif begun is not None and begun.yielding is not None:
            begun.yielding.finish()
        elif begun is not None and begun.walks:
            self._loop.walking.finish(begun.handle)

    def cancel(self, motion: int, reason: str) -> None:
        """Brake a motion and hold; a walk stops within its last steps."""
        begun = self._begun.get(motion)
        if begun is not None and begun.walks:
            self._loop.walking.cancel(begun.handle, reason)
        elif begun is not None:
            self._loop.motion.cancel(begun.handle, reason)

    def cancel_all(self, reason: str) -> None:
        """The same with every one."""
        for motion in self._begun:
            self.cancel(motion, reason)

    def forget(self) -> None:
        """Whose motions they were has gone."""
        self._begun.clear()

    def told(self, all_of_them: bool) -> list[bytes]:
        """Messages on what became of them; those that have ended are told once more, and forgotten.

        Args:
            all_of_them: Whether to tell of those that run, too.
        """
        messages: list[bytes] = []
        for number, begun in list(self._begun.items()):
            handle = begun.handle
            if handle.finished:
                del self._begun[number]
            elif not all_of_them:
                continue
            if begun.yielding is not None:
                messages.append(_felt(number, begun.yielding))
            if begun.jogging is not None:
                report = begun.jogging.report
                told = {"held_back": report.held_back, "moving": report.moving}
                messages.append(write_message("jogged", motion=number, **told))
            messages.append(
                motion_message(
                    number, handle.status, handle.progress, handle.reason, met_something=handle.met_something
                )
            )
        return messages


def motion_message(
    number: int, status: MotionStatus, progress: float, reason: str, *, met_something: bool = False
) -> bytes:
    """The payload that tells where a motion stands."""
    return write_message(
        "motion",
        motion=number,
        status=status.value,
        progress=progress,
        reason=reason,
        met_something=met_something,
    )


def _felt(number: int, motion: YieldingStarted) -> bytes:
    report = motion.report
    return write_message(
        "felt",
        motion=number,
        outcome=report.outcome,
        s=report.s,
        peak_force_n=report.peak_force_n,
        peak_pull_n=report.peak_pull_n,
        bias=report.bias.tolist(),
    )


def _told(wrong: Exception) -> str:
    """What a document that cannot be carried out is refused with; none of them may end this process."""
    if isinstance(wrong, KinematicsError):
        return str(wrong)
    return f"the document makes no motion ({type(wrong).__name__}: {wrong})"[:2000]

"""Asks a model's server through a process of its own, which is ended when it takes too long."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from types import TracebackType
from typing import Any

from executive.front.front_model import Waiting
from executive.front.model_settings import ModelSettings
from executive.front.proposal import ModelFailure, ModelFailureKind
from robots.clock import WallClock
from robots.live.wire.child_process import ChildProcess
from robots.live.wire.errors import LiveError

_MODULE = "executive.doors.model.model_process"
_STARTS_WITHIN_S = 30.0
"""Wall time that the process may take to load, beyond what its first answer may take."""
_BEYOND_S = 2.0
"""Wall time after which a process is ended that should have told by then that its time is over."""


class ModelAsker:
    """Asks one model's server; as a context it ends the process that does so.

    Args:
        settings: Where it is.
    """

    def __init__(self, settings: ModelSettings) -> None:
        self._settings, self._wall = settings, WallClock()
        self._child: ChildProcess | None = None
        self._is_new = True

    def __enter__(self) -> ModelAsker:
        """Nothing is asked yet."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End the process."""
        self.close()

    def close(self) -> None:
        """End the process, if there is one; the next question starts another."""
        if self._child is not None:
            self._child.close()
            self._child, self._is_new = None, True

    def ask(self, messages: Sequence[Mapping[str, str]], waiting: Waiting) -> str | ModelFailure:
        """The text of the model's answer, or why there is none."""
        if self._child is None:
            self._child = ChildProcess(_MODULE, [self._settings.name])
        allowed_s = self._settings.timeout_s + (_STARTS_WITHIN_S if self._is_new else _BEYOND_S)
        until_s = self._wall.now_s() + allowed_s
        answer: Future[Any] = self._child.ask([dict(one) for one in messages])
        while not answer.done():
            if waiting():
                self.close()
                return ModelFailure.of(ModelFailureKind.CANCELLED)
            if self._wall.now_s() > until_s:
                self.close()
                told = f"{self._settings.timeout_s:g} s were allowed"
                return ModelFailure.of(ModelFailureKind.TIMEOUT, told)
        self._is_new = False
        try:
            found: str | ModelFailure = answer.result()
        except LiveError as gone:
            self.close()
            return ModelFailure.of(ModelFailureKind.UNREACHABLE, str(gone))
        return found

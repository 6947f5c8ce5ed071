"""Branches of a run: at an instant the process is doubled, and the copy goes another way.

A run is deterministic, so that a branch is what would have happened had the run been stopped there;
and the way to that instant is simulated once for all branches of a run.
"""

from __future__ import annotations

import os
import pickle
import traceback
from typing import Generic, NoReturn, TypeVar

Result = TypeVar("Result")


class Branches(Generic[Result]):
    """The branches of one run.

    Attributes:
        in_copy: Whether this process is a branch.
        results: What the branches delivered; a traceback for one that broke, None for one that died.
    """

    def __init__(self) -> None:
        self.in_copy = False
        self.results: list[Result | str | None] = []
        self._write = -1

    def split(self) -> bool:
        """Double this process: True in the copy; False in the original, once the copy has delivered."""
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(read)
            self.in_copy, self._write = True, write
            return True
        os.close(write)
        with os.fdopen(read, "rb") as answer:
            told = answer.read()
        _, status = os.waitpid(child, 0)
        self.results.append(pickle.loads(told) if status == 0 and told else None)
        return False

    def deliver(self, result: Result) -> NoReturn:
        """End the copy with what it found."""
        self._end(result)

    def break_off(self) -> None:
        """Called when something was raised: end the copy with the traceback; nothing in the original."""
        if self.in_copy:
            self._end(traceback.format_exc())

    def _end(self, result: Result | str) -> NoReturn:
        try:
            with os.fdopen(self._write, "wb") as out:
                pickle.dump(result, out)
        finally:
            os._exit(0)

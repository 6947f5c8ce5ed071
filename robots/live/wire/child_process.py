"""A process of its own that answers questions one after the other, and ends when its parent does.

Question and answer are Python values over a private pair of sockets that only the two hold. The child is
a fresh interpreter: it has none of the parent's connections, so that the end of the parent is the end of
the pair, however the parent ended.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from multiprocessing.connection import Connection, Pipe
from typing import Any

from robots.live.wire.errors import LiveError


class ChildDiedError(LiveError):
    """The child process ended before it answered."""


class ChildProcess:
    """A child process that answers questions, as its parent sees it.

    Args:
        module: What the child runs, as ``python -m`` does; it calls ``serve_parent``.
        arguments: Further arguments of the child.
        niceness: How far the child steps back behind other processes.
    """

    def __init__(self, module: str, arguments: Sequence[str] = (), niceness: int = 0) -> None:
        self._command = [sys.executable, "-m", module, *arguments]
        self._niceness = niceness
        self._pool = ThreadPoolExecutor(1, thread_name_prefix=module)
        self._process: subprocess.Popen[bytes] | None = None
        self._pipe: Connection[Any, Any] | None = None
        self._start()

    def ask(self, question: object) -> Future[Any]:
        """Ask; the answer comes later, and a question that the child raised on raises the same.

        A child that died is started anew with the next question.
        """
        return self._pool.submit(self._ask, question)

    def close(self) -> None:
        """End the child; what it has not answered is not answered any more."""
        self._end()
        self._pool.shutdown(wait=False, cancel_futures=True)

    def _start(self) -> None:
        ours, theirs = Pipe()
        self._process = subprocess.Popen(
            [*self._command, str(theirs.fileno())],
            pass_fds=[theirs.fileno()],
            stdin=subprocess.DEVNULL,
            start_new_session=True,
        )
        theirs.close()
        if self._niceness:
            os.setpriority(os.PRIO_PROCESS, self._process.pid, self._niceness)
        self._pipe = ours

    def _ask(self, question: object) -> Any:
        if self._pipe is None:
            self._start()
        pipe = self._pipe
        try:
            if pipe is None:
                raise EOFError
            pipe.send(question)
            failed, answer = pipe.recv()
        except (EOFError, OSError):
            self._end()
            raise ChildDiedError(f"the process {self._command[2]} ended before it answered") from None
        if failed:
            raise answer
        return answer

    def _end(self) -> None:
        pipe, self._pipe = self._pipe, None
        process, self._process = self._process, None
        if pipe is not None:
            pipe.close()
        if process is not None:
            process.kill()
            process.wait()


def serve_parent(descriptor: int, answer: Callable[[Any], Any]) -> None:
    """The child's side: answer until the parent ends."""
    pipe: Connection[Any, Any] = Connection(descriptor)
    while True:
        try:
            question = pipe.recv()
        except (EOFError, OSError):
            return
        try:
            reply = (False, answer(question))
        except Exception as raised:
            reply = (True, raised)
        try:
            pipe.send(reply)
        except OSError:
            return
        except Exception as unsendable:
            pipe.send((True, LiveError(f"an answer that cannot be sent: {unsendable!r}")))

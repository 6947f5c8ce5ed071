"""A peer at work in its own environment, asked one question at a time.

Being asked problem by problem, several peers can take turns, so that the machine's ups and downs fall
on all alike. They report their own processor time; what passes between the processes is not counted.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Any

from tools.benchmark.peers.environments import PeerEnvironment

_RUNNERS = Path(__file__).parent / "runners"
_ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")


class PeerError(RuntimeError):
    """A peer raised, or ended before it answered; the message holds what it said."""


class PeerProcess:
    """One script running in a peer's environment; use it as a context.

    Args:
        environment: Where it runs.
        runner: Name of the script in ``peers/runners``, without its ending.
    """

    def __init__(self, environment: PeerEnvironment, runner: str) -> None:
        self.environment = environment
        script = _RUNNERS / f"{runner}.py"
        # a file and not a pipe: a peer that prints much must never wait for a reader
        self._files = contextlib.ExitStack()
        self._said = self._files.enter_context(tempfile.TemporaryFile("w+", encoding="utf-8"))
        self._process = subprocess.Popen(
            [str(environment.python), str(script)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._said,
            text=True,
            env={**os.environ, **_ONE_THREAD, "PYTHONPATH": ""},
        )

    def __enter__(self) -> PeerProcess:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._process.communicate()
        self._files.close()

    def ask(self, question: str, **values: Any) -> Mapping[str, Any]:
        """Put a question and wait for its answer.

        Raises:
            PeerError: The peer failed.
        """
        stdin, stdout = self._process.stdin, self._process.stdout
        assert stdin is not None
        assert stdout is not None
        try:
            stdin.write(json.dumps({"ask": question, **values}) + "\n")
            stdin.flush()
            line = stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            self._said.seek(0)
            raise PeerError(f"{self.environment.name} ended: {self._said.read()[-2000:]}")
        answer: dict[str, Any] = json.loads(line)
        if "error" in answer:
            raise PeerError(f"{self.environment.name}: {answer['error']}")
        return answer

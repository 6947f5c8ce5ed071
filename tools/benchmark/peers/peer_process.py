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
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import IO, Any

from tools.benchmark.peers.environments import PeerEnvironment

_RUNNERS = Path(__file__).parent / "runners"
_ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
# How much of what a peer said before it died is told.
_LAST_WORDS = 2000


class PeerError(RuntimeError):
    """A peer raised, or ended before it answered; the message holds what it said."""


class PeerProcess:
    """One script running in a peer's environment; ``peer_process`` starts it.

    Attributes:
        environment: Where it runs.
    """

    def __init__(self, environment: PeerEnvironment, process: subprocess.Popen[str], said: IO[str]) -> None:
        self.environment = environment
        self._process, self._said = process, said

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
            raise PeerError(f"{self.environment.name} ended: {self._said.read()[-_LAST_WORDS:]}")
        answer: dict[str, Any] = json.loads(line)
        if "error" in answer:
            raise PeerError(f"{self.environment.name}: {answer['error']}")
        return answer


@contextlib.contextmanager
def peer_process(environment: PeerEnvironment, runner: str) -> Iterator[PeerProcess]:
    """Run a script in a peer's environment for as long as the context lasts.

    Args:
        environment: Where it runs.
        runner: Name of the script in ``peers/runners``, without its ending.
    """
    command = [str(environment.python), str(_RUNNERS / f"{runner}.py")]
    surroundings = {**os.environ, **_ONE_THREAD, "PYTHONPATH": ""}
    # errors go to a file and not to a pipe: a peer that prints much must never wait for a reader
    with (
        tempfile.TemporaryFile("w+", encoding="utf-8") as said,
        subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=said, text=True, env=surroundings
        ) as process,
    ):
        yield PeerProcess(environment, process, said)

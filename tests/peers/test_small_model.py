"""A real small model behind a real server: it takes the request, and what it answers is judged."""

import subprocess
from contextlib import closing
from pathlib import Path

import pytest

from executive.doors.model.client import ModelClient
from executive.front.front_model import FrontModel
from executive.front.model_settings import ModelSettings
from executive.front.proposal import Asked, Context, ModelFailure, ModelFailureKind, Proposed
from tools.benchmark.peers.environments import MODEL_NAMES, PeerEnvironment, default_cache

PROGRAM = Path(__file__).parent / "programs" / "serve_smollm2.py"
TOKENS = 48
"""Of an answer: one step has some forty; what is longer is cut off, which is a typed failure as well."""
ANSWERS_WITHIN_S = 150.0
"""Bounds the test where a busy machine has not answered by then; that, too, is a typed failure."""
JUDGED = {
    ModelFailureKind.MALFORMED,
    ModelFailureKind.NOT_VALID,
    ModelFailureKind.OVERSIZED,
    ModelFailureKind.TIMEOUT,
}
"""How a model may fail that is there."""


@pytest.fixture(scope="module")
def address():
    """Where the model is served; skipped, and named, where the registry does not give it."""
    environment = PeerEnvironment(*MODEL_NAMES, default_cache())
    if not environment.is_ready:
        pytest.skip(
            f"{environment.name} is not installed: python -m tools.benchmark.peers {environment.name}"
        )
    command = [str(environment.python), str(PROGRAM)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as server:
        yield server.stdout.readline().strip()
        server.kill()


class Direct:
    """Asks a client in this process."""

    def __init__(self, client):
        self._client = client

    def ask(self, messages, _waiting):
        return self._client.ask(messages)

    def close(self):
        """Nothing to let go of."""


@pytest.fixture
def client(address, monkeypatch):
    """A client of the model that asks for short answers; settings and client."""
    monkeypatch.setattr("executive.doors.model.client.MOST_TOKENS", TOKENS)
    settings = ModelSettings("smollm2", f"{address}/v1", "smollm2", timeout_s=ANSWERS_WITHIN_S)
    with closing(ModelClient(settings, "")) as asked:
        yield settings, asked


@pytest.mark.timeout(300)
@pytest.mark.requirement("L10")
def test_a_real_model_takes_the_request_and_answers(client):
    answer = client[1].ask_about([{"type": "text", "text": "Say hello."}])

    assert isinstance(answer, str) or answer.kind in {ModelFailureKind.OVERSIZED, ModelFailureKind.TIMEOUT}


@pytest.mark.timeout(300)
@pytest.mark.requirement("L10")
def test_what_a_real_model_answers_is_judged_and_never_taken_unasked(client):
    settings, asked = client
    front = FrontModel(settings, Direct(asked), reads_back=True)

    found = front.understand("my hands are full, up with the red cup, mate", Context(), lambda: False)

    if isinstance(found, ModelFailure):
        assert found.kind in JUDGED, found.reason
    else:
        assert isinstance(found, Asked | Proposed)
        assert not isinstance(found, Proposed) or found.read_back.startswith("I understood: ")

"""One request to a server: its answer is read to a bound, and every other ending is a typed failure."""

import time

import pytest

from executive.doors.model.client import MOST_BYTES, ModelClient
from executive.front.model_settings import ModelSettings
from executive.front.proposal import ModelFailureKind
from tools.evaluate.front.scripted_server import Answer, ScriptedServer, saying, steps

MESSAGES = [{"role": "user", "content": "{}"}]


def asked(*answers, key="", **settings):
    """What a client makes of a server's first answer, and the server."""
    with ScriptedServer(*answers, sleep=time.sleep) as server:
        client = ModelClient(ModelSettings("house", server.url, "m", **settings), key)
        return client.ask(MESSAGES), server


def test_the_text_of_an_answer_is_what_comes_back():
    answer, _ = asked(saying("hello"))

    assert answer == "hello"


def test_the_request_asks_for_the_strict_form_and_offers_no_tool():
    _, server = asked(saying("hello"))
    (request,) = server.requests

    assert request["model"] == "m"
    assert request["response_format"]["json_schema"]["strict"] is True
    assert "tools" not in request


def test_nothing_is_told_of_this_machine():
    _, server = asked(saying("hello"))

    assert not [
        name for name in server.headers if name.startswith("x-stainless-") and name[12:] in ("os", "arch")
    ]
    assert "authorization" not in server.headers


def test_a_key_is_sent_as_one():
    _, server = asked(saying("hello"), key="secret")

    assert server.headers["authorization"] == "Bearer secret"


@pytest.mark.requirement("L10")
@pytest.mark.parametrize(
    ("answer", "kind"),
    [
        (Answer((b"{}",), 429), ModelFailureKind.RATE_LIMITED),
        (Answer((b"{}",), 401), ModelFailureKind.DENIED),
        (Answer((b"{}",), 403), ModelFailureKind.DENIED),
        (Answer((b"{}",), 404), ModelFailureKind.SERVER_ERROR),
        (Answer((b"{}",), 500), ModelFailureKind.SERVER_ERROR),
        (Answer((b"",), 302, {"Location": "http://127.0.0.1:9/"}), ModelFailureKind.SERVER_ERROR),
        (Answer((b"<html>",)), ModelFailureKind.MALFORMED),
        (Answer((b"\xff",)), ModelFailureKind.MALFORMED),
        (Answer((b'{"choices": []}',)), ModelFailureKind.MALFORMED),
        (Answer((b'{"choices": {"a": 1}}',)), ModelFailureKind.MALFORMED),
        (Answer((b'{"choices": [{"message": {"content": 5}}]}',)), ModelFailureKind.MALFORMED),
        (Answer((b"\x1f\x8b",), headers={"Content-Encoding": "gzip"}), ModelFailureKind.MALFORMED),
        (Answer((b"x" * (MOST_BYTES + 1),)), ModelFailureKind.OVERSIZED),
        (saying("{", finish_reason="length"), ModelFailureKind.OVERSIZED),
        (saying(None, tool_calls=[{"id": "1"}]), ModelFailureKind.MALFORMED),
        (saying(None, refusal="no"), ModelFailureKind.DECLINED),
        (saying("", finish_reason="content_filter"), ModelFailureKind.DECLINED),
        (saying(""), ModelFailureKind.MALFORMED),
    ],
)
def test_another_ending_is_a_typed_failure(answer, kind):
    failure, server = asked(answer)

    assert failure.kind is kind
    assert failure.reason.startswith(kind.value)
    assert len(server.requests) == 1


def test_a_late_answer_is_a_timeout():
    failure, _ = asked(Answer(steps("go home").body, pause_s=2.0), timeout_s=0.3)

    assert failure.kind is ModelFailureKind.TIMEOUT


def test_an_answer_that_trickles_is_a_timeout():
    body = steps("go home").body[0]
    answer = Answer(tuple(body[i : i + 4] for i in range(0, len(body), 4)), pause_s=0.1)

    failure, _ = asked(answer, timeout_s=0.5)

    assert failure.kind is ModelFailureKind.TIMEOUT


def test_a_server_that_is_not_there_is_told_with_its_address():
    failure = ModelClient(ModelSettings("house", "http://127.0.0.1:9/v1", "m"), "").ask(MESSAGES)

    assert failure.kind is ModelFailureKind.UNREACHABLE
    assert "http://127.0.0.1:9/v1" in failure.reason


def test_no_proxy_of_the_environment_is_heeded(monkeypatch):
    with ScriptedServer(saying("hello"), sleep=time.sleep) as proxy:
        for name in ("HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy"):
            monkeypatch.setenv(name, proxy.url.removesuffix("/v1"))
        answer = ModelClient(ModelSettings("house", "http://127.0.0.2:9/v1", "m"), "").ask(MESSAGES)

    assert not proxy.requests
    assert answer.kind is ModelFailureKind.UNREACHABLE

"""Who may see the page, and who may command by it."""

import pytest

from executive.doors.view.access import Access, new_token

PORT = 8095
TOKEN = "the-printed-one"
HOST = {"Host": f"127.0.0.1:{PORT}"}


@pytest.fixture
def access():
    return Access(TOKEN)


def cookie_of(answer):
    return answer.headers["Set-Cookie"].split(";")[0]


def test_reading_needs_no_token_and_commands_nothing(access):
    answer = access.judge("/", HOST, PORT)

    assert (answer.passes, answer.commands) == (True, False)


def test_the_token_in_the_address_becomes_a_cookie_that_commands(access):
    first = access.judge(f"/?token={TOKEN}", HOST, PORT)
    then = access.judge("/", {**HOST, "Cookie": cookie_of(first)}, PORT)

    assert (first.status, first.headers["Location"]) == (303, "/")
    assert {"HttpOnly", "SameSite=Strict"} <= set(first.headers["Set-Cookie"].split("; "))
    assert (then.passes, then.commands) == (True, True)


@pytest.mark.parametrize("said", ["", "another", TOKEN[:-1], "é"])
def test_another_token_is_refused(access, said):
    assert access.judge(f"/?token={said}x", HOST, PORT).status == 403
    assert not access.judge("/", {**HOST, "Cookie": f"executive-view-{PORT}={said}"}, PORT).commands


def test_a_cookie_of_another_port_does_not_command(access):
    assert not access.judge("/", {**HOST, "Cookie": f"executive-view-1={TOKEN}"}, PORT).commands


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example",
        "http://127.0.0.1:9",
        f"https://127.0.0.1:{PORT}",
        "null",
        f"http://127.0.0.1:{PORT}.evil.example",
        f"http://localhost:{PORT}",
    ],
)
def test_another_origin_is_refused_even_with_the_token(access, origin):
    kept = f"executive-view-{PORT}={TOKEN}"

    assert access.judge("/", {**HOST, "Origin": origin, "Cookie": kept}, PORT).status == 403


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost"])
def test_the_pages_own_origin_passes_by_both_names_of_this_machine(access, name):
    own = {"host": f"{name}:{PORT}", "origin": f"http://{name}:{PORT}"}

    assert access.judge("/", own, PORT).passes


@pytest.mark.parametrize("host", ["", "evil.example", f"evil.example:{PORT}", "127.0.0.1", "127.0.0.1:9"])
def test_a_name_that_somebody_has_pointed_here_is_refused(access, host):
    assert access.judge("/", {"Host": host}, PORT).status == 403


def test_tokens_differ():
    assert len({new_token() for _ in range(20)}) == 20

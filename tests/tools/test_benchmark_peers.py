"""Peers run in environments of their own, whose versions are locked, and answer line by line."""

import re
import sys
from pathlib import Path

import pytest

from tools.benchmark.peers import peer_process as module
from tools.benchmark.peers.environments import CACHE_VARIABLE, NAMES, PeerEnvironment, default_cache
from tools.benchmark.peers.peer_process import PeerError, peer_process

RUNNER = """
import sys
from pathlib import Path
sys.path.insert(0, {folder!r})
from line_protocol import serve

def double(question):
    print("chatter that is no answer")
    return {{"value": 2 * question["value"]}}

def die(question):
    sys.stderr.write("out of luck")
    sys.stderr.flush()
    raise SystemExit(3)

serve({{"double": double, "die": die}})
"""


class Here(PeerEnvironment):
    """This interpreter, as if it were a peer's."""

    @property
    def python(self):
        return Path(sys.executable)


@pytest.fixture
def peer(tmp_path, monkeypatch):
    folder = str(Path(module.__file__).parent / "runners")
    (tmp_path / "example.py").write_text(RUNNER.format(folder=folder))
    monkeypatch.setattr(module, "_RUNNERS", tmp_path)
    with peer_process(Here("roboplan", tmp_path), "example") as process:
        yield process


@pytest.mark.parametrize("name", NAMES)
def test_a_lock_pins_every_package_and_names_no_host(name):
    lines = PeerEnvironment(name, Path()).lock.read_text("utf-8").splitlines()

    assert all(re.fullmatch(r"[\w.-]+==[\w.]+", line) for line in lines)
    assert len(set(lines)) == len(lines)


@pytest.mark.parametrize("name", NAMES)
def test_the_first_line_of_a_lock_is_the_peer(name):
    assert name in PeerEnvironment(name, Path()).version


def test_an_environment_is_ready_only_when_it_was_made_from_the_present_lock(tmp_path):
    environment = PeerEnvironment("mink", tmp_path)
    assert not environment.is_ready

    stamp = tmp_path / "environments" / "mink" / "lock.sha256"
    stamp.parent.mkdir(parents=True)
    stamp.write_text("of an older lock")

    assert not environment.is_ready


def test_the_cache_is_where_the_variable_says(monkeypatch, tmp_path):
    monkeypatch.setenv(CACHE_VARIABLE, str(tmp_path))

    assert default_cache() == tmp_path


def test_the_cache_is_the_users_otherwise(monkeypatch, tmp_path):
    monkeypatch.delenv(CACHE_VARIABLE, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))

    assert default_cache().is_relative_to(tmp_path)


def test_a_peer_answers_and_what_it_prints_is_no_answer(peer):
    assert [peer.ask("double", value=value)["value"] for value in (2, 3)] == [4, 6]


def test_a_question_that_fails_is_an_error_and_the_next_is_answered(peer):
    with pytest.raises(PeerError, match="KeyError"):
        peer.ask("unheard of")

    assert peer.ask("double", value=5)["value"] == 10


def test_a_peer_that_ends_is_an_error_with_its_last_words(peer):
    with pytest.raises(PeerError, match="out of luck"):
        peer.ask("die")

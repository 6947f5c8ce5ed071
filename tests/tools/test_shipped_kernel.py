"""Compiled code goes to machines that have none, and to no other."""

import pytest

from tools.evaluate.harness import shipped_kernel
from tools.evaluate.harness.shipped_kernel import packed_kernel, unpack_kernel


@pytest.fixture
def machine(tmp_path, monkeypatch):
    """Answers a function that says which folder the machine has, and whether all is in it."""

    def become(name, complete):
        place = tmp_path / name
        place.mkdir(exist_ok=True)
        monkeypatch.setattr(shipped_kernel, "folder", lambda: place)
        monkeypatch.setattr(shipped_kernel, "is_complete", lambda: complete)
        return place

    return become


def test_what_is_compiled_here_is_there_as_it_was(machine):
    here = machine("here", complete=True)
    (here / "kinematics.kernel").mkdir()
    (here / "kinematics.kernel" / "judge.nbc").write_bytes(b"code")
    (here / "complete").write_bytes(b"all of it")
    packed = packed_kernel()

    there = machine("there", complete=False)
    unpack_kernel(packed)

    assert (there / "kinematics.kernel" / "judge.nbc").read_bytes() == b"code"
    assert (there / "complete").read_bytes() == b"all of it"
    assert sorted(path.name for path in there.parent.iterdir()) == ["here", "there"]


def test_a_machine_that_has_its_own_keeps_it(machine):
    (machine("here", complete=True) / "complete").write_bytes(b"other")
    packed = packed_kernel()

    there = machine("there", complete=True)
    unpack_kernel(packed)

    assert not list(there.iterdir())


def test_half_of_it_is_not_sent(machine):
    (machine("here", complete=False) / "judge.nbc").write_bytes(b"code")

    assert packed_kernel().size == 0

"""A sentence is read once: no text is written anew and read again to find out what it means or lacks."""

import pytest

from executive.language.text.lattice import Lattice
from executive.understanding.command_parser import parse


@pytest.mark.parametrize(
    "said",
    [
        "pick up the red cup and put it on the table",
        "pick up the red\ncup",
        "put the bowl",
        "wlak to the kichten",
        "go to the kitchen, no, the office",
        "bring me the red or the blue cup",
        "say hello and wave",
        "wave to Herta",
    ],
)
def test_a_sentence_is_read_once(said, monkeypatch):
    read = []
    begin = Lattice.__init__

    def counted(self, plain, *args):
        read.append(plain)
        begin(self, plain, *args)

    monkeypatch.setattr(Lattice, "__init__", counted)
    parse(said)

    assert len(read) == 1

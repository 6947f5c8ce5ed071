"""Live drawing, plain lines, nothing."""

import io

import pytest
from rich.console import Console

from executive.screens.display import LiveDisplay, NoDisplay, PlainDisplay
from executive.session.events import TaskAccepted
from trees.events import LeafFailed, NodeChanged
from trees.failures import Failure
from trees.snapshot import NodeSnapshot, TreeSnapshot


class Tree:
    status = "running"
    leaf_places = frozenset({"pick/detect"})

    def snapshot(self, t_s):
        leaf = NodeSnapshot("detect", "leaf", self.status, "3 of 8 frames")
        return TreeSnapshot(t_s, 1, NodeSnapshot("pick", "sequence", self.status, "", (leaf,)))


EVENTS = [
    TaskAccepted(0.2, "x", {"action": "pick", "object": {"color": "red", "kind": "cup"}, "from": "table"}),
    NodeChanged(0.2, "pick/detect", "running", ""),
    NodeChanged(0.2, "pick", "running", ""),
    LeafFailed(1.5, Failure.infeasible("nothing red in view", seen=0).at("pick/detect")),
]


def play(display):
    tree = Tree()
    display.tick(tree)
    for event in EVENTS:
        display.event(event)
    tree.status = "failure"
    display.tick(tree)
    display.close()


@pytest.mark.requirement("U1", "S9")
def test_plain_output_is_a_line_for_each_leaf_and_failure():
    stream = io.StringIO()

    play(PlainDisplay(stream))

    assert stream.getvalue() == (
        "[   0.20 s] accepted: pick up the red cup from the table\n"
        "[   0.20 s] EXECUTING: pick/detect\n"
        "[   1.50 s] failed: nothing red in view (seen 0) [INFEASIBLE at pick/detect]\n"
    )


def test_a_branch_that_bears_the_name_of_a_leaf_is_not_told():
    stream = io.StringIO()
    display = PlainDisplay(stream)
    display.tick(Tree())

    display.event(NodeChanged(0.2, "pick/look it over/detect", "running", ""))

    assert stream.getvalue() == ""


@pytest.mark.requirement("U1")
def test_the_live_drawing_fits_80_columns_and_needs_no_colour():
    stream = io.StringIO()
    console = Console(file=stream, force_terminal=True, width=80, height=24, no_color=True, color_system=None)

    play(LiveDisplay(console))

    text = stream.getvalue()
    assert "✗ pick" in text
    assert "  ✗ detect  3 of 8 frames" in text
    assert "failed: nothing red in view" in text


def test_markup_in_a_message_is_shown_as_it_is():
    stream = io.StringIO()
    display = LiveDisplay(Console(file=stream, force_terminal=True, width=80, height=24, color_system=None))

    display.note("[red]not red[/red]")

    assert "[red]not red[/red]" in stream.getvalue()


def test_quiet_shows_nothing(capsys):
    play(NoDisplay())

    captured = capsys.readouterr()
    assert captured.out == captured.err == ""


def test_plain_output_survives_a_terminal_without_unicode():
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding="ascii")

    PlainDisplay(stream).note("└─ because")

    assert raw.getvalue() == b"?? because\n"

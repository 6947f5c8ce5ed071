"""The tree as text: a snapshot of what people see."""

from executive.screens.tree_lines import tree_lines
from trees.snapshot import NodeSnapshot, TreeSnapshot


def node(name, kind="leaf", status="idle", message="", *children):
    return NodeSnapshot(name, kind, status, message, children)


PICK = TreeSnapshot(
    3.2,
    160,
    node(
        "pick", "sequence", "running", "",
        node("search", "selector", "success", "",
             node("look", status="success", message="arrived"),
             node("detect", status="success", message="red cup at 0.52 m")),
        node("attempt", "sequence", "running", "attempt 2 of 4",
             node("plan pick", status="failure", message="no grasp: 12 in collision"),
             node("stream reach", status="running", message="42 %")),
        node("give up", "sequence", "idle", "", node("go home")),
    ),
)  # fmt: skip


def shown(**options):
    return "\n".join(line.text for line in tree_lines(PICK, **options))


def test_every_node_is_a_line_with_its_status_and_newest_message():
    assert (
        shown()
        == """\
▶ pick
  ✓ search
    ✓ look  arrived
    ✓ detect  red cup at 0.52 m
  ▶ attempt  attempt 2 of 4
    ✗ plan pick  no grasp: 12 in collision
    ▶ stream reach  42 %
  · give up
    · go home"""
    )


def test_a_terminal_without_unicode_gets_ascii():
    text = shown(unicode=False)

    assert text.isascii()
    assert "    x plan pick  no grasp: 12 in collision" in text
    assert "    > stream reach  42 %" in text


def test_a_low_terminal_folds_what_has_not_begun_and_then_what_is_done():
    assert shown(height=8).splitlines()[-1] == "  · give up"
    assert "detect" in shown(height=8)
    assert (
        shown(height=6)
        == """\
▶ pick
  ✓ search
  ▶ attempt  attempt 2 of 4
    ✗ plan pick  no grasp: 12 in collision
    ▶ stream reach  42 %
  · give up"""
    )


def test_the_running_leaf_stays_in_sight_however_low_the_terminal():
    lines = shown(height=3).splitlines()

    assert len(lines) == 3
    assert "    ▶ stream reach  42 %" in lines


def test_no_line_is_wider_than_the_terminal():
    lines = shown(width=20).splitlines()

    assert max(map(len, lines)) <= 20
    assert any(line.endswith("…") for line in lines)


def test_control_characters_in_a_message_do_not_reach_the_terminal():
    tree = TreeSnapshot(0.0, 1, node("x", status="failure", message="a\x1b[31mb\nc"))

    (line,) = tree_lines(tree)

    assert line.text == "✗ x  a [31mb c"

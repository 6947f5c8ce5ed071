"""Pictures of trees: every node is there, inside the picture, and no two boxes lie on each other."""

from itertools import pairwise
from xml.etree import ElementTree

from executive.checks.tree_preview import preview
from executive.screens.tree_drawing import as_svg
from executive.understanding.command_parser import parse

SVG = "{http://www.w3.org/2000/svg}"


def drawn(sentence):
    snapshot = preview(parse(sentence).commands[0])
    return snapshot, ElementTree.fromstring(as_svg(snapshot))


def names(node):
    yield node.name
    for child in node.children:
        yield from names(child)


def test_every_node_is_drawn_with_its_name_in_the_order_of_the_tree():
    snapshot, picture = drawn("pick up the red cup")
    words = [text.text.lstrip("→?⇉◇ ") for text in picture.iter(f"{SVG}text")]

    assert words == list(names(snapshot.root))


def test_boxes_are_inside_the_picture_and_do_not_overlap():
    _, picture = drawn("put the red cup on the table")
    left, top, width, height = (float(value) for value in picture.get("viewBox").split())
    boxes = [
        tuple(float(box.get(key)) for key in ("x", "y", "width", "height"))
        for box in picture.iter(f"{SVG}rect")
    ]

    assert all(
        left <= x and x + w <= left + width and top <= y and y + h <= top + height for x, y, w, h in boxes
    )
    rows = sorted(y for _, y, _, _ in boxes)
    assert all(after - before >= boxes[0][3] for before, after in pairwise(rows))

"""Colour names of pieces of a picture."""

import numpy as np
import pytest

from robots.perception.rgbd.colors import Light, features, name_colors, piece_colors

LIGHT = Light(np.ones(3), 200.0, True)
WHITE, GREY = (190, 190, 190), (100, 100, 100)
IN_SHADE = 0.45
SIZE = 60


def told(level, upright):
    """What a piece is called whose upper half faces up, the lower to the side, each of a colour or unseen."""
    color = np.zeros((SIZE, SIZE, 3), np.uint8)
    up = np.full((SIZE // 2, SIZE // 2), np.nan, np.float32)
    for rows, shown, facing in ((slice(0, 30), level, 1.0), (slice(30, 60), upright, 0.0)):
        color[rows] = shown if shown is not None else (110, 110, 110)
        if shown is not None:
            up[rows.start // 2 : rows.stop // 2] = facing
    pieces = piece_colors(color, np.ones((SIZE, SIZE), np.int32), 1, up)
    names, shares, _ = name_colors(features(pieces, LIGHT))
    return names[0], float(shares[0])


def shaded(color):
    return tuple(int(IN_SHADE * part) for part in color)


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("color", "name"), [(WHITE, "white"), (GREY, "grey")])
def test_what_faces_up_tells_white_from_grey_whatever_shade_the_sides_are_in(color, name):
    assert told(color, shaded(color))[0] == name


@pytest.mark.requirement("P2")
def test_where_nothing_that_faces_a_known_way_is_seen_white_and_grey_stay_open():
    name, share = told(None, None)

    assert name in ("white", "grey", "black")
    assert share < 0.6

"""What a camera tells of furniture that the map has: its solids, with all that the map calls it."""

import pytest

from robots.perception.rgbd.piece import pieces_of
from robots.scenes.scene_description import Furniture


def test_the_solids_of_a_piece_are_told_by_its_names():
    shelf = Furniture(
        "bookcase shelf", "shelf", (0.34, 1.0, 1.2), (1.0, 0.0), names=("rack",), categories=("storage",)
    )

    plain, raised = pieces_of(shelf, 0.9), pieces_of(shelf, 0.8, frozenset({"place"}), raised_m=0.02)

    assert {(one.name, one.names, one.categories) for one in plain} == {
        ("bookcase shelf", ("rack",), ("storage",))
    }
    assert all(one.assumed == frozenset({"place"}) and one.confidence == 0.8 for one in raised)
    for low, high in zip(plain, raised, strict=True):
        assert (high.odom_T_solid - low.odom_T_solid)[2, 3] == pytest.approx(0.02, abs=1e-6)

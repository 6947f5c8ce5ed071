"""Flats for errands: what cannot be is drawn again."""

import dataclasses

import numpy as np
import pytest

from robots.scenes.scene_file import load_scene
from tools.evaluate.skills import errands


def test_a_flat_in_which_somebody_stands_inside_the_counter_is_drawn_again(monkeypatch):
    flat = load_scene("flat")
    counter = next(piece for piece in flat.furniture if piece.kind == "counter")
    inside = dataclasses.replace(flat.people[0], position_m=counter.position_m)
    drawn = iter([dataclasses.replace(flat, people=(inside, *flat.people[1:])), flat])
    monkeypatch.setattr(errands, "_drawn", lambda *_: next(drawn))

    assert errands.home(np.random.default_rng(0)).people[0].position_m == flat.people[0].position_m
    with pytest.raises(StopIteration):
        next(drawn)

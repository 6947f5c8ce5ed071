"""The randomness of a run: of one seed, and each part's own, in lockstep and live."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Seeded(NamedTuple):
    """A random generator for each part of a run; what one part draws changes nothing for the others."""

    world: np.random.Generator
    perception: np.random.Generator
    trees: np.random.Generator
    places: np.random.Generator

    @classmethod
    def by(cls, seed: int) -> Seeded:
        """The generators of one seed: the same wherever the parts run."""
        return cls(*map(np.random.default_rng, np.random.SeedSequence(seed).spawn(len(cls._fields))))

"""How likely a thing is there, is what it is called, and is where it is told to be."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.labels import Call
from robots.perception.rgbd.samples import Samples
from robots.perception.rgbd.shapes import Solid

FEATURES = (
    "fit",
    "margin",
    "hidden",
    "border",
    "pixels",
    "color off",
    "lifted",
    "uncertain",
    "color",
    "kind",
)
RIGHT: Mapping[str, float] = MappingProxyType(
    {"constant": 0.99, "fit": -0.64, "hidden": 0.4, "border": -5.69, "uncertain": -0.56, "color": 1.03}
)
"""Of a logistic regression of whether a thing is as it is told, and where, on a few features.

Learned by ``tools.evaluate.perception.learn`` on the things told of 150 random tables, in bright, dim and
warm light.
"""
THERE = (2.463, -0.62, -0.104, -2.955, -2.955, 1.563, 0.0, -0.919, 0.0, 0.0, 0.0)
"""The same of whether there is a thing at all: first the constant, then the features in their order.

Learned on 100 random tables, half of them seen by the gazes of a search.
"""
_BY_ITS_TOP, _CLEAR = 0.5, 0.5
"""What remains of the confidence where only the top is seen and another form fits nearly as well: a lid
looks like the cap of a ball."""
_SURE_M = 0.001
_MOST_ODDS = 4.0


def evidence_of(
    solid: Solid, pixels: int, color_off: float, color_share: float, kind_score: float
) -> tuple[float, ...]:
    """What speaks for and against one thing, in the order of ``FEATURES``.

    Args:
        solid: Its shape.
        pixels: How many show it.
        color_off: How far its colour is from the nearest name's, squared, in deviations.
        color_share: How likely that name is among all.
        kind_score: How sure its kind is.
    """
    return (
        min(solid.score, 8.0),
        min(solid.margin, 4.0),
        min(solid.hidden, 0.5),
        min(solid.border, 0.5),
        float(np.log(max(pixels, 1) / 500.0)),
        min(color_off, 25.0) ** 0.5,
        1.0 if solid.lifted_m > 0.0 else 0.0,
        float(np.log(min(max(max(solid.sigma_m) / _SURE_M, 1.0), 50.0))),
        _odds(color_share),
        _odds(kind_score),
    )


def _odds(share: float) -> float:
    """Logarithm of the odds, within reason."""
    return float(np.clip(np.log(max(share, 1e-6) / max(1.0 - share, 1e-6)), -_MOST_ODDS, _MOST_ODDS))


@dataclass(frozen=True, slots=True)
class Belief(InFloat64):
    """How sure things are.

    Attributes:
        right: How likely each is as it is told: there, of that kind and colour, and where; in [0, 1],
            shape (k,).
        there: How likely there is a thing at all, shape (k,).
        evidence: What both were made of, shape (k, features).
    """

    right: Array
    there: Array
    evidence: Array


def confidences(
    samples: Samples, solids: Sequence[Solid], calls: Sequence[Call], shares: Array, off: Array
) -> Belief:
    """How sure some things are.

    Args:
        samples: What was measured of them.
        solids, calls: What they are taken for.
        shares: How likely the name of each one's colour is.
        off: How far its colour is from that name's, squared, in deviations.
    """
    evidence = np.array(
        [
            evidence_of(solid, int(pixels), float(away), float(share), call.score)
            for solid, call, pixels, away, share in zip(
                solids, calls, samples.pixels, off, shares, strict=True
            )
        ]
    )
    by_name = np.array([RIGHT.get(name, 0.0) for name in FEATURES])
    right = _share(RIGHT["constant"] + evidence @ by_name)
    right *= [1.0 if "sides" in solid.measured or solid.margin > _CLEAR else _BY_ITS_TOP for solid in solids]
    return Belief(right, _share(THERE[0] + evidence @ np.array(THERE[1:])), evidence)


def _share(odds: Array) -> Array:
    """Of the logarithms of some odds."""
    return np.asarray(1.0 / (1.0 + np.exp(-np.clip(odds, -30.0, 30.0))))

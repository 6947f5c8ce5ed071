"""Smooth scalar profiles over the unit interval, at rest at both ends."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import Polynomial

from kinematics.arrays import Array

_S = Polynomial([0.0, 1.0])
_GO = 10 * _S**3 - 15 * _S**4 + 6 * _S**5
_GO_AND_RETURN = 64 * (_S * (1 - _S)) ** 3


class Profile:
    """``go`` + ``back`` * there-and-back + ``wave`` * windowed sine, within a part of the interval.

    Args:
        go: Where it ends.
        back: Height of a detour.
        wave: Amplitude of a sine in a smooth window.
        turns: Full waves in that window.
        start, end: The part of the interval in which it moves.
    """

    def __init__(
        self,
        go: float,
        back: float = 0.0,
        wave: float = 0.0,
        turns: float = 1.0,
        start: float = 0.0,
        end: float = 1.0,
    ) -> None:
        self._poly = go * _GO + back * _GO_AND_RETURN
        self._window = wave * _GO_AND_RETURN
        self._rate = 2.0 * np.pi * turns
        self._start, self._width = start, end - start

    def __call__(self, s: Array) -> tuple[Array, Array]:
        """Values and derivatives with respect to ``s``, shape (n,) each."""
        u = np.clip((s - self._start) / self._width, 0.0, 1.0)
        window, slope = self._window(u), self._window.deriv()(u)
        sine, cosine = np.sin(self._rate * u), np.cos(self._rate * u)
        value = self._poly(u) + window * sine
        rate = self._poly.deriv()(u) + slope * sine + window * self._rate * cosine
        return np.asarray(value), np.asarray(rate / self._width)

    def scaled(self, factor: float) -> Profile:
        """The same shape, ``factor`` times as large."""
        copy = Profile(0.0)
        copy._poly, copy._window = self._poly * factor, self._window * factor
        copy._rate, copy._start, copy._width = self._rate, self._start, self._width
        return copy


def random_profile(rng: np.random.Generator, size: float) -> Profile:
    """A random profile that goes about ``size`` far to either side."""
    go, back, wave = size * rng.uniform(-1.0, 1.0, 3) * rng.permutation([1.0, 0.6, 0.3])
    start = 0.0 if rng.random() < 0.6 else rng.uniform(0.0, 0.4)
    end = 1.0 if rng.random() < 0.6 else rng.uniform(0.6, 1.0)
    return Profile(go, back, wave, rng.uniform(0.5, 2.0), start, end)

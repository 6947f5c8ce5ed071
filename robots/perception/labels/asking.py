"""The seam to a model that is asked what pictures show: who opens the connection gives it to the labeller."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from robots.errors import RobotsError

AskAboutPictures = Callable[[Sequence[Mapping[str, Any]]], str]
"""Asks a model: takes the parts of one message, texts and pictures, in the form of OpenAI's interface; gives
the text of the answer, which is untrusted. It raises ``SilentModelError``. It crosses to the process that
looks at pictures, so that it can be pickled."""


class SilentModelError(RobotsError):
    """A model that gave no answer; the message says which one, and why."""

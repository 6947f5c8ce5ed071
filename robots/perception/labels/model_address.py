"""Where a model is that can be asked what pictures show."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class VisionModel:
    """A model behind an OpenAI-compatible address, as a table ``[models.NAME]`` has it.

    Attributes:
        url: Base address: ".../v1".
        model: What the server calls it.
        key: Empty where the server wants none.
        timeout_s: Wall time that an answer may take.
    """

    url: str
    model: str
    key: str = field(default="", repr=False)
    timeout_s: float = 20.0

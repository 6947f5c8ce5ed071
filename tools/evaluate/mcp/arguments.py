"""Arguments of tools, made at random from their own JSON schemas: fitting, nearly fitting, and hostile."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from executive.understanding.understanding import understand

_WORDS = (
    "pick",
    "up",
    "the",
    "red",
    "cup",
    "walk",
    "to",
    "door",
    "and",
    "then",
    "not",
    "stop",
    "if",
    "left",
    "7",
)
_ODD = (
    "", " ", "\x00", "\n\n", "\u202e", "\ud7ff", "\U0001f916", "{}", "[]", "null", "'; DROP TABLE runs; --",
    "../../etc/passwd", "$(reboot)", "%s%n", "robot://scene", "run-1", "run-0", "run--1", "\\", '"',
)  # fmt: skip
_LONGEST = 60_000
_DEEPEST = 40
_NUMBERS = (0, 1, -1, 2, 45, 46, 1e308, -1e308, 1e-300, 2**31, 2**63, 2**70, 10**40, 0.5)


class ArgumentMaker:
    """Makes the arguments of one tool.

    Args:
        schema: Of its input, as the server tells it.
        rng: Where chance comes from.
    """

    def __init__(self, schema: Mapping[str, Any], rng: np.random.Generator) -> None:
        self._properties: Mapping[str, Any] = schema.get("properties", {})
        self._required = list(schema.get("required", []))
        self._rng = rng

    def make(self) -> dict[str, Any]:
        """Arguments: a third of them fits the schema, a third nearly does, a third is anything."""
        kind = int(self._rng.integers(3))
        if kind == 2:
            return {self._name(): self._anything(0) for _ in range(int(self._rng.integers(5)))}
        made = {
            name: self._fitting(schema)
            for name, schema in self._properties.items()
            if name in self._required or self._rng.random() < 0.7
        }
        return self._spoiled(made) if kind == 1 else made

    def _spoiled(self, made: dict[str, Any]) -> dict[str, Any]:
        """Fitting arguments with one thing wrong."""
        names = list(self._properties)
        match int(self._rng.integers(4)):
            case 0 if made:
                made.pop(str(self._rng.choice(list(made))))
            case 1:
                made[self._name()] = self._anything(0)
            case _ if names:
                made[str(self._rng.choice(names))] = self._anything(0)
        return made

    def _fitting(self, schema: Mapping[str, Any]) -> Any:
        if "anyOf" in schema:
            return self._fitting(schema["anyOf"][int(self._rng.integers(len(schema["anyOf"])))])
        if "enum" in schema:
            return schema["enum"][int(self._rng.integers(len(schema["enum"])))]
        match schema.get("type"):
            case "string":
                return self._text()
            case "number" | "integer":
                return self._number()
            case "boolean":
                return bool(self._rng.integers(2))
            case _:
                return None

    def _anything(self, depth: int) -> Any:
        match int(self._rng.integers(8)):
            case 0 | 1:
                return self._text()
            case 2:
                return self._number()
            case 3:
                return bool(self._rng.integers(2))
            case 4:
                return None
            case 5:
                nested: Any = []
                for _ in range(int(self._rng.integers(_DEEPEST))):
                    nested = [nested]
                return nested
            case 6 if depth < 3:
                return [self._anything(depth + 1) for _ in range(int(self._rng.integers(4)))]
            case _ if depth < 3:
                return {self._name(): self._anything(depth + 1) for _ in range(int(self._rng.integers(4)))}
            case _:
                return {}

    def _number(self) -> float:
        if self._rng.random() < 0.5:
            return _NUMBERS[int(self._rng.integers(len(_NUMBERS)))]
        return float(self._rng.normal() * 10.0 ** float(self._rng.integers(-3, 9)))

    def _name(self) -> str:
        known = [*self._properties, "text", "run", "force", "reset", "__class__", "ctx", "reply", "_meta"]
        return self._text() if self._rng.random() < 0.3 else str(self._rng.choice(known))

    def _text(self) -> str:
        """A text that means nothing to the robot: what it would carry out is no hostile call."""
        while True:
            text = self._any_text()
            if understand(text).parsed.refusal is not None:
                return text

    def _any_text(self) -> str:
        match int(self._rng.integers(5)):
            case 0:
                return _ODD[int(self._rng.integers(len(_ODD)))]
            case 1:
                points = self._rng.integers(1, 0x2FFFF, int(self._rng.integers(1, 60)))
                return "".join(chr(int(one)) for one in points if not 0xD800 <= one < 0xE000)
            case 2 if self._rng.random() < 0.1:
                return chr(int(self._rng.integers(32, 127))) * int(self._rng.integers(_LONGEST))
            case _:
                return " ".join(self._rng.choice(_WORDS, int(self._rng.integers(1, 12))).tolist())

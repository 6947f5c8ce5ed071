"""One table of a scene file, read key by key: what is wrong is told with file, key and reason."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from robots.errors import SceneError
from robots.scenes.scene_words import nearest_word


class SceneTable:
    """One table of the document.

    Every method raises ``SceneError`` where the value under the key is not what it asks for.

    Attributes:
        data: The table.
        source: File name for messages.
        key: Where the table stands in the document; empty for the whole.
    """

    def __init__(self, data: Any, source: str, key: str) -> None:
        self.data, self.source, self.key = data, source, key
        if not isinstance(data, dict):
            raise SceneError(source, key, "must be a table")

    def fail(self, key: str, reason: str) -> SceneError:
        """The error that names file and key; the caller raises it."""
        return SceneError(self.source, f"{self.key}.{key}" if self.key else key, reason)

    def only(self, known: Iterable[str]) -> None:
        """Refuse keys that are not known."""
        names = list(known)
        for key in self.data:
            if key not in names:
                near = nearest_word(key, names)
                raise self.fail(key, f"unknown key; the nearest is {near!r}, all: {', '.join(names)}")

    def table(self, key: str) -> SceneTable:
        """The table under a key; an empty one where there is none."""
        return SceneTable(self.data.get(key, {}), self.source, f"{self.key}.{key}" if self.key else key)

    def tables(self, key: str) -> list[SceneTable]:
        """The list of tables under a key; an empty one where there is none."""
        items = self.data.get(key, [])
        if not isinstance(items, list):
            raise self.fail(key, f"must be a list of tables: write [[{key}]]")
        return [SceneTable(item, self.source, f"{key}[{i}]") for i, item in enumerate(items)]

    def _get(self, key: str) -> Any:
        if key not in self.data:
            raise self.fail(key, "is missing")
        return self.data[key]

    def text(self, key: str) -> str:
        """A text that is not blank."""
        value = self._get(key)
        if not isinstance(value, str) or not value.strip():
            raise self.fail(key, f"must be a text in quotes, not {value!r}")
        return value

    def texts(self, key: str) -> tuple[str, ...]:
        """A list of texts that are not blank; an empty one where the key is missing."""
        value = self.data.get(key, [])
        if not isinstance(value, list) or not all(isinstance(one, str) and one.strip() for one in value):
            raise self.fail(key, f'must be a list of texts, ["tomato soup"], not {value!r}')
        return tuple(value)

    def word(self, key: str, known: Iterable[str]) -> str:
        """One of some words."""
        value, words = self.text(key), list(known)
        if value not in words:
            near = nearest_word(value, words)
            raise self.fail(key, f"unknown {key} {value!r}; the nearest is {near!r}, all: {', '.join(words)}")
        return value

    def number(self, key: str, default: float | None = None) -> float:
        """A finite number; the default, if there is one, where the key is missing."""
        if default is not None and key not in self.data:
            return default
        return self._number(key, self._get(key))

    def _number(self, key: str, value: Any) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.fail(key, f"must be a number, not {value!r}")
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            raise self.fail(key, f"must be finite, not {value!r}")
        return number

    def flag(self, key: str) -> bool:
        """True or false; false where the key is missing."""
        value = self.data.get(key, False)
        if not isinstance(value, bool):
            raise self.fail(key, f"must be true or false, not {value!r}")
        return value

    def points(self, key: str) -> tuple[tuple[float, float], ...]:
        """A list of places on the floor; an empty one where the key is missing."""
        value = self.data.get(key, [])
        if not isinstance(value, list) or not all(isinstance(one, list) and len(one) == 2 for one in value):
            raise self.fail(key, f"must be a list of places, [[1.0, 0.0], [2.0, 0.5]], not {value!r}")
        return tuple(
            (self._number(f"{key}[{i}][0]", x), self._number(f"{key}[{i}][1]", y))
            for i, (x, y) in enumerate(value)
        )

    def numbers(self, key: str, count: int) -> tuple[float, ...]:
        """A list of so many finite numbers."""
        value = self._get(key)
        if not isinstance(value, list) or len(value) != count:
            raise self.fail(key, f"must be a list of {count} numbers, not {value!r}")
        return tuple(self._number(f"{key}[{i}]", item) for i, item in enumerate(value))

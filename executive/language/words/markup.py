"""Marks that language models put around words: "**Step 1:** grasp the `cup`", "walk to <kitchen>".

They are taken away where the text means nothing with them. Quotation marks are, where nothing in the text
speaks: elsewhere they hold words to say, or what is written on something.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator

_AROUND = re.compile(r"\*\*|`+|^\s*#{1,4}\s+", re.MULTILINE)
_ANGLES = re.compile(r"<([^\W\d][\w ]{0,30})>")
_BETWEEN = re.compile(rf"{_ANGLES.pattern}|`[^`]+`")
_NO_WORD = "zorbl"
_MOST_BETWEEN = 8
"""Brackets and ticks that are looked at; a text with more is no sentence."""
_QUOTED = re.compile(r"\"([^\"]{1,60})\"|(?<!\w)'([^']{1,60})'(?!\w)")
_CURLY = str.maketrans({**dict.fromkeys("\u201c\u201d\u201e", '"'), **dict.fromkeys("\u2018\u2019", "'")})
_WRITTEN_ON = re.compile(
    r"\b(?:with|called|named|labell?ed|marked|reads?|reading|says?|saying|titled|word|written|means?)\s*:?\s*[\"']"
)


def without_marks(text: str) -> str | None:
    """The text without bold, code and angle brackets; None where there are none."""
    plain = _ANGLES.sub(r"\1", _AROUND.sub("", text))
    return plain if plain != text and plain.strip() else None


def with_others_between_marks(text: str) -> Iterator[str]:
    """The text without marks, with nothing or what is no word in place of what stands between two of them.

    Where the text means the same with that, what stands there was passed over: it is no "<kitchen>", and may
    be a "<script>".
    """
    between = list(_BETWEEN.finditer(text))
    for one, instead in itertools.product(between[:_MOST_BETWEEN], ("", _NO_WORD)):
        told = f"{text[: one.start()]} {instead} {text[one.end() :]}"
        yield without_marks(told) or told
    if len(between) > _MOST_BETWEEN:
        yield without_marks(text) or text


def without_quotation_marks(text: str) -> str | None:
    """The text without quotation marks; None where there are none, or where they tell what is written."""
    text = text.translate(_CURLY)
    if _WRITTEN_ON.search(text.lower()):
        return None
    plain = _QUOTED.sub(lambda match: match.group(1) or match.group(2), text)
    return plain if plain != text else None

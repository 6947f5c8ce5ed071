"""The indefinite article before a noun."""

from __future__ import annotations


def with_article(words: object) -> str:
    """A thing as one of its kind: "a red cup", "an orange cup"."""
    noun = str(words)
    return f"{'an' if noun.lower().startswith(tuple('aeiou')) else 'a'} {noun}"

"""How many things are meant: numbers, "both", "all", "some", "one of"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.phrases.features import COUNTED_FROM, SUPERLATIVES, described
from executive.language.phrases.parts import Parts, nominal_of, words
from executive.language.phrases.values import Feature, Meaning, Nominal, Relative, Trouble

MAX_COUNT = 20
"""More things at once than anybody means; beyond it the number is taken for a mistake."""


def _several(parts: Parts) -> Nominal | Trouble | None:
    amounts = [part for part in parts if isinstance(part, float)]
    couple = words(parts, "COUPLE")
    amount = amounts[0] if amounts else float(couple[0].meaning)
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    if (nominal.anaphoric and amount == 1) or (couple and not nominal.plural):
        return None
    if amount != int(amount) or not 1 <= amount <= MAX_COUNT:
        return Trouble(
            f"{amount:g} things at once: a whole number from 1 to {MAX_COUNT} is understood", f"{amount:g}"
        )
    if amount > 1 and words(parts, "DET") and not (nominal.plural or nominal.paired):
        message = f"{amount:g} of them, or the one with the number {amount:g}?"
        return Trouble(message, f"{amount:g}", asks=True)
    extreme = nominal.size if nominal.size in SUPERLATIVES else None
    if amount > 1 and extreme:
        return Trouble(one_by_one(extreme), extreme)
    if amount > 1 and nominal.ordinal not in (None, "other"):
        return Trouble(one_by_one(nominal.ordinal), nominal.ordinal)
    return replace(nominal, count=int(amount), counted=True, determined=True)


def _some_of(parts: Parts) -> Nominal | Trouble | None:
    """Two of the four cans: as many as are meant, of no fewer."""
    meant, among = (part for part in parts if isinstance(part, float))
    if meant > among or among < 2:
        return Trouble(f"{meant:g} of {among:g}: how many are meant?", asks=True)
    first = parts.index(among)
    return _several((*parts[:first], *parts[first + 1 :]) if meant != among else parts[parts.index(among) :])


def one_by_one(rank: str) -> str:
    """Why several things cannot be chosen by what only one of them can be."""
    return f"{rank!r} is one of them; name several things one by one"


def _both(parts: Parts) -> Nominal | Trouble | None:
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or not nominal.plural:
        return nominal if isinstance(nominal, Trouble) else None
    return replace(nominal, count="both", counted=True, determined=True)


def _all(parts: Parts) -> Nominal | Trouble | None:
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    each = bool(words(parts, "EVERY"))
    if nominal.kind == "glasses":
        return unclear_glasses(nominal)
    if not each and not (nominal.plural or nominal.mass):
        return None
    if each and nominal.ordinal == "other" and not nominal.plural:
        return Trouble("every second one, or all the others?", "other", asks=True)
    only = nominal.size if nominal.size in SUPERLATIVES else nominal.ordinal
    if only not in (None, "other"):
        return Trouble(one_by_one(only), only)
    amounts = [part for part in parts if isinstance(part, float)]
    count: int | str = int(amounts[0]) if amounts and 1 < amounts[0] <= MAX_COUNT else "all"
    return replace(nominal, count=count, counted=True, determined=True, plural=True)


def _one_of(parts: Parts) -> Nominal | Trouble | None:
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or not nominal.plural:
        return nominal if isinstance(nominal, Trouble) else None
    return replace(nominal, plural=False, determined=True)


def _of_them(parts: Parts) -> Trouble:
    """One of them, two of these: which of them is not said, whatever they are."""
    them = words(parts, "THEM")[-1].said
    return Trouble(f"what does {them!r} stand for, and which of them is meant?", asks=True)


def _out_of(parts: Parts) -> Nominal | Trouble | None:
    """The bigger of the two cups."""
    amounts = [part for part in parts if isinstance(part, float)]
    if nominal_of(parts) is None and not amounts:
        return None  # "on top of that"
    features = sum(isinstance(part, (Feature, Relative)) for part in parts)
    if nominal_of(parts) is None and features > 1:
        return None  # "the bigger of the two first"
    nominal = nominal_of(parts) or Nominal("any", plural=True)
    if not nominal.plural:
        return None
    result = described(nominal, parts)
    if not isinstance(result, Nominal):
        return result
    if result.ordinal in COUNTED_FROM and any(word.said in ("a", "an") for word in words(parts, "DET")):
        return Trouble("how many of them?", result.ordinal, asks=True)  # "a third of the cups"
    return replace(result, plural=False, determined=True)


def _some(parts: Parts) -> Nominal | Trouble | None:
    """A few cups, some cups: nobody knows how many; some water, any cup: one."""
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    if not nominal.plural and words(parts, "MANY")[0].meaning != "some":
        return None
    how_many = "some" if words(parts, "MANY")[0].meaning == "some" else "many"
    return replace(nominal, count=how_many if nominal.plural else 1, determined=True, indefinite=True)


def _everything(_parts: Parts) -> Nominal:
    return Nominal("any", count="all", counted=True, plural=True, determined=True)


def _vague(_parts: Parts) -> Trouble:
    return Trouble("which object is meant?", asks=True)


def unclear_glasses(nominal: Nominal) -> Trouble:
    """Ask about a word that means two things."""
    return Trouble("glasses to see with, or to drink from?", nominal.said, asks=True)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "several": _several,
        "some_of": _some_of,
        "both": _both,
        "all": _all,
        "one_of": _one_of,
        "of_them": _of_them,
        "out_of": _out_of,
        "some": _some,
        "everything": _everything,
        "vague": _vague,
    }
)

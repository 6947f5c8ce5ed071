"""What every rule of the grammar of sentences means."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from executive.language.clauses import (
    arrivals,
    before_command,
    given_reasons,
    headings,
    sentences,
    stated_goals,
    statements,
    told_after,
)
from executive.language.clauses.begun_by import begun_by
from executive.language.clauses.fronted import fronted
from executive.language.commands import (
    attention,
    chores,
    counted_apart,
    gestures,
    going,
    handling,
    one_after_another,
    placing,
    set_speed,
    speech,
    the_same,
    turns,
    two_verbs,
    verbless,
    waiting,
)
from executive.language.noun_phrases import (
    amounts,
    appositions,
    chosen_from,
    features,
    lists,
    nominals,
    pairs,
    places,
    quantities,
    sharing,
)
from executive.language.phrases import Meaning

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        **amounts.MEANINGS,
        **appositions.MEANINGS,
        **arrivals.MEANINGS,
        **attention.MEANINGS,
        **before_command.MEANINGS,
        **chores.MEANINGS,
        **chosen_from.MEANINGS,
        **counted_apart.MEANINGS,
        **features.MEANINGS,
        **gestures.MEANINGS,
        **given_reasons.MEANINGS,
        **going.MEANINGS,
        **handling.MEANINGS,
        **headings.MEANINGS,
        **lists.MEANINGS,
        **nominals.MEANINGS,
        **one_after_another.MEANINGS,
        **pairs.MEANINGS,
        **places.MEANINGS,
        **placing.MEANINGS,
        **quantities.MEANINGS,
        **sentences.MEANINGS,
        **set_speed.MEANINGS,
        **sharing.MEANINGS,
        **speech.MEANINGS,
        **stated_goals.MEANINGS,
        **statements.MEANINGS,
        **the_same.MEANINGS,
        **told_after.MEANINGS,
        **turns.MEANINGS,
        **verbless.MEANINGS,
        **two_verbs.MEANINGS,
        **waiting.MEANINGS,
        "begun_by": begun_by,
        "fronted": fronted,
    }
)

"""What every rule of the grammar of sentences means."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from executive.language import (
    amounts,
    appositions,
    arrivals,
    attention,
    before_command,
    chores,
    chosen_from,
    counted_apart,
    features,
    gestures,
    given_reasons,
    going,
    handling,
    lists,
    nominals,
    one_after_another,
    pairs,
    places,
    placing,
    quantities,
    sentences,
    set_speed,
    sharing,
    speech,
    stated_goals,
    statements,
    the_same,
    told_after,
    turns,
    two_verbs,
    verbless,
    waiting,
)
from executive.language.begun_by import begun_by
from executive.language.fronted import fronted
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

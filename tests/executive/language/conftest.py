"""Somebody who always gives the same answer."""

import pytest

from executive.dialogue.clarification import clarified


@pytest.fixture
def answered():
    """What a sentence means once its question has been answered so."""

    def meaning(parsed, answer):
        steps, said = clarified(parsed), None
        while True:
            try:
                steps.send(said)
            except StopIteration as end:
                return end.value
            said = answer

    return meaning

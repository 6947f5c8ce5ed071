"""Somebody who always gives the same answer."""

import pytest

from executive.dialogue.clarification import clarified
from executive.session.driver import driven


@pytest.fixture
def answered():
    """What a sentence means once its question has been answered so."""

    def meaning(parsed, answer):
        return driven(clarified(parsed), lambda _question: answer)

    return meaning

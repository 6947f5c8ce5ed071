"""A model's answers in the record of a run, and a model that gives them again: a replay asks no server."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from executive.front.front_model import FrontModel, Waiting
from executive.front.model_settings import ModelSettings
from executive.front.proposal import ModelFailure, ModelFailureKind
from executive.session.events import InputTaken
from executive.trust import Trust

MODEL_INPUT = "model"
"""What an input is called that a model has given."""


def written_answer(answer: str | ModelFailure) -> str:
    """An answer, or why there was none, as an input's value."""
    if isinstance(answer, ModelFailure):
        return json.dumps({"failure": answer.kind.name, "reason": answer.reason})
    return json.dumps({"answer": answer})


def recorded_front(header: Mapping[str, Any], inputs: Iterable[InputTaken], trust: Trust) -> FrontModel:
    """The model of a recorded run, which gives the recorded answers.

    Args:
        header: What ``FrontModel.header`` has made.
        inputs: All inputs of the run.
        trust: How far its confidences were trusted.

    Raises:
        ValueError, KeyError, TypeError: The header or an answer is none of ours.
    """
    told = dict(header)
    reads_back = bool(told.pop("reads_back"))
    answers = [_read(one.value) for one in inputs if one.what == MODEL_INPUT]
    return FrontModel(ModelSettings(**told), _RecordedAsker(iter(answers)), trust, reads_back)


def _read(value: str) -> str | ModelFailure:
    told = json.loads(value)
    if "failure" in told:
        return ModelFailure(ModelFailureKind[told["failure"]], str(told["reason"]))
    return str(told["answer"])


class _RecordedAsker:
    """Gives answers, one after the other, at once."""

    def __init__(self, answers: Iterator[str | ModelFailure]) -> None:
        self._answers = answers

    def ask(self, _messages: Sequence[Mapping[str, str]], _waiting: Waiting) -> str | ModelFailure:
        """The next answer; none where the recording has no more."""
        return next(self._answers, ModelFailure.of(ModelFailureKind.CANCELLED))

    def close(self) -> None:
        """There is nothing to let go of."""

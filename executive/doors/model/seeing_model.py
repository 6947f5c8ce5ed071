"""The model that a user has set up to be asked what the camera's pictures show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from typing import Any

from executive.config import config_files, environment_value
from executive.doors.model.front_model import usable_model
from executive.front.model_settings import ModelSettings, model_that_sees
from executive.front.proposal import ModelFailure
from robots.perception.labels.asking import SilentModelError


@dataclass(frozen=True, slots=True)
class SeeingModel:
    """Asks one model; a value that crosses to the process that looks at pictures, and asks from there.

    Attributes:
        settings: Where it is.
        key: The key; empty where the server wants none.
    """

    settings: ModelSettings
    key: str = field(repr=False)

    def __call__(self, content: Sequence[Mapping[str, Any]]) -> str:
        """The text of the model's answer, untrusted.

        Args:
            content: Parts of one message: texts and pictures.

        Raises:
            SilentModelError: There is none.
        """
        from executive.doors.model.client import ModelClient

        with closing(ModelClient(self.settings, self.key)) as client:
            answer = client.ask_about(content)
        if isinstance(answer, ModelFailure):
            raise SilentModelError(f"the model {self.settings.name!r}: {answer.reason}")
        return answer


def seeing_model() -> SeeingModel | None:
    """The model that is asked what pictures show, where a user has set one up; nothing is sent yet.

    Raises:
        ModelSettingsError: There are several, a file is wrong, or its key is not there.
        MissingExtraError: The client's package is not installed.
    """
    found = model_that_sees(config_files())
    if found is None:
        return None
    settings = usable_model(found.name)
    return SeeingModel(settings, environment_value(settings.key_env) if settings.key_env else "")

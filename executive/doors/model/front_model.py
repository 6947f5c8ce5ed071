"""The model that a user calls by a name, ready to be asked."""

from __future__ import annotations

from executive.config import config_files, environment_value
from executive.doors.companion import require_extra
from executive.front.front_model import FrontModel
from executive.front.model_asker import ModelAsker
from executive.front.model_settings import ModelSettings, ModelSettingsError, model_called
from executive.trust import Trust


def usable_model(name: str) -> ModelSettings:
    """The settings of a model that could be asked; nothing is sent.

    Args:
        name: As ``[models.NAME]`` has it.

    Raises:
        ModelSettingsError: There is no such model, a file is wrong, or its key is not there.
        MissingExtraError: The client's package is not installed.
    """
    settings = model_called(name, config_files())
    require_extra("models", "openai")
    if settings.key_env and not environment_value(settings.key_env):
        raise ModelSettingsError(
            f"models.{name}.key_env: the environment variable {settings.key_env} is not set; it holds the key"
        )
    return settings


def front_model(name: str, trust: Trust, reads_back: bool = True) -> tuple[FrontModel, ModelAsker]:
    """The model that a user calls by a name; nothing is sent before it is asked.

    Args:
        name: As ``[models.NAME]`` has it.
        trust: How far its confidences are trusted.
        reads_back: Whether everything is read back, or only what must be.

    Returns:
        The model, and what asks its server, to be closed in the end.

    Raises:
        ModelSettingsError: There is no such model, a file is wrong, or its key is not there.
        MissingExtraError: The client's package is not installed.
    """
    settings = usable_model(name)
    asker = ModelAsker(settings)
    return FrontModel(settings, asker, trust, reads_back), asker

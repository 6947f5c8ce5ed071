"""What the environment says: where data go, and how the terminal wants to be written to."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

APPLICATION = "humanoid-executive"
CONFIG_VARIABLE = "HUMANOID_EXECUTIVE_CONFIG"


def config_directory() -> Path:
    """Where this user's settings are, by the platform's custom."""
    import platformdirs  # help is told without it

    return platformdirs.user_config_path(APPLICATION, appauthor=False, roaming=True)


def config_files(given: Path | None = None) -> tuple[Path, ...]:
    """Files with a user's settings: ``config.toml`` of the user's folder, if it is there, and a given one.

    Without a given one it is that of ``use_config``.
    """
    own = config_directory() / "config.toml"
    files = [own] if own.is_file() else []
    chosen = chosen_config() if given is None else given
    return tuple(files if chosen is None else [*files, chosen])


def use_config(file: Path | None) -> None:
    """Take a file of settings for this process and for those that it starts; None changes nothing."""
    if file is not None:
        os.environ[CONFIG_VARIABLE] = str(file.absolute())


def forget_config() -> None:
    """Take no file of settings but that of the user's folder."""
    os.environ.pop(CONFIG_VARIABLE, None)


def chosen_config() -> Path | None:
    """The file of ``use_config``, or of the environment variable ``HUMANOID_EXECUTIVE_CONFIG``."""
    chosen = os.environ.get(CONFIG_VARIABLE)
    return Path(chosen) if chosen else None


def environment_value(name: str) -> str:
    """What a variable of the environment says, such as one with a secret; empty where it is not set."""
    return os.environ.get(name, "")


def cache_directory() -> Path:
    """Where what can be made anew is kept, by the platform's custom."""
    import platformdirs  # help is told without it

    return platformdirs.user_cache_path(APPLICATION, appauthor=False)


def data_directory() -> Path:
    """Where this user's recorded runs and crash reports go, by the platform's custom."""
    import platformdirs  # help is told without it

    return platformdirs.user_data_path(APPLICATION, appauthor=False)


def state_directory() -> Path:
    """Where this user's history of typed lines goes, by the platform's custom."""
    import platformdirs  # help is told without it

    return platformdirs.user_state_path(APPLICATION, appauthor=False)


def runs_directory() -> Path:
    """Where runs are recorded unless ``--record`` says otherwise."""
    return data_directory() / "runs"


def crashes_directory() -> Path:
    """Where crash reports go."""
    return data_directory() / "crashes"


def shown_directory() -> Path:
    """Where views of things are kept that were shown to the robot."""
    return data_directory() / "shown"


def leave_opengl_to_the_renderer() -> None:
    """Forget ``MUJOCO_GL``: importing MuJoCo fails when it names a library that is missing, while
    pictures are drawn with whichever library is there.
    """
    os.environ.pop("MUJOCO_GL", None)


def runtime_directory() -> Path:
    """Where the sockets of a served robot are: a folder of this user alone.

    A client and what it talks to must agree on it also where no session has made such a folder, and without
    a warning; so it is not asked of ``platformdirs``.
    """
    given = os.environ.get("XDG_RUNTIME_DIR")
    if given and Path(given).is_dir():
        return Path(given) / APPLICATION
    return Path(tempfile.gettempdir()) / f"{APPLICATION}-{os.geteuid()}"

"""Where this user's files are."""

import tempfile
from pathlib import Path

import pytest

from executive import config

FOLDERS = [
    (config.config_directory, "XDG_CONFIG_HOME", ".config"),
    (config.cache_directory, "XDG_CACHE_HOME", ".cache"),
    (config.data_directory, "XDG_DATA_HOME", ".local/share"),
]


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setenv("HOME", str(tmp_path))
    for variable in ("XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"):
        monkeypatch.delenv(variable, raising=False)
    return tmp_path


@pytest.mark.parametrize(("folder", "variable", "usual"), FOLDERS)
def test_files_of_a_user_are_in_the_usual_folders_of_a_home(home, folder, variable, usual):
    assert folder() == home / usual / "humanoid-executive"


@pytest.mark.parametrize(("folder", "variable", "usual"), FOLDERS)
def test_the_environment_says_where_else_they_are(home, monkeypatch, folder, variable, usual):
    monkeypatch.setenv(variable, str(home / "elsewhere"))

    assert folder() == home / "elsewhere" / "humanoid-executive"


def test_sockets_are_in_the_sessions_folder_or_in_one_of_the_user(home, monkeypatch):
    own = config.runtime_directory()
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(home))

    assert own.parent == Path(tempfile.gettempdir())
    assert config.runtime_directory() == home / "humanoid-executive"

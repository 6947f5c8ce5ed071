"""The folder is this user's alone, and one control process has it."""

import os
import stat

import pytest

from robots.live.wire.errors import AlreadyServedError, NotServedError, RuntimeFolderError
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.unix_socket import connect_to


def test_it_is_made_for_its_owner_alone(tmp_path):
    folder = RuntimeFolder(tmp_path / "robot")
    folder.make()

    assert stat.S_IMODE(folder.path.stat().st_mode) == 0o700


def test_one_that_others_may_enter_is_refused(tmp_path):
    (tmp_path / "robot").mkdir(mode=0o755)
    (tmp_path / "robot").chmod(0o755)

    with pytest.raises(RuntimeFolderError, match="0700"):
        RuntimeFolder(tmp_path / "robot").make()


def test_a_link_to_a_folder_is_refused(tmp_path):
    (tmp_path / "elsewhere").mkdir(mode=0o700)
    (tmp_path / "robot").symlink_to(tmp_path / "elsewhere")

    with pytest.raises(RuntimeFolderError, match="no folder"):
        RuntimeFolder(tmp_path / "robot").make()


def test_a_path_that_is_too_long_for_a_socket_is_refused(tmp_path):
    with pytest.raises(RuntimeFolderError, match="too long"):
        RuntimeFolder(tmp_path / ("x" * 100)).make()


def test_a_second_control_process_is_refused_until_the_first_has_ended(folder):
    held = folder.hold()
    with pytest.raises(AlreadyServedError):
        folder.hold()

    os.close(held)

    os.close(folder.hold())


def test_the_socket_is_the_owners_alone(live):
    assert stat.S_IMODE(live.folder.control_socket.stat().st_mode) == 0o600


def test_nobody_there_is_told_as_such(folder):
    with pytest.raises(NotServedError, match="executive serve"):
        connect_to(folder.control_socket)

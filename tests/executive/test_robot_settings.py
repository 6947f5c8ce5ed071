"""What the robot says of itself stands in the table [robot]; mistakes are told with key and reason."""

from datetime import datetime

import pytest

from executive.robot_settings import (
    RobotSettings,
    RobotSettingsError,
    robot_settings,
    settings_from_json,
)
from trees.self_knowledge import Identity

TALLY = """
[robot]
name = "Tally"
team = "Lodestar"
begins = 2027-12-31T23:59:00

[vocabulary.KIND]
same = ["sprocket"]
"""


@pytest.fixture
def written(tmp_path):
    def write(text, name="config.toml"):
        file = tmp_path / name
        file.write_text(text)
        return file

    return write


def test_what_a_file_says_is_known_and_the_rest_is_not(written):
    settings = robot_settings([written(TALLY)])

    assert settings == RobotSettings(Identity("Tally", "Lodestar"), datetime(2027, 12, 31, 23, 59))


def test_without_a_file_or_a_table_nothing_is_known(written):
    assert robot_settings([]) == robot_settings([written("[vocabulary.KIND]\nsame = ['x']")])
    assert robot_settings([]) == RobotSettings()


def test_of_two_files_the_later_one_counts_where_both_say_something(written):
    settings = robot_settings([written(TALLY), written('[robot]\nteam = "Borealis"', "own.toml")])

    assert settings.identity == Identity("Tally", "Borealis")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('[robot]\ntaem = "x"', "robot.taem: unknown key; .*team"),
        ("[robot]\nname = 7", "robot.name: must be a text in quotes, not 7"),
        ('[robot]\nname = " "', "robot.name: must be a text in quotes"),
        ('robot = "Tally"', r"robot: must be a table, \[robot\]"),
        ("[robot]\nbegins = 2027-12-31T23:59:00Z", "robot.begins: must be a local time without a zone"),
        ("[robot\n", "robot: is no TOML"),
    ],
)
def test_a_mistake_is_told_with_file_key_and_reason(written, text, told):
    with pytest.raises(RobotSettingsError, match=told):
        robot_settings([written(text)])


def test_a_file_that_is_not_there_is_told(tmp_path):
    with pytest.raises(RobotSettingsError, match="No such file"):
        robot_settings([tmp_path / "none.toml"])


def test_the_record_of_a_run_keeps_what_was_said(written):
    settings = robot_settings([written(TALLY)])

    assert settings_from_json(settings.to_json()) == settings

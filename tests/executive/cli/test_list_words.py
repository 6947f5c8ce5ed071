"""Words are marked that name what the robot's perception can tell in a scene."""

import pytest
from typer.testing import CliRunner

from executive.cli.app import app

SCENE = """
[perception]
labels = [{labels}]

[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.9]
position_m = [0.65, 0.0]

[[object]]
name = "rubik's cube"
kind = "toy"
size_m = [0.06, 0.06, 0.06]
mass_kg = 0.1
friction = 0.6
on = "table"
position_m = [0.0, 0.0]
"""


@pytest.fixture
def words(tmp_path):
    def listed(labels=""):
        scene = tmp_path / "scene.toml"
        scene.write_text(SCENE.format(labels=labels))
        result = CliRunner().invoke(app, ["list", "words", "--scene", str(scene)])
        assert result.exit_code == 0, result.output
        return {line.partition(":")[0].strip() for line in result.output.splitlines()}

    return listed


def test_what_can_be_found_there_is_marked_and_nothing_else(words):
    told = words()

    assert {"cup *", "table *", "toy *"} <= told
    assert "teapot" in told
    assert "teapot *" not in told


def test_what_the_scene_declares_is_marked_too(words):
    assert "teapot *" in words('"teapot"')


def test_where_anything_can_be_told_every_thing_is_marked(words):
    assert {"teapot *", "cup *"} <= words('"any"')


def test_no_scene_of_that_name_is_told(words):
    result = CliRunner().invoke(app, ["list", "words", "--scene", "tabeltop"])

    assert result.exit_code != 0

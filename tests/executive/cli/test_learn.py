"""``executive learn`` keeps what is shown, tells what is known, and forgets."""

import numpy as np
import pytest
from PIL import Image
from typer.testing import CliRunner

from executive.cli.app import app

pytestmark = pytest.mark.opengl
SCENE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.7, 1.2, 0.75]
position_m = [0.95, 0.0]

[[object]]
name = "thing"
kind = "can"
radius_m = 0.034
height_m = 0.11
on = "table"
position_m = [-0.23, 0.0]
texture = "front.png"
"""


def learn(*arguments):
    return CliRunner().invoke(app, ["learn", *arguments]).output


@pytest.fixture
def scene(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    front = np.zeros((32, 64, 3), np.uint8)
    front[:, ::4] = 220
    Image.fromarray(front).save(tmp_path / "front.png")
    (tmp_path / "scene.toml").write_text(SCENE)
    return str(tmp_path / "scene.toml")


def test_what_was_shown_is_known_until_it_is_forgotten(scene):
    learn("tomato soup", "--scene", scene, "--views", "3")

    assert learn() == "tomato soup: 3 views\n"
    assert learn("tomato soup", "--forget") == "forgot 3 views of tomato soup\n"
    assert learn() == ""


def test_without_a_scene_nothing_is_shown(scene):
    assert "nothing is shown: --scene" in learn("tomato soup")


def test_what_was_never_shown_cannot_be_forgotten(scene):
    assert "'tea' was never shown; known: nothing" in learn("tea", "--forget")

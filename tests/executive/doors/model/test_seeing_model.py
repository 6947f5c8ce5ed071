"""A model that a user has set up says what the camera's pictures show; without one, nothing is sent."""

import json
import pickle

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from executive.config import CONFIG_VARIABLE, use_config
from executive.doors.model.seeing_model import seeing_model
from executive.front.model_settings import ModelSettingsError
from robots.perception.labels.asking import SilentModelError
from tools.evaluate.front.scripted_server import Answer, ScriptedServer, saying

SOUP = saying({"answers": [{"picture": 1, "label": "tomato soup", "score": 0.95}]})
PARTS = [
    {"type": "text", "text": "what is it?"},
    {"type": "image_url", "image_url": {"url": "data:image/png;base64,"}},
]
SCENE = """
robot_start = { x_m = 0.0, y_m = 0.0, yaw_rad = 0.0 }

[perception]
kind = "rgbd"
labels = ["tomato soup"]

[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.9]
position_m = [0.65, 0.0]
yaw_rad = 0.0

[[object]]
name = "tin"
kind = "can"
color = "white"
radius_m = 0.033
height_m = 0.11
mass_kg = 0.2
on = "table"
position_m = [-0.15, -0.2]
"""


@pytest.fixture
def configure(tmp_path, monkeypatch):
    """Sets up models; answers the file."""

    def configure(text):
        config = tmp_path / "config.toml"
        config.write_text(text)
        use_config(config)
        return config

    monkeypatch.delenv(CONFIG_VARIABLE, raising=False)
    yield configure
    monkeypatch.delenv(CONFIG_VARIABLE, raising=False)


@pytest.fixture
def run(configure, tmp_path):
    """Runs a sentence before a white can, with a server set up as a model."""

    def run(server, text, **keys):
        config, scene = configure(server.settings(**keys)), tmp_path / "soup.toml"
        scene.write_text(SCENE)
        words = ["run", text, "--scene", str(scene), "--config", str(config)]
        return CliRunner().invoke(app, [*words, "--record", str(tmp_path / "runs")])

    return run


def test_a_model_that_sees_is_asked_with_the_pictures_and_its_words_come_back(configure):
    with ScriptedServer(SOUP) as server:
        configure(server.settings(sees=True))
        answer = pickle.loads(pickle.dumps(seeing_model()))(PARTS)

    assert json.loads(answer)["answers"][0]["label"] == "tomato soup"
    [request] = server.requests
    assert request["messages"] == [{"role": "user", "content": PARTS}]
    assert "response_format" not in request


def test_it_is_told_nothing_of_this_machine(configure):
    with ScriptedServer(SOUP) as server:
        configure(server.settings(sees=True))
        seeing_model()(PARTS)

    assert "authorization" not in server.headers
    assert not [name for name in server.headers if name in ("x-stainless-os", "x-stainless-arch")]


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (Answer((b"{}",), 500), "the server answered with an error"),
        (Answer((b"x" * 70_000,)), "the answer is too long to be read"),
        (saying(None, refusal="I cannot"), "the model declined"),
    ],
)
def test_a_model_that_fails_is_silent_for_a_reason(configure, answer, told):
    with ScriptedServer(answer) as server:
        configure(server.settings(sees=True))

        with pytest.raises(SilentModelError, match=f"the model 'scripted': {told}"):
            seeing_model()(PARTS)


def test_a_model_that_is_not_said_to_see_is_asked_nothing(configure):
    with ScriptedServer(SOUP) as server:
        configure(server.settings())

        assert seeing_model() is None


def test_two_models_that_see_are_refused(configure):
    with ScriptedServer(SOUP) as server:
        configure(server.settings("one", sees=True) + server.settings("two", sees=True))

        with pytest.raises(ModelSettingsError, match="'one' and 'two' have sees = true"):
            seeing_model()


@pytest.mark.slow
@pytest.mark.opengl
def test_a_run_with_a_camera_takes_a_thing_by_the_name_that_the_model_gives_it(run):
    with ScriptedServer(SOUP) as server:
        result = run(server, "find the tomato soup", sees=True)

    assert result.exit_code == 0, result.output
    assert "tomato soup" in result.stdout
    assert server.requests


@pytest.mark.slow
@pytest.mark.opengl
def test_where_the_model_answers_badly_that_is_told_and_the_shape_counts(run):
    with ScriptedServer(saying("It looks tasty!")) as server:
        result = run(server, "find the white can", sees=True)

    assert result.exit_code == 0, result.output
    assert "what things are called is not told by a model: its answer has another form" in result.stderr
    assert 1 <= len(server.requests) <= 3


@pytest.mark.slow
@pytest.mark.opengl
def test_no_picture_leaves_a_run_where_no_model_is_said_to_see(run):
    with ScriptedServer(SOUP) as server:
        result = run(server, "find the white can")

    assert result.exit_code == 0, result.output
    assert not server.requests

"""Pictures and films, where this machine can make them, and clear words where it cannot."""

import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from robots.errors import RenderingUnavailableError
from robots.scenes.scene_file import load_scene
from robots.simulated.pictures import opengl, rendering


@pytest.fixture
def body(stand):
    return stand(load_scene("tabletop"))


@pytest.mark.opengl
@pytest.mark.parametrize("camera", ["overview", "grasp"])
def test_a_picture_shows_the_robot(body, tmp_path, camera):
    path = tmp_path / "picture.png"

    rendering.snapshot(body.world, path, size=(320, 240), camera=camera)
    pixels = np.asarray(Image.open(path))

    assert pixels.shape == (240, 320, 3)
    assert pixels.std() > 15.0


@pytest.mark.opengl
def test_the_red_cup_is_in_the_overview(body, tmp_path):
    with rendering.Renderer(body.world, (320, 240)) as renderer:
        pixels = renderer.draw("overview").astype(int)

    red = (pixels[..., 0] > 100) & (pixels[..., 1] < 60) & (pixels[..., 2] < 60)
    assert red.sum() > 30


@pytest.mark.opengl
def test_drawing_does_not_change_the_course_of_things(stand):
    def after(draw):
        body = stand(load_scene("tabletop"))
        body.run(0.02)
        if draw:
            with rendering.Renderer(body.world, (64, 48), fine=False) as renderer:
                renderer.draw()
        body.run(0.02)
        return body.world.physics.data.qpos.tobytes()

    assert after(draw=True) == after(draw=False)


@pytest.mark.opengl
def test_a_film_has_a_frame_for_every_twenty_fifth_of_a_second(body, tmp_path):
    path = tmp_path / "film.mp4"
    try:
        film = rendering.VideoRecorder(body.world, path, size=(160, 120))
    except RenderingUnavailableError as missing:
        pytest.skip(str(missing))
    drawn = []
    draw = film._renderer.draw
    film._renderer.draw = lambda camera: drawn.append(camera) or draw(camera)
    body.run(0.2, film.tick)
    film.close()
    film.close()
    counted = subprocess.run(
        [rendering.require_ffmpeg(), "-i", str(path), "-f", "null", "-"], capture_output=True, text=True
    )

    assert len(drawn) == 5
    assert int(counted.stderr.rpartition("frame=")[2].split()[0]) == 5 + 12  # the last one stands still
    assert path.read_bytes()[4:8] == b"ftyp"


@pytest.mark.opengl
def test_a_film_that_cannot_be_written_says_why(body, tmp_path):
    try:
        film = rendering.VideoRecorder(body.world, tmp_path / "no" / "such" / "folder.mp4", size=(160, 120))
    except RenderingUnavailableError as missing:
        pytest.skip(str(missing))

    with pytest.raises(RenderingUnavailableError, match="ffmpeg could not write"):
        film.close()


def test_without_an_opengl_library_the_debian_packages_are_named(monkeypatch, body, tmp_path):
    monkeypatch.setattr(opengl, "_library", lambda name: None)

    with pytest.raises(RenderingUnavailableError, match=r"libegl1 .* or libosmesa6") as caught:
        rendering.snapshot(body.world, tmp_path / "picture.png")

    assert "\n" not in str(caught.value)
    with pytest.raises(RenderingUnavailableError):
        rendering.require_rendering(video=False)


def test_without_ffmpeg_its_package_is_named(monkeypatch):
    monkeypatch.setattr(rendering.shutil, "which", lambda name: None)

    with pytest.raises(RenderingUnavailableError, match="Debian package ffmpeg"):
        rendering.require_ffmpeg()


def test_the_simulator_runs_where_no_opengl_library_is_chosen():
    """The physics never asks for OpenGL, also when the environment switches it off."""
    code = (
        "import numpy as np; from robots.models.description import load_robot; "
        "from robots.scenes.scene_file import load_scene; from robots.simulated.world import build_world; "
        "build_world(load_robot('talos'), load_scene('tabletop'), np.random.default_rng(0))"
    )
    environment = {**os.environ, "MUJOCO_GL": "disabled"}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)

    assert done.returncode == 0, done.stderr

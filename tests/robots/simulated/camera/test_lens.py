"""Errors of the camera, as its data declare them."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from robots.interface.depth_camera import CameraErrors, DepthCamera
from robots.simulated.camera.lens import Lens
from robots.simulated.camera.orders import LensFaults

CAMERA = DepthCamera("head", "optical", 523.3)
SHAPE = CAMERA.height_px, CAMERA.width_px
GREY = np.full((*SHAPE, 3), 120, np.uint8)


def wall(depth_m):
    return np.full(SHAPE, depth_m, np.float32)


def spoiled(color=GREY, depth=None, light="bright", sequence=1, seed=(7,), camera=CAMERA, faults=None):
    depth = wall(1.0) if depth is None else depth
    return Lens(camera, seed).spoil(color, depth, light, sequence, faults or LensFaults())


@pytest.mark.parametrize("depth_m", [0.4, 1.0, 2.0])
def test_depth_noise_grows_with_the_square_of_the_distance(depth_m):
    _, depth = spoiled(depth=wall(depth_m))

    off = depth[depth > 0.0] - depth_m
    assert off.std() == pytest.approx(0.0012 + 0.0019 * (depth_m - 0.4) ** 2, rel=0.1)
    assert abs(off.mean()) < 2e-4


def test_depth_noise_is_alike_in_neighbouring_pixels():
    _, depth = spoiled()

    off = depth - 1.0
    assert np.corrcoef(off[:, :-1].ravel(), off[:, 1:].ravel())[0, 1] > 0.7
    assert abs(np.corrcoef(off[:, :-20].ravel(), off[:, 20:].ravel())[0, 1]) < 0.05


def test_returns_are_missing_where_depth_jumps_and_nowhere_else():
    depth = wall(1.0)
    depth[:, 320:] = 1.5

    _, told = spoiled(depth=depth)

    lost = (told <= 0.0).mean(axis=0)
    assert lost[319] == pytest.approx(CAMERA.errors.edge_loss, abs=0.1)
    assert lost[320] == pytest.approx(CAMERA.errors.edge_loss, abs=0.1)
    assert lost[:310].max() == lost[330:].max() == 0.0


def test_dark_surfaces_return_less():
    dark = np.full((*SHAPE, 3), 12, np.uint8)

    _, told = spoiled(color=dark)

    assert (told <= 0.0).mean() == pytest.approx(CAMERA.errors.dark_loss, abs=0.05)


def test_what_is_out_of_range_returns_nothing():
    assert not spoiled(depth=wall(0.2))[1].any()


def test_dim_light_is_made_up_for_by_exposure_at_the_price_of_noise():
    light_grey = np.full((*SHAPE, 3), 200, np.uint8)
    bright, dim = (spoiled(light_grey, light=light)[0].astype(float) for light in ("bright", "dim"))

    assert dim.mean() == pytest.approx(bright.mean(), rel=0.15)
    assert dim.std() > 1.5 * bright.std()


def test_warm_light_takes_blue_away():
    red, _, blue = spoiled(light="warm")[0].reshape(-1, 3).mean(axis=0)

    assert blue < 0.6 * red


def test_a_picture_is_the_same_when_it_is_taken_again_and_another_one_the_next_time():
    first, again, other = spoiled(sequence=3)[1], spoiled(sequence=3)[1], spoiled(sequence=4)[1]

    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)


def test_the_error_of_calibration_is_drawn_once_for_an_episode():
    lens = Lens(CAMERA, (7,))
    first = lens.place_error(LensFaults())
    lens.spoil(GREY, wall(1.0), "bright", 1, LensFaults())

    assert np.array_equal(lens.place_error(LensFaults()), first)


def test_calibration_errs_as_its_data_say():
    errors = [Lens(CAMERA, (seed,)).camera_error for seed in range(40)]
    turns = np.array([poses.vector_from_rotation(error[:3, :3]) for error in errors])
    shifts = np.array([error[:3, 3] for error in errors])

    assert turns.std() == pytest.approx(0.003, rel=0.25)
    assert shifts.std() == pytest.approx(0.002, rel=0.25)


def test_a_camera_without_errors_tells_the_truth():
    exact = CameraErrors(
        0.0, 0.0, depth_step_m=0.0, edge_loss=0.0, color_noise=0.0, turn_rad=0.0, shift_m=0.0
    )

    _, depth = spoiled(camera=replace(CAMERA, errors=exact))

    assert np.array_equal(depth, wall(1.0))


@pytest.mark.parametrize(
    ("faults", "lost"),
    [(LensFaults(stain=0.1), 0.1), (LensFaults(no_depth=0.4), 0.4), (LensFaults(covered=True), 1.0)],
)
def test_faults_take_depth_away(faults, lost):
    _, depth = spoiled(faults=faults)

    assert (depth <= 0.0).mean() == pytest.approx(lost, abs=0.03)


def test_a_dark_room_stays_dark_and_a_lamp_outshines_the_picture():
    dark, glare = spoiled(faults=LensFaults(light=0.003))[0], spoiled(faults=LensFaults(glare=0.8))[0]

    assert dark.mean() < 20.0
    assert (glare[:200] == 255).mean() > 0.9

from dataclasses import replace

import numpy as np

from robots.perception.rgbd.watch import PictureWatch

RED = (217, 26, 20)


def test_a_good_picture_has_nothing_wrong(take):
    assert PictureWatch().judge(take([])) is None


def test_the_same_picture_three_times_is_a_frozen_camera(take):
    watch, picture = PictureWatch(), take([])

    assert [watch.judge(picture) for _ in range(3)] == [None, None, "frozen"]


def test_pictures_that_differ_in_noise_alone_are_not_frozen(take):
    watch, rng = PictureWatch(), np.random.default_rng(0)
    told = []
    for _ in range(5):
        picture = take([])
        picture.depth_m[:] += rng.normal(0.0, 1e-3, picture.depth_m.shape)
        told.append(watch.judge(picture))

    assert told == [None] * 5


def test_a_dark_picture_is_told(take):
    assert PictureWatch().judge(take([], tint=(0.05, 0.05, 0.05))) == "dark"


def test_a_good_picture_hinders_nobody(take):
    assert PictureWatch.hindrance(take([])) is None


def test_a_picture_that_is_nearly_dark_says_so_through_its_noise(take):
    picture, rng = take([], tint=(0.25, 0.25, 0.25)), np.random.default_rng(0)
    noise = rng.normal(0.0, 20.0, picture.color.shape)
    noisy = replace(picture, color=np.clip(picture.color + noise, 0, 255).astype(np.uint8))

    assert PictureWatch().judge(noisy) is None
    assert "dark" in PictureWatch.hindrance(noisy)


def test_a_lamp_in_a_part_of_the_picture_is_told(take):
    picture = take([])
    picture.color[:60] = 255

    assert "outshone" in PictureWatch.hindrance(picture)


def test_a_stain_on_the_lens_is_told(take):
    picture = take([])
    picture.depth_m[80:200, 60:260] = 0.0

    assert "dirty" in PictureWatch.hindrance(picture)


def test_an_outshone_picture_is_told(take):
    picture = take([])
    picture.color[:200] = 255

    assert PictureWatch().judge(picture) == "outshone"


def test_missing_depth_is_told(take):
    picture = take([])
    picture.depth_m[:200] = 0.0

    assert PictureWatch().judge(picture) == "no depth"

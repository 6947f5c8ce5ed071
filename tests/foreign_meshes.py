"""Meshes of things that nobody here made, made at test time: with another axis up, in other units, hollow."""

from pathlib import Path

import numpy as np
import pytest

trimesh = pytest.importorskip("trimesh")

LATHE_SECTIONS = 48


def lathe(profile):
    """A thing of revolution about z from (radius, height) pairs."""
    return trimesh.creation.revolve(np.array(profile, dtype=float), sections=LATHE_SECTIONS)


def can(radius_m=0.033, height_m=0.101):
    rim = 0.0015
    return lathe(
        [
            (0, 0),
            (radius_m - rim, 0),
            (radius_m, rim),
            (radius_m, height_m - rim),
            (radius_m - rim, height_m),
            (0, height_m),
        ]
    )


def carton(size_m=(0.062, 0.09, 0.16)):
    return trimesh.creation.box(size_m)


def bottle(radius_m=0.032, height_m=0.22, shoulder=0.55):
    neck = 0.4 * radius_m
    return lathe(
        [
            (0, 0),
            (radius_m, 0),
            (radius_m, shoulder * height_m),
            (neck, (shoulder + 0.23) * height_m),
            (neck, height_m),
            (0, height_m),
        ]
    )


def bowl(radius_m=0.07, height_m=0.05, wall_m=0.004):
    foot = 0.5 * radius_m
    return lathe(
        [
            (0, 0),
            (foot, 0),
            (radius_m, height_m),
            (radius_m - wall_m, height_m),
            (foot - wall_m, wall_m),
            (0, wall_m),
        ]
    )


def mug(radius_m=0.038, height_m=0.095, wall_m=0.004):
    """A hollow one, with its handle along x."""
    body = lathe(
        [
            (0, 0),
            (radius_m, 0),
            (radius_m, height_m),
            (radius_m - wall_m, height_m),
            (radius_m - wall_m, wall_m),
            (0, wall_m),
        ]
    )
    angles = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 9)
    ring = np.stack(
        [radius_m - 0.003 + 0.025 * np.cos(angles), 0 * angles, 0.5 * height_m + 0.03 * np.sin(angles)],
        axis=1,
    )
    pieces = [
        trimesh.creation.cylinder(0.005, segment=[ring[k], ring[k + 1]], sections=8)
        for k in range(len(ring) - 1)
    ]
    return trimesh.util.concatenate([body, *pieces])


def plate(radius_m=0.1, height_m=0.012):
    return lathe([(0, 0), (0.7 * radius_m, 0), (radius_m, height_m), (0, 0.6 * height_m)])


def pebble(rng, size_m=0.05):
    """An irregular convex one."""
    return trimesh.convex.convex_hull(rng.normal(size=(30, 3)) * size_m * rng.uniform(0.3, 0.6, 3))


def written(mesh, folder: Path, name: str, up="+z", unit=1.0):
    """A file of it with another axis up, in units of so many metres."""
    turned = mesh.copy()
    if up == "+y":
        turned.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, (1, 0, 0)))
    turned.apply_scale(1.0 / unit)
    file = folder / name
    turned.export(file)
    return file

"""Views are kept as pictures, by name, and read back as they were."""

import numpy as np

from robots.perception.labels import views as kept
from robots.perception.labels.views import forget_views, keep_views, kept_views, known_names
from tests.robots.perception.labels.conftest import package, views


def test_views_are_read_back_as_they_were_kept(tmp_path):
    shown = views(package(1), package(2))

    keep_views(tmp_path, "Tomato soup", shown)
    read = kept_views(tmp_path)["Tomato soup"]

    assert all(np.array_equal(a.color, b.color) for a, b in zip(shown, read, strict=True))
    assert all(np.array_equal(a.mask, b.mask) for a, b in zip(shown, read, strict=True))


def test_the_oldest_views_go_when_there_are_too_many(tmp_path, monkeypatch):
    monkeypatch.setattr(kept, "MOST_VIEWS", 3)

    assert keep_views(tmp_path, "soup", views(*map(package, range(5)))) == 3
    assert known_names(tmp_path) == {"soup": 3}


def test_a_forgotten_thing_leaves_nothing(tmp_path):
    keep_views(tmp_path, "soup", views(package(1)))

    assert forget_views(tmp_path, "soup") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_is_no_view_is_left_out(tmp_path):
    keep_views(tmp_path, "soup", views(package(1)))
    (tmp_path / "soup" / "view-0002.png").write_bytes(b"no picture")

    assert len(kept_views(tmp_path)["soup"]) == 1


def test_nothing_is_known_where_nothing_was_shown(tmp_path):
    assert kept_views(tmp_path / "nowhere") == {}

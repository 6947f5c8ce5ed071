"""Where somebody is who is watched."""

import pytest

from trees.skills.follow.person_track import PersonTrack


@pytest.fixture
def track():
    return PersonTrack("Ana", 1.0, 0.0, 0.0, still_m=0.12)


def walks(track, speed_m_s, seconds, period_s=0.1):
    x_m, began_s = track.x_m, track.seen_s
    for k in range(1, round(seconds / period_s) + 1):
        track.take(x_m + k * period_s * speed_m_s, 0.0, began_s + k * period_s)


@pytest.mark.parametrize(
    ("name", "x_m", "seen_s", "fits"),
    [
        ("Ana", 1.3, 0.1, True),
        ("Ben", 1.0, 0.1, False),
        (None, 1.3, 0.1, True),
        (None, 3.0, 0.1, False),
        (None, 3.0, 1.0, True),
    ],
)
def test_a_sighting_fits_by_its_name_and_by_how_far_one_walks(track, name, x_m, seen_s, fits):
    assert track.fits(name, x_m, 0.0, seen_s) is fits


def test_who_walks_has_walked_and_does_not_stand(track):
    walks(track, 0.4, 2.0)

    assert track.walked
    assert track.still_s < 0.5


def test_who_stands_after_a_walk_is_seen_to_stand(track):
    walks(track, 0.4, 2.0)
    walks(track, 0.0, 3.0)

    assert track.still_s == pytest.approx(3.0, abs=0.35)


def test_the_sway_of_the_own_walk_is_no_walk_of_the_person(track):
    for k in range(40):
        track.take(1.0 + 0.04 * (-1) ** k, 0.0, 0.1 * (k + 1))

    assert not track.walked


def test_nobody_is_held_to_stand_while_out_of_sight(track):
    walks(track, 0.4, 2.0)

    assert track.still_s < 0.5  # however long ago that was


def test_where_somebody_is_by_now_goes_on_as_the_walk_did(track):
    walks(track, 0.4, 2.0)

    assert track.place(2.5)[0] == pytest.approx(track.x_m + 0.2, abs=0.02)


def test_nobody_is_expected_farther_away_the_longer_they_are_unseen(track):
    walks(track, 0.4, 2.0)

    assert track.place(60.0)[0] - track.x_m < 0.5

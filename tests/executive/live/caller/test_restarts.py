"""An executive that ends is replaced at a rate, however long the robot has been served."""

from executive.live.caller.restarts import Restarts


def test_so_many_within_the_window_are_too_many():
    restarts = Restarts(most=3, within_s=100.0)

    assert [restarts.take(now_s) for now_s in (1.0, 2.0, 3.0, 4.0)] == [True, True, True, False]


def test_what_was_before_the_window_counts_no_more():
    restarts = Restarts(most=3, within_s=100.0)

    assert all(restarts.take(60.0 * times) for times in range(50))


def test_one_that_commands_for_long_enough_is_well_and_begins_the_count_anew():
    restarts = Restarts(most=1, within_s=1000.0, well_after_s=60.0)
    restarts.take(0.0)
    restarts.note_health(True, 10.0)
    restarts.note_health(True, 70.0)

    assert restarts.take(71.0)


def test_one_that_commands_now_and_then_is_not_well():
    restarts = Restarts(most=1, within_s=1000.0, well_after_s=60.0)
    restarts.take(0.0)
    for now_s, commands in ((10.0, True), (40.0, False), (50.0, True), (100.0, True)):
        restarts.note_health(commands, now_s)

    assert not restarts.take(101.0)

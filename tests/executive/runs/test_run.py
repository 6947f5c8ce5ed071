"""The garbage collector leaves what was built before alone, and only as long as it should."""

import gc

from executive.runs.run import frozen_heap


def test_what_exists_is_left_alone_until_the_end():
    before = gc.get_freeze_count()

    with frozen_heap():
        during = gc.get_freeze_count()

    assert during > before
    assert gc.get_freeze_count() == 0

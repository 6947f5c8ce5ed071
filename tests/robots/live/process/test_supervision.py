"""A control process knows whether the process that started it is there, and says once that it is not."""

import pytest

from robots.live.process.supervision import Supervision


class Parent:
    pid = 700

    def __call__(self):
        return self.pid


@pytest.mark.requirement("S3")
def test_a_supervisor_that_has_gone_is_none_and_that_is_said_once():
    parent = Parent()
    supervision = Supervision(700, parent)
    assert (supervision.supervisor, supervision.news()) == (700, None)

    parent.pid = 1  # whoever takes in processes without a parent

    assert supervision.supervisor is None
    assert "process 700, has gone" in supervision.news()
    assert supervision.news() is None


def test_one_that_is_never_supervised_has_nothing_to_say():
    supervision = Supervision(None)

    assert (supervision.supervisor, supervision.news()) == (None, None)

import pytest

from robots.control.gate.authority import HOLD, STOP, Authority, together


@pytest.fixture
def authority():
    return Authority(["shoulder", "elbow", "finger"])


def test_a_joint_has_one_holder_and_the_second_is_told_who(authority):
    assert authority.claim("reach", ["shoulder", "elbow"]) is None

    assert authority.claim("jog", ["finger", "elbow"]) == ("elbow", "reach")
    assert authority.holder("finger") is None


def test_a_released_joint_can_be_claimed_again(authority):
    authority.claim("reach", ["elbow"])
    authority.release("reach")

    assert authority.claim("jog", ["elbow"]) is None
    assert authority.holder("elbow") == "jog"


def test_an_owner_may_move_what_he_holds_and_nothing_else(authority):
    authority.claim("reach", ["elbow"])

    assert authority.forbidden("reach").tolist() == [True, False, True]
    assert authority.forbidden("stranger").all()
    assert authority.forbidden(HOLD).all()


def test_a_permission_ends_with_the_release(authority):
    authority.claim("reach", ["elbow"])
    assert not authority.forbidden("reach").all()

    authority.release("reach")

    assert authority.forbidden("reach").all()


def test_owners_side_by_side_hold_together(authority):
    authority.claim("reach", ["shoulder", "elbow"])
    authority.claim("close", ["finger"])

    assert authority.forbidden(together(["reach", "close"])) is None
    assert together([]) == HOLD


def test_a_stop_may_move_everything_whoever_holds_it(authority):
    authority.claim("reach", ["elbow"])

    assert authority.forbidden(STOP) is None

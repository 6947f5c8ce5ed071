"""Ask whether a door or drawer is as it should be already."""

from __future__ import annotations

from trees.leaves.verify_opening import VerifyOpening


class IsItSo(VerifyOpening):
    """As ``VerifyOpening``, before anything is moved; that it is not so is an answer."""

    ASKS = True

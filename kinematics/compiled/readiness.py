"""Whether the kernel can be used at once, and what makes it so; see also ``kinematics.warming``."""

from __future__ import annotations

import functools

from kinematics.compiled import cache


def ready() -> bool:
    """Tell whether all compiled code of the present sources is on disk for this processor.

    Looks at each file's end, not at what is in it; ``cache.damaged`` does.
    Who plans goes on with Coal when it is not: nobody waits for a compiler unasked.
    """
    return cache.is_complete()


@functools.cache
def usable() -> bool:
    """``ready``, asked once: one run has one judge."""
    return ready()

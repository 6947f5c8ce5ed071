"""What a thing is called by who is not sure: with what it may be as well."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.scene.label import Label


@dataclass(frozen=True, slots=True)
class SeenLabel(Label):
    """A label of something that looks much like other things.

    Attributes:
        alike: Kinds and names that it may have as well, the likelier first.
    """

    alike: tuple[str, ...] = ()

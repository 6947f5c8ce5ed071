"""Where the soles of a standing robot are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kinematics.arrays import Array, Sealed, sealed
from kinematics.geometry.poses import Transform
from kinematics.model.robot_model import RobotModel


@dataclass(frozen=True, slots=True)
class Stance(Sealed):
    """The soles that carry and where they stand: sole frame name to ``world_T_sole``.

    Raises:
        InvalidArrayError: A pose is no array of real numbers.
    """

    soles: tuple[tuple[str, Transform], ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "soles", tuple((frame, sealed(pose, frame)) for frame, pose in self.soles))

    @property
    def key(self) -> tuple[tuple[str, bytes], ...]:
        """The same for stances that are equal to the bit, for tables of what was computed once."""
        return tuple((frame, pose.tobytes()) for frame, pose in self.soles)

    @property
    def height_m(self) -> float:
        """Height of the plane that the soles stand on, where the ZMP is: their mean; 0 without soles."""
        return sum(float(pose[2, 3]) for _, pose in self.soles) / max(len(self.soles), 1)


def stance_at(model: RobotModel, q: Array, frames: Sequence[str] | None = None) -> Stance:
    """Return the stance of the soles where a configuration has them.

    Args:
        model: The robot.
        q: Configuration, shape (nq,).
        frames: Names of the sole frames that carry; all soles of the robot when left out (a welded
            robot has none, so its stance is empty).

    Raises:
        UnknownNameError: A frame is not in the model.
    """
    names = [sole.frame for sole in model.description.soles] if frames is None else list(frames)
    return Stance(tuple(zip(names, model.frame_poses(q, names), strict=True)))

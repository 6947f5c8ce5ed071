"""Tolerances that judges and gate share."""

from __future__ import annotations

SETPOINT_FRACTION = 1e-4
"""Setpoints may pass limits of speed, acceleration and jerk by this fraction: a brake is judged by
differences along a path that uses its limits fully, and where one was refused for a millionth, a harder one
was left."""

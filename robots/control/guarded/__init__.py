"""Motions that are made as they go, each setpoint judged before the gate."""

"""The process that records a run in lockstep: it writes what comes through its standard input, to its end."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from executive.doors.recorder.recorder import Recorder
from executive.doors.recorder.told_apart import EVENT, STATE, TREE, frames
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from robots.perception.rgbd.picture_slot import PictureSlotReader


def main(path: str, robot: str, about: str, zero_ns: str, slot: str = "") -> int:
    """Write an MCAP file until the input ends."""
    pictures = PictureSlotReader(Path(slot)) if slot else None
    try:
        if pictures is not None:
            pictures.want(True)
        recorder = Recorder(
            Path(path), RobotModel(load_description(robot)), json.loads(about), int(zero_ns) or None
        )
        for kind, value in frames(sys.stdin.buffer):
            if kind == STATE:
                recorder.state(value)
                if pictures is not None and (shown := pictures.newest()) is not None:
                    recorder.picture(shown)
            elif kind == EVENT:
                recorder.event(value["told"], value["line"])
            elif kind == TREE:
                recorder.tree(float(value["t_s"]), value["nodes"])
            else:
                recorder.world(float(value["t_s"]), value["world"])
        recorder.close()
    except OSError as failed:
        sys.stderr.write(f"executive: the run's motion is not recorded: {failed.strerror or failed}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

"""What the packages import is declared: an install brings it, whatever else brings it today."""

import importlib.metadata
import re
import sys
import tomllib
from pathlib import Path

from source import modules

PROJECT = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())["project"]
OWN = {"executive", "trees", "robots", "kinematics", "tools"}
# Their wheels do not tell what they bring.
UNTOLD = {
    "pinocchio": ["pin"],
    "coal": ["coal"],
    "placo": ["placo"],
    "ruckig": ["ruckig"],
    "example_robot_data": ["example-robot-data"],
}
# Referees that the development environment alone has.
REFEREES = {"behaviortreepy", "scipy", "jsonschema"}
# What a user of ROS has, for the node that runs there.
ROS = {
    "rclpy",
    "std_srvs",
    "test_msgs",
    "humanoid_executive_interfaces",
    "unique_identifier_msgs",
    "control_msgs",
}
# What stands beside the node, which is started as a file.
NODE = Path(__file__).parents[2] / "executive" / "doors" / "ros" / "node"
ROS |= {path.stem for path in NODE.glob("*.py")}


def test_every_library_that_is_imported_is_declared():
    names = ("ros", "mcp", "models", "camera", "view", "record", "groot")
    extras = [line for name in names for line in PROJECT["optional-dependencies"][name]]
    declared = {
        re.match(r"[\w-]+", line)[0].lower().replace("_", "-") for line in [*PROJECT["dependencies"], *extras]
    }
    providers = importlib.metadata.packages_distributions()
    imported = {
        (name.split(".")[0], module.file)
        for module in modules()
        if module.package != "tools"
        for _, name in module.imports()
    }

    undeclared = {
        (library, file)
        for library, file in imported
        if library not in OWN | set(sys.stdlib_module_names) | REFEREES | ROS
        and not declared
        & {one.lower().replace("_", "-") for one in UNTOLD.get(library) or providers.get(library, [])}
    }

    assert not undeclared

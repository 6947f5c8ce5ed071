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


def test_every_library_that_is_imported_is_declared():
    declared = {re.match(r"[\w-]+", line)[0].lower().replace("_", "-") for line in PROJECT["dependencies"]}
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
        if library not in OWN | set(sys.stdlib_module_names) | REFEREES
        and not declared
        & {one.lower().replace("_", "-") for one in UNTOLD.get(library) or providers.get(library, [])}
    }

    assert not undeclared

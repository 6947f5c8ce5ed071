"""The rules of the architecture, each shown to catch a breach, then held against every file."""

from __future__ import annotations

import ast
import re

import pytest
from source import Module, modules, parse

LAYERS = ("tools", "executive", "trees", "robots", "kinematics")

# Who may import what; a library that is not named here is free. "kinematics" and "robots" are prefixes.
HEAVY = {
    "mujoco": ("robots.simulated",),
    "py_trees": ("trees",),
    "placo": ("kinematics", "tools"),
    "pinocchio": ("kinematics", "tools"),
    "coal": ("kinematics", "tools"),
    "ruckig": ("kinematics", "tools"),
    "ompl": ("kinematics", "tools"),
    "typer": ("executive",),
    "rich": ("executive", "tools"),
    "cv2": ("robots.perception.rgbd", "robots.perception.labels", "robots.simulated.camera", "tools"),
    "cyclonedds": ("executive.doors.ros", "robots.unitree", "tools"),
    "mcp": ("executive.doors.mcp", "tools.evaluate.mcp"),
    "uvicorn": ("executive.doors.mcp",),
    "openai": ("executive.doors.model",),
    "mcap": ("executive.doors.recorder", "executive.doors.view.motion_read"),
    "zmq": ("executive.doors.groot",),
    "msgpack": ("executive.doors.groot",),
    "viser": ("executive.doors.view",),
    "trimesh": ("executive.doors.view",),
    "websockets": ("executive.doors.view",),
    "rclpy": ("executive.doors.ros.node", "tools.evaluate.ros.client"),
}
# The simulator's truth is for sensors that are simulated and for those who judge.
TRUTH = ("robots.simulated.truth", "robots.perception.truth_view")
TRUTH_USERS = (
    "robots.perception.stub", "robots.perception.sight", "robots.simulated", "robots.fake",
    "executive.session.assembly", "tools",
)  # fmt: skip
# Scripts that run in other environments than the product's: nobody imports them.
ELSEWHERE = ("tools.benchmark.peers.runners", "executive.doors.ros.node", "tools.evaluate.ros.client")
# Who makes a secret that nobody may guess: the one thing for which randomness is not injected.
SECRETS = ("executive.doors.mcp.serving", "executive.doors.view.access")
# The one place that opens sockets, and no others than those of this machine.
LOCAL_SOCKETS = "robots.live.wire.unix_socket"
# The one place that speaks over a network, to the server that a user has named.
MODEL_CLIENT = "executive.doors.model.client"
# Clients of this program's own MCP server, on loopback.
MCP_CLIENTS = "tools.evaluate.mcp"
# The one place that serves a scripted model, on loopback, for those who judge.
SCRIPTED = "tools.evaluate.front.scripted_server"
NETWORK = (
    "socket",
    "ssl",
    "http",
    "urllib.request",
    "requests",
    "httpx",
    "httpx2",
    "aiohttp",
    "ftplib",
    "smtplib",
)
WALL_CLOCK = re.compile(
    r"(time\.(time|time_ns|monotonic|monotonic_ns|perf_counter|perf_counter_ns|sleep|process_time|localtime"
    r"|gmtime|strftime)|datetime\.(datetime\.)?(now|utcnow|today)|datetime\.date\.today)$"
)
GLOBAL_RANDOM = re.compile(r"(random|secrets|uuid\.uuid[14])(\.|$)|os\.urandom$|numpy\.random\.[a-z]\w*$")
# What the judge of motions shares with those who plan them: what is judged, in which
# form its numbers come, and how far two solids are apart.
JUDGE = "kinematics.checking"
SHARED_WITH_THE_JUDGE = tuple(
    f"kinematics.{name}"
    for name in ("arrays", "compiled", "distance", "errors", "geometry", "model", "motion", "scene")
)  # fmt: skip
# What the standard library says is there to be set.
MEANT_TO_BE_SET = ("sys.stdin", "sys.stdout", "sys.stderr", "os.environ")
SEALED = ("kinematics.motion.verdict", "kinematics.checking.trajectory_checker")


def _within(name: str, places: tuple[str, ...]) -> bool:
    return any(name == place or name.startswith(f"{place}.") for place in places)


def wrong_layer(module: Module) -> list[str]:
    """Imports of a layer above."""
    rank = LAYERS.index(module.package)
    return [
        f"{module.file}:{line}: {module.package} must not import {name}"
        for line, name in module.imports()
        if name.split(".")[0] in LAYERS and LAYERS.index(name.split(".")[0]) < rank
    ]


def wrong_library(module: Module) -> list[str]:
    """Heavy libraries outside the place that is theirs, and any network."""
    found = []
    for line, name in module.imports():
        library = name.split(".")[0]
        if library in HEAVY and not _within(module.name, (*HEAVY[library], *ELSEWHERE)):
            found.append(f"{module.file}:{line}: {library} belongs to {' and '.join(HEAVY[library])}")
        mine = _within(module.name, (LOCAL_SOCKETS, *ELSEWHERE)) and name == "socket"
        mine |= module.name == MODEL_CLIENT and name == "httpx2"
        mine |= _within(module.name, (MCP_CLIENTS,)) and name == "httpx2"
        mine |= module.name == SCRIPTED and _within(name, ("http.server",))
        if _within(name, NETWORK) and not mine:
            found.append(f"{module.file}:{line}: nothing here speaks over a network ({name})")
    if module.name == LOCAL_SOCKETS:
        found += [
            f"{module.file}:{line}: only sockets of this machine ({name})"
            for line, name in module.calls()
            if name == "socket.create_connection" or re.match(r"socket\.AF_(?!UNIX$)", name)
        ]
    return found


def wall_clock(module: Module) -> list[str]:
    """Readings of the wall clock outside robots/clock.py; tools may count their processor time."""
    if _within(module.name, ("robots.clock", *ELSEWHERE)):
        return []
    return [
        f"{module.file}:{line}: {name}"
        for line, name in module.calls()
        if WALL_CLOCK.match(name) and not (module.package == "tools" and name == "time.process_time")
    ]


def global_random(module: Module) -> list[str]:
    """Randomness that nobody injected; making a Generator from a given seed is allowed."""
    secret = _within(module.name, SECRETS)
    called = [name for name in module.calls() if not (secret and name[1].startswith("secrets"))]
    return [f"{module.file}:{line}: {name}" for line, name in called if _is_global_random(name)] + [
        f"{module.file}:{node.lineno}: default_rng() without a seed"
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr == "default_rng"
        and not node.args
        and not node.keywords
    ]


def _is_global_random(name: str) -> bool:
    return bool(GLOBAL_RANDOM.match(name)) and not name.endswith((".default_rng", ".bit_generator"))


def truth(module: Module) -> list[str]:
    """The simulator's truth in other hands than its allowed users'."""
    if _within(module.name, (*TRUTH_USERS, *TRUTH)):
        return []
    return [f"{module.file}:{line}: {name}" for line, name in module.imports() if _within(name, TRUTH)]


def seal(module: Module) -> list[str]:
    """Use of the seal that makes a trajectory a checked one."""
    if module.name in SEALED:
        return []
    return [
        f"{module.file}:{node.lineno}: only the checker seals a trajectory"
        for node in ast.walk(module.tree)
        if (isinstance(node, ast.Name) and node.id == "_Seal")
        or (isinstance(node, ast.Attribute) and node.attr == "_Seal")
        or (isinstance(node, ast.alias) and node.name == "_Seal")
    ]


def judge(module: Module) -> list[str]:
    """What the judge of motions has from those who plan them, beyond what is told in ADR 0007."""
    if not _within(module.name, (JUDGE,)):
        return []
    return [
        f"{module.file}:{line}: the checker shares no {name} with the planner"
        for line, name in module.imports()
        if name.startswith("kinematics.")
        and not _within(name, (JUDGE,))
        and not _within(name, SHARED_WITH_THE_JUDGE)
    ]


def commander(module: Module) -> list[str]:
    """Calls of a robot's ``command`` beside the gate; robots themselves define it.

    A robot around another one passes on what it is commanded, and nothing else.
    """
    if module.name == "robots.control.gate.setpoint_gate":
        return []
    passed_on = {
        id(node)
        for robot in ast.walk(module.tree)
        if isinstance(robot, ast.ClassDef) and {"read", "command", "advance"} <= _methods(robot).keys()
        for node in ast.walk(_methods(robot)["command"])
        if ast.unparse(_methods(robot)["command"].body[-1]) == "self._robot.command(setpoint)"
    }
    return [
        f"{module.file}:{node.lineno}: only the gate commands a robot"
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Attribute) and node.attr == "command" and "robot" in ast.unparse(node.value)
        if id(node) not in passed_on
    ]


def _methods(of: ast.ClassDef) -> dict[str, ast.FunctionDef]:
    return {node.name: node for node in of.body if isinstance(node, ast.FunctionDef)}


def environment(module: Module) -> list[str]:
    """Readings of the environment outside executive/config.

    Evaluations set that of their workers; the node of ROS, a program of its own, that of its middleware.
    """
    allowed = (
        "executive.config",
        "tools",
        "robots.simulated.pictures.rendering",
        "executive.doors.ros.node.fast_dds",
    )
    if _within(module.name, allowed):
        return []
    return [
        f"{module.file}:{line}: {name}"
        for line, name in module.calls()
        if name in ("os.environ", "os.getenv", "os.putenv")
    ]


def imported_again(module: Module) -> list[str]:
    """Late imports of what the file has imported at its top already: they put nothing off."""
    at_top = {node.module for node in module.tree.body if isinstance(node, ast.ImportFrom)}
    return [
        f"{module.file}:{node.lineno}: {node.module} is imported at the top already"
        for function in ast.walk(module.tree)
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef)
        for node in ast.walk(function)
        if isinstance(node, ast.ImportFrom) and node.module in at_top
    ]


def around(module: Module) -> list[str]:
    """Surroundings that somebody puts together by hand: "the other table" would be another one to them."""
    if module.name in ("trees.readings.odometry", "trees.beliefs.scene.believed_thing"):
        return []
    return [
        f"{module.file}:{line}: trees.readings.odometry tells what is around the robot"
        for line, name in module.imports()
        if name == "trees.beliefs.scene.believed_thing.surroundings"
    ]


def patching(module: Module) -> list[str]:
    """Attributes of imported modules and classes of others that are set: a library stays as it was made."""
    names = {bound: name for bound, name in module.bound() if name.split(".")[0] not in LAYERS}
    found = []
    for node in ast.walk(module.tree):
        for target in _set_by(node):
            owner, dotted = target, ""
            while isinstance(owner, ast.Attribute | ast.Subscript):
                dotted = f".{owner.attr}{dotted}" if isinstance(owner, ast.Attribute) else dotted
                owner = owner.value
                if isinstance(owner, ast.Call) and ast.unparse(owner.func) == "vars" and owner.args:
                    owner = owner.args[0]
            if owner is target or not isinstance(owner, ast.Name) or owner.id not in names:
                continue
            whole = names[owner.id] + dotted
            if not _within(whole, MEANT_TO_BE_SET):
                found.append(f"{module.file}:{node.lineno}: {whole} is another's: derive, do not patch")
    return found


def _set_by(node: ast.AST) -> list[ast.expr]:
    """What a statement or a call sets or deletes; of a call, the attribute as it would be written."""
    if isinstance(node, ast.Assign | ast.Delete):
        return [one for target in node.targets for one in _single(target)]
    if isinstance(node, ast.AugAssign | ast.AnnAssign):
        return [node.target]
    if isinstance(node, ast.Call):
        called = ast.unparse(node.func)
        if called in ("setattr", "delattr", "type.__setattr__", "type.__delattr__"):
            return [ast.Attribute(node.args[0], "__dict__", ast.Store())]
        if re.search(r"(^vars\(.+\)|\.__dict__)\.(update|setdefault|pop)$", called):
            return [node.func]
    return []


def _single(target: ast.expr) -> list[ast.expr]:
    if isinstance(target, ast.Tuple | ast.List):
        return [one for item in target.elts for one in _single(item)]
    return [target.value if isinstance(target, ast.Starred) else target]


def figures(module: Module) -> list[str]:
    """Numbers of a failure that are read one by one, and words that are looked for in its text.

    Both are for people, who read all of them: programs decide by a failure's kind, reason and typed fields.
    """
    if module.package == "tools":
        return []
    return [
        f"{module.file}:{node.lineno}: {ast.unparse(read)} is for people"
        for node in ast.walk(module.tree)
        for read in _looked_into(node)
        if _is_for_people(module, read)
    ]


def _looked_into(node: ast.AST) -> list[ast.expr]:
    """What an expression takes one thing out of, or looks for one thing in."""
    if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Load):
        return [node.value]
    if isinstance(node, ast.Attribute) and node.attr in (
        "get",
        "pop",
        "setdefault",
        "startswith",
        "endswith",
    ):
        return [node.value]
    if isinstance(node, ast.Compare) and any(isinstance(op, ast.In | ast.NotIn) for op in node.ops):
        return node.comparators
    return []


def _is_for_people(module: Module, read: ast.expr) -> bool:
    if isinstance(read, ast.Attribute):
        return read.attr == "numbers" or ast.unparse(read).endswith(("failure.message", "root.message"))
    has_failures = any(name.startswith("trees.failures.") for _, name in module.imports())
    return has_failures and isinstance(read, ast.Name) and read.id == "numbers"


def driving(module: Module) -> list[str]:
    """Generators of steps that somebody drives by hand: whoever does decides again what an answer is for."""
    if module.name == "executive.session.driver":
        return []
    return [
        f"{module.file}:{node.lineno}: executive.session.driver drives"
        for node in ast.walk(module.tree)
        if isinstance(node, ast.ExceptHandler) and node.type and "StopIteration" in ast.unparse(node.type)
    ]


AROUND = """
class Around:
    def read(self): ...
    def command(self, setpoint):
        self._robot.command(setpoint)
    def advance(self, period_s): ...
"""
CHANGED_ON_THE_WAY = AROUND.replace("_robot.command(setpoint)", "_robot.command(other)")
BREACHES = [
    (wrong_layer, "import trees.tasks", "robots/example.py"),
    (wrong_layer, "def f():\n    from executive.cli.app import main", "trees/example.py"),
    (wrong_layer, "import tools.evaluate", "executive/example.py"),
    (wrong_library, "import mujoco", "robots/control/example.py"),
    (wrong_library, "from mujoco import MjModel", "tools/example.py"),
    (wrong_library, "import py_trees.ports", "executive/example.py"),
    (wrong_library, "import pinocchio as pin", "robots/control/example.py"),
    (wrong_library, "from rich.table import Table", "trees/example.py"),
    (wrong_library, "import socket", "executive/example.py"),
    (wrong_library, "import urllib.request", "executive/example.py"),
    (wrong_library, "import socket", "robots/live/wire/connection.py"),
    (wrong_library, "import http", "robots/live/wire/unix_socket.py"),
    (wrong_library, "import socket\nsocket.socket(socket.AF_INET)", "robots/live/wire/unix_socket.py"),
    (wall_clock, "import time\nt = time.monotonic()", "executive/example.py"),
    (wall_clock, "from time import perf_counter as now\nnow()", "kinematics/example.py"),
    (wall_clock, "import datetime\ndatetime.datetime.now()", "executive/example.py"),
    (wall_clock, "from datetime import datetime as d\nd.now()", "tools/example.py"),
    (wall_clock, "import time as t\nt.sleep(1)", "trees/example.py"),
    (wall_clock, "import time\ntime.process_time()", "trees/example.py"),
    (wall_clock, "import time\ntime.perf_counter()", "tools/example.py"),
    (global_random, "import random\nrandom.random()", "kinematics/example.py"),
    (global_random, "from random import choice\nchoice([1])", "kinematics/example.py"),
    (global_random, "import numpy as np\nnp.random.normal()", "robots/example.py"),
    (global_random, "import numpy as np\nnp.random.default_rng()", "robots/example.py"),
    (global_random, "import uuid\nuuid.uuid4()", "executive/example.py"),
    (truth, "from robots.simulated.truth.truth import SimulatorTruth", "trees/example.py"),
    (truth, "from robots.perception import truth_view", "executive/session/session.py"),
    (truth, "import robots.simulated.truth.truth", "robots/control/example.py"),
    (seal, "from kinematics.motion.trajectory import _Seal", "kinematics/motion_planner.py"),
    (seal, "import kinematics.motion.trajectory as t\nt._Seal", "robots/control/example.py"),
    (judge, "from kinematics.ik.reach_ik import solve", "kinematics/checking/contacts.py"),
    (judge, "from kinematics.kernel import search", "kinematics/checking/trajectory_checker.py"),
    (commander, "self._robot.command(setpoint)", "robots/control/loop/control_loop.py"),
    (commander, "send = world.robot.command", "executive/example.py"),
    (commander, "def command(setpoint):\n    robot.command(setpoint)", "executive/example.py"),
    (
        commander,
        CHANGED_ON_THE_WAY,
        "robots/control/example.py",
    ),
    (environment, "import os\nos.environ['HOME']", "executive/example.py"),
    (imported_again, "from math import pi\ndef f():\n    from math import tau", "trees/example.py"),
    (around, "from trees.beliefs.scene.believed_thing import surroundings", "trees/leaves/example.py"),
    (patching, "import py_trees\npy_trees.ports.asked = cache", "trees/example.py"),
    (patching, "from py_trees import ports\nvars(ports)['asked'] = cache", "trees/example.py"),
    (patching, "from py_trees import ports\nvars(ports).update(asked=cache)", "trees/example.py"),
    (patching, "from py_trees.behaviour import Behaviour as B\nB.tick = tick", "trees/example.py"),
    (patching, "import numpy as np\nsetattr(np.linalg, 'norm', norm)", "kinematics/example.py"),
    (patching, "import numpy as np\na, np.sin = 1, sin", "kinematics/example.py"),
    (patching, "import numpy as np\ndef f():\n    del np.random.seed", "kinematics/example.py"),
    (patching, "import rich\nrich.__dict__.update(print=quiet)", "executive/example.py"),
    (patching, "import sys\nsys.excepthook = hook", "executive/example.py"),
    (figures, "def f(failure):\n    return failure.root.numbers.get('seen')", "trees/example.py"),
    (figures, "def f(failure):\n    return failure.numbers['seen']", "robots/example.py"),
    (figures, "def f(failure):\n    return 'seen' in failure.root.numbers", "executive/example.py"),
    (figures, "from trees.failures import Number\ndef f(numbers):\n    numbers.get('a')", "trees/example.py"),
    (figures, "def f(failure):\n    return 'is stuck' in failure.message", "trees/example.py"),
    (driving, "try:\n    next(steps)\nexcept StopIteration as end:\n    pass", "executive/example.py"),
]
ALLOWED = [
    (commander, AROUND, "robots/control/example.py"),
    (patching, "import sys\nsys.stdout = stream", "executive/example.py"),
    (patching, "from rich.text import Text\nText('a').style = 'bold'", "executive/example.py"),
    (patching, "import numpy as np\na = np.zeros(3)\na[0] = 1", "kinematics/example.py"),
    (patching, "from trees.tasks import Task\nTask.action = 'x'", "trees/example.py"),
    (wrong_layer, "import kinematics.geometry.poses", "robots/example.py"),
    (wrong_library, "import mujoco", "robots/simulated/world.py"),
    (wrong_library, "import urllib.parse", "executive/example.py"),
    (wrong_library, "import socket\nsocket.socket(socket.AF_UNIX)", "robots/live/wire/unix_socket.py"),
    (wall_clock, "import time\ntime.monotonic()", "robots/clock.py"),
    (wall_clock, "import time\ntime.process_time()", "tools/example.py"),
    (wall_clock, "import datetime\ndatetime.timedelta(1)", "executive/example.py"),
    (global_random, "import numpy as np\nnp.random.default_rng(3)", "tools/example.py"),
    (global_random, "import numpy as np\ndef f(rng: np.random.Generator): ...", "robots/example.py"),
    (truth, "from robots.perception.truth_view import TruthView", "robots/perception/stub.py"),
    (seal, "from kinematics.motion.trajectory import _Seal", "kinematics/checking/trajectory_checker.py"),
    (judge, "from kinematics.distance.separation import core_distance", "kinematics/checking/certificate.py"),
    (commander, "self._robot.command(setpoint)", "robots/control/gate/setpoint_gate.py"),
    (around, "from trees.beliefs.scene.believed_thing import Surroundings", "trees/leaves/example.py"),
    (around, "from trees.beliefs.scene.believed_thing import surroundings", "trees/readings/odometry.py"),
    (figures, "def f(failure):\n    return list(failure.numbers.items())", "executive/example.py"),
    (figures, "from trees.failures import Number\nnumbers = {}\nnumbers['held'] = 1", "trees/example.py"),
    (figures, "def f(numbers, name):\n    return numbers[name]", "kinematics/example.py"),
    (imported_again, "from math import pi\ndef f():\n    from cmath import tau", "trees/example.py"),
    (driving, "try:\n    next(steps)\nexcept StopIteration:\n    pass", "executive/session/driver.py"),
    (imported_again, "if True:\n    from math import pi\ndef f():\n    from math import pi", "trees/a.py"),
]
RULES = (
    wrong_layer, wrong_library, wall_clock, global_random, truth, seal, judge, commander, environment,
    imported_again, around, patching, figures, driving,
)  # fmt: skip


@pytest.mark.parametrize(("rule", "source", "file"), BREACHES)
def test_a_rule_catches_its_breach(rule, source, file):
    assert rule(parse(source, file))


@pytest.mark.parametrize(("rule", "source", "file"), ALLOWED)
def test_a_rule_lets_pass_what_is_allowed(rule, source, file):
    assert not rule(parse(source, file))


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_every_file_keeps_the_rule(rule):
    breaches = [breach for module in modules() for breach in rule(module)]

    assert not breaches, "\n".join(breaches)


def test_every_package_is_looked_at():
    assert {module.package for module in modules()} == set(LAYERS)
    assert len(modules()) > 40

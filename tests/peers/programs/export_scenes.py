"""Builds scenes of other people's benchmarks, and writes each as MJCF with what its maker says is in it.

Run by an interpreter that has those benchmarks: ``export_scenes.py FOLDER``. Beside ``NAME.xml`` stands
``NAME.json``: objects and furniture by the names and kinds that the benchmark's own files give them, and of
what moves in each the bodies with their kind.
"""

import json
import os
import re
import sys
from pathlib import Path

os.environ.setdefault("MUJOCO_GL", "disable")


def moving_parts(prefix, xml_model):
    """Bodies of a model that move by a joint of their own, by name, and the joint's type and range."""
    found = []
    for body in xml_model.iter("body"):
        for joint in body.findall("joint"):
            name = body.get("name") or ""
            if not name.startswith(prefix) or joint.get("type") == "free":
                continue
            found.append({"body": name, "type": joint.get("type", "hinge"), "range": joint.get("range")})
    return found


def write(folder, name, env, objects, furniture):
    """One scene, everything where it was put: its model, and the answer."""
    model = env.model
    for body in model.worldbody.findall("body"):
        placed = env.sim.model.body_name2id(body.get("name"))
        for key, values in (("pos", env.sim.data.body_xpos), ("quat", env.sim.data.body_xquat)):
            body.set(key, " ".join(f"{value:.6f}" for value in values[placed]))
        for key in ("euler", "axisangle"):
            body.attrib.pop(key, None)
    text = model.get_xml()
    (folder / f"{name}.xml").write_text(text)
    for piece in furniture:
        piece["moving"] = moving_parts(piece["name"], model.root)
    (folder / f"{name}.json").write_text(json.dumps({"objects": objects, "furniture": furniture}, indent=1))
    print(name, len(objects), "objects", len(furniture), "pieces", flush=True)


def libero(folder):
    """One scene for each arrangement that LIBERO's tasks name."""
    from libero.libero import benchmark, get_libero_path
    from libero.libero.envs import TASK_MAPPING
    from libero.libero.envs.bddl_utils import get_problem_info, robosuite_parse_problem
    from robosuite import load_controller_config

    seen = {}
    for suite in ("libero_90", "libero_10", "libero_goal", "libero_spatial", "libero_object"):
        tasks = benchmark.get_benchmark(suite)(task_order_index=0)
        for number in range(tasks.n_tasks):
            task = tasks.get_task(number)
            place = re.match(r"([A-Z_]+SCENE\d+)", task.name)
            name = place.group(1).lower() if place else suite
            if suite == "libero_object":
                name = f"{suite}_{number}" if number < 2 else None
            if name is None or name in seen:
                continue
            seen[name] = Path(get_libero_path("bddl_files")) / task.problem_folder / task.bddl_file
    for name, file in seen.items():
        problem = get_problem_info(str(file))["problem_name"]
        env = TASK_MAPPING[problem](
            bddl_file_name=str(file),
            robots=["Panda"],
            controller_configs=load_controller_config(default_controller="OSC_POSE"),
            has_renderer=False,
            has_offscreen_renderer=False,
            use_camera_obs=False,
            camera_names=["agentview"],
        )
        env.reset()
        parsed = robosuite_parse_problem(str(file))
        objects = [{"name": each, "kind": kind} for kind, all_ in parsed["objects"].items() for each in all_]
        pieces = [{"name": each, "kind": kind} for kind, all_ in parsed["fixtures"].items() for each in all_]
        write(folder, name, env, objects, pieces)


def suite(folder):
    """Two of robosuite's own."""
    import robosuite

    for name in ("PickPlace", "Door"):
        env = robosuite.make(name, robots="Panda", has_renderer=False, has_offscreen_renderer=False,
                             use_camera_obs=False)  # fmt: skip
        env.reset()
        things = [] if name == "Door" else [{"name": each.name, "kind": each.name} for each in env.objects]
        pieces = [{"name": "Door", "kind": "door"}] if name == "Door" else [
            {"name": each, "kind": "bin"} for each in ("bin1", "bin2")]  # fmt: skip
        write(folder, f"robosuite_{name.lower()}", env, things, pieces)


if __name__ == "__main__":
    into = Path(sys.argv[1])
    into.mkdir(parents=True, exist_ok=True)
    suite(into)
    libero(into)

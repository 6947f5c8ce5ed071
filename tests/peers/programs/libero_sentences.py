"""Tells the sentences of LIBERO's tasks, and of LIBERO-PRO's rephrasings, each with the scene it is said in.

Run by an interpreter that has the benchmark; a line of JSON each: ``sentence``, ``scene`` (as
``export_scenes.py`` names it), ``rephrased``, and ``things``: what its task file puts into the scene.
"""

import json
import re
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

SUITES = ("libero_90", "libero_10", "libero_goal", "libero_spatial", "libero_object")


def main():
    with redirect_stdout(StringIO()):
        from libero.libero import benchmark, get_libero_path

        told = []
        for suite in SUITES:
            tasks = benchmark.get_benchmark(suite)(task_order_index=0)
            for number in range(tasks.n_tasks):
                task = tasks.get_task(number)
                place = re.match(r"([A-Z_]+SCENE\d+)", task.name)
                scene = place.group(1).lower() if place else suite
                file = Path(task.problem_folder) / task.bddl_file
                told.append((task.language, scene, file, False))
        for suite in SUITES[1:]:
            folder = Path(get_libero_path("bddl_files")) / f"{suite}_lan"
            for file in sorted(folder.glob("*.bddl")):
                language = re.search(r"\(:language ([^)]*)\)", file.read_text()).group(1).strip()
                place = re.match(r"([A-Z_]+SCENE\d+)", file.stem)
                told.append((language, place.group(1).lower() if place else suite, file, True))
        root = Path(get_libero_path("bddl_files"))
    for sentence, scene, file, rephrased in told:
        text = (root / file).read_text()
        one = {"sentence": sentence, "scene": scene, "rephrased": rephrased, "things": things_of(text)}
        before, _, goal = text.partition("(:goal")
        print(json.dumps({**one, "init": before.partition("(:init")[2], "goal": goal}))


def things_of(text):
    """The instances that a task file declares."""
    declared = re.findall(r"\(:(?:objects|fixtures)([^)]*)\)", text)
    return [name for group in declared for name in re.findall(r"(\w+)(?=(?: \w+)* - )", group)]


if __name__ == "__main__":
    main()

"""``executive learn``: things that a person shows, and their names."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.cli.commands.choices import whole_number_from
from executive.errors import UserError

_SCENE = typer.Option(metavar="FILE.toml", help="A scene with the one thing that is shown, on a table.")
_VIEWS = typer.Option(min=1, max=64, help="From how many sides it is shown.")


def learn(
    name: Annotated[str | None, typer.Argument(help='What the thing is called: "tomato soup".')] = None,
    scene: Annotated[str | None, _SCENE] = None,
    views: Annotated[int, _VIEWS] = 8,
    robot: Annotated[str, typer.Option(metavar="NAME", help="Who looks.")] = "talos",
    seed: Annotated[int, typer.Option(parser=whole_number_from(0), help="Of the camera's errors.")] = 0,
    forget: Annotated[bool, typer.Option("--forget", help="Forget the thing.")] = False,
) -> None:
    """Learn what a thing looks like that is shown; without a name, tell what was learned."""
    from executive.config import leave_opengl_to_the_renderer, shown_directory
    from robots.models.description import load_robot

    leave_opengl_to_the_renderer()
    from robots.simulated.camera.camera_perception import require_camera

    require_camera(load_robot(robot))
    from robots.perception.labels.views import forget_views, keep_views, known_names
    from robots.scenes.scene_file import load_scene

    folder = shown_directory()
    if name is None:
        for known, count in known_names(folder).items():
            typer.echo(f"{known}: {count} views")
        return
    name = " ".join(name.split())
    if not name or len(name) > 60:
        raise UserError("a name has from 1 to 60 letters")
    if forget:
        if not (count := forget_views(folder, name)):
            known = ", ".join(known_names(folder)) or "nothing"
            raise UserError(f"{name!r} was never shown; known: {known}")
        typer.echo(f"forgot {count} views of {name}")
        return
    if scene is None:
        raise UserError("nothing is shown: --scene FILE.toml has the one thing that is put before the robot")
    from robots.simulated.camera.showing import shown_views

    seen = shown_views(load_robot(robot), load_scene(scene), views, seed)
    if not seen:
        raise UserError(f"the robot sees nothing that is shown in {scene}")
    count = keep_views(folder, name, seen)
    typer.echo(f"learned {name}: {len(seen)} of {views} views, {count} in all, in {folder}")

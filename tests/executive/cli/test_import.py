"""``executive import``: what it prints, and what it refuses."""

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from executive.exit_codes import ExitCode
from tests import foreign_meshes as foreign

KITCHEN = """<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
<body name="table" pos=".9 0 0"><geom type="box" size=".35 .7 .4" pos="0 0 .4"/></body>
<body name="mug_1" pos=".8 0 .85"><freejoint/><geom type="cylinder" size=".03 .05"/></body>
</worldbody></mujoco>"""


def said(*arguments):
    return CliRunner().invoke(app, ["import", *map(str, arguments)])


def test_an_object_is_told_with_every_guess(tmp_path):
    file = foreign.written(foreign.can(), tmp_path, "soup_can.obj", "+y")

    answer = said("object", file, "--mass-kg", "0.4")

    assert answer.exit_code == ExitCode.DONE
    assert "soup can, 66 x 66 x 101 mm, 0.4 kg, 1 part, nearly a cylinder" in answer.stdout
    assert "up = +y: guessed, it stands so" in answer.stdout
    assert "mass_kg" not in answer.stdout
    assert f"to mend: {file}.toml" in answer.stdout


def test_a_scene_is_told_with_what_is_in_it(tmp_path):
    file = tmp_path / "kitchen.xml"
    file.write_text(KITCHEN)

    answer = said("scene", file)

    assert answer.exit_code == ExitCode.DONE
    assert "1 object, 1 piece of furniture: mug, table" in answer.stdout


def test_what_only_a_person_can_tell_is_asked(tmp_path):
    file = tmp_path / "mobility.urdf"
    file.write_text(
        """<robot name="r"><link name="base"/><link name="link_0"><collision><origin xyz="0 0 .35"/><geometry>
<box size=".4 .5 .7"/></geometry></collision></link><joint name="j" type="fixed"><parent link="base"/>
<child link="link_0"/></joint></robot>"""
    )

    answer = said("scene", file)

    assert "to be said by you: mobility: its name tells nothing: what is it called?" in answer.stdout


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("object", "none.obj"), "none.obj: cannot be read"),
        (("object", "none.obj", "--up", "north"), "--up must be one of"),
        (("object", "none.obj", "--scale", "-1"), "--scale must be above 0"),
        (("object", "a.obj", "b.obj", "--label", "soup"), "--label is for one file"),
        (("scene", "a.xml", "--up", "+z"), "are for objects"),
        (("scene", "none.xml"), "none.xml: cannot be read"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(arguments, reason):
    answer = said(*arguments)

    assert answer.exit_code == ExitCode.INVALID
    assert reason in answer.stderr
    assert len(answer.stderr.strip().splitlines()) == 1

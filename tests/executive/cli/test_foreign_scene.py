"""A foreign scene named on the command line is imported at once."""

from pathlib import Path

from typer.testing import CliRunner

from executive.cli.app import app

KITCHEN = """<mujoco><worldbody><geom type="plane" size="4 4 .1"/>
<body name="table" pos="0.9 0 0.82"><geom type="box" size=".35 .7 .02"/></body>
<body name="moka_pot_1_main" pos="0.8 0.2 0.905"><freejoint/><geom type="box" size=".04 .04 .06"/></body>
<body name="lost_ball" pos="3 3 2"><freejoint/><geom type="sphere" size=".03"/></body>
</worldbody></mujoco>"""


def test_the_names_of_a_foreign_scene_are_understood(tmp_path: Path) -> None:
    file = tmp_path / "kitchen.xml"
    file.write_text(KITCHEN)

    said = CliRunner().invoke(app, ["parse", "pick up the moka pot", "--scene", str(file)])

    assert said.exit_code == 0, said.output
    assert '"moka pot"' in said.stdout
    assert "lost ball: stands on nothing that is known" in said.stderr
    assert (tmp_path / "kitchen.guesses.toml").exists()


def test_a_scene_that_was_mended_beside_it_is_kept(tmp_path: Path) -> None:
    file = tmp_path / "kitchen.xml"
    file.write_text(KITCHEN)
    runner = CliRunner()
    runner.invoke(app, ["parse", "wave", "--scene", str(file)])
    made = tmp_path / "kitchen.toml"
    made.write_text(made.read_text() + "# mended\n")

    said = runner.invoke(app, ["parse", "wave", "--scene", str(file)])

    assert said.exit_code == 0
    assert made.read_text().endswith("# mended\n")

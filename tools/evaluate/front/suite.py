"""Suites ``front`` and ``free-speech``: transcripts with a scripted model, judged by tasks and in simulation.

``front``: of ``--episodes`` transcripts four in five are bad. A bad one is held out to two persons, one who
wants no read-back and answers nothing, and one who says yes to what is wanted alone; nothing may be carried
out. Good ones, and those of ``free-speech``, are carried out in simulation; with ``--every N`` so many of
them, and the others are judged by the tasks that were agreed upon.
"""

from __future__ import annotations

import json
import re
import tempfile
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from rich.console import Console

from executive.config import config_files, forget_config, use_config
from executive.dialogue.attendant import Stoppable
from executive.dialogue.clarification import OpenQuestion
from executive.front.front_model import FrontModel
from executive.front.front_talk import FrontTalk
from executive.front.model_asker import ModelAsker
from executive.front.model_settings import model_called
from executive.meaning import Command, command_json
from executive.reports.meaning_words import meaning_words
from executive.scripts.script_run import run_statements
from executive.session.assembly import assemble
from executive.understanding.spoken_in import spoken_in
from executive.understanding.statement import Statement
from executive.understanding.understanding import understand
from robots.clock import WallClock
from robots.scenes.scene_file import load_scene
from tools.evaluate.front.bad_answers import bad_transcripts
from tools.evaluate.front.free_speech import free_speech
from tools.evaluate.front.good_answers import good_transcripts
from tools.evaluate.front.scripted_server import ScriptedServer
from tools.evaluate.front.transcript import HASTY, USUAL, Transcript
from trees.failures import Failure

FRONT, FREE = "front", "free-speech"
FRONT_SUITES = (FRONT, FREE)
DONE_BAR = 0.95
_HASTY_S = 1.0


@dataclass(frozen=True, slots=True)
class Verdict:
    """What became of one transcript.

    Attributes:
        one: The transcript.
        outcome: "done", "refused", "question", "failed", ...
        told: What the person was told last.
        wrong: What is wrong with it; empty where nothing is.
    """

    one: Transcript
    outcome: str
    told: str
    wrong: str = ""

    def to_json(self) -> dict[str, Any]:
        """As the figures hold it."""
        return {
            "kind": self.one.kind,
            "text": self.one.text,
            "outcome": self.outcome,
            "told": self.told,
            "wrong": self.wrong,
        }


class CarefulPerson:
    """Says yes to what is wanted and to nothing else; satisfies ``Attendant``.

    Args:
        one: What is said, and wanted.
        silent: Whether nothing is answered at all.
    """

    def __init__(self, one: Transcript, silent: bool = False) -> None:
        self._one, self._silent = one, silent
        self._replies = list(one.replies)
        self.asked = ""

    def begin(self, _session: Stoppable) -> None:
        """Nothing to prepare."""

    def attend(self, _session: Stoppable) -> None:
        """Let it go on."""

    def answer(self, question: OpenQuestion) -> str | None:
        """Answer a question."""
        self.asked = question.text
        if self._silent:
            return None
        if not question.choices:
            return self._replies.pop(0) if self._replies else None
        wanted = (f"I understood: {_meant(sentence)};" for sentence in self._one.wants)
        return "yes" if any(question.text.startswith(one) for one in wanted) else "no"


def run_front_suite(
    suite: str, episodes: int, seed: int, every: int, robot: str, file: Path | None, messages: Console
) -> int:
    """Run one of the suites; 0 when its demands are met.

    Args:
        suite: One of ``FRONT_SUITES``.
        episodes: How many transcripts.
        seed: Of their draw, and of the world.
        every: Every so manyth good one is carried out in simulation; the others are judged by their tasks.
        robot: Name of the robot.
        file: Where the figures go, or None.
        messages: Takes the progress.
    """
    wall = WallClock()
    verdicts: list[Verdict] = []
    with tempfile.TemporaryDirectory() as folder, ScriptedServer(sleep=wall.sleep) as server:
        config = Path(folder) / "config.toml"
        hasty = server.settings(HASTY, when="always", timeout_s=_HASTY_S)
        config.write_text(server.settings(USUAL, when="always") + hasty, "utf-8")
        use_config(config)
        askers = {name: ModelAsker(model_called(name, config_files())) for name in (USUAL, HASTY)}
        bench = _Bench(server, askers, robot, seed, wall)
        try:
            for one, judge in _cases(suite, episodes, seed, every, bench):
                verdicts.append(judge(one))
                count = f"{len(verdicts)} of {episodes}: {one.kind} {verdicts[-1].outcome}"
                messages.print(f"{count} {verdicts[-1].wrong}".rstrip(), markup=False)
        finally:
            for asker in askers.values():
                asker.close()
            forget_config()
    return _concluded(suite, seed, verdicts, bench.simulated, file)


def _cases(
    suite: str, episodes: int, seed: int, every: int, bench: _Bench
) -> list[tuple[Transcript, Callable[[Transcript], Verdict]]]:
    good = episodes if suite == FREE else max(1, episodes // 5)
    right = free_speech(good, seed) if suite == FREE else good_transcripts(good, seed)
    simulated = [index % every == 0 or one.fails_first for index, one in enumerate(right)]
    return [
        *((one, bench.held_off) for one in bad_transcripts(episodes - good, seed)),
        *(
            (one, bench.carried_out if moves else bench.agreed)
            for one, moves in zip(right, simulated, strict=True)
        ),
    ]


class _Bench:
    """A server that plays transcripts, and a robot that carries out what is agreed upon.

    Attributes:
        simulated: How many were carried out so far.
    """

    def __init__(
        self, server: ScriptedServer, askers: dict[str, ModelAsker], robot: str, seed: int, wall: WallClock
    ) -> None:
        self._server, self._askers, self._robot, self._seed, self._wall = server, askers, robot, seed, wall
        self.simulated = 0

    def held_off(self, one: Transcript) -> Verdict:
        """Whether nothing comes of a bad one, and whoever is there is told why."""
        verdicts = [self._settled(one, silent, reads_back=not silent) for silent in (True, False)]
        return next((verdict for verdict in verdicts if verdict.wrong), verdicts[0])

    def _settled(self, one: Transcript, silent: bool, reads_back: bool) -> Verdict:
        person = CarefulPerson(one, silent)
        with spoken_in(one.scene):
            said = self._talk(one, person, reads_back).settled(Statement(understand(one.text).parsed))
        if isinstance(said, Failure):
            return Verdict(one, "failed", said.message, "it was ended")
        parsed = said.parsed
        told = " ".join(filter(None, (person.asked, str(parsed.refusal or ""))))
        if parsed.commands:
            return Verdict(one, "tasks", told, f"it would be carried out: {_words(parsed.commands)}")
        names_why = re.search(one.why, told) is not None
        return Verdict(one, parsed.outcome, told, "" if names_why else f"does not say why: {told!r}")

    def agreed(self, one: Transcript) -> Verdict:
        """Whether what is agreed upon is what is wanted; nothing is carried out."""
        person = CarefulPerson(one)
        with spoken_in(one.scene):
            said = self._talk(one, person, reads_back=True).settled(Statement(understand(one.text).parsed))
            return self._against_what_is_wanted(one, said, person) or Verdict(one, "done", person.asked)

    def carried_out(self, one: Transcript) -> Verdict:
        """Whether a good one is carried out in simulation, as it is wanted."""
        person = CarefulPerson(one)
        self.simulated += 1
        session = assemble(self._robot, load_scene(one.scene), self._seed).session
        talk = self._talk(one, person, reads_back=True)
        talk.meet(session)
        with spoken_in(one.scene):
            said = talk.settled(Statement(understand(one.text).parsed))
            instead = self._against_what_is_wanted(one, said, person)
            if instead is not None or isinstance(said, Failure):
                return instead or Verdict(one, "not begun", person.asked, "not begun")
            results = run_statements([said], session, person, "fail", session.events, talk.again)
        last = results[-1][1][-1]
        why = "" if last.failure is None else last.failure.root.message
        return Verdict(one, last.outcome, person.asked, why)

    def _against_what_is_wanted(
        self, one: Transcript, said: Statement | Failure, person: CarefulPerson
    ) -> Verdict | None:
        if isinstance(said, Failure) or not said.parsed.commands:
            return Verdict(one, "not begun", person.asked, f"not begun: {said}")
        wanted = one.wants[:1] if one.fails_first else one.wants
        if _plain(said.parsed.commands) != [plain for wish in wanted for plain in _plain(_read(wish))]:
            return Verdict(one, "other", person.asked, f"other tasks: {_words(said.parsed.commands)}")
        return None

    def _talk(self, one: Transcript, person: CarefulPerson, reads_back: bool) -> FrontTalk:
        def waiting() -> bool:
            self._wall.sleep(0.002)
            return False

        self._server.script(one.answers)
        asker = self._askers[one.model]
        front = FrontModel(model_called(one.model, config_files()), asker, reads_back=reads_back)
        return FrontTalk(front, person.answer, lambda _event: None, waiting, seen=lambda: one.seen)


def _read(sentence: str) -> tuple[Command, ...]:
    return understand(sentence).parsed.commands


def _plain(commands: Sequence[Command]) -> list[Command]:
    """Commands without the words that they came from."""
    return [replace(one, text="") for one in commands]


def _words(commands: Sequence[Command]) -> str:
    return ", then ".join(meaning_words(command_json(one)) for one in commands)


def _meant(sentence: str) -> str:
    return _words(_read(sentence))


def _concluded(suite: str, seed: int, verdicts: Sequence[Verdict], simulated: int, file: Path | None) -> int:
    bad = [one for one in verdicts if not one.one.wants]
    good = [one for one in verdicts if one.one.wants]
    executed = sum(one.outcome == "tasks" for one in bad) + sum(one.outcome == "other" for one in good)
    unexplained = sum(bool(one.wrong) and one.outcome != "tasks" for one in bad)
    done = sum(one.outcome == "done" for one in good)
    rate = done / len(good) if good else 1.0
    document = {
        "suite": suite,
        "seed": seed,
        "episodes": len(verdicts),
        "bad": len(bad),
        "executed_wrongly": executed,
        "not_explained": unexplained,
        "good": len(good),
        "simulated": simulated,
        "success_rate": rate,
        "kinds": dict(Counter(one.one.kind for one in verdicts)),
        "wrong": [one.to_json() for one in verdicts if one.wrong],
    }
    if file is not None:
        file.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    Console().print_json(json.dumps(document))
    return 0 if not executed and not unexplained and rate >= DONE_BAR else 1

"""``executive send`` with a script, to somebody at a real desk who answers as a test says."""

import threading
import time

import pytest
from typer.testing import CliRunner

from executive import cli
from executive.exit_codes import ExitCode
from executive.live.desk import Desk
from robots.live.runtime_folder import RuntimeFolder

DONE, FAILED = ("done: it waves", "done", ExitCode.DONE), ("failed: it fell", "failed", ExitCode.FAILED)
REFUSED = ("refused: no zorbl", "refused", ExitCode.INVALID)
CANCELLED = ("cancelled: enough", "cancelled", ExitCode.CANCELLED)
QUESTION = ("question: which cup?", "question", ExitCode.QUESTION)


class Nobody:
    """Attends to nothing."""

    def status(self):
        return {"task": None, "paused": False}


class Served:
    """A desk in another thread that ends each order as it is told to."""

    def __init__(self, folder):
        self.folder, self.endings, self.said = folder, [], []
        folder.make()
        self._desk, self._over = (
            Desk(folder.executive_socket, Nobody(), lambda text: False),
            threading.Event(),
        )
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def _serve(self):
        while not self._over.is_set():
            self._desk.poll()
            if (order := self._desk.next_order()) is not None:
                self.said.append(order.said.text)
                order.end(*self.endings.pop(0))
                self._desk.finish()
            time.sleep(0.002)
        self._desk.close()

    def send(self, script, *endings):
        self.endings[:] = endings
        return CliRunner().invoke(cli.app, ["send", str(script), "--folder", str(self.folder.path)])

    def close(self):
        self._over.set()
        self._thread.join()


@pytest.fixture
def served(tmp_path):
    made = Served(RuntimeFolder(tmp_path / "live"))
    yield made
    made.close()


@pytest.fixture
def script(tmp_path):
    """A script of statements that are not "wave and go on to the next": what else each says."""

    def write(*more):
        path = tmp_path / "tidy.toml"
        path.write_text("".join(f'[[task]]\nsay = "wave"\n{lines}\n' for lines in more))
        return path

    return write


ON, AGAIN = 'on_failure = "continue"', 'on_failure = "retry"'


@pytest.mark.requirement("U1")
@pytest.mark.parametrize(
    ("statements", "endings", "code", "line"),
    [
        (["", ""], [DONE, DONE], 0, DONE),
        ([ON, ""], [FAILED, DONE], 1, FAILED),
        ([ON, ""], [REFUSED, FAILED], 2, REFUSED),
        ([ON, ON, ""], [DONE, QUESTION, DONE], 3, QUESTION),
        (["", ""], [FAILED], 1, FAILED),
        ([AGAIN, ""], [FAILED, DONE, DONE], 0, DONE),
        ([AGAIN, ""], [FAILED, REFUSED], 2, REFUSED),
        (['expect = "refused"', ""], [REFUSED, DONE], 0, DONE),
        (['expect = "refused"', ""], [DONE], 1, DONE),
        ([ON, ""], [CANCELLED], 4, CANCELLED),
    ],
)
def test_a_script_that_is_sent_ends_with_the_code_of_its_first_unexpected_result(
    served, script, statements, endings, code, line
):
    result = served.send(script(*statements), *endings)

    assert (result.exit_code, result.stdout.strip()) == (code, line[0])
    assert len(served.said) == len(endings)

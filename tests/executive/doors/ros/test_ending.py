"""A program before a middleware ends when it is asked to, whatever hangs."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

import executive.doors.ros.node

NODE = Path(executive.doors.ros.node.__file__).parent
BEGIN = f"""
import sys, threading, time
sys.path.insert(0, {str(NODE)!r})
from ending import Ending
ending = Ending(within_s=0.5)
"""
READY = """
print("ready", flush=True)
ending.wait()
"""
WAITS = "threading.Thread(target=lambda: time.sleep(3600)).start()"
HOLDS_THE_INTERPRETER = "import ctypes; ctypes.PyDLL(None).sleep(3600)"
ENDS_WITHIN_S = 60.0


def ended(program, number=signal.SIGTERM):
    """Exit code and stderr of a program that was told to end once it was ready."""
    piped = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen([sys.executable, "-c", program], **piped) as process:
        try:
            assert process.stdout.readline() == "ready\n"
            process.send_signal(number)
            _, said = process.communicate(timeout=ENDS_WITHIN_S)
        finally:
            process.kill()
    return process.returncode, said


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_program_leaves_in_order_though_a_thread_goes_on(number):
    assert ended(f"{BEGIN}{WAITS}{READY}ending.leave()", number) == (0, "")


def test_a_program_whose_teardown_hangs_ends_and_tells_where():
    code, said = ended(f"{BEGIN}{READY}{HOLDS_THE_INTERPRETER}")

    assert code == 1
    assert "Timeout" in said
    assert 'File "<string>"' in said


def test_a_thread_that_ends_the_program_ends_it():
    asks = "threading.Thread(target=ending.ask).start()"

    assert ended(f"{BEGIN}{asks}{READY}ending.leave()", 0) == (0, "")

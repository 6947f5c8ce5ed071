"""What a person does in the page: by pointer, by keys alone, on a phone, in the dark.

But for the simulator's truth no robot is served: one that remembers what it is told stands for it.
"""

import io
import threading

import numpy as np
import pytest
from PIL import Image

from executive.doors.view.access import Access, new_token
from executive.doors.view.browser import Browser
from executive.doors.view.page_server import PageServer
from executive.doors.view.seen import LogLine, Seen
from tests.peers.served_page import MARKS, PHONE, WINDOW, Served, opened, say, until

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

PORT = 8099
MOST_TABS = 40
TRUTH = (170, 60, 200)
LEAST_CONTRAST = 4.5
"""Of small text, by WCAG 2.2, AA."""
CONTRAST_OF_TEXTS = """() => {
    const numbers = color => color.match(/[0-9.]+/g).map(Number);
    const luminance = rgb => {
        const [r, g, b] = rgb.map(one => one / 255).map(
            one => one <= 0.04045 ? one / 12.92 : ((one + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const above = one => one ? [one, ...above(one.parentElement)] : [];
    return [...document.querySelectorAll("[style*='font-size:13px'] *")].filter(one =>
        one.offsetParent && [...one.childNodes].some(node => node.nodeType === 3 && node.data.trim())
    ).map(one => {
        const grounds = above(one).map(each => numbers(getComputedStyle(each).backgroundColor));
        const ground = (grounds.find(rgba => (rgba[3] ?? 1) > 0.9) || [255, 255, 255]).slice(0, 3);
        const opacity = above(one).reduce((sofar, each) => sofar * getComputedStyle(each).opacity, 1);
        const color = numbers(getComputedStyle(one).color).slice(0, 3);
        const seen = color.map((part, i) => opacity * part + (1 - opacity) * ground[i]);
        const [a, b] = [luminance(seen), luminance(ground)];
        return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), one.textContent];
    });
}"""
"""Of each text of the panels: its contrast with what is behind it, and itself."""
NODES = [
    {"depth": depth, "name": name, "status": status, "message": message}
    for depth, name, status, message in (
        (0, "pick", "running", "attempt 1 of 4"),
        (1, "look", "success", "arrived"),
        (2, "turn the head", "success", "0.02 rad"),
        (1, "reach", "running", ""),
        (2, "stream reach", "running", "72 %"),
        (1, "lift", "failure", "it slipped"),
        (1, "recover", "idle", ""),
    )
]
FAILURE = {
    "kind": "POSTCONDITION", "where": "pick/lift", "message": "it slipped", "numbers": {"lost_n": 2.0},
    "cause": {"kind": "UNSAFE", "where": "pick/reach", "message": "too near", "numbers": {}},
}  # fmt: skip
SEEN = Seen(
    robot="talos",
    scene="tabletop",
    state="NORMAL",
    task="pick up the cup",
    nodes=NODES,
    log=tuple(
        LogLine(1.0, f"a line of {level}", level) for level in ("info", "said", "warning", "error", "alarm")
    ),
    failure=FAILURE,
    complaint="the executive does not answer",
)
ASKED = {"text": "which cup?", "choices": ("blue cup", "red cup")}
pytestmark = MARKS


class Robot:
    """Remembers what it is told."""

    def __init__(self):
        self.told = []

    def begin(self, text):
        self.told.append(text)

    def answer(self, text):
        self.told.append(f"answer: {text}")
        return True

    def __getattr__(self, name):  # stop, pause, resume, cancel
        return lambda *_: self.told.append(name) or True


class Shown:
    """A page of such a robot, and what it shows."""

    def __init__(self):
        self.seen, self.robot = SEEN, Robot()
        self._access, self._over, self._browsers = Access(token := new_token()), threading.Event(), []
        self._server = PageServer(0, self._access, "robot")
        self._server.on_client(self._welcome)
        self.address = f"http://127.0.0.1:{self._server.port}/?token={token}"
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def close(self):
        self._over.set()
        self._thread.join()
        self._server.close()

    def _welcome(self, client, may_command):
        self._browsers.append(Browser(client, self.robot, self._access, lambda _: None, may_command))

    def _run(self):
        while not self._over.wait(0.05):
            for browser in list(self._browsers):
                browser.show(self.seen)


@pytest.fixture(scope="module")
def module_shown():
    made = Shown()
    yield made
    made.close()


@pytest.fixture
def shown(module_shown):
    module_shown.seen = SEEN
    module_shown.robot.told.clear()
    return module_shown


@pytest.fixture(params=[WINDOW], ids=["window"])
def page(chromium, shown, request):
    made = opened(chromium, request.param)
    made.goto(shown.address)
    made.get_by_text("pick up the cup").first.wait_for()
    made.get_by_role("button", name="STOP").wait_for()
    yield made
    made.context.close()


def lines_of_tree(page):
    texts = page.locator("span[style*='padding-left']").all_text_contents()
    return [text for text in texts if not text.startswith(("failed", "because"))]


def tab_to(page, told):
    """Press Tab until what has the focus is called so."""
    for _ in range(MOST_TABS):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.textContent").strip() == told:
            return
    raise AssertionError(f"no Tab reaches {told!r}")


def test_a_branch_is_folded_and_unfolded_by_hand(page):
    until(lambda: len(lines_of_tree(page)) == len(NODES) - 1)  # what has succeeded is folded

    def turn(branch):
        page.get_by_label("fold, unfold").click()
        page.get_by_role("option", name=branch, exact=True).click()

    turn("pick/look")
    until(lambda: any("turn the head" in line for line in lines_of_tree(page)))
    turn("pick")
    until(lambda: len(lines_of_tree(page)) == 1)
    turn("pick")
    until(lambda: len(lines_of_tree(page)) == len(NODES))


def test_all_is_done_by_keys_alone(page, shown):
    told = shown.robot.told
    tab_to(page, "STOP")
    page.keyboard.press("Tab")  # the line to type in, which has no name of its own
    page.keyboard.type("wave")
    page.keyboard.press("Enter")
    until(lambda: told == ["wave"])
    page.keyboard.type("half a sent")
    for key, does in (("p", "pause"), ("c", "cancel"), ("s", "stop")):
        page.keyboard.press(f"Alt+{key}")  # the line has the focus still
        until(lambda does=does: told[-1] == does)

    shown.seen = Seen(question=ASKED)
    page.get_by_role("button", name="red cup").wait_for()
    tab_to(page, "red cup")
    page.keyboard.press("Enter")
    until(lambda: told[-1] == "answer: red cup")
    tab_to(page, "STOP")
    page.keyboard.press("Enter")
    until(lambda: told[-1] == "stop" and told.count("stop") == 2)


@pytest.mark.parametrize("sends", ["this.form.requestSubmit()", "this.send.click()"], ids=["enter", "send"])
def test_a_command_that_is_sent_at_once_is_whole(page, shown, sends):
    page.evaluate(
        """sends => {
            const field = document.querySelector("form input");
            const write = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set;
            const type = text => {
                write.call(field, text);
                field.dispatchEvent(new Event("input", {bubbles: true}));
            };
            type("move 1");
            type("move 10 cm to the left");
            const send = [...document.querySelectorAll("form button")].find(
                one => one.textContent.trim() == "send");
            new Function(sends).call({form: field.form, send});
        }""",
        sends,
    )
    until(lambda: shown.robot.told)

    assert shown.robot.told == ["move 10 cm to the left"]


@pytest.mark.parametrize("page", [PHONE], indirect=True, ids=["phone"])
def test_on_a_phone_all_is_in_reach_and_nothing_is_cut_off(page, shown):
    width, height = PHONE
    shown.seen = Seen(question=ASKED)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    for name in ("STOP", "red cup", "send", "pause / go on", "cancel"):
        button = page.get_by_role("button", name=name, exact=True)
        button.scroll_into_view_if_needed()
        place = button.bounding_box()
        assert (place["x"] >= 0.0, place["x"] + place["width"] <= width) == (True, True), name
        assert (place["y"] >= 0.0, place["y"] + place["height"] <= height) == (True, True), name

    say(page, "blue cup")
    until(lambda: shown.robot.told == ["answer: blue cup"])
    shown.seen = SEEN
    page.get_by_text("tree \u00b7 log").click()
    page.get_by_text("stream reach").last.wait_for()
    page.get_by_text("log", exact=True).last.click()
    page.get_by_text("a line of alarm").wait_for()
    page.get_by_role("button", name="STOP").click()
    until(lambda: shown.robot.told[-1] == "stop")


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_every_word_is_read_in_the_dark_and_in_the_light(page, dark):
    page.get_by_label("dark", exact=True).set_checked(dark)
    page.get_by_label("unfold all").check()
    until(lambda: len(lines_of_tree(page)) == len(NODES))
    scheme = "dark" if dark else "light"
    until(lambda: page.evaluate("getComputedStyle(document.documentElement).colorScheme") == scheme)
    page.wait_for_timeout(1000)
    told = page.evaluate(CONTRAST_OF_TEXTS)
    page.get_by_text("log", exact=True).click()
    page.get_by_text("a line of alarm").wait_for()
    told += page.evaluate(CONTRAST_OF_TEXTS)

    assert len(told) > 20
    assert [(round(contrast, 1), text) for contrast, text in told if contrast < LEAST_CONTRAST] == []


@pytest.fixture
def served(tmp_path):
    made = Served(tmp_path, PORT, "--scene", "tabletop", "--evaluation")
    until(made.is_ready, 240.0)
    yield made
    made.end()


def test_the_simulators_truth_is_shown_while_its_switch_is_on(chromium, served):
    page = opened(chromium)
    page.goto(served.address)
    page.locator("canvas[data-engine]").wait_for()

    def violet():
        taken = page.screenshot(clip={"x": 400, "y": 30, "width": 540, "height": 750})
        pixels = np.asarray(Image.open(io.BytesIO(taken)).convert("RGB")).astype(int)
        return int((np.abs(pixels - TRUTH).max(axis=2) < 60).sum())

    assert violet() == 0
    page.get_by_label("the simulator's truth").check()
    until(lambda: violet() > 20)
    page.get_by_label("the simulator's truth").uncheck()
    until(lambda: violet() == 0)
    page.context.close()

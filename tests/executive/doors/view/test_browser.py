"""The words and buttons of one browser, with a page that remembers what is in it."""

from contextlib import nullcontext
from types import SimpleNamespace

import pytest

from executive.doors.view.access import Access
from executive.doors.view.browser import Browser
from executive.doors.view.seen import Seen
from robots.live.wire.errors import NotServedError

TOKEN = "the-printed-one"


class Element(nullcontext):
    """A button, field, text or folder: what it is called, and what happens when it is used."""

    def __init__(self, page, label, value=None, **options):
        super().__init__(self)
        self.page, self.label, self.value, self.content = page, label, value, label
        self.options, self.calls, self.visible = options, [], options.get("visible", True)

    def on_click(self, call):
        self.calls.append(call)

    on_update = on_submit = on_trigger = on_click

    def use(self):
        for call in self.calls:
            call(None)

    submit = use

    def remove(self):
        self.page.elements.remove(self)

    def add_tab(self, label, _icon):
        return Element(self.page, label)

    def dock_left(self):
        pass

    dock_right = dock_left

    def set_width(self, _px):
        pass


class Gui:
    def __init__(self):
        self.elements, self.main_panel = [], Element(self, "main")

    def _add(self, label="", *values, **options):
        made = Element(self, label, *values[:1], **options)
        self.elements.append(made)
        return made

    add_button = add_command = add_html = add_folder = add_form = add_panel = _add
    add_text = add_checkbox = _add

    def add_dropdown(self, label, options, **more):
        made = self._add(label, options[0], **more)
        made.offered = options
        return made

    def configure_theme(self, **_theme):
        pass

    def set_panel_label(self, _label):
        pass

    def called(self, label):
        return [one for one in self.elements if one.label == label]


class Robot:
    """Remembers what it is told."""

    def __init__(self):
        self.told, self.asks, self.under_way = [], False, True

    def stop(self, reason):
        self.told.append("stop")

    def begin(self, text):
        self.told.append(text)

    def answer(self, text):
        self.told.append(f"answer {text}")
        return self.asks

    def pause(self, _reason):
        self.told.append("pause")
        return self.under_way

    def resume(self):
        self.told.append("resume")

    def cancel(self, _reason):
        self.told.append("cancel")
        return self.under_way


class Page:
    def __init__(self, may_command):
        self.gui, self.robot, self.notes = Gui(), Robot(), []
        client = SimpleNamespace(gui=self.gui)
        self.browser = Browser(client, self.robot, Access(TOKEN), self.notes.append, may_command)

    def press(self, label):
        (button,) = [one for one in self.gui.called(label) if one.calls][:1]
        button.use()

    def type(self, label, text):
        (field,) = self.gui.called(label)
        field.value = text
        (form,) = [one for one in self.gui.elements if one.label is None]
        form.submit()


@pytest.fixture
def page():
    return Page(may_command=True)


@pytest.fixture
def reading():
    return Page(may_command=False)


def test_stop_is_there_for_everybody_who_sees_the_page(page, reading):
    page.press("STOP")
    reading.press("STOP")

    assert page.robot.told == reading.robot.told == ["stop"]
    assert page.notes[-1].level == "alarm"


def test_a_page_without_the_token_has_nothing_that_commands(reading):
    assert not [label for label in ("say", "pause / go on", "cancel") if reading.gui.called(label)]


def test_the_printed_token_lets_command_and_another_does_not(reading):
    reading.type("token", "another")
    assert reading.gui.called("say") == []
    assert reading.notes[-1].level == "warning"

    reading.type("token", TOKEN)
    reading.type("say", "wave")
    assert reading.robot.told == ["wave"]


def test_a_line_is_a_command_or_the_answer_to_what_is_asked(page):
    page.type("say", "pick up the cup")
    page.browser.show(Seen(question={"text": "which one?", "choices": ["the red one"]}))
    page.robot.asks = True
    page.type("say", "the blue one")

    assert page.robot.told == ["pick up the cup", "answer the blue one"]


def test_a_question_has_a_button_for_each_choice_until_it_is_answered(page):
    page.browser.show(Seen(question={"text": "which one?", "choices": ["the red one", "the blue one"]}))
    page.press("the blue one")
    assert page.robot.told == ["answer the blue one"]

    page.browser.show(Seen())
    assert page.gui.called("the blue one") == []


def test_who_only_reads_sees_the_choices_and_cannot_press_them(reading):
    reading.browser.show(Seen(question={"text": "which one?", "choices": ["the red one"]}))

    assert reading.gui.called("the red one")[0].options["disabled"]


def test_one_button_pauses_and_goes_on(page):
    page.press("pause / go on")
    page.browser.show(Seen(paused=True))
    page.press("pause / go on")

    assert page.robot.told == ["pause", "resume"]


def test_nothing_to_cancel_is_said(page):
    page.robot.under_way = False
    page.press("cancel")

    assert page.notes[-1].text == "nothing is under way"


def test_a_robot_that_does_not_answer_is_told_in_the_log(page, tmp_path):
    def gone(_text):
        raise NotServedError(tmp_path)

    page.robot.begin = gone
    page.type("say", "wave")

    assert page.notes[-1].level == "error"


def test_what_has_not_changed_is_not_sent_again(page):
    page.browser.show(Seen(robot="talos"))
    status = page.browser._status
    status.content = "as it was drawn"
    page.browser.show(Seen(robot="talos"))

    assert status.content == "as it was drawn"

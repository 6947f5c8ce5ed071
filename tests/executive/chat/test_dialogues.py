"""Scripted dialogues, line by line, with a fake robot: what a person would expect."""

import pytest

from executive.exit_codes import ExitCode
from robots.fake.fake_world import cup

RED = cup("a", "red", (0.45, 0.2))
TASK = "pick up the red cup"
MOVING = 0.008
"""Wall time of a tick with which a task goes on long enough for somebody to step in."""


@pytest.mark.requirement("U1")
def test_a_task_is_carried_out_and_one_sentence_tells_what_became_of_it(serve, talk_to):
    dialogue = talk_to(serve(RED)).say(TASK)

    assert dialogue.end() == ExitCode.DONE
    assert dialogue.lines[:2] == [f"you:   {TASK}", f"robot: I understood: {TASK}"]
    assert dialogue.lines[2].startswith("robot: Done: red cup held in the left hand, opening 60 mm")
    assert len(dialogue.lines) == 3


@pytest.mark.requirement("L6")
def test_a_question_is_put_with_its_choices_and_answered_by_number(serve, talk_to):
    dialogue = talk_to(serve()).say("pick up the cup").until("Answer with a number")

    assert dialogue.lines[2:5] == [
        "robot: which cup? there are 2",
        "         1  red cup",
        "         2  blue cup",
    ]
    assert dialogue.say("2").end() == ExitCode.DONE
    assert "Done: blue cup held" in dialogue.lines[-1]


@pytest.mark.requirement("L6")
def test_a_question_is_answered_in_words_after_an_answer_that_is_none(serve, talk_to):
    dialogue = talk_to(serve()).say("pick up the cup").until("which cup?").say("the green one")
    dialogue.until("'the green one' is none of the choices").until("which cup?", 2).say("the blue one")

    assert dialogue.end() == ExitCode.DONE
    assert "Done: blue cup held" in dialogue.lines[-1]


@pytest.mark.requirement("L6")
def test_lines_of_a_pipe_answer_in_their_order(serve, talk_to):
    dialogue = talk_to(serve()).say("pick up the cup", "the blue one", "why")

    assert dialogue.end() == ExitCode.DONE
    assert "Done: blue cup held" in dialogue.text
    assert dialogue.lines[-1].strip() == "Nothing failed."


@pytest.mark.requirement("L6")
def test_a_question_that_is_withdrawn_ends_the_task(serve, talk_to):
    dialogue = talk_to(serve()).say("pick up the cup").until("which cup?").say("never mind")

    assert dialogue.end() == ExitCode.CANCELLED
    assert dialogue.lines[-1].startswith("robot: Cancelled: ")


@pytest.mark.requirement("L4")
def test_an_unclear_sentence_is_refused_with_help(serve, talk_to):
    dialogue = talk_to(serve(RED)).say("flarb the cup", "help")

    assert dialogue.end() == ExitCode.INVALID
    assert dialogue.lines[1] == (
        "robot: Refused: the word 'flarb' is not known. ('help' tells what can be said)"
    )
    assert "pick up the red cup on the table" in dialogue.text


@pytest.mark.requirement("F4")
def test_a_failure_is_explained_and_the_corrected_command_carried_out(serve, talk_to):
    dialogue = talk_to(serve(RED)).say("pick up the green cup", "why", "pick up the red one")

    assert dialogue.end() == ExitCode.DONE
    assert "robot: Failed: " in dialogue.text
    assert "('why' tells more)" in dialogue.text
    assert "why: no green cup seen" in dialogue.text
    assert "what helps:" in dialogue.text
    assert dialogue.lines[-1].startswith("robot: Done: red cup held")


@pytest.mark.requirement("S7")
def test_a_cancel_in_the_middle_of_a_task_halts_it_and_the_next_command_is_taken(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING)).say(TASK).until_it_moves("pick/reach").say("cancel")
    dialogue.until("robot: Cancelled: ").say("wait for 0.2 seconds")

    assert dialogue.end() == ExitCode.DONE
    assert "robot: Cancelling: I brake and hold." in dialogue.lines
    assert "cancelled in the chat" in dialogue.text


@pytest.mark.requirement("S7")
def test_a_cancel_typed_at_once_after_a_command_is_not_lost(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING)).say(TASK, "cancel")

    assert dialogue.end() == ExitCode.CANCELLED
    assert dialogue.lines[-1].startswith("robot: Cancelled: ")


@pytest.mark.requirement("S4")
def test_a_stop_goes_to_the_control_socket_latches_and_tells_what_a_person_does_then(serve, talk_to):
    robot = serve(RED, tick_s=MOVING)
    dialogue = talk_to(robot).say(TASK).until_it_moves("pick/reach").say("STOP!")
    dialogue.until("robot: Cancelled: ").say("wait for 0.2 seconds").until("robot: Refused: ")

    assert dialogue.end() != ExitCode.DONE
    assert robot.fake.stops == ["'STOP!' was typed"]
    assert f"robot: Stopped: the emergency stop is engaged. {'A person resets it.'}" in dialogue.lines
    assert "a person has to reset it" in dialogue.text


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("word", ["stop", "halt", "Halt!!", "please stop", "don't move", "freeze", "whoa"])
def test_whatever_means_stop_is_the_emergency_stop(serve, talk_to, word):
    robot = serve(RED)
    dialogue = talk_to(robot).say(word)

    dialogue.end()
    assert len(robot.fake.stops) == 1


@pytest.mark.requirement("S4")
def test_a_stop_is_heeded_before_the_lines_that_stand_before_it(serve, talk_to):
    robot = serve(RED, tick_s=MOVING)
    dialogue = talk_to(robot).say(TASK, "wait for 5 seconds", "wait for 6 seconds", "stop")

    assert dialogue.end() != ExitCode.DONE
    assert "robot: Not begun: 'wait for 5 seconds', 'wait for 6 seconds'." in dialogue.lines
    assert len(robot.fake.stops) == 1


@pytest.mark.requirement("S4")
def test_a_reset_is_refused_to_a_pipe_and_done_for_a_person_at_the_terminal(serve, talk_to):
    robot, left = serve(RED), []
    talk_to(robot).say("stop").until("Stopped").say("reset").until("A reset is a person's").end()
    person = talk_to(robot, typed=True, reset=lambda: left.append(True) or "the emergency stop is left")
    person.say("reset").until("robot: the emergency stop is left").end()

    assert left == [True]


@pytest.mark.requirement("S7")
def test_ctrl_c_cancels_what_is_under_way_and_ends_the_chat_when_nothing_is(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING)).say(TASK).until_it_moves("pick/reach")
    dialogue.press(dialogue.talk.interrupt).until("Ctrl-C again is the emergency stop").until("Cancelled: ")
    dialogue.press(dialogue.talk.interrupt)
    dialogue._thread.join(10.0)

    assert dialogue.talk.is_over
    assert dialogue.talk.code == ExitCode.CANCELLED


@pytest.mark.requirement("S4")
def test_a_second_ctrl_c_is_the_emergency_stop(serve, talk_to):
    robot = serve(RED, tick_s=MOVING)
    dialogue = talk_to(robot).say(TASK).until_it_moves("pick/reach")
    dialogue.press(lambda: (dialogue.talk.interrupt(), dialogue.talk.interrupt())).until("Stopped: ")

    assert dialogue.end() == ExitCode.CANCELLED
    assert robot.fake.stops == ["Ctrl-C, twice"]


@pytest.mark.requirement("U1")
def test_the_end_of_input_in_the_middle_of_a_task_lets_it_end_and_tells_how(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=0.005)).say(TASK).until_it_moves("pick/reach")

    assert dialogue.end() == ExitCode.DONE
    assert dialogue.lines[-1].startswith("robot: Done: red cup held")


@pytest.mark.requirement("L6")
def test_the_end_of_input_at_a_question_leaves_it_open(serve, talk_to):
    dialogue = talk_to(serve()).say("pick up the cup").until("which cup?")

    assert dialogue.end() == ExitCode.QUESTION
    assert "The question stays open: nobody is there to answer." in dialogue.text


@pytest.mark.requirement("U1")
def test_two_commands_typed_while_one_runs_wait_for_their_turn_and_that_is_said(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING), typed=True).say(TASK).until_it_moves("pick/reach")
    dialogue.say("wait for 0.1 seconds", "wait for 0.2 seconds").until("After that", 2)

    assert dialogue.end() == ExitCode.DONE
    assert f"robot: I am busy with '{TASK}'. After that: 'wait for 0.1 seconds'." in dialogue.lines
    told = [line for line in dialogue.lines if line.startswith(("robot: Now ", "robot: Done: "))]
    assert [line.split(":")[1][:8] for line in told] == [" Done", " Now 'wa", " Done", " Now 'wa", " Done"]


@pytest.mark.requirement("U1")
def test_what_waits_is_not_begun_after_a_cancel(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING), typed=True).say(TASK).until_it_moves("pick/reach")
    dialogue.say("wait for 0.1 seconds").until("After that").say("cancel").until("Cancelled: ")

    assert dialogue.end() == ExitCode.CANCELLED
    assert dialogue.lines[-1] == (
        "robot: Not begun: 'wait for 0.1 seconds'. Say it again if you still want it."
    )


@pytest.mark.requirement("S7")
def test_a_pause_holds_and_go_on_goes_on(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING)).say(TASK).until_it_moves("pick/reach")
    dialogue.say("pause").until("I hold, in balance").say("go on").until("Going on.")

    assert dialogue.end() == ExitCode.DONE


@pytest.mark.requirement("U1")
def test_status_and_what_is_seen_are_told_while_a_task_runs(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING), typed=True).say(TASK).until_it_moves("pick/reach")
    dialogue.say("what are you doing?", "What do you see?").until("around me")

    assert dialogue.end() == ExitCode.DONE
    assert any(line.startswith(f"robot: I am busy with '{TASK}': pick/") for line in dialogue.lines)
    assert any("red cup on the table: 0.4 m ahead, 0.2 m to the left" in line for line in dialogue.lines)


@pytest.mark.requirement("U1")
def test_why_before_anything_was_tried_says_so(serve, talk_to):
    dialogue = talk_to(serve(RED)).say("why?")

    dialogue.end()
    assert dialogue.lines[-1] == "robot: Nothing has been tried yet."


@pytest.mark.requirement("U1")
def test_quit_in_the_middle_of_a_typed_task_cancels_it_and_ends(serve, talk_to):
    dialogue = talk_to(serve(RED, tick_s=MOVING), typed=True).say(TASK).until_it_moves("pick/reach")

    assert dialogue.say("quit").until("Cancelled: ").end() == ExitCode.CANCELLED

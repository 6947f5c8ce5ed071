"""What people say beside the command, and how they name things in passing."""

import pytest

from executive.understanding.command_parser import parse
from trees.tasks import ObjectOf


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


class TestReasons:
    @pytest.mark.parametrize(
        "sentence",
        [
            "It's cold in here, close the window.",
            "Close the window, I'm freezing.",
            "My hands are full, so close the window.",
            "Close the window please, it's getting dark outside.",
        ],
    )
    def test_a_reason_before_or_after_a_command_changes_nothing(self, sentence):
        assert tasks_of(sentence) == tasks_of("close the window")

    @pytest.mark.parametrize("reason", ["I'm thirsty.", "It's cold in here.", "The doorbell rang."])
    def test_a_reason_alone_is_no_command(self, reason):
        assert parse(reason).refusal is not None

    def test_a_reason_after_words_to_say_may_be_one_of_them(self):
        assert parse("say good morning to Ana, dinner is ready").question is not None


class TestWhoIsMeant:
    def test_him_is_the_only_man_of_those_who_were_named(self):
        assert tasks_of("wave to Ana and Ben and give him the cup")[-1]["to"] == "Ben"

    def test_her_is_the_only_woman_of_those_who_were_named(self):
        assert tasks_of("find Ben, then find Ana and wave to her")[-1]["person"] == "Ana"

    @pytest.mark.parametrize("two", ["Ben and Tom", "Ben and Sam", "Kim and Sam"])
    def test_two_who_may_both_be_meant_are_asked_about(self, two):
        assert parse(f"wave to {two} and give him the cup").question is not None


class TestHeldAlready:
    @pytest.mark.parametrize("again", ["grasp the cup and lift it", "reach for the cup, then pick it up"])
    def test_lifting_what_was_grasped_is_no_second_task(self, again):
        assert [task["action"] for task in tasks_of(again)] == ["pick"]

    @pytest.mark.parametrize("other", ["lift it with your left hand", "lift it off the table"])
    def test_what_is_said_anew_of_it_is_not_passed_over(self, other):
        assert tasks_of(f"take the cup, {other}") == []


class TestBeforeAList:
    def test_what_and_joins_is_done_before(self):
        said = tasks_of(
            "before you go home, count the cups on the table and wave to Ana and close the drawer"
        )
        assert [task["action"] for task in said] == ["count", "wave", "close", "go_home"]

    @pytest.mark.parametrize("joined", [",", " and"])
    def test_in_a_list_it_stays_open_what_is_done_before(self, joined):
        said = f"before you go home, count the cups, wave to Ana{joined} close the drawer"
        assert parse(said).question is not None


class TestSaidInPassing:
    @pytest.mark.parametrize(
        "command",
        ["put the cup in the box", "take the cup to the shelf", "take the cup and a can", "open the drawer"],
    )
    def test_it_is_not_guessed_which_of_two_things_stands_there(self, command):
        assert tasks_of(f"{command}, it's on the table") == []

    @pytest.mark.parametrize(
        ("sentence", "plainly"),
        [
            ("I've lost my phone, please find it", "find my phone"),
            ("make sure the fridge is closed", "close the fridge"),
            ("count the cups and tell me how many there are", "count the cups"),
            ("whats on the table", "what's on the table"),
        ],
    )
    def test_other_ways_to_say_the_same(self, sentence, plainly):
        assert tasks_of(sentence) == tasks_of(plainly) != []

    def test_a_time_after_a_statement_belongs_to_what_is_said(self):
        assert tasks_of("tell Ben that I'm leaving now")[0]["text"] == "I'm leaving now"

    def test_a_time_after_a_greeting_is_said_of_the_command(self):
        assert tasks_of("say hello now")[0]["text"] == "hello"


class TestInTheRoom:
    def test_in_the_room_says_nothing_of_its_own(self):
        assert tasks_of("how many people are in the room") == tasks_of("how many people are there")

    def test_after_a_place_was_named_it_may_be_that_one(self):
        assert parse("go to the kitchen and tell me how many people are in the room").question is not None


def test_three_of_a_kind_are_told_by_their_colours():
    colors = [task["object"]["color"] for task in tasks_of("take the red, the blue and the green cup")]

    assert colors == ["red", "blue", "green"]


def test_lists_may_be_lettered():
    assert tasks_of("a) close the drawer b) wave") == tasks_of("close the drawer, then wave")


def test_letters_out_of_order_are_asked_about():
    assert tasks_of("b) close the drawer a) wave") == []


def test_the_front_door_has_a_name_as_that_of_a_room_has():
    assert tasks_of("open the front door")[0]["object"] == {"kind": "door", "name": "front door"}


def test_a_slice_of_something_is_that_thing():
    assert tasks_of("bring me a slice of bread") == tasks_of("bring me a piece of bread")


@pytest.mark.parametrize("where", ["on you", "in Ana", "at me"])
def test_a_place_after_the_command_that_is_none_is_refused(where):
    assert tasks_of(f"bring me the cup, it's {where}") == []


def test_coming_and_standing_beside_somebody_is_one_walk():
    assert tasks_of("come, stand next to me") == tasks_of("come to me")


def test_some_things_that_a_statement_names_are_all_of_them():
    said = tasks_of("there are some toys on the floor, put them in the box")

    assert said[0]["count"] == "all"


def test_what_burns_is_not_handed_to_a_baby():
    assert parse("bring the lighter to the baby").refusal is not None


def test_what_is_in_the_hand_comes_from_nowhere_else():
    assert tasks_of("take the keys from the shelf and give them to Ana from the table") == []


def test_they_may_be_one_person():
    assert tasks_of("find the guest and give them the remote")[-1]["to"] == {"kind": "guest"}


@pytest.mark.parametrize("sentence", ["find Ana and Ben and give them the cup", "give them the cup"])
def test_they_who_may_be_several_are_asked_about(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize("words", ["!walk now", "go " * 120])
def test_what_is_said_in_quotation_marks_may_be_no_sentence(words):
    assert tasks_of(f'say "{words}"')[0]["text"] == words.strip()


def test_her_who_is_told_is_nobody_of_whom_it_is_told():
    said = tasks_of("bring the glass to grandma and tell her that the doctor is here")

    assert said[-1]["person"] == {"kind": "grandmother"}


def test_after_that_she_may_be_either():
    assert parse("tell grandma that the doctor is here and wave to her").question is not None


def test_how_many_are_meant_of_a_bare_plural_is_asked():
    assert parse("take the cups and saucers").question.text == "how many of them?"


def test_an_adjective_may_not():
    assert parse("take the red cups and saucers").question is not None


def test_where_somebody_left_a_thing_is_where_it_is():
    assert tasks_of("bring me the book I left on the sofa") == tasks_of("bring me the book from the sofa")


class TestOfOneThingInTheHand:
    def test_it_is_not_picked_twice_when_it_is_named_again_without_its_place(self):
        said = tasks_of("take the cup from the table, walk to the kitchen and bring the cup to Ana")

        assert [task["action"] for task in said] == ["pick", "walk_to", "hand_over"]

    def test_it_may_be_named_by_its_colour_alone(self):
        said = tasks_of(
            "take the red cup from the table and the blue cup from the shelf, bring the red one to Ana"
        )

        assert said[-1] == {"action": "hand_over", "object": {"ref": 0}, "to": "Ana"}

    @pytest.mark.parametrize(
        "sentence",
        [
            "take the cup from the table, take the cup from the shelf and bring the cup to Ana",
            "take the cup from the table and bring a cup to Ana",
        ],
    )
    def test_another_that_may_be_meant_is_asked_about(self, sentence):
        assert parse(sentence).question is not None


def test_what_was_opened_may_be_where_something_is_asked_for():
    assert parse("open the fridge and check if there is any cheese").question is not None


def test_one_dice_is_no_heap_of_them():
    assert "count" not in tasks_of("bring me a dice")[0]


def test_steps_may_be_numbered_in_words():
    assert tasks_of("Step one: open the cupboard. Step two: wave.") == tasks_of(
        "open the cupboard, then wave"
    )


def test_steps_out_of_order_are_asked_about():
    assert parse("Step two: open the cupboard. Step one: wave.").question is not None


class TestWhoLostOrDroppedSomething:
    @pytest.mark.parametrize(
        "sentence",
        [
            "I dropped my pen, please pick it up",
            "The baby dropped her pen. Pick it up.",
            "someone just dropped a pen, can you pick it up",
        ],
    )
    def test_names_the_thing(self, sentence):
        assert tasks_of(sentence) == tasks_of("pick up the pen")

    def test_may_say_where(self):
        assert tasks_of("Tom dropped a fork on the floor, pick it up") == tasks_of(
            "pick up the fork from the floor"
        )

    def test_may_be_who_gets_it(self):
        assert tasks_of("Ana can't find her phone, bring it to her") == tasks_of("bring the phone to Ana")

    @pytest.mark.parametrize(
        "sentence",
        [
            "I dropped my pen",
            "Ana dropped the pen. Close the fridge.",
            "I can't find my pen on the table, find it",
            "Ana dropped her pen. Wave to Maria and give it to her.",
        ],
    )
    def test_is_no_command_and_decides_nothing_that_is_open(self, sentence):
        assert parse(sentence).outcome != "tasks"


class TestAllOfWhatHasNoPlural:
    @pytest.mark.parametrize(
        ("said", "kind"),
        [("all the fruit", "fruit"), ("all the mail", "mail"), ("all my clothes", "clothes")],
    )
    def test_is_counted_as_all(self, said, kind):
        assert tasks_of(f"pick up {said}") == [{"action": "pick", "object": {"kind": kind}, "count": "all"}]

    def test_is_called_it(self):
        assert tasks_of("take all the food from the table and put it in the fridge")[1]["object"] == {
            "ref": 0
        }

    @pytest.mark.parametrize("sentence", ["bring me all my glasses", "pick up all the cup"])
    def test_is_no_other_singular(self, sentence):
        assert parse(sentence).outcome != "tasks"


@pytest.mark.parametrize("at", ["on the left side of", "on the right of", "to the right side of"])
@pytest.mark.parametrize("flat", ["tray", "chopping board", "table"])
def test_a_side_of_what_things_stand_on_is_a_part_of_it(at, flat):
    assert parse(f"put the cup {at} the {flat}").outcome != "tasks"


@pytest.mark.parametrize("sentence", ["wave to Ana together with Ben", "point at Ana along with Ben"])
def test_who_is_named_as_company_may_be_who_acts_too(sentence):
    assert parse(sentence).outcome != "tasks"


class TestBringing:
    @pytest.mark.parametrize(
        ("sentence", "same"),
        [
            (
                "bring the blanket from the sofa and put it on the bed",
                "take the blanket from the sofa and put it",
            ),
            ("bring both cups and put them on the bed", "pick up both cups and put them"),
        ],
    )
    def test_to_nobody_is_to_get_what_is_put_somewhere_then(self, sentence, same):
        assert tasks_of(sentence) == tasks_of(f"{same} on the bed")

    @pytest.mark.parametrize(
        "sentence",
        [
            "bring me the blanket and put it on the bed",
            "bring the cup and the bowl and put them on the table",
            "give Ana the cup and the bowl and then put both on the table",
            "bring the blanket, wave, and put it on the bed",
        ],
    )
    def test_what_somebody_was_given_is_not_put_anywhere(self, sentence):
        assert parse(sentence).question is not None


class TestWhatIsWalkedTo:
    @pytest.mark.parametrize("rest", ["pick it up", "take it", "wave to Ana, then grab it"])
    def test_a_thing_that_is_walked_to_is_it(self, rest):
        walk, *_, pick = parse(f"walk to the red cup and {rest}").commands

        assert walk.to.color == "red"
        assert pick.object == ObjectOf(0)

    @pytest.mark.parametrize(
        "sentence",
        [
            "walk to the red cup and the blue cup and pick it up",
            "walk to the cup, then to the bottle, and pick it up",
            "take the bottle, walk to the cup and pick it up",
        ],
    )
    def test_of_two_things_that_may_be_it_one_is_asked_about(self, sentence):
        assert parse(sentence).question is not None

    def test_what_is_held_stays_it_beside_what_is_walked_to(self):
        assert parse("pick up the cup, go to the bowl and put it down").commands[-1].object == ObjectOf(0)


class TestWhyItIsWanted:
    @pytest.mark.parametrize(
        "sentence",
        [
            "Mom wants the newspaper, take it to her",
            "Mom would like the newspaper. Bring it to her",
        ],
    )
    def test_what_somebody_wants_is_it(self, sentence):
        assert tasks_of(sentence) == tasks_of("bring the newspaper to Mom")

    def test_a_wish_alone_is_no_command(self):
        assert parse("Grandma would like her tea").refusal is not None

    def test_a_wish_for_something_else_is_asked_about(self):
        assert parse("Ben needs the cup. Give him the bowl").question is not None


class TestHesitations:
    @pytest.mark.parametrize(
        "sentence", ["turn left uh right", "turn right uh ninety degrees", "take the box on the left uh one"]
    )
    def test_one_that_may_take_something_back_is_refused(self, sentence):
        assert parse(sentence).refusal is not None

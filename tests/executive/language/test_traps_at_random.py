"""What is forbidden, conditional, told, asked, permitted, planned, taken back or quoted is never done."""

import random

import pytest

from executive.understanding.command_parser import parse

FRAMES = {
    "forbidden": """
        don't {do} | never {do} | please do not {do} | you must not {do} | you shouldn't {do} | stop {doing} |
        I don't want you to {do} | there is no need to {do} | refrain from {doing} |
        whatever you do, don't {do} | nobody should {do} | I'd rather you didn't {do} | you needn't {do} |
        do anything but {do} | {do} - no, don't
    """,
    "conditional": """
        if it rains, {do} | {do} if Ana is home | unless Tom is asleep, {do} | {do} unless I say otherwise |
        when the bell rings, {do} | {do} as soon as Ben arrives | {do} only if it is dirty |
        {do} in case she asks | {do} until I say stop | {do} whenever I sneeze | as long as it is dark, {do} |
        should it get dark, {do}
    """,
    "told": """
        {who} {did} | {who} just {did} | yesterday {who} {did} | {who} has {did} | you {did} |
        you have {did} | {who} is {doing} | {who} was {doing} | {who} forgot to {do} | {who} managed to {do} |
        I saw that {who} {did} | thanks for {doing} | {who} can {do} | {who} should {do} |
        {who} used to {do} | {who} likes to {do} | {doing} is fun | to {do} is easy
    """,
    "asked": """
        did you {do}? | have you {did}? | did {who} {do}? | why did you {do}? | should I {do}? | may I {do}? |
        shall we {do}? | is it possible to {do}? | are you able to {do}? | do you know how to {do}? |
        what happens if you {do}? | how long does it take to {do}? | why don't we {do}? |
        would it be safe to {do}? | do you want to {do}?
    """,
    "permitted": """
        you may {do} | you can {do} | you could {do} | feel free to {do} | you are allowed to {do} |
        it's fine to {do} | {who} may {do} | nobody minds if you {do}
    """,
    "hearsay": """
        {who} said to {do} | {who} says: {do} | {who} told me to {do} | {who} asked you to {do} |
        the note says to {do} | the manual tells you to {do} | according to Ana you {do} |
        {who} said that you should {do} | he shouted {do}
    """,
    "planned": """
        the plan is to {do} | the task is to {do} | I plan to {do} | we are going to {do} | I'll {do} |
        {who} will {do} | I want to {do} | let me {do} | I hope you can {do} | I wish you could {do} |
        imagine you {do} | pretend to {do} | maybe {do} | perhaps you should {do} | it would be nice to {do} |
        I dreamt that you {did} | ideally you would {do}
    """,
    "taken back": """
        {do}, no, wait | {do}, never mind | {do}. Cancel that | {do}. Forget it | {do}, scratch that |
        {do}, no, {other} | {do}, I mean {other} | {do}, sorry, {other} | {do} instead of {doing} |
        {do} or {other} | {do}, or rather {other} | {do}... just kidding | rather than {doing} {other}
    """,
    "quoted": """
        the words "{do}" | "{do}" is what he said | what does "{do}" mean? | translate {do} |
        the phrase {do} is short | how would you say {do} in French | the instruction "{do}" is wrong
    """,
}
WHO = ("I", "we", "he", "she", "they", "Ana", "my sister", "somebody", "the nurse", "the other robot")
VERBS = (
    ("pick up the {thing}", "picked up the {thing}", "picking up the {thing}"),
    ("open the {door}", "opened the {door}", "opening the {door}"),
    ("close the {door}", "closed the {door}", "closing the {door}"),
    ("bring Tom the {thing}", "brought Tom the {thing}", "bringing Tom the {thing}"),
    ("put the {thing} on the shelf", "put the {thing} on the shelf", "putting the {thing} on the shelf"),
    ("take the {thing} to the desk", "took the {thing} to the desk", "taking the {thing} to the desk"),
    ("go to the kitchen", "went to the kitchen", "going to the kitchen"),
    ("wave to Ben", "waved to Ben", "waving to Ben"),
    ("find the {thing}", "found the {thing}", "finding the {thing}"),
)
THINGS = ("cup", "red cup", "bottle", "book", "milk", "keys", "blue ball")
DOORS = ("fridge", "drawer", "window", "cupboard")
JOINTS = (". ", ", ", " and ", "; ", " ", ": ", " because ", " so ", ". Then ")
HOW_MANY = 30


def drawn_order(rng):
    """Infinitive, past and -ing form of one order."""
    names = {"thing": rng.choice(THINGS), "door": rng.choice(DOORS)}
    return [form.format(**names) for form in rng.choice(VERBS)]


def drawn_trap(rng, kind):
    do, did, doing = drawn_order(rng)
    frame = rng.choice(FRAMES[kind].split("|"))
    return frame.strip().format(do=do, did=did, doing=doing, other=drawn_order(rng)[0], who=rng.choice(WHO))


@pytest.mark.requirement("L5")
@pytest.mark.parametrize("kind", FRAMES)
def test_what_is_no_order_is_never_done(kind):
    rng = random.Random(kind)
    traps = [drawn_trap(rng, kind) for _ in range(HOW_MANY)]

    assert [said for said in traps if parse(said).commands] == []


@pytest.mark.requirement("L5")
@pytest.mark.parametrize("kind", FRAMES)
def test_beside_an_order_it_is_never_done_either(kind):
    rng = random.Random(f"beside {kind}")
    done = []
    for _ in range(HOW_MANY):
        both = [drawn_order(rng)[0], drawn_trap(rng, kind)]
        rng.shuffle(both)
        said = rng.choice(JOINTS).join(both)
        done += [said] if parse(said).commands else []

    assert done == []


def test_the_same_orders_are_done_when_they_are_given():
    rng = random.Random(1)
    orders = [drawn_order(rng)[0] for _ in range(HOW_MANY)]

    assert [said for said in orders if not parse(said).commands] == []

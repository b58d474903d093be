"""What is announced about each thing that the robot does, and with which sound."""

import pytest
from msgspec.structs import replace

from devices.ports.robot import Grip, Met, Motion, Pushed, StoppedBy
from donnie_tui.core.announcer import Announcer
from donnie_tui.core.events import (
    Announced,
    CueSounded,
    Driven,
    Error,
    Event,
    GripperUsed,
    HowStarted,
    Link,
    Moved,
    Outcome,
    RunEnded,
    RunStarted,
    Scanned,
    SeenGroup,
    SeenMark,
    SoundSwitched,
    Turned,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.transcript import SentencePublisher
from donnie_tui.core.wording import position_in_words
from donnie_tui.i18n.words import Words
from tests.floor import Floor
from tests.unit.core.values import HERE

OBSTACLE, COLLISION, USER = StoppedBy.OBSTACLE, StoppedBy.COLLISION, StoppedBy.USER


def answers_to(event: Event, language: str = "en", detail: str = "normal") -> list[Event]:
    """What the announcer publishes because of an event."""
    hub, words, heard = Hub(lambda: 0.0), Words(language, detail), list[Event]()
    Announcer(hub, SentencePublisher(hub, words), words)
    hub.subscribe(lambda stamped: heard.append(stamped.event))
    hub.publish(event)
    return heard[1:]


def walked(asked: int, done: int, by: StoppedBy | None = None, *, forward: bool = True) -> Moved:
    return Moved(f"FW {asked}", asked, done, by, HERE, forward)


def turned(asked: int, done: int, by: StoppedBy | None = None, *, right: bool = True) -> Turned:
    return Turned(f"TR {asked}", asked, done, by, HERE, right)


MOVEMENTS = [
    (walked(3, 3), "moved", "I walked 3 steps forward."),
    (walked(1, 1), "moved", "I walked 1 step forward."),
    (walked(-5, 0), "moved", "I walked 0 steps forward."),
    (walked(3, 3, forward=False), "moved", "I walked 3 steps backward."),
    (walked(5, 2, OBSTACLE), "moved", "I walked only 2 steps forward. I found an obstacle."),
    (
        walked(5, 1, OBSTACLE, forward=False),
        "moved",
        "I walked only 1 step backward. I found an obstacle.",
    ),
    (walked(5, 2, COLLISION), "moved", "I walked only 2 steps forward. I hit something."),
    (walked(5, 2, USER), "moved", "I walked only 2 steps forward. I was stopped."),
    (turned(90, 90), "turned", "I turned 90 degrees to the right."),
    (turned(0, 0), "turned", "I turned 0 degrees to the right."),
    (turned(-90, -90), "turned", "I turned 90 degrees to the left."),
    (turned(90, 90, right=False), "turned", "I turned 90 degrees to the left."),
    (turned(-1, -1, right=False), "turned", "I turned 1 degree to the right."),
    (turned(90, 30, COLLISION), "turned", "I turned only 30 degrees to the right. I hit something."),
]


@pytest.mark.parametrize(("event", "code", "sentence"), MOVEMENTS, ids=[each[2] for each in MOVEMENTS])
def test_a_movement_is_announced_in_one_sentence(event: Event, code: str, sentence: str) -> None:
    """The sentences are those of the manual."""
    assert [each for each in answers_to(event) if isinstance(each, Announced)] == [Announced(code, sentence)]


@pytest.mark.parametrize(
    ("event", "cue"),
    [
        (walked(5, 2, OBSTACLE), CueSounded("obstacle", 0.0, 1.0)),
        (walked(5, 2, OBSTACLE, forward=False), CueSounded("obstacle", 180.0, 1.0)),
        (walked(5, 2, COLLISION), CueSounded("bump", 0.0, 0.0)),
        (turned(90, 30, COLLISION), CueSounded("bump", 90.0, 0.0)),
        (turned(-90, -30, COLLISION), CueSounded("bump", -90.0, 0.0)),
    ],
)
def test_a_cue_starts_before_its_sentence_and_comes_from_where_it_happened(
    event: Event, cue: CueSounded
) -> None:
    assert answers_to(event)[0] == cue


def test_the_start_of_a_run_of_an_older_recording_is_announced_by_nothing() -> None:
    assert answers_to(RunStarted("a.gd", "w", "donnie", 0, "0", None)) == []


def test_a_successful_movement_has_no_cue_at_its_end() -> None:
    assert [each for each in answers_to(walked(3, 3)) if isinstance(each, CueSounded)] == []


def test_seen_things_are_announced_and_sounded_from_left_to_right() -> None:
    scanned = Scanned((SeenGroup("left", 30, 17, ("green", "red")), SeenGroup("ahead", 0, 1, ("blue",))))

    assert answers_to(scanned) == [
        CueSounded("scan", 0.0, None),
        CueSounded("found", -30.0, 17.0),
        Announced("scan", "To the 30 degrees in the left: 2 objects of color green, red at 17 steps."),
        CueSounded("found", 0.0, 1.0),
        Announced("scan", "Ahead: 1 object of color blue at 1 step."),
    ]


MARKS = (SeenMark(9, "left", 10, 12), SeenMark(3, "ahead", 0, 1), SeenMark(None, "right", 1, 50))


@pytest.mark.parametrize(
    ("language", "said"),
    [
        (
            "en",
            [
                "Mark 9 at 12 steps, 10 degrees left.",
                "Mark 3 at 1 step, ahead.",
                "A mark at 50 steps, 1 degree right. I can't read it from here.",
            ],
        ),
        (
            "pt",
            [
                "Marca 9 a 12 passos, 10 graus à esquerda.",
                "Marca 3 a 1 passo, à frente.",
                "Uma marca a 50 passos, 1 grau à direita. Não consigo ler daqui.",
            ],
        ),
        (
            "es",
            [
                "Marca 9 a 12 pasos, 10 grados a la izquierda.",
                "Marca 3 a 1 paso, al frente.",
                "Una marca a 50 pasos, 1 grado a la derecha. No puedo leerla desde aquí.",
            ],
        ),
    ],
)
def test_seen_marks_are_announced_and_sounded(language: str, said: list[str]) -> None:
    answers = answers_to(Scanned((), MARKS), language)

    assert [each.text for each in answers if isinstance(each, Announced)] == said
    assert {each.code for each in answers if isinstance(each, Announced)} == {"scan"}
    assert [(each.name, each.bearing) for each in answers if isinstance(each, CueSounded)] == [
        ("scan", 0.0),
        ("found", -10.0),
        ("found", 0.0),
        ("found", 1.0),
    ]


def test_colours_are_announced_in_the_learners_language() -> None:
    scanned = Scanned((SeenGroup("right", 90, 4, ("red",)),))

    assert answers_to(scanned, "es")[-1] == Announced(
        "scan", "A 90 grados a la derecha: 1 objeto de color rojo a 4 pasos."
    )


@pytest.mark.parametrize(
    ("seen", "said"),
    [
        (("yellow",), "À frente: 1 objeto amarelo a 3 passos."),
        (("green", "red"), "À frente: 2 objetos, verde, vermelho, a 3 passos."),
        (("",), "À frente: 1 objeto de cor desconhecida a 3 passos."),
    ],
)
def test_colours_agree_with_the_things_in_portuguese(seen: tuple[str, ...], said: str) -> None:
    assert answers_to(Scanned((SeenGroup("ahead", 0, 3, seen),)), "pt")[-1] == Announced("scan", said)


def test_an_empty_scan_is_announced_too() -> None:
    assert answers_to(Scanned(()))[-1] == Announced("scan", "I see no objects.")


def test_a_run_that_ends_well_has_its_cue_before_its_last_event() -> None:
    floor = Floor()
    floor.run("FW 1")

    assert floor.events[-2] == CueSounded("done", 0.0, None)
    assert isinstance(floor.events[-1], RunEnded)


@pytest.mark.parametrize("program", ["FWD", "SPEAK q", "QUIT"])
def test_any_other_end_of_a_run_has_no_cue_of_success(program: str) -> None:
    floor = Floor(terminal=True)
    floor.run(program)

    assert CueSounded("done", 0.0, None) not in floor.events


@pytest.mark.parametrize(
    ("event", "sentence"),
    [
        (SoundSwitched(True), "Sound on."),
        (SoundSwitched(False), "Sound off."),
        (Link("connected", ""), "Robot connected."),
        (Link("lost", "The cable is out."), "Robot lost. If it moves, switch it off."),
        (Link("restarted", ""), "The robot restarted. It does not move."),
        (Link("battery-low", "7.0"), "The robot's battery is low."),
        (Link("restored", ""), "The robot is back."),
        (Link("runaway", ""), "It does not stop. Switch it off."),
        (
            Link("profile-2018", ""),
            "The wheels count as with the firmware of 2018. Start again with --profile 2018.",
        ),
    ],
)
def test_switches_and_the_connection_to_a_robot_are_announced(event: Event, sentence: str) -> None:
    assert [each.text for each in answers_to(event) if isinstance(each, Announced)] == [sentence]


def test_detail_brief_announces_only_the_result() -> None:
    assert answers_to(walked(5, 2, OBSTACLE), detail="brief")[-1] == Announced(
        "moved", "Only 2 steps. I found an obstacle."
    )


def test_every_motion_has_a_cue() -> None:
    from donnie_tui.core.actions import _CUE_OF

    assert set(_CUE_OF) == set(Motion)


def test_detail_full_adds_the_new_place_where_it_changed() -> None:
    """At detail full the place follows the sentence of the movement."""
    place = "Position 1, 2. Facing east."
    said = [
        [each.text for each in answers_to(event, detail="full") if isinstance(each, Announced)]
        for event in (walked(3, 3), turned(90, 90), walked(3, 0, OBSTACLE))
    ]

    assert [lines[1:] for lines in said] == [[place], [place], []]
    assert len(answers_to(walked(3, 3))) == 1


# --- what was met


def met_in_words(
    event: Event, language: str = "en", detail: str = "normal", *, typed: bool = True
) -> list[str]:
    """What is announced after the sentence of a movement."""
    hub, words, heard = Hub(lambda: 0.0), Words(language, detail), list[Event]()
    Announcer(hub, SentencePublisher(hub, words), words)
    hub.publish(RunStarted("typed", "w", "r", 0, "0", HowStarted("", 1, False, typed, False, HERE)))
    hub.subscribe(lambda stamped: heard.append(stamped.event))
    hub.publish(event)
    return [each.text for each in heard if isinstance(each, Announced)][1:]


def bumped(kind: str, degrees: float, name: str = "") -> Moved:
    return replace(walked(5, 2, COLLISION), met=Met(kind, name, degrees))


@pytest.mark.parametrize(
    ("event", "language", "said"),
    [
        (bumped("wall", 0.0), "en", "Wall, ahead."),
        (bumped("chair", 50.0, "chair7"), "en", "Chair, ahead right."),
        (bumped("chair", -88.0, "chair7"), "pt", "Cadeira, à esquerda."),
        (bumped("wall", 180.0), "es", "Pared, atrás."),
        (bumped("wall", -179.9), "en", "Wall, behind."),
        (bumped("wall", 135.0), "en", "Wall, behind right."),
        (bumped("wall", -135.0), "en", "Wall, behind left."),
        (bumped("wall", -45.0), "en", "Wall, ahead left."),
        (bumped("wall", 22.4), "en", "Wall, ahead."),
        (bumped("wall", 22.6), "en", "Wall, ahead right."),
        (bumped("wall", 340.0), "en", "Wall, ahead."),
        (bumped("robot", 0.0, "bob"), "en", "Bob, ahead."),
        (bumped("robot", 0.0), "pt", "Outro robô, à frente."),
        (bumped("crate", 0.0, "crate2"), "en", "Crate2, ahead."),
        (bumped("crate", 0.0), "en", "Crate, ahead."),
        (bumped("something", 45.0), "en", "Something, ahead right."),
        (bumped("something", 180.0), "pt", "Algo, atrás."),
        (replace(turned(90, 30, COLLISION), met=Met("wall", "", 90.0)), "en", "Wall, right."),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_collision_names_the_thing_and_the_side(event: Event, language: str, said: str) -> None:
    """The sentence follows the one of the manual."""
    assert met_in_words(event, language) == [said]


def test_a_collision_with_nothing_known_has_no_second_sentence() -> None:
    assert met_in_words(walked(5, 2, COLLISION)) == []


def test_a_script_prints_the_manuals_sentence_and_at_full_what_was_met() -> None:
    event = bumped("wall", 0.0)

    assert met_in_words(event, typed=False) == []
    assert met_in_words(event, typed=False, detail="full")[0] == "Wall, ahead."
    assert met_in_words(event, detail="brief") == []


# --- driven by another program


def test_what_another_program_drives_is_announced_once_for_each_motion() -> None:
    hub, words, heard = Hub(lambda: 0.0), Words(), list[Event]()
    Announcer(hub, SentencePublisher(hub, words), words)
    hub.publish(RunStarted("typed", "w", "bob", 0, "0", HowStarted("", 1, False, True, False, HERE)))
    hub.subscribe(lambda stamped: heard.append(stamped.event))
    for motion in ("standing", "forward", "forward", "left", "blocked", "standing", "standing"):
        hub.publish(Driven(motion, HERE))

    assert [each.text for each in heard if isinstance(each, Announced)] == [
        "Another program drives bob forward.",
        "Another program turns bob to the left.",
        "Something blocks bob.",
        "Another program has stopped bob.",
    ]
    assert {each.code for each in heard if isinstance(each, Announced)} == {"driven"}
    assert [each for each in heard if isinstance(each, CueSounded)] == [CueSounded("bump", 0.0, 0.0)]


@pytest.mark.parametrize(
    ("event", "cue", "bearing"),
    [
        (walked(5, 2, OBSTACLE), "obstacle", 0.0),
        (walked(5, 2, OBSTACLE, forward=False), "obstacle", 180.0),
        (walked(5, 2, StoppedBy.STALL), "bump", 0.0),
        (turned(90, 30, COLLISION), "bump", 90.0),
        (turned(90, 30, COLLISION, right=False), "bump", -90.0),
        (turned(-90, -30, OBSTACLE, right=False), "obstacle", 90.0),
    ],
)
def test_a_stop_sounds_on_the_side_to_which_the_robot_moved(event: Event, cue: str, bearing: float) -> None:
    cues = [each for each in answers_to(event) if isinstance(each, CueSounded)]

    assert [(each.name, each.bearing) for each in cues] == [(cue, bearing)]


# --- after the sentence of a movement


def announced_after(event: Event, detail: str = "normal") -> list[tuple[str, str]]:
    """The announcements after the first."""
    return [
        (each.code, each.text) for each in answers_to(event, "en", detail) if isinstance(each, Announced)
    ][1:]


def cone(steps: float) -> Pushed:
    return Pushed("cone", "", "red", steps)


@pytest.mark.parametrize("event", [walked(3, 3), turned(90, 90)])
@pytest.mark.parametrize(
    ("steps", "pushed"),
    [
        ((0.1,), ["little"]), ((0.09,), []), ((0.5,), ["little"]), ((0.51,), ["1"]), ((2.4,), ["2"]),
        ((1, 2, 3), ["1", "2", "3"]), ((1, 2, 3, 4), ["1", "2", "3", "more 1"]),
        ((1, 2, 0.0, 3), ["1", "2", "3"]), ((1, 2, 3, 4, 5), ["1", "2", "3", "more 2"]),
    ],
)  # fmt: skip
def test_what_was_pushed_is_announced_up_to_three_things(
    event: Moved | Turned, steps: tuple[float, ...], pushed: list[str]
) -> None:
    words, thing = Words(), "the red cone"
    sentences = {"little": words("pushed-little", thing=thing)}
    sentences |= {str(each): words("pushed", thing=thing, steps=each) for each in range(1, 6)}
    sentences |= {f"more {each}": words("pushed-more", count=each) for each in (1, 2)}
    moved = replace(event, pushed=tuple(map(cone, steps)))

    assert announced_after(moved) == [("pushed", sentences[each]) for each in pushed]
    assert announced_after(moved, "brief") == []


@pytest.mark.parametrize(("event", "code"), [(walked(3, 3), "moved"), (turned(90, 90), "turned")])
def test_at_detail_full_the_place_follows_and_what_was_met(event: Moved | Turned, code: str) -> None:
    words, place = Words("en", "full"), position_in_words(HERE, Words("en", "full"))
    assert announced_after(event, "full") == [(code, place)]
    still = replace(event, walked=0) if isinstance(event, Moved) else replace(event, turned=0)
    assert announced_after(still, "full") == []
    assert announced_after(event) == []

    met = replace(event, met=Met("wall", "", 90.0), pushed=(cone(2),))
    assert announced_after(met, "full") == [
        (code, words("met", name=words("met-wall"), where=words("around-right"))),
        ("pushed", words("pushed", thing="the red cone", steps=2)),
        (code, place),
    ]
    assert announced_after(met) == [("pushed", words("pushed", thing="the red cone", steps=2))]


@pytest.mark.parametrize(
    ("kind", "name", "said"),
    [
        ("robot", "bob", "bob"), ("robot", "", "met-robot"), ("wall", "north", "met-wall"),
        ("something", "x", "met-something"),
    ],
)  # fmt: skip
def test_an_obstacle_has_its_name_or_its_kind(kind: str, name: str, said: str) -> None:
    words = Words("en", "full")
    named = words(said) if words.knows(said) else said
    event = replace(walked(3, 0), met=Met(kind, name, 0.0))

    assert announced_after(event, "full")[0] == (
        "moved",
        words("met", name=named, where=words("around-front")),
    )


THINGS = (("", "", "", ""), ("gold", "", "", "gold"), ("", "box", "red", "the red box"), ("", "", "red", ""))
GRIPS = [
    *(
        (outcome, cue, thing)
        for outcome, cue in ((Grip.GRIPPED, "grip"), (Grip.RELEASED, "release"))
        for thing in THINGS
    ),
    *((Grip.HOLDS_ALREADY, "nothing", thing) for thing in THINGS),
    *((outcome, "nothing", THINGS[0]) for outcome in (Grip.NOTHING_THERE, Grip.HOLDS_NOTHING)),
]


@pytest.mark.parametrize(("outcome", "cue", "thing"), GRIPS)
def test_the_gripper_has_its_cue_and_names_the_thing(outcome: Grip, cue: str, thing: tuple[str, ...]) -> None:
    *seen, called = thing
    code = f"gripper-{outcome.value}{'' if called else '-something'}"

    assert answers_to(GripperUsed(outcome, *seen)) == [
        CueSounded(cue, 0.0, None),
        Announced("gripper", Words()(code, thing=called)),
    ]


@pytest.mark.parametrize(
    ("event", "following"),
    [
        (SoundSwitched(True), Announced("sound", "Sound on.")),
        (SoundSwitched(False), Announced("sound", "Sound off.")),
        (Announced("waiting", "Waiting."), CueSounded("waiting", 0.0, None)),
        (Announced("no-gripper", "None."), CueSounded("nothing", 0.0, None)),
        (Error("k", 1, 1, "Wrong.", None), CueSounded("error", 0.0, None)),
        (Link("connected", ""), Announced("link", "Robot connected.")),
        (Link("lost", "why"), Announced("link", "Robot lost. If it moves, switch it off.")),
    ],
)
def test_other_events_have_one_sentence_or_one_sound(event: Event, following: Event) -> None:
    assert answers_to(event) == [following]


@pytest.mark.parametrize(
    ("outcome", "cues"), [(Outcome.COMPLETED, ["done"]), (Outcome.FAILED, []), (Outcome.QUIT, [])]
)
def test_only_a_completed_run_has_the_cue_of_the_end(outcome: Outcome, cues: list[str]) -> None:
    hub, words, published = Hub(lambda: 0.0), Words(), list[Event]()
    announcer = Announcer(hub, SentencePublisher(hub, words), words)
    hub.subscribe(lambda stamped: published.append(stamped.event))
    announcer.about_to_end(outcome)

    assert published == [CueSounded(each, 0.0, None) for each in cues]

"""The lines that are printed, shown and spoken: printable, short, never more than the event says."""

import io
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.audio import Cue, Urgency, Utterance
from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import (
    Announced,
    Answered,
    CueSounded,
    Error,
    Event,
    Moved,
    SoundSwitched,
    Spoke,
    Stamped,
    Turned,
    Waited,
)
from donnie_tui.core.transcript import (
    LONGEST_SOURCE,
    MOST_MOVEMENTS,
    History,
    SentencePublisher,
    TranscriptLog,
    lines_of,
    lines_with_robot_name,
    next_log,
    printed_lines,
    with_robot_name,
)
from donnie_tui.core.voice import Cues, Voice
from donnie_tui.i18n.words import Words


@pytest.mark.parametrize(
    ("event", "lines"),
    [
        (Spoke("hello"), ("hello",)),
        (Spoke("two\nlines"), ("two", "lines")),
        (Spoke(""), ("",)),
        (Spoke("a\x1b[2Jb\tc\x07"), ("a [2Jb c ",)),
        (Spoke("ação \u00a0 日本 👩\u200d🔬"), ("ação \u00a0 日本 👩\u200d🔬",)),
        (Spoke("\udcff"), (" ",)),
        (Announced("moved", "I walked."), ("I walked.",)),
        (Answered("Saved."), ("Saved.",)),
        (Waited(3), ()),
        (CueSounded("done", 0.0, None), ()),
    ],
)
def test_an_event_has_printable_lines(event: Event, lines: tuple[str, ...]) -> None:
    assert lines_of(event, Words()) == lines


def test_a_mistake_quotes_the_relevant_part_of_a_long_line() -> None:
    source = "FW 1 " * 100 + "SPEAK q" + " FW 1" * 100

    lines = lines_of(Error("undeclared-variable", 1, 507, "There is no variable q.", None, source), Words())

    assert "SPEAK q" in lines[1]
    assert len(lines[1]) <= LONGEST_SOURCE + len("Line 1: ")


SEVENTY = "0123456789" * 7


@pytest.mark.parametrize(
    ("source", "column", "quoted"),
    [
        (SEVENTY[:60], 60, SEVENTY[:60]),
        (f"  {SEVENTY[:58]}", 1, f"  {SEVENTY[:58]}"),
        (SEVENTY, 1, SEVENTY[:60]),
        (SEVENTY, 31, SEVENTY[:60]),
        (SEVENTY, 32, SEVENTY[1:61]),
        (SEVENTY, 41, SEVENTY[10:70]),
        (SEVENTY, 70, SEVENTY[39:70]),
        (SEVENTY, 71, SEVENTY[40:70]),
        (SEVENTY, 500, SEVENTY[40:70]),
    ],
)
def test_of_a_long_line_sixty_characters_around_the_mistake_are_quoted(
    source: str, column: int, quoted: str
) -> None:
    error = Error("syntax", 1, column, "Wrong.", None, source)

    assert lines_of(error, Words()) == (f"Error, line 1, column {column}: Wrong.", f"Line 1: {quoted}")


@pytest.mark.parametrize(("source", "is_apart"), [("FW q", True), ("", False)])
def test_at_brief_a_mistake_is_on_one_line_of_forty_cells_or_on_its_own(source: str, is_apart: bool) -> None:
    """``Error, line 1: `` has 15 letters."""
    fits, is_long = (Error("syntax", 1, 4, "m" * length, None, source) for length in (25, 26))
    said = ("Line 1: FW q",) if source else ()

    assert lines_of(fits, Words("en", "brief")) == (f"Error, line 1: {'m' * 25}", *said)
    assert lines_of(is_long, Words("en", "brief")) == (
        ("Error, line 1: FW q", "m" * 26) if is_apart else (f"Error, line 1: {'m' * 26}",)
    )


# --- the same lines, spoken and logged


class Diary:
    """A speaker and a cue player that record their calls."""

    def __init__(self) -> None:
        self.said: list[Utterance] = []
        self.played: list[Cue] = []
        self.silenced = 0

    def say(self, utterance: Utterance) -> None:
        self.said.append(utterance)

    def play(self, cue: Cue) -> None:
        self.played.append(cue)

    def silence_speech(self) -> None:
        self.silenced += 1

    silence_cues = silence_speech


def listening(language: str = "en") -> tuple[Diary, Voice, Cues]:
    diary = Diary()
    return diary, Voice(diary, Words(language)), Cues(diary)


def test_the_voice_says_what_is_printed_in_the_learners_language() -> None:
    diary, voice, _ = listening("pt")

    voice(Stamped(1, 0.0, Spoke("olá")))
    voice(Stamped(2, 0.0, Error("syntax", 1, 1, "Não conheço X.", None)))
    voice(Stamped(3, 0.0, Announced("waiting", "Esperando 3 segundos.")))

    assert diary.said == [
        Utterance("olá", Urgency.PROGRAM, "pt"),
        Utterance("Erro na linha 1, coluna 1: Não conheço X.", Urgency.ALERT, "pt"),
        Utterance("Esperando 3 segundos.", Urgency.PROGRESS, "pt"),
    ]


@pytest.mark.parametrize(
    ("language", "message", "lines"),
    [
        (
            "es",
            "AV necesita un número, como AV 2.",
            ("Error, línea 2: AV", "AV necesita un número, como AV 2.", "pista"),
        ),
        ("es", "No conozco FWD.", ("Error, línea 2: No conozco FWD.", "Línea 2: AV", "pista")),
        (
            "pt",
            "Não existe a variável oi.",
            ("Erro na linha 2: AV", "Não existe a variável oi.", "pista"),
        ),
    ],
)
def test_at_detail_brief_no_line_of_a_mistake_is_wider_than_a_braille_display(
    language: str, message: str, lines: tuple[str, ...]
) -> None:
    error = Error("syntax", 2, 1, message, "pista", "AV")

    assert lines_of(error, Words(language, "brief")) == lines
    assert max(map(len, lines)) <= 40


def test_sound_off_silences_voice_and_cues_at_once_until_sound_on() -> None:
    diary, voice, cues = listening()

    for event in (SoundSwitched(False), Spoke("a"), CueSounded("done", 0.0, None), SoundSwitched(True)):
        voice(Stamped(1, 0.0, event))
        cues(Stamped(1, 0.0, event))
    voice(Stamped(1, 0.0, Spoke("b")))
    cues(Stamped(1, 0.0, CueSounded("bump", 90.0, 0.0)))

    assert diary.silenced == 2
    assert [each.text for each in diary.said] == ["b"]
    assert diary.played == [Cue("bump", 90.0, 0.0)]


def test_the_log_has_every_printed_line() -> None:
    out = io.StringIO()
    log = TranscriptLog(out, Words())

    for event in (Spoke("a\nb"), Waited(1), Announced("moved", "I walked.")):
        log(Stamped(1, 0.0, event))

    assert out.getvalue() == "a\nb\nI walked.\n"


def test_a_full_disk_ends_the_log_and_is_reported_once() -> None:
    problems, full = list[OSError](), OSError("disk full")
    tried: list[str] = []

    class Disk(io.StringIO):
        def write(self, text: str) -> int:
            tried.append(text)
            raise full

    log = TranscriptLog(Disk(), Words(), problems.append)
    for text in ("a", "b"):
        log(Stamped(1, 0.0, Spoke(text)))
    assert (tried, problems) == (["a\n"], [full])
    TranscriptLog(Disk(), Words())(Stamped(1, 0.0, Spoke("a")))  # it ends quietly

    closed = io.StringIO()
    log = TranscriptLog(closed, Words())
    closed.close()
    log(Stamped(1, 0.0, Spoke("a")))
    assert closed.closed


def test_a_new_log_gets_the_next_number(tmp_path: Path) -> None:
    assert next_log(tmp_path).name == "log_001.txt"

    for name in ("log_001.txt", "log_041.txt", "log_x.txt", "other.txt"):
        (tmp_path / name).touch()

    assert next_log(tmp_path).name == "log_042.txt"


def test_the_history_keeps_the_newest_movements_and_counts_the_others() -> None:
    history = History(most=3)
    for steps in range(1, 6):
        history.remember(Moved(f"FW {steps}", steps, steps, None, HERE, forward=True))

    assert [number for number, _ in history.movements] == [3, 4, 5]
    assert [event.command for _, event in history.movements] == ["FW 3", "FW 4", "FW 5"]
    assert (history.forgotten, MOST_MOVEMENTS) == (2, 10_000)


# --- sentences about a robot


def said(do: Callable[[SentencePublisher], object]) -> list[tuple[str, str]]:
    published: list[Announced] = []
    hub: Any = Part(publish=published.append)
    do(SentencePublisher(hub, Words()))
    return [(each.code, each.text) for each in published]


HERE = Pose(2.6, -3.4, 90.2)
WALKED = Moved("FW 3", 3, 2, StoppedBy.OBSTACLE, HERE, True)
TURNED = Turned("TR 90", 90, 90, None, HERE, True)


NONE = "No command executed, position [2,-3,90]."
WALK = "Command 1 was FW 3, walked 2, crashed, position [2,-3,90]."
TURN = "Command 2 was TR 90, turned 90, didn't crash, position [2,-3,90]."


def test_a_movement_is_announced_with_its_number_or_that_there_was_none() -> None:
    assert said(lambda it: it.no_movement("history", HERE)) == [("history", NONE)]
    assert said(lambda it: it.movement("state", 1, WALKED)) == [("state", WALK)]
    assert said(lambda it: it.movement("history", 2, TURNED)) == [("history", TURN)]


def test_a_movement_that_lost_the_link_has_not_crashed() -> None:
    for stopped_by, crashed in ((None, False), (StoppedBy.LINK, False), (StoppedBy.STALL, True)):
        moved = Moved("FW 3", 3, 2, stopped_by, HERE, True)
        ((_, sentence),) = said(lambda it, moved=moved: it.movement("state", 1, moved))
        assert (", crashed," in sentence, ", didn't crash," in sentence) == (crashed, not crashed)


def test_a_history_that_was_forgotten_begins_again() -> None:
    history = History(2)
    for event in (WALKED, TURNED, TURNED):
        history.remember(event)
    assert ([*history.movements], history.forgotten) == ([(2, TURNED), (3, TURNED)], 1)
    history.forget()
    assert ([*history.movements], history.forgotten) == ([], 0)
    history.remember(TURNED)
    assert [*history.movements] == [(1, TURNED)]


@pytest.mark.parametrize(
    ("do", "announced"),
    [
        (lambda it: it.place("start", HERE), [("start", "Position 2, -3. Facing east.")]),
        (lambda it: it.announce("belt-on"), [("belt-on", "Belt on.")]),
    ],
)
def test_a_sentence_is_announced_with_its_code(do: Any, announced: list[tuple[str, str]]) -> None:
    assert said(do) == announced


def test_the_help_is_announced_line_by_line() -> None:
    assert said(lambda it: it.help("FW")) == [("help", each) for each in Words().help("FW")]


@pytest.mark.parametrize(
    ("event", "lines"),
    [
        (Announced("hint", "a\nb"), ("bob: a", "bob: b")),
        (Spoke(""), ("bob: ",)),
        *((Announced(code, "a"), ("a",)) for code in ("help", "more-mistakes", "driven", "clients")),
    ],
)
def test_lines_of_a_robot_have_its_name_unless_they_are_about_none(
    event: Event, lines: tuple[str, ...]
) -> None:
    words = Words()

    assert tuple(each.rstrip() for each in printed_lines(Stamped(1, 0.0, event, "bob"), words)) == tuple(
        each.rstrip() for each in lines
    )
    assert printed_lines(Stamped(1, 0.0, event), words) == lines_of(event, words)


def test_a_robots_name_is_before_the_first_of_its_lines() -> None:
    words = Words()

    assert lines_with_robot_name("bob", ("a", "b"), words) == ("bob: a", "b")
    assert lines_with_robot_name(None, ("a", "b"), words) == ("a", "b")
    assert lines_with_robot_name("bob", (), words) == ()
    assert with_robot_name("bob", "a", words) == "bob: a"
    assert with_robot_name(None, "a", words) == "a"


def test_at_detail_full_a_mistake_lists_its_calls_up_to_ten() -> None:
    error = Error("k", 3, 2, "Wrong.", "Hint.", "FW x", calls=tuple(range(1, 13)))
    few = ["Error, line 3, column 2: Wrong.", "Line 3: FW x", "Hint."]

    assert [*lines_of(error, Words())] == few
    found = [*lines_of(error, Words("en", "full"))]
    assert found[:3] == few
    assert found[3:] == [Words()("called-from", line=line) for line in range(1, 11)]

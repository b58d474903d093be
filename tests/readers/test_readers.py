"""Real screen readers read the linear mode: a short lesson.

The long lesson: ``python -m tests.readers.gate yasr`` (or ``fenrir``, ``orca``, ``brltty``).
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from tests.readers.lesson import FIRST_HOUR, FROM_THE_TOUR, OF_A_CHALLENGE, OF_THE_SCREEN, SHORT
from tests.readers.reading import (
    AS_PROMPT,
    BRIEF,
    EACH_LINE,
    FULL_SCREEN,
    Listener,
    is_installed,
    phases_of,
)
from tests.readers.scoring import Phase, is_whole, score, shown
from tests.sessions.learner import until
from tests.sessions.test_first_hours import PEOPLE, typed

pytestmark = pytest.mark.slow

OPTIONS = ("--world", "living_room")
QUITS = {"QUIT", "SAIR", "SALIR"}
ORCA = ("orca", "lxterminal", "xvfb-run", "dbus-run-session", "openbox", "xdotool")
"""The reader, and the programs of its graphical session."""


def needs(*programs: str) -> pytest.MarkDecorator:
    """Skips the test where the reader or a program that it needs is missing."""
    return pytest.mark.skipif(not all(map(is_installed, programs)), reason=f"needs {', '.join(programs)}")


def noise_of_the_screen(reader: str, folder: Path) -> tuple[int, float]:
    """Clean answers of the full screen's lesson and the noise: of three goes the one with the least.

    A reader on a busy machine looks late and says two pictures of the screen as one; what Donnie makes it
    say again is there in every go.
    """
    heard = []
    for attempt in ("one", "two", "three"):
        home = folder / attempt
        home.mkdir()
        heard.append(score(phases_of(reader, OF_THE_SCREEN, home, OPTIONS, mode=FULL_SCREEN)[1:]))
        if heard[-1].noise <= 0.05:
            break
    best = min(heard, key=lambda each: each.noise)
    return best.clean, best.noise


@needs("yasr")
def test_yasr_says_every_answer_once_in_order_and_nothing_else(tmp_path: Path) -> None:
    heard = score(phases_of("yasr", SHORT, tmp_path, OPTIONS))
    assert (heard.once, heard.in_order, heard.clean, heard.noise) == (1.0, 1.0, heard.phases, 0.0)


@needs("yasr")
@pytest.mark.parametrize("language", FIRST_HOUR)
def test_yasr_says_the_first_hour_once_and_in_order(tmp_path: Path, language: str) -> None:
    """As a beginner types it, with RUN, in each language. The line that FIX or CHANGE offers is read, too."""
    heard = score(phases_of("yasr", FIRST_HOUR[language], tmp_path, (*OPTIONS, "--lang", language), {}))
    assert (heard.once, heard.in_order) == (1.0, 1.0)
    assert heard.clean >= heard.phases - 1


@needs("yasr")
@pytest.mark.parametrize("person", PEOPLE, ids=lambda path: path.stem)
def test_yasr_says_what_each_person_was_answered_once_and_in_order(tmp_path: Path, person: Path) -> None:
    """The typed first hours, in the language and with the options of each, up to QUIT."""
    first, *lines = person.read_text(encoding="utf-8").splitlines()
    language, *options = first.split()
    commands = [line or " " for line in typed(lines)]  # a blank runs what waits, as nothing does
    *lesson, _ = commands[: commands.index(*QUITS & set(commands)) + 1]

    heard = score(phases_of("yasr", lesson, tmp_path, (*options, "--lang", language), {}))

    assert (heard.once, heard.in_order) == (1.0, 1.0)
    assert heard.clean >= heard.phases - 1  # on a busy machine it may say a prompt twice


@needs("yasr")
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_yasr_says_the_verdict_of_a_challenge_once_and_in_order(tmp_path: Path, language: str) -> None:
    options = ("--world", "challenge:first_walk", "--lang", language)
    heard = score(phases_of("yasr", OF_A_CHALLENGE, tmp_path, options))
    assert (heard.once, heard.in_order) == (1.0, 1.0)
    assert heard.clean >= heard.phases - 1  # on a busy machine it may say a prompt twice


VERDICTS = {
    "en": ("enter begins it one command solves it", "solved in 1 command", "3 of 3 solved"),
    "pt": ("enter começa um comando resolve", "resolvido em 1 comando", "resolvidos 3 de 3"),
    "es": ("enter empieza un comando lo resuelve", "resuelto en 1 comando", "resueltos 3 de 3"),
}


@needs("yasr")
@pytest.mark.parametrize("language", FROM_THE_TOUR)
def test_a_listening_pupil_solves_the_first_three_challenges_from_the_tour(
    tmp_path: Path, language: str
) -> None:
    """Every line is said once and in order, from the first page to the verdicts and the results."""
    phases = phases_of("yasr", FROM_THE_TOUR[language], tmp_path, ("--lang", language))
    heard, said = score(phases), " ".join(" ".join(each.spoken_words) for each in phases)
    assert (heard.once, heard.in_order) == (1.0, 1.0)
    assert heard.clean >= heard.phases - 2  # on a busy machine it may say a prompt twice
    for each in VERDICTS[language]:
        assert each in said
    assert said.count(VERDICTS[language][1].replace("1 com", "2 com")) == 2


@needs("fenrir")
def test_fenrir_says_every_answer_once_with_little_noise(tmp_path: Path) -> None:
    heard = score(phases_of("fenrir", SHORT, tmp_path, OPTIONS))
    assert heard.once == 1.0
    assert heard.noise <= 0.05


@needs("fenrir")
def test_fenrir_repeats_an_answer_that_is_still_on_the_screen(tmp_path: Path) -> None:
    walk = "FOR VAR i = 1; i <= 8; i = i + 1 DO FW i TR 10 * i END FOR"
    heard = score(phases_of("fenrir", (walk, "SHOW LOG", "SHOW LOG"), tmp_path, OPTIONS))
    assert (heard.once, heard.in_order) == (1.0, 1.0)


@needs(*ORCA)
def test_orca_says_forty_lone_numbers_and_what_comes_after(tmp_path: Path) -> None:
    """Orca takes a block of only digits for typing."""
    count = "FOR VAR i = 1; i <= 40; i = i + 1 DO SPEAK i END FOR"
    heard = score(phases_of("orca", ("FW 2", count, "SHOW LOG", "WHERE"), tmp_path, OPTIONS))
    assert (heard.once, heard.in_order, heard.clean, heard.noise) == (1.0, 1.0, heard.phases, 0.0)


@needs("fenrir")
def test_fenrir_says_the_answers_of_the_plain_full_screen_with_little_noise(tmp_path: Path) -> None:
    """Fenrir compares the screen before and after."""
    clean, noise = noise_of_the_screen("fenrir", tmp_path)
    assert clean >= 8
    assert noise <= 0.05


@pytest.mark.parametrize(
    "reader", [pytest.param("orca", marks=needs(*ORCA)), pytest.param("yasr", marks=needs("yasr"))]
)
def test_no_row_of_the_plain_full_screen_is_said_again(reader: str, tmp_path: Path) -> None:
    """The log does not scroll, so that a reader does not repeat earlier rows with each answer."""
    clean, noise = noise_of_the_screen(reader, tmp_path)
    assert clean >= 7
    assert noise <= 0.05


@needs("brltty")
def test_a_braille_display_shows_the_last_line_of_every_answer(tmp_path: Path) -> None:
    """A display of 40 cells shows the line without a key, whole unless it leaves no room for the cursor."""
    phases = phases_of("brltty", SHORT, tmp_path, (*OPTIONS, *BRIEF), AS_PROMPT)[1:]
    assert [(each.command, each.heard[-1:]) for each in phases if not shown(each)] == []
    assert sum(map(is_whole, phases)) >= len(phases) - 1


IN_AUTO = ("--speech", "auto")
WITH_A_DEVICE = {**EACH_LINE, "PULSE_SERVER": "unix:/nowhere/pulse"}
"""With a named sound server Donnie would choose the built-in voice. It must stay inaudible."""


def voices_below(parent: int) -> list[int]:
    """The processes below that one that make sound."""
    found = []
    for each in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            is_voice = b"devices.audio.worker" in (each / "cmdline").read_bytes()
            if is_voice and parent in ancestors(int(each.name)):
                found.append(int(each.name))
    return found


def ancestors(pid: int) -> Iterator[int]:
    while pid > 1:
        pid = int(Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
        yield pid


@contextmanager
def voices_of(listener: Listener) -> Iterator[list[int]]:
    """The voice processes that the listener's Donnie starts; one without a device ends soon."""
    found, is_over = list[int](), threading.Event()

    def look() -> None:
        while not is_over.wait(0.02):
            found.extend(voices_below(listener.child.pid))

    looking = threading.Thread(target=look, daemon=True)
    looking.start()
    try:
        yield found
    finally:
        is_over.set()
        looking.join()
        listener.close()


@pytest.mark.parametrize("reader", [pytest.param(each, marks=needs(each)) for each in ("yasr", "fenrir")])
def test_no_voice_process_starts_under_a_reader(reader: str, tmp_path: Path) -> None:
    """With a screen reader Donnie does not speak."""
    listener = Listener(reader, tmp_path, (*OPTIONS, *IN_AUTO), WITH_A_DEVICE)
    with voices_of(listener) as found:
        listener.take_lesson([Phase(command, (), ()) for command in ("", "WHERE", "FW 2")])

    assert not found


@needs("espeak-ng")
def test_without_a_reader_the_same_session_has_a_voice_process(tmp_path: Path) -> None:
    """Shows that the test above would see one."""
    listener = Listener("none", tmp_path, (*OPTIONS, *IN_AUTO), {**WITH_A_DEVICE, "DONNIE_READER": "off"})
    with voices_of(listener) as found:
        listener.child.expect("> ")
        listener.child.send(b"WHERE\r")
        until(lambda: bool(found))


def test_the_last_text_on_a_display_counts() -> None:
    assert shown(Phase("SPEAK 5", ("4", "5"), ("SPEAK 5", "4 5", "5")))
    assert not shown(Phase("SPEAK 5", ("5",), ("5", ">")))
    assert not shown(Phase("SPEAK 5", ("5",), ()))
    long = Phase("STATE", ("a" * 41 + "b.",), ("ab.",))
    assert shown(long)
    assert not is_whole(long)


def test_repeated_and_extra_words_are_counted() -> None:
    phases = [
        Phase("FW 3", ("I walked 3 steps.",), ("I walked 3 steps.",)),
        Phase("FW 2", ("I walked 2 steps.",), ("FW 2", "I walked 2 steps.")),
        Phase("POS", ("Here.", "Facing north."), ("Here.", "Here.", "Facing north.", "2>"), "2> "),
        Phase("SCAN", ("Nothing here.",), ()),
    ]
    heard = score(phases)
    assert (heard.clean, heard.phases) == (1, 4)
    assert heard.once == 3 / 5
    assert heard.in_order == pytest.approx(11 / 13)
    assert heard.noise == pytest.approx(3 / 14)

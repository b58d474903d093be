"""Every word of the linear mode in one session prints only plain text."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path

import pexpect
import pytest

from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.lookup import typed_form, word_of
from donnie_tui.i18n.help import CHAPTERS, chapter_lines
from donnie_tui.i18n.words import Words
from tests.sessions.command import end, environment
from tests.sessions.learner import Learner
from tests.sessions.typed_lines import printed_by, quiet
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

LANGUAGES = ("en", "pt", "es")
PROGRAMS = {
    "en": "VAR x = 2\nREPEAT 2 TIMES\nFW x\nTR 90\nEND REPEAT\nSCAN\nSPEAK DISTANCE F",
    "pt": "CRIAR x = 2\nREPITA 2 VEZES\nPF x\nGD 90\nFIM REPITA\nESPIAR\nFALAR DISTÂNCIA F",
    "es": "CREAR x = 2\nREPETIR 2 VECES\nAV x\nGD 90\nFIN REPETIR\nMIRAR\nHABLAR DISTANCIA F",
}
ELSEWHERE = {"quit", "visual", "connect"}
"""They leave, or look for devices."""
NOT_ALONE = {"open", "save_as", "save_log", "run_to", "search"}
"""The linear mode asks for their argument or explains it."""
SETTING = {"en": ["SET page off"], "pt": ["AJUSTAR página nada"], "es": ["AJUSTAR página nada"]}
DRAWN = {"map_picture", "show_path"}
"""A picture is asked for, and is not text."""


def every_word(language: str, *, without: set[str] = ELSEWHERE) -> list[str]:
    """A program, a run, a mistake, then each word as its help says it, and alone where that means something.

    Changes are undone, so that each word has a program.
    """
    words = Words(language)
    command = PROGRAMS[language].split("\n")[-1]
    goes_on, takes_back = words_of("continue_", language), words_of("undo", language)
    behind = {
        "set": SETTING[language],
        "replace": [""],  # by what, where it is found
        "step": [goes_on],
        "step_over": [goes_on],
        "run_to": [goes_on],
        "new": [takes_back],
        "change": [command],
        "insert": [command],
        "delete": [takes_back],
        "translate": [takes_back],
        "tour": ["", words_of("stop", language)],
    }
    lines = [*PROGRAMS[language].split("\n"), "", "FWD 3", ""]
    for case in (each for each in COMMANDS if not each.is_visual and each.name not in without):
        lines += [typed_form(case, words), *behind.get(case.name, ())]
        if case.argument and not case.required and case.name not in NOT_ALONE:
            lines += [word_of(case, language), *behind.get(case.name, ())]
    return [*lines, *(f"{words_of('manual', language)} {chapter}" for chapter in range(1, len(CHAPTERS) + 1))]


def read_in_manual(language: str) -> list[str]:
    """Its programs have lines that are typed here too."""
    return [line for chapter in CHAPTERS for line in chapter_lines(Words(language), chapter)]


def words_of(name: str, language: str) -> str:
    return word_of(BY_NAME[name], language)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_word_in_a_file_of_typed_lines_answers_in_plain_text(tmp_path: Path, language: str) -> None:
    """Printable, no empty line, no blanks at the ends, nothing typed is printed again."""
    lines = every_word(language, without=ELSEWHERE | DRAWN | {"language"})
    said = printed_by(tmp_path, language, lines)

    assert said.pop() == ""
    assert [line for line in said if not line or line != line.strip()] == []
    assert [line for line in said if not line.isprintable()] == []
    assert [line for line in said if re.search(r"([^\w\s])\1\1", line)] == []
    repeated = {each for each in lines if each} - set(read_in_manual(language))
    assert [line for line in said if line in repeated] == []
    assert [line for line in said if "Donnie failed" in line or "inside Donnie" in line] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_word_is_understood(tmp_path: Path, language: str) -> None:
    """Each is typed as its help says, and none is answered by its form."""
    said = printed_by(tmp_path, language, every_word(language, without=ELSEWHERE | {"language"}))
    not_understood = Words(language)("command-example", example="").split(".")[0]

    assert [line for line in said if line.startswith(not_understood)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_at_detail_brief_no_answer_to_a_word_is_wider_than_a_braille_display(
    tmp_path: Path, language: str
) -> None:
    """Except for quoted lines of the learner and an author's words about a world."""
    authored = {"world", "task", "challenge", "next_challenge", "hint"}
    lines = every_word(language, without=ELSEWHERE | authored | {"language", "detail", "report", "recover"})
    said = printed_by(tmp_path, language, lines, "--verbosity", "brief")

    assert [line for line in said if len(line) > 40 and not line.startswith(("Error", "Erro"))] == []


def test_with_the_plain_editor_a_terminal_gets_nothing_but_text(tmp_path: Path) -> None:
    """No escape, no carriage return but that of the terminal's own line ends, no bell."""
    command = quiet("en")
    child: pexpect.spawn[bytes] = pexpect.spawn(
        command[0],
        command[1:],
        env=environment(tmp_path, {"TERM": "xterm", "DONNIE_EDITOR": "plain"}),
        cwd=str(tmp_path),
        dimensions=(24, 80),
        timeout=TIMEOUT,
    )
    child.delaybeforesend = None
    raw = b""
    for line in [*every_word("en"), "QUIT"]:
        child.expect(rb"(?:\A|\n)(?:[0-9]+)?> $")
        raw += child.before + child.match[0]
        child.send(line.encode() + b"\n")
    child.expect([pexpect.EOF, "Enter é não".encode()])  # it talks Portuguese by then
    raw += child.before
    end(child)

    assert b"\x1b" not in raw and b"\a" not in raw and b"\b" not in raw
    text = raw.replace(b"\r\n", b"\n").decode()
    assert [each for each in text if each != "\n" and unicodedata.category(each) == "Cc"] == []
    assert "\n\n" not in text.replace("> \n", "> typed\n")


LONG_ANSWERS = ("AROUND", "MAP", "MAP PICTURE", "HELP REPEAT", "LIST", "SENSORS", "WORLD", "MANUAL 2")


@pytest.mark.parametrize("columns", [20, 40, 80])
def test_a_line_that_wraps_is_read_whole_at_every_width(tmp_path: Path, columns: int) -> None:
    """Nothing is cut, repainted or lost: the terminal wraps what is too long for it."""
    command = quiet("en")
    child: pexpect.spawn[bytes] = pexpect.spawn(
        command[0],
        command[1:],
        env=environment(tmp_path, {"TERM": "xterm"}),
        cwd=str(tmp_path),
        dimensions=(24, columns),
        timeout=TIMEOUT,
    )
    child.delaybeforesend = None
    long = 'SPEAK "one two three four five six seven eight nine ten eleven twelve thirteen fourteen"'
    child.expect_exact("> ")
    child.send(long + "\r")
    child.expect_exact("> ")
    child.send("\r")
    child.expect_exact("thirteen fourteen\r\n> ")
    assert child.before.decode().strip() == long[7:-19].strip()
    said = []
    for line in LONG_ANSWERS:
        child.send(f"{line}\r")
        child.expect(rb"\r\n> $")
        said += child.before.decode().replace("\r\n", "\n").split("\n")[1:]
    end(child)

    assert said == printed_by(tmp_path, "en", [long, "", *LONG_ANSWERS])[3:-2]


def test_a_challenge_asks_about_its_world_after_a_program_that_does_not_solve_it(tmp_path: Path) -> None:
    """A line alone is no program; of the table in the living room Donnie asks the colour, which is red."""
    learner = Learner(tmp_path, "--world", "challenge:blue_things", language="es")
    learner.enters("AV 1", "", "REPETIR 2 VECES", "AV 1", "FIN REPETIR", "")
    learner.sees("¿De qué color es este objeto: mesa?")
    learner.sees("> ")
    learner.types("rojo\r")
    learner.sees("Acertaste 1 de 1 pregunta.")

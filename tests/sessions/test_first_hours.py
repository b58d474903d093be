"""The first hour of four people, as they type it and as it is printed: a pupil, a braille reader, a teacher
and an author of scripts. Each file was read aloud from its first line to its last.

A file begins with the language and options of donnie. What is typed comes after a
prompt.
"""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.environment import of_a_process
from tests.sessions.learner import Learner

pytestmark = pytest.mark.slow

PEOPLE = sorted(Path(__file__).with_name("first_hours").glob("*.txt"))
BRAILLE_CELLS = 40
_PROMPT = re.compile(r"[0-9]*> ")


def typed(lines: list[str]) -> list[str]:
    """What the lines say is typed, each at its prompt."""
    return [line[prompt.end() :] for line in lines if (prompt := _PROMPT.match(line))]


@pytest.mark.parametrize("person", PEOPLE, ids=lambda path: path.stem)
def test_a_first_hour_is_printed_as_it_was_read(person: Path, tmp_path: Path) -> None:
    first, *lines = person.read_text(encoding="utf-8").splitlines()
    language, *options = first.split()
    learner = Learner(tmp_path, *options, language=language)

    learner.enters(*typed(lines))

    assert learner.leaves() == 0
    assert learner.lines[: len(lines)] == lines


def test_the_braille_reader_gets_no_line_that_a_display_cuts_off() -> None:
    (person,) = (each for each in PEOPLE if each.stem == "braille_reader")
    printed = person.read_text(encoding="utf-8").splitlines()[1:]

    assert [line for line in printed if len(line) > BRAILLE_CELLS] == []


def test_the_author_of_scripts_gets_the_codes_and_the_totals(tmp_path: Path) -> None:
    """What is wrong is in the exit code; CHECK writes all of it to standard output."""
    lessons = tmp_path / "lessons"
    lessons.mkdir()
    (lessons / "good.gd").write_text("FW 3\n")
    (lessons / "wrong.gd").write_text("FW\nTR 90\n")

    def donnie(*words: str, typed: str = "") -> tuple[int, list[str], list[str]]:
        command = [sys.executable, "-m", "donnie_tui", *words]
        ran = subprocess.run(
            command,
            input=typed,
            capture_output=True,
            text=True,
            check=False,
            cwd=tmp_path,
            env=of_a_process(tmp_path),
        )
        return ran.returncode, ran.stdout.splitlines(), ran.stderr.splitlines()

    assert donnie("check", "lessons") == (
        1,
        [
            "lessons/good.gd: no mistakes.",
            "lessons/wrong.gd:1:1: syntax: FW needs a number, such as FW 2.",
            "2 programs. 1 with mistakes, 1 without.",
        ],
        [],
    )
    assert donnie("chek", "good.gd") == (2, [], ["I do not know the command chek. Did you mean check?"])
    assert donnie("--screen-reader", typed="FW 3\nRUN\n")[0] == 0
    assert donnie("--linear", typed="WALK 3\nRUN\n")[0] == 1
    assert donnie("--linear", typed="FW 1 / 0\nRUN\n")[0] == 1
    assert donnie("--linear", "none.gd") == (
        2,
        ["Linear mode, from the option.", "There is no file none.gd.", "Goodbye."],
        [],
    )

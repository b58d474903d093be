"""A language that is added as a folder is there everywhere, and no line of Python knows of it."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.i18n import po
from donnie_tui.i18n.words import Sentence, filled
from language.locales import BUILT_IN, ENGLISH
from tests.sessions.command import QUIET, donnie
from tests.tui.terminal import F5, Terminal
from tests.unit.i18n.pseudo_language import CODE, pseudo, typed, write_language

ENGLISH_SENTENCES = {each.context: each.english for each in po.read(Path(BUILT_IN, ENGLISH, "messages.po"))}
MISSING = ("turned-right", "turned-right|brief", "TL", "reset")


@pytest.fixture
def added(tmp_path: Path) -> dict[str, str]:
    """The environment in which there is the language."""
    write_language(tmp_path / "locales", without=MISSING)
    return {"DONNIE_LOCALES": str(tmp_path / "locales")}


def sentence(code: str, forms: dict[str, str] | None = None, **values: object) -> str:
    """A sentence of the language; ``forms`` are the words that agree with numbers."""
    text = pseudo(ENGLISH_SENTENCES[code])
    for place, form in (forms or {}).items():
        text = text.replace(place, form)
    return filled(Sentence(text, ENGLISH), values)


def lines_of_session(folder: Path, added: dict[str, str], *lines: str) -> list[str]:
    done = donnie(
        folder,
        "--linear",
        "--lang",
        CODE,
        *QUIET,
        typed="".join(f"{each}\n" for each in lines),
        changes=added,
    )
    assert done.stderr == b""
    return done.stdout.decode().splitlines()


def test_a_session_is_in_the_language_from_its_first_line(tmp_path: Path, added: dict[str, str]) -> None:
    printed = lines_of_session(
        tmp_path, added, f"{typed('FW')} 1 {typed('FW')} 2 {typed('FW')} 3", "", typed("SPEED")
    )

    place = pseudo("{steps:step|steps}")
    assert printed[:2] == [sentence("linear-cause-option"), sentence("start-hint")]
    assert [line for line in printed if line.startswith(pseudo("I walked"))] == [
        sentence("walked-forward", {place: pseudo("step")}, steps=1),
        sentence("walked-forward", {place: pseudo("steps") + "-II"}, steps=2),
        sentence("walked-forward", {place: pseudo("steps")}, steps=3),
    ]
    assert sentence("answer-speed", speed=5) in printed


def test_a_mistake_is_explained_in_the_language_with_its_words(tmp_path: Path, added: dict[str, str]) -> None:
    printed = "\n".join(lines_of_session(tmp_path, added, "FWZUU 2", "", typed("EXPLAIN")))

    assert sentence("mistake-unknown-command", found="FWZUU", name="FWZUU") in printed
    assert sentence("hint-meant", meant="FWZU") in printed
    assert sentence("help-example", example="FWZU 5") in printed


def test_help_has_the_purposes_and_examples_of_the_language(tmp_path: Path, added: dict[str, str]) -> None:
    printed = lines_of_session(tmp_path, added, typed("HELP"), f"{typed('HELP')} repeat")

    assert f"{typed('SCAN')}: {sentence('purpose-SCAN')}" in printed
    example = "REPEATZU 4 TIMESZU FWZU 2 TRZU 90 ENDZU REPEATZU"
    assert sentence("help-example", example=example) + "." in printed


def test_what_is_missing_is_english(tmp_path: Path, added: dict[str, str]) -> None:
    printed = lines_of_session(tmp_path, added, "TRZU 90 TL 90", "", f"{typed('HELP')} RESET")

    degrees = {pseudo("{degrees:degree|degrees}"): pseudo("degrees")}
    assert "I turned 90 degrees to the right." in printed
    assert sentence("turned-left", degrees, degrees=90) in printed
    assert f"RESET: {sentence('action-reset')}" in printed


def test_the_doctor_lists_what_is_missing(tmp_path: Path, added: dict[str, str]) -> None:
    printed = donnie(tmp_path, "doctor", "--lang", "en", changes=added).stdout.decode()

    (line,) = [line for line in printed.splitlines() if "lacks" in line]
    assert line.startswith("Problem: zz lacks 5 texts")
    assert all(
        each in line for each in ("messages.po turned-right", "keywords.toml TL", "commands.toml reset")
    )


def test_a_program_is_translated_into_the_language_and_back(tmp_path: Path, added: dict[str, str]) -> None:
    (tmp_path / "walk.gd").write_text("REPEAT 2 TIMES FW 1 END REPEAT")
    there = donnie(tmp_path, "format", "--to", CODE, "walk.gd", changes=added).stdout
    (tmp_path / "there.gd").write_bytes(there)

    assert there.decode() == "REPEATZU 2 TIMESZU\n  FWZU 1\nENDZU REPEATZU\n"
    back = donnie(tmp_path, "format", "--to", "pt", "there.gd", changes=added).stdout
    assert back.decode() == "REPITA 2 VEZES\n  PF 1\nFIM REPITA\n"


@pytest.fixture
def screen(tmp_path: Path, added: dict[str, str]) -> Iterator[Terminal]:
    made = Terminal(["--lang", CODE], tmp_path, 120, 40, added)
    yield made
    made.close()


@pytest.mark.slow
def test_the_full_screen_is_in_the_language(screen: Terminal) -> None:
    screen.shows(sentence("screen-start"))
    screen.shows(pseudo("Ready").upper())
    screen.type("FWZU 2")
    screen.shows("FWZU 2")
    screen.type(F5)
    screen.shows(pseudo("I walked 2 steps"))
    screen.shows(sentence("pane-log"))

"""Each program in the folders here prints exactly the text of its ``.output`` file.

A program is in the folder of its language; ``-- world: NAME`` in its first line selects its world, or
``-- world: NAME.world`` a file in the folder of this module.
The last line of ``.output`` is the outcome and the pose. After an intended change, read the difference
and write the files again with ``ACCEPT_OUTPUT=1 pytest tests/programs``.

The examples in the guide and in the documents of a language (``docs/pt``) print the block of text after
them, in the world where a session begins. ``ACCEPT_OUTPUT=1`` writes it, too.
"""

import os
import re
from pathlib import Path

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import words_of
from donnie_tui.core.events import Event, RunEnded
from donnie_tui.core.session import RunOptions
from donnie_tui.core.transcript import lines_of
from donnie_tui.core.wording import keys_of, spelled
from donnie_tui.i18n.help import ENTRIES
from donnie_tui.settings.settings import Settings
from language.keywords import ARGUMENTS, WORDS, spelling
from tests.timeouts import TIMEOUT

FOLDER = Path(__file__).parent
PROGRAMS = sorted(FOLDER.glob("*/*.gd"))
GUIDES = [Path("docs/guide.md"), Path("docs/pt/guia.md"), Path("docs/es/guia.md")]
DOCUMENTS = sorted({*Path("docs").glob("??/*.md"), *GUIDES})
EXAMPLE = re.compile(
    r"(?P<before>^```godonnie\n(?P<program>.*?)^```\n.*?^```text\n)(?P<printed>.*?)^```\n",
    re.DOTALL | re.MULTILINE,
)

CODE = re.compile(r"^ *```\w*\n.*?^ *```$|`[^`\n]+`|\]\([^)]*\)", re.DOTALL | re.MULTILINE)
CAPITALS = re.compile(r"\b[A-ZÀ-ÖØ-Þ]{2,}(?: [A-ZÀ-ÖØ-Þ]{2,})*\b")
NO_WORDS = {"END", "FIM", "FIN", "SSH", "NVDA", "BRLTTY", "YASR"}


def output_of(program: Path) -> tuple[str, ...]:
    return printed_by(program.read_text(encoding="utf-8"), program.name, language_of(program))


def printed_by(text: str, name: str, language: str, default: str = "open_floor") -> tuple[str, ...]:
    """The printed lines of a run, and its end."""
    world = re.match(r"-- world: (\w+)(\.world)?", text)
    name_of_world = world[1] if world else default
    settings = Settings(
        world=str(FOLDER / f"{name_of_world}.world") if world and world[2] else name_of_world,
        language=language,
        speed=None,
        speech="off",
        sound=False,
    )
    donnie = assemble(settings, terminal=False)
    try:
        events: list[Event] = []
        donnie.session.hub.subscribe(lambda stamped: events.append(stamped.event))
        assert donnie.session.start(text, name, RunOptions(fresh=True, hooked=False)).wait(TIMEOUT)
        lines = [line for event in events for line in lines_of(event, donnie.words)]
        return (*lines, ending(events[-1]))
    finally:
        donnie.close()


def language_of(program: Path) -> str:
    return program.parent.name if program.parent.name in ("pt", "es") else "en"


def ending(event: Event) -> str:
    assert isinstance(event, RunEnded)
    pose = event.pose
    return f"({event.outcome.value}: {pose.x:g} {pose.y:g} {pose.heading:g})"


@pytest.mark.parametrize("program", PROGRAMS, ids=[f"{each.parent.name}/{each.stem}" for each in PROGRAMS])
def test_a_program_prints_its_expected_output(program: Path) -> None:
    expected = program.with_suffix(".output")
    output = "".join(f"{line}\n" for line in output_of(program))
    if os.environ.get("ACCEPT_OUTPUT"):
        expected.write_text(output, encoding="utf-8")

    assert output == expected.read_text(encoding="utf-8")


def test_every_expected_output_has_its_program() -> None:
    output = {each.with_suffix("") for each in FOLDER.glob("*/*.output")}

    assert output == {each.with_suffix("") for each in PROGRAMS}


@pytest.mark.parametrize("language", ["pt", "es"])
def test_a_square_is_the_same_in_every_language(language: str) -> None:
    name = {"pt": "quadrado", "es": "cuadrado"}[language]

    assert output_of(FOLDER / language / f"{name}.gd")[-1] == "(completed: 0 0 0)"


@pytest.mark.parametrize("document", DOCUMENTS, ids=[f"{each.parent.name}/{each.stem}" for each in DOCUMENTS])
def test_every_example_of_a_document_prints_the_text_after_it(document: Path) -> None:
    text = document.read_text(encoding="utf-8")
    printed = EXAMPLE.sub(lambda example: _as_printed(example, language_of(document)), text)
    if os.environ.get("ACCEPT_OUTPUT"):
        document.write_text(printed, encoding="utf-8")

    assert len(EXAMPLE.findall(text)) == text.count("```godonnie") > 0
    assert printed == document.read_text(encoding="utf-8")


@pytest.mark.parametrize("guide", GUIDES, ids=[each.as_posix() for each in GUIDES])
def test_a_guide_has_an_example_of_every_command_of_a_program(guide: Path) -> None:
    """RUN, HELP and QUIT are typed at the prompt."""
    examples = " ".join(each["program"] for each in EXAMPLE.finditer(guide.read_text(encoding="utf-8")))
    commands = {spelling(each, language_of(guide)) for each in {*ENTRIES} - {"RUN", "HELP", "QUIT"}}

    assert {each for each in commands if not re.search(rf"\b{each}\b", examples)} == set()


@pytest.mark.parametrize("document", DOCUMENTS, ids=[f"{each.parent.name}/{each.stem}" for each in DOCUMENTS])
def test_every_word_in_capitals_in_a_document_is_one_that_can_be_typed(document: Path) -> None:
    language = language_of(document)
    commands = (word for each in COMMANDS for word in words_of(each.name, language))
    keywords = (word for each in (*WORDS, *ARGUMENTS) for word in each.spellings[language])
    topics = (spelled(each, language, "help").upper() for each in keys_of("help"))
    building = (spelled(each, language, "building").upper() for each in keys_of("building"))
    can_be_typed = {*commands, *keywords, *topics, *building, *NO_WORDS}
    named = CAPITALS.findall(CODE.sub("", document.read_text(encoding="utf-8")))

    assert {name for name in named if not _consists_of(name.split(), can_be_typed)} == set()


def _consists_of(words: list[str], known: set[str]) -> bool:
    lengths = range(1, min(4, len(words)) + 1)
    return not words or any(
        " ".join(words[:each]) in known and _consists_of(words[each:], known) for each in lengths
    )


def _as_printed(example: re.Match[str], language: str) -> str:
    """An example with what it really prints."""
    lines = printed_by(example["program"], "example.gd", language, Settings().world)[:-1]
    return "\n".join((example["before"].rstrip("\n"), *lines, "```\n"))

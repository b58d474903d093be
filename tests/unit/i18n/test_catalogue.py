"""Every code has a natural, short and speakable sentence in each of the three languages."""

import ast
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from importlib import import_module
from pathlib import Path
from string import Formatter
from types import ModuleType

import pytest

import donnie_tui
from devices.audio_worker.notices import NoticeCode
from devices.speech import voices
from donnie_tui import DETAILS, LANGUAGES
from donnie_tui.i18n.catalogue import (
    SENTENCES,
    TOPICS,
    answers,
    devices,
    explain,
    files,
    help,  # noqa: A004 -- the module's own name
    linear,
    mistakes,
    movement,
    signs,
    stepping,
    summing,
    surroundings,
    tour,
    use_cases,
)
from donnie_tui.i18n.catalogue.signs import CODE_OF
from donnie_tui.i18n.first_words import CAUSES
from donnie_tui.i18n.sentence import Sentence, filled
from donnie_tui.i18n.words import Words
from language import keywords
from language.diagnostics import Kind
from sim.worldfile.mistakes import Code

SAMPLES: dict[str, object] = {
    "asked": 5,
    "bearing": 45,
    "colour": "red",
    "colours": "red",
    "column": 4,
    "command": "FW 3",
    "count": 2,
    "crashed": "didn't crash",
    "degrees": 45,
    "done": 3,
    "fastest": 1000.0,
    "facing": "north",
    "found": "FWD",
    "given": 3,
    "heading": 90,
    "language": "English",
    "limit": 200,
    "line": 3,
    "lines": 4,
    "message": "I do not know FWD.",
    "millimetres": 32.5,
    "name": "size",
    "number": 7,
    "seconds": 3,
    "slowest": 0.1,
    "speed": 5,
    "steps": 12,
    "turns": 12,
    "volts": 8.0,
    "wanted": 2,
    "width": 60,
    "x": 3,
    "y": 4,
}
"""Ordinary values; a place without one is filled with an ordinary word."""

LESSON = (
    movement,
    mistakes,
    help,
    signs,
    linear,
    answers,
    explain,
    files,
    stepping,
    summing,
    surroundings,
    tour,
)
"""What is heard while somebody programs."""

OF_THE_MANUAL = re.compile(r"(walked|turned)-.*-obstacle|scan-(left|right|ahead)|(no-)?movement.*")
"""Its sentences are kept as they are (L14)."""

LEGEND = re.compile(r"legend-.*")
"""Rows beside a picture; each begins with the letter that it explains."""

WORDLESS = {"kind-answer"}
"""Labels that are left out on purpose."""


AS_IN_ENGLISH = {
    "cell-robot": ("pt", "es"),
    "cue-volume": ("pt",),
    "doctor-reset-package-remedy": ("pt", "es"),
    "doctor-version": ("pt", "es"),
    "help-program-words": ("pt", "es"),
    "help-typed-robot": ("pt", "es"),
    "help-typed-text-file": ("pt", "es"),
    "inspector-variables": ("es",),
    "key-linear": ("pt",),
    "key-robots": ("es",),
    "key-show_variables": ("es",),
    "kind-error": ("es",),
    "kind-link": ("es",),
    "pane-inspector": ("es",),
    "reading-colour": ("es",),
    "report-column-color": ("es",),
    "report-title": ("pt", "es"),
    "setting-mouse": ("pt",),
    "speed-max": ("pt", "es"),
    "spell-tilde": ("es",),
    "status-inspector": ("es",),
    "thing-cone": ("pt",),
    "value-speech-ssip": ("pt", "es"),
    "value-verbosity-normal": ("pt", "es"),
    "world-robots": ("es",),
}
"""Texts with the same words in these languages, names among them."""


def all_texts() -> Iterator[tuple[str, str]]:
    for code, sentence in SENTENCES.items():
        for detail in DETAILS:
            for language in LANGUAGES:
                if code not in WORDLESS:
                    for line in lines_of(sentence.text(language, detail)):
                        yield f"{code} {detail} {language}", line


def lines_of(text: str) -> list[str]:
    """A chapter of the manual has several, some of them empty, some of a program; a sentence is one."""
    return [line.strip() for line in text.split("\n") if line] if "\n" in text else [text]


def places(text: str) -> Counter[str]:
    """The names of the places of a text, words that agree with them apart."""
    return Counter(name for _, name, spec, _ in Formatter().parse(text) if name and "|" not in (spec or ""))


def with_samples(text: str) -> str:
    return filled(text, {name: SAMPLES.get(name, "FW") for _, name, _, _ in Formatter().parse(text) if name})


def test_what_is_told_is_understood_and_said_in_the_same_languages() -> None:
    assert keywords.LANGUAGES == voices.LANGUAGES == LANGUAGES


def test_a_code_belongs_to_one_topic() -> None:
    counted = Counter(
        code for topic in TOPICS for code in import_module(f"donnie_tui.i18n.catalogue.{topic}").SENTENCES
    )

    assert [code for code, times in counted.items() if times > 1] == []


def test_no_text_is_missing_or_has_blanks_around_it() -> None:
    assert [where for where, text in all_texts() if not text or text != text.strip()] == []


def test_a_sentence_has_the_same_places_in_all_languages() -> None:
    def differs(sentence: Sentence, detail: str) -> bool:
        return len({tuple(sorted(places(sentence.text(each, detail)))) for each in LANGUAGES}) > 1

    assert [code for code, each in SENTENCES.items() for detail in DETAILS if differs(each, detail)] == []


def test_a_sentence_begins_with_a_word() -> None:
    """L8; Spanish opens a question with a sign that no reader says."""
    texts = [(where, with_samples(text)) for where, text in all_texts()]

    told = [(where, text) for where, text in texts if not LEGEND.match(where)]
    assert [where for where, text in told if not text.lstrip("¿¡")[0].isalnum()] == []


def test_no_sentence_stands_in_english_where_another_language_belongs() -> None:
    """Words that are the same there are listed; names and files have none to translate."""

    def has_words(text: str) -> bool:
        return re.search("[A-Za-z]{3}", re.sub(r"\{[^}]*\}", "", text)) is not None

    same = {
        f"{code} {language}"
        for code, sentence in SENTENCES.items()
        for detail in DETAILS
        for language in ("pt", "es")
        if has_words(sentence.text("en", detail))
        and sentence.text(language, detail) == sentence.text("en", detail)
    }
    assert same == {
        f"{code} {language}" for code, languages in AS_IN_ENGLISH.items() for language in languages
    }


def test_every_topic_is_found() -> None:
    folder = Path(donnie_tui.__file__).parent / "i18n" / "catalogue"

    assert {each.stem for each in folder.glob("*.py")} - {"__init__"} == set(TOPICS)
    assert "no-such-code" not in SENTENCES


def test_nothing_is_there_that_a_reader_spells_out() -> None:
    """L6: boxes, arrows, blocks, braille, emoji, three equal signs in a row."""
    drawn = re.compile(r"[\u2190-\u21ff\u2500-\u27bf\u2800-\u28ff\U0001f000-\U0001ffff]|([^\w\s])\1\1|\n")

    assert [where for where, text in all_texts() if drawn.search(with_samples(text))] == []


def whole_sentences(topics: Iterable[ModuleType], detail: str) -> dict[str, int]:
    """The lengths of what is told as a line of its own, which has a full stop."""
    codes = [code for topic in topics for code in topic.SENTENCES if not OF_THE_MANUAL.fullmatch(code)]
    texts = [with_samples(SENTENCES[code].text(each, detail)) for code in codes for each in LANGUAGES]
    return {text: len(text) for text in texts if text.endswith((".", "?"))}


def test_ordinary_lines_of_a_lesson_fit_forty_cells() -> None:
    """L8, B1 at detail normal."""
    lengths = whole_sentences(LESSON, "normal").values()

    assert sum(length <= 40 for length in lengths) / len(lengths) >= 0.9


def test_no_line_of_a_lesson_is_longer_than_eighty_characters() -> None:
    told = whole_sentences(LESSON, "normal") | whole_sentences(LESSON, "full")

    assert [text for text, length in told.items() if length > 80] == []


def test_at_detail_brief_every_line_of_a_lesson_fits_forty_cells() -> None:
    """L8, B1."""
    lengths = whole_sentences((*LESSON, use_cases, devices), "brief")

    assert {text: length for text, length in lengths.items() if length > 40} == {}


ABOUT_ROBOTS = (
    "robots-only-one",
    "robot-chosen",
    "robot-listed",
    "robot-busy",
    "robot-started",
    "robot-no-programs",
)
ABOUT_LINES = ("devices-none", "connect-instead", "remedy-port-busy", "connect-how", "connect-simulator")
ABOUT_WORLDS = ("world-no-robot", "world-robot-start", "world-things-from-start", "world-things-from-robot")


@pytest.mark.parametrize("code", ABOUT_ROBOTS + ABOUT_LINES + ABOUT_WORLDS)
def test_at_detail_brief_what_the_linear_mode_says_of_robots_and_worlds_fits_forty_cells(code: str) -> None:
    """L8, B1: topics that also have sentences of commands, which nobody hears in a lesson."""
    told = [with_samples(SENTENCES[code].text(language, "brief")) for language in LANGUAGES]

    assert [text for text in told if len(text) > 40] == []


SPEAKS = Path(donnie_tui.__file__).parent
ROOMS = ("core", "linear", "outlets", "robot", "settings", "words")
OF_COMMANDS = ("written.py",)
"""Modules of what is refused before a conversation begins."""


EXPLAINS = SPEAKS / "i18n" / "explanation.py"


def trees_of_linear_mode() -> list[ast.Module]:
    modules = [
        *SPEAKS.glob("*.py"),
        EXPLAINS,
        *(each for room in ROOMS for each in SPEAKS.glob(f"{room}/*.py")),
    ]
    return [ast.parse(each.read_text("utf-8")) for each in modules if each.name not in OF_COMMANDS]


def codes_of_linear_mode() -> set[str]:
    """Every code that a module names which the linear mode speaks with, of whatever topic."""
    trees = trees_of_linear_mode()
    named = {node.value for tree in trees for node in ast.walk(tree) if isinstance(node, ast.Constant)}
    return {code for code in SENTENCES if code in named and not OF_THE_MANUAL.fullmatch(code)}


NOT_A_LINE = ("-text",)
"""A chapter of the manual is broken into lines where it is told."""
NO_SHORTER = {"remedy-no-permission"}
"""A command for the shell, which has to be typed as it stands."""


def codes_put_together() -> set[str]:
    """Codes that a module makes of a name and something that is only known then, such as ``walked-{how}``."""
    known, found = "[a-z0-9-]+", set[str]()
    for tree in trees_of_linear_mode():
        for node in ast.walk(tree):
            if isinstance(node, ast.JoinedStr) and re.match(r"[a-z]{3,}", begin := _fixed(node.values[0])):
                pattern = "".join(re.escape(_fixed(each)) or known for each in node.values)
                found |= {code for code in SENTENCES if "-" in begin and re.fullmatch(pattern, code)}
    return {code for code in found if not code.endswith(NOT_A_LINE)} - NO_SHORTER


def _fixed(part: ast.expr) -> str:
    return str(part.value) if isinstance(part, ast.Constant) else ""


def test_at_detail_brief_whatever_the_linear_mode_can_say_fits_forty_cells() -> None:
    """L8, B1: the topics of the commands and of the screen too, as far as it says something of them."""
    codes = codes_of_linear_mode() | {
        code for code in codes_put_together() if not OF_THE_MANUAL.fullmatch(code)
    }
    told = {(code, with_samples(SENTENCES[code].text(each, "brief"))) for code in codes for each in LANGUAGES}

    assert {"setting-unknown", "screen-not-formatted", "world-robot", "connect-instead"} <= codes
    assert {"walked-forward", "legend-robot", "mend-unknown-command"} <= codes
    assert sorted((code, text) for code, text in told if len(text) > 40) == []


def test_a_number_with_decimals_has_the_sign_of_the_language_and_text_is_left_alone() -> None:
    told = {each: Words(each)("device-robot", port="/dev/tty.1", volts=8.0) for each in LANGUAGES}

    assert told["en"] == "/dev/tty.1: robot, original firmware, battery 8.0 volts."
    assert told["pt"] == "/dev/tty.1: robô, firmware original, bateria 8,0 volts."
    assert told["es"] == "/dev/tty.1: robot, firmware original, batería 8,0 voltios."


def test_no_sentence_has_an_english_decimal_number_in_another_language() -> None:
    """Also of those that are written into it; addresses, versions and names of files have letters beside."""
    english = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.])")
    other = [(where, text) for where, text in all_texts() if not where.endswith(" en")]

    assert [where for where, text in other if english.search(text)] == []


def test_the_number_one_has_the_singular_in_every_language() -> None:
    for language, one, many in (("en", "1 step", "2 steps"), ("pt", "1 passo", "2 passos")):
        text = SENTENCES["walked-forward"].text(language)
        assert one in filled(text, {"steps": 1})
        assert f"{one}s" not in filled(text, {"steps": 1})
        assert many in filled(text, {"steps": 2})


@pytest.mark.parametrize(
    ("place", "told"), [("capital", "À frente, Bob"), ("small", "à frente, Bob"), ("", "à frente, Bob")]
)
def test_a_value_begins_a_sentence_where_the_sentence_says_so(place: str, told: str) -> None:
    assert (
        filled(f"{{where:{place}}}: {{x:capital}}", {"where": "à frente, Bob", "x": 3}, "pt") == f"{told}: 3"
    )


@pytest.mark.parametrize("kind", Kind, ids=lambda kind: kind.value)
def test_every_kind_of_mistake_has_a_sentence(kind: Kind) -> None:
    assert f"mistake-{kind.value}" in SENTENCES


@pytest.mark.parametrize("code", Code, ids=lambda code: code.value)
def test_every_mistake_in_a_world_has_a_sentence(code: Code) -> None:
    assert f"world-{code.value}" in SENTENCES


@pytest.mark.parametrize("code", NoticeCode, ids=lambda code: code.value)
def test_everything_that_voice_and_sound_may_lack_has_a_sentence(code: NoticeCode) -> None:
    assert code.value in SENTENCES


def test_a_command_has_one_word_in_spanish() -> None:
    two_words = re.compile(r"\b[oó]rden(es)?\b", re.IGNORECASE)

    assert [code for code, each in SENTENCES.items() if two_words.search(each.es)] == []


def test_every_sign_has_a_name() -> None:
    assert set(CODE_OF.values()) <= set(SENTENCES)


def test_the_first_words_have_three_languages_each() -> None:
    assert {len(each) for each in CAUSES.values()} == {len(LANGUAGES)}

"""Every code has a natural, short and speakable sentence in each of the three languages."""

import ast
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from string import Formatter

import pytest

import donnie_tui
from devices.ports.audio import NoticeCode
from donnie_tui import DETAILS
from donnie_tui.core.session_log import CODE_OF_SIGN
from donnie_tui.i18n.words import Sentence, Words, filled, find
from language.diagnostics import MistakeKind
from language.locales import languages
from sim.worldfile.mistakes import Code
from tests.unit.i18n.sentences import CODES, all_texts, codes_of, text

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
    *("movement", "mistakes", "help", "signs", "linear", "answers"),
    *("explain", "files", "stepping", "summing", "surroundings", "tour"),
)
"""The topics of the lines that a learner meets while programming."""

OF_THE_MANUAL = re.compile(r"(walked|turned)-.*-obstacle|scan-(left|right|ahead)|(no-)?movement.*")
"""Its sentences are kept as they are."""

NO_WORDS = re.compile(r"legend-.*|decimal-sign.*")
"""Rows of a legend, each of which begins with the letter that it explains; a sign."""

AS_IN_ENGLISH = {
    "cell-robot": ("pt", "es"),
    "cue-volume": ("pt",),
    "doctor-reset-package-remedy": ("pt", "es"),
    "doctor-version": ("pt", "es"),
    "form-colour": ("es",),
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
    "report-column-robot": ("es",),
    "report-title": ("pt", "es"),
    "setting-mouse": ("pt",),
    "spell-ampersand": ("es",),
    "status-inspector": ("es",),
    "thing-cone": ("pt",),
    "value-speech-ssip": ("pt", "es"),
    "value-verbosity-normal": ("pt", "es"),
    "world-robots": ("es",),
}
"""Texts with the same words in these languages, names among them."""


def places(sentence: str) -> Counter[str]:
    """The names of the places of a text, words that agree with them apart."""
    return Counter(name for _, name, spec, _ in Formatter().parse(text) if name and "|" not in (spec or ""))


def with_samples(text: str) -> str:
    values = {name: SAMPLES.get(name, "FW") for _, name, _, _ in Formatter().parse(text) if name}
    return filled(Sentence(text, "en"), values)


def test_no_text_is_missing_or_has_blanks_around_it() -> None:
    assert [where for where, text in all_texts() if not text or text != text.strip()] == []


def test_a_sentence_begins_with_a_word() -> None:
    """Spanish opens a question with a sign that no reader says."""
    texts = [(where, with_samples(text)) for where, text in all_texts()]

    printed = [(where, text) for where, text in texts if not NO_WORDS.match(where)]
    assert [where for where, text in printed if not text.lstrip("¿¡")[0].isalnum()] == []


def test_no_sentence_of_another_language_is_english() -> None:
    """Words that are the same there are listed; names and files have none to translate."""

    def has_words(sentence: str) -> bool:
        return re.search("[A-Za-z]{3}", re.sub(r"\{[^}]*\}", "", sentence)) is not None

    same = {
        f"{code} {language}"
        for code in CODES
        for detail in DETAILS
        for language in ("pt", "es")
        if has_words(text(code, "en", detail)) and text(code, language, detail) == text(code, "en", detail)
    }
    assert same == {
        f"{code} {language}" for code, languages in AS_IN_ENGLISH.items() for language in languages
    }


def test_no_sentence_has_a_sign_that_a_reader_spells_out() -> None:
    """No boxes, arrows, blocks, braille, emoji, nor three equal signs in a row."""
    drawn = re.compile(r"[\u2190-\u21ff\u2500-\u27bf\u2800-\u28ff\U0001f000-\U0001ffff]|([^\w\s])\1\1|\n")

    assert [where for where, text in all_texts() if drawn.search(with_samples(text))] == []


def whole_sentences(topics: Iterable[str], detail: str) -> dict[str, int]:
    """The lengths of the sentences that are a line of their own: they have a full stop."""
    codes = [code for code in codes_of(*topics) if not OF_THE_MANUAL.fullmatch(code)]
    texts = [with_samples(text(code, each, detail)) for code in codes for each in languages()]
    return {each: len(each) for each in texts if each.endswith((".", "?"))}


def test_ordinary_lines_of_a_lesson_fit_forty_cells() -> None:
    lengths = whole_sentences(LESSON, "normal").values()

    assert sum(length <= 40 for length in lengths) / len(lengths) >= 0.9


def test_no_line_of_a_lesson_is_longer_than_eighty_characters() -> None:
    printed = whole_sentences(LESSON, "normal") | whole_sentences(LESSON, "full")

    assert [text for text, length in printed.items() if length > 80] == []


def test_every_line_of_a_lesson_at_detail_brief_fits_forty_cells() -> None:
    lengths = whole_sentences((*LESSON, "commands", "devices"), "brief")

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
def test_detail_brief_of_robots_and_worlds_fits_forty_cells_in_linear_mode(code: str) -> None:
    """Of topics that also have sentences of the command line."""
    printed = [with_samples(text(code, language, "brief")) for language in languages()]

    assert [text for text in printed if len(text) > 40] == []


SPEAKS = Path(donnie_tui.__file__).parent
ROOMS = ("commands", "core", "linear", "outlets", "robot", "settings", "words")
OF_COMMANDS = ("outlets/files.py",)
"""Modules of what is refused before a conversation begins."""


def trees_of_linear_mode() -> list[ast.Module]:
    modules = [
        *SPEAKS.glob("*.py"),
        *(each for room in ROOMS for each in SPEAKS.glob(f"{room}/*.py")),
    ]
    return [
        ast.parse(each.read_text("utf-8")) for each in modules if not each.as_posix().endswith(OF_COMMANDS)
    ]


def codes_of_linear_mode() -> set[str]:
    """Every code that a module names which the linear mode speaks with, of whatever topic."""
    trees = trees_of_linear_mode()
    named = {node.value for tree in trees for node in ast.walk(tree) if isinstance(node, ast.Constant)}
    return {code for code in CODES if code in named and not OF_THE_MANUAL.fullmatch(code)}


NOT_A_LINE = ("-text",)
"""A chapter of the manual is broken into lines where it is printed."""
NO_SHORTER = {"remedy-no-permission", "setting-cues-wanted", "setting-keys-wanted"}
"""A command for the shell, which has to be typed as it stands."""


def codes_put_together() -> set[str]:
    """Codes that a module makes of a name and something that is only known then, such as ``walked-{how}``."""
    known, found = "[a-z0-9-]+", set[str]()
    for tree in trees_of_linear_mode():
        for node in ast.walk(tree):
            if isinstance(node, ast.JoinedStr) and re.match(r"[a-z]{3,}", begin := _fixed(node.values[0])):
                pattern = "".join(re.escape(_fixed(each)) or known for each in node.values)
                found |= {code for code in CODES if "-" in begin and re.fullmatch(pattern, code)}
    return {code for code in found if not code.endswith(NOT_A_LINE)} - NO_SHORTER


def _fixed(part: ast.expr) -> str:
    return str(part.value) if isinstance(part, ast.Constant) else ""


def test_every_line_of_the_linear_mode_at_detail_brief_fits_forty_cells() -> None:
    """The topics of the commands and of the screen too, as far as the linear mode says something of them."""
    put_together = {code for code in codes_put_together() if not OF_THE_MANUAL.fullmatch(code)}
    codes = codes_of_linear_mode() | put_together | set(codes_of("explain"))
    printed = {(code, with_samples(text(code, each, "brief"))) for code in codes for each in languages()}

    assert {"setting-unknown", "screen-not-formatted", "world-robot", "connect-instead"} <= codes
    assert {"walked-forward", "legend-robot", "advice-unknown-command"} <= codes
    assert sorted((code, text) for code, text in printed if len(text) > 40) == []


def test_a_number_with_decimals_has_the_sign_of_the_language_and_text_is_left_alone() -> None:
    printed = {each: Words(each)("device-robot", port="/dev/tty.1", volts=8.0) for each in languages()}

    assert printed["en"] == "/dev/tty.1: robot, original firmware, battery 8.0 volts."
    assert printed["pt"] == "/dev/tty.1: robô, firmware original, bateria 8,0 volts."
    assert printed["es"] == "/dev/tty.1: robot, firmware original, batería 8,0 voltios."


def test_no_sentence_has_an_english_decimal_number_in_another_language() -> None:
    """Addresses, versions and names of files have letters next to their numbers."""
    english = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.])")
    other = [(where, text) for where, text in all_texts() if not where.endswith(" en")]

    assert [where for where, text in other if english.search(text)] == []


def test_the_number_one_has_the_singular_in_every_language() -> None:
    for language, one, many in (("en", "1 step", "2 steps"), ("pt", "1 passo", "2 passos")):
        sentence = find("walked-forward", language)
        assert sentence is not None
        assert one in filled(sentence, {"steps": 1})
        assert f"{one}s" not in filled(sentence, {"steps": 1})
        assert many in filled(sentence, {"steps": 2})


@pytest.mark.parametrize(
    ("place", "printed"), [("capital", "À frente, Bob"), ("small", "à frente, Bob"), ("", "à frente, Bob")]
)
def test_a_value_begins_a_sentence_where_the_sentence_says_so(place: str, printed: str) -> None:
    assert (
        filled(Sentence(f"{{where:{place}}}: {{x:capital}}", "pt"), {"where": "à frente, Bob", "x": 3})
        == f"{printed}: 3"
    )


@pytest.mark.parametrize("kind", MistakeKind, ids=lambda kind: kind.value)
def test_every_kind_of_mistake_has_a_sentence(kind: MistakeKind) -> None:
    assert f"mistake-{kind.value}" in CODES


@pytest.mark.parametrize("code", Code, ids=lambda code: code.value)
def test_every_mistake_in_a_world_has_a_sentence(code: Code) -> None:
    assert f"world-{code.value}" in CODES


@pytest.mark.parametrize("code", NoticeCode, ids=lambda code: code.value)
def test_every_problem_of_voice_and_sound_has_a_sentence(code: NoticeCode) -> None:
    assert code.value in CODES


def test_a_command_has_one_word_in_spanish() -> None:
    two_words = re.compile(r"\b[oó]rden(es)?\b", re.IGNORECASE)

    assert [code for code in CODES if two_words.search(text(code, "es"))] == []


def test_every_sign_has_a_name() -> None:
    assert set(CODE_OF_SIGN.values()) <= set(CODES)

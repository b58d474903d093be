"""Each sensor of the grammar alone on a line, misspelt, and with HELP, in each language."""

import pytest

from donnie_tui.i18n.words import Words
from language.checker import check
from language.keywords import argument_words, canonical_of_terminal, spelling
from language.lexer import SENSOR_FORMS
from language.locales import languages
from language.parser import parse
from tests.floor import Floor

LINES = [
    (language, " ".join((spelling(canonical_of_terminal(word), language), *argument)))
    for language in languages()
    for word, *taken in SENSOR_FORMS
    if all(argument_words(each, language) for each in taken)  # a name of the world is no word
    for argument in ([argument_words(each, language)[0] for each in taken],)
]


@pytest.mark.parametrize(("language", "line"), LINES)
def test_a_sensor_alone_on_a_line_has_a_hint_with_speak(language: str, line: str) -> None:
    program = parse(f"{spelling('FW', language)} 1\n{line}").program
    assert program is not None

    (hint,) = check(program)

    assert hint.meant.startswith(f"{spelling('SPEAK', language)} {line.upper()}")
    assert hint.meant in (Words(language).hint(hint) or "")


@pytest.mark.parametrize(("language", "line"), LINES)
def test_the_hint_names_the_sensor_of_a_misspelt_line(language: str, line: str) -> None:
    word, *argument = line.split()
    floor = Floor(language=language)

    floor.run(" ".join((spelling("SPEAK", language), word[:2] + word[1:], *argument)))

    assert word in floor.printed[-1]


@pytest.mark.parametrize(("language", "line"), LINES)
def test_help_explains_a_sensor(language: str, line: str) -> None:
    word = line.split()[0]

    assert all(word in each for each in Words(language).help(word))


def test_help_shows_the_form_of_a_word_without_a_purpose(monkeypatch: pytest.MonkeyPatch) -> None:
    words = Words("en")
    knows = Words.knows
    monkeypatch.setattr(Words, "knows", lambda self, code: code != "purpose-POS" and knows(self, code))

    assert words.help("POS") == (
        "POS.",
        "You write: POS X, Y, A, or POSITION X, Y, A.",
        "Example: SPEAK POS X.",
    )
    assert "POS." in words.help(None)

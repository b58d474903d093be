"""HELP lists every command with its purpose, and explains each by its form and an example that runs."""

import re

import pytest

from donnie_tui.i18n.help import (
    CHAPTERS,
    ENTRIES,
    chapter_lines,
    example,
    manual,
    needs,
    screen_tour_page,
    sections,
)
from donnie_tui.i18n.words import Words
from language import keywords
from language.locales import languages
from language.parser import parse
from tests.unit.i18n.sentences import codes_of, text

KEYS = {
    place
    for code in codes_of("screen-tour")
    if code[-1].isdigit()
    for place in re.findall(r"\{(\w+)\}", text(code, "en"))
}
"""The commands whose keys the tour of the full screen names."""


def test_every_command_word_of_every_language_has_help() -> None:
    topics = {keywords.topic(word) for word in keywords.all_words()}

    assert topics == set(ENTRIES)


@pytest.mark.parametrize("language", languages())
def test_the_list_gives_its_length_and_then_a_command_a_line(language: str) -> None:
    first, *rest = Words(language).help(None)

    assert first.startswith(f"{len(ENTRIES)} ")
    assert len(rest) == len(ENTRIES)
    assert all(len(line) <= 60 and ": " in line and line.endswith(".") for line in rest)


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("topic", ENTRIES)
def test_an_example_is_a_program_without_mistakes(topic: str, language: str) -> None:
    parsed = parse(example(topic, Words(language)))

    assert parsed.diagnostics == ()
    assert parsed.program is not None


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("topic", ENTRIES)
def test_an_example_shows_its_command_in_the_learners_words(topic: str, language: str) -> None:
    assert keywords.spelling(topic, language) in example(topic, Words(language))


def test_help_for_a_word_has_its_purpose_its_form_and_one_example() -> None:
    assert Words("en").help("forward") == (
        "FW: Walks forward, in steps.",
        "You write: FW value, or FORWARD value.",
        "Example: FW 5.",
    )


def test_a_word_of_another_language_is_explained_in_the_learners() -> None:
    assert Words("es").help("enquanto")[0] == "MIENTRAS: Repite mientras es verdad."


def test_a_closing_word_is_explained_with_what_it_closes() -> None:
    assert Words("pt").help("fim se") == Words("pt").help("SE")


def test_a_misspelt_topic_gets_the_nearest_word() -> None:
    assert Words("en").help("REPAET") == ("I do not know REPAET. Did you mean REPEAT?",)


@pytest.mark.parametrize(
    ("topic", "near"), [("WHILST", "WHILE"), ("BACKW", "BACKWARD"), ("END PROC", "END PROCEDURE")]
)
def test_a_topic_that_ends_otherwise_or_is_cut_off_gets_the_nearest_word(topic: str, near: str) -> None:
    assert Words("en").help(topic) == (f"I do not know {topic}. Did you mean {near}?",)


@pytest.mark.parametrize("topic", ["", "zzz", "x" * 10_000, "{0}", "\x1b"])
def test_the_answer_to_an_unknown_topic_is_one_short_line(topic: str) -> None:
    (line,) = Words("en").help(topic)

    assert line.startswith("I do not know")
    assert len(line) <= 80


FORMS = {
    "FW": "FW value, or FORWARD value",
    "BW": "BW value, or BACKWARD value",
    "TR": "TR value, or RIGHT TURN value",
    "TL": "TL value, or LEFT TURN value",
    "SPEAK": 'SPEAK "text"',
    **{each: each for each in ("SCAN", "STATE", "HISTORY", "GRIP", "RELEASE", "RUN")},
    "POS": "POS X, Y, A, or POSITION X, Y, A",
    "COLOR": "COLOR color",
    "VAR": "VAR name = value",
    "IF": "IF condition THEN commands ELSE commands END IF",
    "REPEAT": "REPEAT value TIMES commands END REPEAT",
    "WHILE": "WHILE condition DO commands END WHILE",
    "FOR": "FOR VAR name = value; condition; name = value DO commands END FOR",
    "PROCEDURE": "PROCEDURE name: name DO commands END PROCEDURE",
    "WAIT": "WAIT value",
    "SOUND": "SOUND ON, OFF",
    "BELT": "BELT ON, OFF",
    "VIBRATE": "VIBRATE direction",
    "HELP": "HELP word",
    "QUIT": "QUIT, or EXIT",
}
"""The forms of the commands as the table of GoDonnie's keywords has them."""


@pytest.mark.parametrize("topic", FORMS)
def test_the_form_of_a_command_has_its_words_in_their_order(topic: str) -> None:
    purpose, form, shown = Words().help(topic)

    assert purpose.startswith(f"{topic}: ")
    assert form == f"You write: {FORMS[topic]}."
    assert shown == f"Example: {example(topic, Words())}."


def test_a_sensor_has_two_forms_by_its_direction_and_by_its_name() -> None:
    assert Words().help("DISTANCE")[1:] == (
        "You write: DISTANCE direction.",
        'You write: DISTANCE "sensor\'s name".',
        "Example: SPEAK DISTANCE F.",
    )


@pytest.mark.parametrize(
    ("language", "topic", "form"),
    [
        ("pt", "SAIR", "Escreve-se: SAIR."),  # one word for QUIT and EXIT
        ("pt", "SOM", "Escreve-se: SOM LIGADO, DESLIGADO."),
        ("pt", "PF", "Escreve-se: PF valor, ou PARA FRENTE valor."),
    ],
)
def test_a_form_is_in_the_learners_words(language: str, topic: str, form: str) -> None:
    assert Words(language).help(topic)[1] == form


def test_an_example_names_a_colour_and_a_switch_in_the_learners_words() -> None:
    assert [example(each, Words("pt")) for each in ("COLOR", "SOUND", "BELT")] == [
        "FALAR COR VERMELHO",
        "SOM DESLIGADO",
        "CINTO LIGADO",
    ]


@pytest.mark.parametrize(
    ("word", "needed"),
    [
        ("FW", (("number",), "FW 2")),
        ("RIGHT TURN", (("number",), "RIGHT TURN 90")),
        ("SPEAK", (("text",), 'SPEAK "hello"')),
        ("VAR", (("name",), "VAR a = 5")),
        ("IF", (("comparison",), "IF a > 3 THEN")),
        ("WHILE", (("comparison",), "WHILE a > 3 DO")),
        ("REPEAT", (("number",), "REPEAT 4 TIMES")),
        ("FOR", (("name",), "FOR VAR i = 1")),
        ("PROCEDURE", (("name",), "PROCEDURE P DO")),
        ("WAIT", (("number",), "WAIT 2")),
    ],
)
def test_a_command_needs_a_class_of_words(word: str, needed: tuple[tuple[str, ...], str]) -> None:
    assert needs(keywords.canonical(word) or word, Words()) == needed


@pytest.mark.parametrize(
    ("typed", "topic"), [("walk", "FW"), ("Turn  LEFT", "TL"), ("go back", "BW"), ("end repeat", "REPEAT")]
)
def test_a_beginners_word_is_explained_as_the_command_that_it_means(typed: str, topic: str) -> None:
    assert Words().help(typed) == Words().help(topic)


@pytest.mark.parametrize("typed", ["walk fast", "turn left now"])
def test_a_beginners_word_among_others_is_unknown(typed: str) -> None:
    assert Words().help(typed)[0].startswith(f"I do not know {typed}. ")


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("zzz", "I do not know zzz. HELP lists the commands."),
        ("w" * 40, f"I do not know {'w' * 40}. HELP lists the commands."),
        ("w" * 41, f"I do not know {'w' * 39}…. HELP lists the commands."),
        ("repaet", "I do not know repaet. Did you mean REPEAT?"),
    ],
)
def test_of_an_unknown_topic_forty_characters_are_quoted(typed: str, said: str) -> None:
    assert Words().help(typed) == (said,)


def test_the_manual_has_its_chapters_in_capitals_with_a_blank_line_after_each_and_all_commands() -> None:
    words = Words()
    lines = manual(words)
    ends = [at for at, line in enumerate(lines) if line == ""]

    headings = [lines[0], *(lines[at + 1] for at in ends)]
    chapters = [words(f"manual-{each}").upper() for each in CHAPTERS]
    assert [each for each in headings if each.isupper()] == [*chapters, words("manual-commands").upper()]
    commands = words.help(None)
    assert lines[-len(commands) - 1 : -1] == commands
    assert lines[-1].startswith(words("first-page", file=""))
    first = words("manual-begin-text").split("\n")
    assert [*lines[1 : len(first) + 1]] == first


def test_the_page_of_the_manual_has_every_line_of_every_command() -> None:
    words = Words()
    last = sections(words)[-1]

    assert (last.heading, last.lines[:4]) == (
        words("manual-commands"),
        (*words.help("FW"), words.help("BW")[0]),
    )
    assert "" not in [line for each in sections(words) for line in each.lines]


def test_a_chapter_has_a_sentence_a_line_and_at_brief_lines_of_forty_cells() -> None:
    whole = Words()("manual-begin-text")
    sentences = [line.strip() for line in whole.replace(". ", ".\n").split("\n") if line]

    assert [*chapter_lines(Words(), "begin")] == [*chapter_lines(Words("en", "full"), "begin")] == sentences
    first = chapter_lines(Words("en", "brief"), "begin")[:2]
    assert " ".join(first).startswith(sentences[0])


def test_a_page_of_the_tour_names_the_keys_that_it_is_given() -> None:
    keys = {place: f"<{place}>" for place in KEYS}
    lines = [line for page in range(1, 10) for line in screen_tour_page(page, Words(), keys)]

    assert {each for each in KEYS if any(f"<{each}>" in line for line in lines)} == KEYS

"""HELP: ten words to begin with, the words of a topic, and GoDonnie's word for what a beginner says."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.help import TOPICS
from donnie_tui.commands.interaction import drive
from donnie_tui.commands.lookup import word_of
from donnie_tui.core.wording import keys_of, spelled
from language.keywords import spelling
from language.locales import first_page, languages
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script

OpenScript = Callable[..., Script]

TYPED = [
    ("en", "HELP", ("MOVING", "LOOKING", "EDITING", "SOUND")),
    ("pt", "AJUDA", ("ANDAR", "OLHAR", "EDITAR", "SOM")),
    ("es", "AYUDA", ("MOVERSE", "MIRAR", "EDITAR", "SONIDO")),
]


@pytest.mark.parametrize(("language", "word", "topics"), TYPED)
def test_help_alone_names_the_topics(
    language: str, word: str, topics: tuple[str, ...], open_script: OpenScript
) -> None:
    said = open_script(language=language).answers_to(word)

    assert len(said) == 13
    assert all(f"{word} {each}" in said[-2] for each in topics)


@pytest.mark.parametrize(("language", "word", "topics"), TYPED)
def test_a_topic_lists_its_words_with_their_number(
    language: str, word: str, topics: tuple[str, ...], open_script: OpenScript
) -> None:
    script = open_script(language=language)
    for typed, (keywords, commands) in zip(topics, TOPICS.values(), strict=True):
        said = script.answers_to(f"{word} {typed.lower()}")
        at = next(number for number, line in enumerate(said) if line.endswith(":"))
        wanted = [spelling(each, language) for each in keywords]
        wanted += [word_of(BY_NAME[each], language) for each in commands]

        assert said[at].split()[0] == str(len(said) - at - 1)
        assert all(any(line.startswith(each) for line in said) for each in wanted)


@pytest.mark.parametrize(
    ("language", "typed", "first"),
    [
        ("en", "HELP MOVING", ["12 words for moving:"]),
        (
            *("en", "HELP SOUND"),
            [
                *("SOUND: Turns voice and sounds on or off.", "You write: SOUND ON, OFF."),
                *("Example: SOUND OFF.", "9 words for sound and the belt:"),
            ],
        ),
        (
            *("en", "HELP TURN"),  # the command that turns a thing; no word of this topic
            [
                *("TURN treasure 90: Turns a thing.", "You write: TURN thing degrees."),
                *("Example: TURN treasure 90.", "12 words for moving:"),
            ],
        ),
        (
            *("en", "HELP EDIT"),
            [
                *("CHANGE 3: Edits line 3.", "You write: CHANGE line.", "Example: CHANGE 3."),
                "10 words for editing the program:",
            ],
        ),
        (
            *("pt", "AJUDA ANDAR"),
            [
                *("PF: Anda para frente, em passos.", "Escreve-se: PF valor, ou PARA FRENTE valor."),
                *("Exemplo: PF 5.", "11 palavras para andar e girar:"),
            ],
        ),
        (
            *("es", "AYUDA MIRAR"),
            [
                *("MIRAR: Dice qué hay al frente y al lado.", "Se escribe: MIRAR."),
                *("Ejemplo: MIRAR.", "12 palabras para mirar alrededor:"),
            ],
        ),
        ("es", "AYUDA MOVERSE", ["12 palabras para moverse y girar:"]),
    ],
)
def test_a_topic_that_is_also_a_word_is_explained_first_and_listed_once(
    language: str, typed: str, first: list[str], open_script: OpenScript
) -> None:
    said = open_script(language=language).answers_to(typed)

    assert said[: len(first)] == first
    assert len(said) == len(first) + int(first[-1].split()[0])
    assert first[0] not in said[1:]


@pytest.mark.parametrize("language", languages())
def test_every_topic_has_a_word_that_is_typed(language: str) -> None:
    assert {*TOPICS} | {"keys", "all"} == {*keys_of("help")}
    assert len({spelled(each, language, "help") for each in keys_of("help")}) == len(keys_of("help"))


@pytest.mark.parametrize(
    ("language", "typed", "first"),
    [
        ("en", "HELP WALK", "FW: Walks forward, in steps."),
        ("en", "HELP turn left", "TL: Turns to the left, in degrees."),
        ("en", "HELP go back", "BW: Walks backward, in steps."),
        ("en", "HELP say", "SPEAK: Says a text or a number."),
        ("pt", "AJUDA caminhar", "PF: Anda para frente, em passos."),
        ("es", "AYUDA caminar", "AV: Camina hacia adelante, en pasos."),
        ("es", "AYUDA walk", "AV: Camina hacia adelante, en pasos."),
    ],
)
def test_an_everyday_word_leads_to_the_word_of_godonnie(
    language: str, typed: str, first: str, open_script: OpenScript
) -> None:
    said = open_script(language=language).answers_to(typed)

    assert said[0] == first
    assert len(said) == 3


@pytest.mark.parametrize(
    ("typed", "last"),
    [("HELP MOVE", "FW: Walks forward, in steps."), ("HELP BACK", "BW: Walks backward, in steps.")],
)
def test_a_command_that_a_beginner_means_otherwise_names_both(
    typed: str, last: str, open_script: OpenScript
) -> None:
    said = open_script().answers_to(typed)

    assert said[0].startswith(typed.split()[1])
    assert said[-1] == last


@pytest.mark.parametrize("language", languages())
def test_the_manual_names_the_document_for_beginners_in_the_language(
    language: str, open_script: OpenScript
) -> None:
    said = open_script(language=language).answers_to("MANUAL")

    assert said[-1].endswith(f"/docs/{language}/README.md")


def test_a_language_without_documents_has_those_in_english() -> None:
    assert first_page("eo") == first_page("en")


def test_more_than_an_everyday_word_is_not_known(open_script: OpenScript) -> None:
    assert open_script().answers_to("HELP WALK nonsense") == [
        "I do not know WALK nonsense. HELP lists the commands."
    ]


def test_distance_names_both_of_its_forms(open_script: OpenScript) -> None:
    assert open_script().answers_to("HELP DISTANCE")[1:3] == [
        "You write: DISTANCE direction.",
        'You write: DISTANCE "sensor\'s name".',
    ]


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("HELP", "FW BW TR TL SPEAK SCAN RUN WHERE AROUND TOUR"),
        ("HELP MOVING", "FW BW TR TL GRIP RELEASE WAIT SLOWER FASTER SPEED STOP RESET"),
        (
            "HELP LOOKING",
            "SCAN DISTANCE COLOR POS STATE HISTORY WHERE AROUND MAP TRAIL SHOW SENSORS WORLD",
        ),
        ("HELP EDITING", "LIST READ CHANGE INSERT DELETE UNDO FIX SEARCH NEW SAVE OPEN"),
        ("HELP SOUND", "SPEAK BELT VIBRATE QUIET LAST SPELL CUES DETAIL FEEL"),
    ],
)
def test_the_words_of_each_topic_are_listed_in_their_order(
    open_script: OpenScript, typed: str, words: str
) -> None:
    said = open_script().answers_to(typed)
    first = next(number for number, line in enumerate(said) if line.endswith(":")) + 1
    count = len(words.split())

    assert [line.split()[0].rstrip(":") for line in said[first : first + count]] == words.split()
    assert len(said) == first + count + (2 if typed == "HELP" else 0)


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (
            "HELP MOVE",
            [
                "MOVE 5 2: Puts line 5 before line 2.",
                "You write: MOVE line before or thing east north.",
                *("Example: MOVE 5 2.", "FW: Walks forward, in steps."),
            ],
        ),
        (
            "HELP BACK",
            [
                *("BACK: Reads the line before.", "You write: BACK.", "Example: BACK."),
                "BW: Walks backward, in steps.",
            ],
        ),
        ("HELP SET page", ["Long answers, page: rest.", "Choose: rest, ask, off."]),
        (
            "HELP SET nothing",
            [
                "SET page ask: Changes a setting.",
                "You write: SET, or SET name value.",
                "Example: SET page ask.",
            ],
        ),
        ("HELP nothing", ["I do not know nothing. HELP lists the commands."]),
        (
            "MANUAL FW",
            ["FW: Walks forward, in steps.", "You write: FW value, or FORWARD value.", "Example: FW 5."],
        ),
        ("MANUAL 9", ["8 chapters. MANUAL 1 reads the first."]),
        ("MANUAL 0", ["8 chapters. MANUAL 1 reads the first."]),
        (
            "HELP KEYS",
            [
                *("Enter: the next line.", "Esc, RUN or an empty line: runs.", "Ctrl+C: stops the robot."),
                *("Up and down: lines you typed before.", "Home, End, Delete, Backspace: edit."),
                *("Ctrl+W: deletes a word.", "Ctrl+U: clears the line.", "Tab: completes a word."),
                "Ctrl+D: leaves Donnie.",
            ],
        ),
    ],
)
def test_a_word_a_setting_and_the_keys_are_explained(
    open_script: OpenScript, typed: str, said: list[str]
) -> None:
    assert open_script().answers_to(typed) == said


def test_the_chapters_of_the_manual_are_numbered_from_one(open_script: OpenScript) -> None:
    said = open_script().answers_to("MANUAL")

    assert said[0] == "8 chapters. MANUAL 1 reads the first."
    assert [line.partition(":")[0] for line in said[1:9]] == [str(number) for number in range(1, 9)]
    assert said[1:3] == ["1: A program", "2: Moving"]


def test_the_tour_turns_its_pages_with_enter_and_begins_again_at_its_end(open_script: OpenScript) -> None:
    script = open_script()
    assert script.answers_to("TOUR")[-1] == "Page 1 of 9. Try it; Enter alone continues."
    assert script.interaction.more is not None
    drive(script.interaction.more())
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)
    assert script.printed[-1] == "Page 2 of 9. Try it; Enter alone continues."

    assert script.answers_to("TOUR")[-1] == "Page 2 of 9. Try it; Enter alone continues."
    for _ in range(7):
        drive(script.interaction.more())
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)
    assert not script.printed[-1].startswith("Page")
    assert script.answers_to("TOUR")[-1] == "Page 1 of 9. Try it; Enter alone continues."


@pytest.mark.parametrize(
    ("typed", "title"), [("MANUAL 1", "A program"), ("MANUAL 8", "Mistakes"), ("MANUAL FW", "FW")]
)
def test_what_the_manual_shows_has_its_title(open_script: OpenScript, typed: str, title: str) -> None:
    script = open_script()

    assert script.answers_to(typed)
    assert script.interaction.asked == [title]


@pytest.mark.parametrize(("detail", "is_named"), [("brief", False), ("normal", True)])
def test_the_manual_names_the_document_unless_its_path_is_too_wide(
    open_script: OpenScript, detail: str, is_named: bool
) -> None:
    script = open_script()
    script.type(f"DETAIL {detail}")

    assert len(script.answers_to("MANUAL")) == 9 + is_named


def test_the_tour_names_the_robot_that_it_moves_where_there_are_several(open_script: OpenScript) -> None:
    said = open_script(world="two_robots").answers_to("TOUR")
    alone = open_script().answers_to("TOUR")

    assert said == ["Now you talk to alice.", *alone]

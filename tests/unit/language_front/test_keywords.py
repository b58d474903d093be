"""The table of words."""

from itertools import combinations

import pytest

from language import keywords
from language.keywords import ARGUMENTS, WORDS
from language.lexer import KIND
from language.locales import languages
from language.source import fold_name


def test_no_spelling_stands_for_two_terminals() -> None:
    for first, second in combinations(WORDS, 2):
        shared = {keywords.folded_word(one) for words in first.spellings.values() for one in words}
        shared &= {keywords.folded_word(one) for words in second.spellings.values() for one in words}
        assert not shared or first.terminal == second.terminal


def test_no_argument_word_is_a_keyword() -> None:
    for each in ARGUMENTS:
        for spellings in each.spellings.values():
            assert not any(keywords.is_reserved(one) for one in spellings)


def test_every_word_is_of_a_terminal_of_the_grammar_and_of_a_topic_that_is_a_command() -> None:
    canonical = {word.canonical for word in WORDS}
    for word in WORDS:
        assert word.terminal in KIND
        assert word.topic in canonical


@pytest.mark.parametrize("language", languages())
def test_every_word_is_found_by_every_spelling(language: str) -> None:
    for word in WORDS:
        found = keywords.word(keywords.spelling(word.canonical, language).lower())
        assert found is not None
        assert found.terminal == word.terminal


@pytest.mark.parametrize(
    ("typed", "canonical"),
    [
        ("para  frente", "FORWARD"),
        ("PF", "FW"),
        ("fim\nse", "END IF"),
        ("SENAO", "ELSE"),
        ("salir", "QUIT"),
        ("girar izquierda", "LEFT TURN"),
        ("vermelho", None),
        ("end", None),
        ("", None),
    ],
)
def test_a_word_has_one_canonical_word(typed: str, canonical: str | None) -> None:
    assert keywords.canonical(typed) == canonical


@pytest.mark.parametrize(
    ("canonical", "pt", "es"),
    [
        ("FW", "PF", "AV"),
        ("FORWARD", "PARA FRENTE", "AVANZAR"),
        ("END IF", "FIM SE", "FIN SI"),
        ("DO", "FAÇA", "HACER"),
    ],
)
def test_short_forms_stay_short_and_long_ones_long(canonical: str, pt: str, es: str) -> None:
    assert keywords.spelling(canonical, "pt") == pt
    assert keywords.spelling(canonical, "es") == es


@pytest.mark.parametrize(
    ("word", "topic"),
    [
        ("THEN", "IF"),
        ("fim se", "IF"),
        ("avanzar", "FW"),
        ("red", "COLOR"),
        ("LIGADO", "SOUND"),
        ("td", "DISTANCE"),
        ("x", "POS"),
        ("verde", "COLOR"),
        ("desligado", "SOUND"),
        ("para  tras", "BW"),
    ],
)
def test_a_word_belongs_to_a_topic_of_help(word: str, topic: str) -> None:
    assert keywords.topic(word) == topic


def test_an_unknown_word_has_no_topic() -> None:
    assert keywords.topic("jump") is None


@pytest.mark.parametrize(
    "name", ["if", "SE", "vezes", "End", "fim", "RIGHT", "girar", "distância", "DISTANCIA", "pos"]
)
def test_first_words_of_commands_are_reserved_in_all_languages(name: str) -> None:
    assert keywords.is_reserved(name)


@pytest.mark.parametrize(
    "name",
    [
        *("x", "y", "a", "f", "b", "t", "d", "red", "on", "frente", "turn", "format", "ending"),
        *("grip", "release", "pegar", "tomar", "soltar"),
    ],
)
def test_words_that_only_follow_are_ordinary_names(name: str) -> None:
    assert not keywords.is_reserved(name)


def test_all_words_of_a_language_are_spelled_in_it() -> None:
    assert "PARA TRÁS" in keywords.all_words("pt")
    assert "PARA TRÁS" not in keywords.all_words("es")
    assert set(keywords.all_words("es")) < set(keywords.all_words())


def test_purple_is_no_colour() -> None:
    colours = {fold_name(one) for each in ARGUMENTS for words in each.spellings.values() for one in words}
    assert not {"purple", "roxo", "morado"} & colours
    assert {"red", "azul", "amarillo", "grey"} <= colours


def test_an_argument_is_spelled_in_every_language_and_read_again() -> None:
    for each in ARGUMENTS:
        for language in languages():
            spelled = keywords.argument_spelling(each.value, language)
            found = keywords.argument(each.terminal, spelled)
            assert found is not None
            assert found.value == each.value


@pytest.mark.parametrize(
    ("line", "column", "topic"),
    [
        ("", 1, ""),
        ("FW 1", 1, "FW"),
        ("  FW 1", 2, ""),
        ("  FW 1", 3, "FW"),
        ("FW 1 TR 2", 5, "FW"),
        ("FW 1 TR 2", 6, "TR"),
        ("IF a THEN GIRAR DIREITA 90", 10, "IF"),
        ("IF a THEN GIRAR DIREITA 90", 11, "TR"),
        ("GIRAR DIREITA 90", 8, "TR"),
        ("END IF", 5, "IF"),
        ("FW x y z", 8, "FW"),
        ("end x", 5, ""),
        ("x FORWARD", 3, "FW"),
    ],
)
def test_the_topic_at_a_column_is_that_of_the_last_word_that_has_begun(
    line: str, column: int, topic: str
) -> None:
    assert keywords.topic_at(line, column) == topic


@pytest.mark.parametrize(
    ("word", "codes"),
    [
        ("pf", "pt"),
        ("AV", "es"),
        ("para", "es pt"),
        ("PARA  FRENTE", "pt"),
        ("pos", "en es pt"),
        ("end\tif", "en"),
        ("end", ""),
        ("x", ""),
    ],
)
def test_a_keyword_is_of_the_languages_that_spell_it_so(word: str, codes: str) -> None:
    assert sorted(keywords.languages_of(word)) == codes.split()


@pytest.mark.parametrize(
    ("typed", "codes"),
    [
        ("DISTÂNCIA", "pt"),
        ("distância", "pt"),
        ("Distância", "pt"),
        ("DISTANCIA", "es"),
        ("DISTÄNCIA", ""),
        ("FW", ""),
        ("SENAO", ""),
        ("PARA\nTRÁS", ""),
        ("x", ""),
    ],
)
def test_accents_decide_the_language_of_a_word_that_two_write_differently(typed: str, codes: str) -> None:
    folded = keywords.folded_word(typed)

    assert sorted(keywords.languages_by_accents(folded, typed)) == codes.split()


@pytest.mark.parametrize(
    ("terminal", "language", "words"),
    [
        ("DIRECTION", "pt", "F FD FE T TD TE"),
        ("AXIS", "en", "X Y A"),
        ("COLOUR", "es", "ROJO VERDE AZUL AMARILLO NARANJA ROSA GRIS"),
        ("SWITCH", "pt", "LIGADO DESLIGADO"),
    ],
)
def test_the_words_that_follow_a_keyword_are_listed_in_order(
    terminal: str, language: str, words: str
) -> None:
    assert keywords.argument_words(terminal, language) == tuple(words.split())


@pytest.mark.parametrize("value", ["purple", "x", 2])
def test_a_value_that_is_no_argument_has_no_spelling(value: str) -> None:
    with pytest.raises(KeyError):
        keywords.argument_spelling(value, "en")


@pytest.mark.parametrize(
    ("terminal", "canonical"), [("FW", "FW"), ("END_IF", "END IF"), ("POS", "POS"), ("QUIT", "QUIT")]
)
def test_the_first_word_of_a_terminal_is_its_canonical_one(terminal: str, canonical: str) -> None:
    assert keywords.canonical_of_terminal(terminal) == canonical


def test_the_words_of_the_help_are_those_of_the_manual() -> None:
    topics = {each.canonical: each.topic for each in WORDS if each.topic != each.canonical}

    assert topics == {
        **{"EXIT": "QUIT", "FORWARD": "FW", "BACKWARD": "BW", "POSITION": "POS"},
        **{"RIGHT TURN": "TR", "LEFT TURN": "TL"},
        **{"THEN": "IF", "ELSE": "IF", "DO": "FOR", "TIMES": "REPEAT"},
        **{f"END {each}": each for each in ("IF", "FOR", "REPEAT", "WHILE", "PROCEDURE")},
    }


@pytest.mark.parametrize(
    ("word", "is_on"), [("on", True), ("OFF", False), ("ligado", True), ("desligado", False), ("red", None)]
)
def test_a_switch_is_on_or_off(word: str, is_on: bool | None) -> None:
    found = keywords.argument("SWITCH", word)

    assert (found.value if found else None) is is_on


def test_a_word_that_ends_a_block_needs_the_word_of_the_block() -> None:
    assert {"end", "fim", "fin"} <= keywords.END_WORDS
    assert all(" " not in each for each in keywords.END_WORDS)
    assert not {"girar", "right", "para", "endif", "sound", "quit"} & keywords.END_WORDS
    assert {"girar", "right", "para", "end"} <= keywords.FIRST_OF_SEVERAL
    assert not {"fw", "sound", "turn"} & keywords.FIRST_OF_SEVERAL

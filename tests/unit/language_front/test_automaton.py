"""The automaton of the recovery: what may come next, and where a command may begin."""

import pytest

from language.lexer import KIND, lex
from language.recovery.reader import Automaton


def automaton_after(source: str) -> Automaton:
    automaton = Automaton()
    for token in lex(source).tokens:
        automaton.feed(token[0])
    return automaton


@pytest.mark.parametrize(
    ("source", "expected", "is_between", "may_end"),
    [
        ("", ("command",), True, True),
        ("FW", ("expression",), False, False),
        ("FW 1", ("command",), True, True),
        ("IF", ("expression",), False, False),
        ("IF 1", ("comparison",), False, False),
        ("IF 1 < 2", ("THEN",), False, False),
        ("IF 1 < 2 THEN", ("command", "ELSE", "END IF"), True, False),
        ("IF 1 < 2 THEN ELSE", ("command", "END IF"), True, False),
        ("VAR", ("name",), False, False),
        ("VAR a", ("command", "="), True, True),
        ("VAR a = (1", (")",), False, False),
        ("P", ("=", "["), False, False),
        ("P [", ("expression", "]"), False, False),
        ("P [1", ("]", ","), False, False),
        ("P [1]", ("command",), True, True),
        ("HELP", ("command",), True, True),
        ("HELP FW", ("command",), True, True),
        ("SPEAK", ("expression", "text"), False, False),
        ('SPEAK "a"', ("command",), True, True),
        ("REPEAT 2 TIMES", ("command", "DO", "END REPEAT"), True, False),
        ("REPEAT 2 TIMES DO", ("command", "END REPEAT"), True, False),
        ("DISTANCE", ("command", "text", "direction"), True, True),
        ("POS", ("command", "axis"), True, True),
        ("COLOR", ("colour",), False, False),
        ("SOUND", ("on-or-off",), False, False),
        ("FOR", ("name", "VAR"), False, False),
        ("FOR VAR i", ("=", ";"), False, False),
        ("FOR VAR i = 0", (";",), False, False),
        ("FOR VAR i = 0; i < 2", (";",), False, False),
        ("FOR VAR i = 0; i < 2; i = 1", ("DO",), False, False),
        ("PROCEDURE P", (":", "DO"), False, False),
        ("PROCEDURE P: a", (",", "DO"), False, False),
        ("x =", ("expression",), False, False),
    ],
)
def test_the_automaton_knows_what_may_come_next(
    source: str, expected: tuple[str, ...], is_between: bool, may_end: bool
) -> None:
    automaton = automaton_after(source)

    assert automaton.expected() == expected
    assert automaton.is_between_commands() is is_between
    assert automaton.accepts(KIND["$END"]) is may_end
    assert ("FW" in automaton.acceptable()) is is_between


def test_a_question_changes_no_state() -> None:
    automaton = automaton_after("IF 1 < 2 THEN FW 1")
    before = list(automaton.states)
    automaton.expected()
    assert not automaton.accepts(KIND["THEN"])

    assert automaton.states == before


def test_a_command_that_was_given_up_leaves_the_state_before_it() -> None:
    automaton = automaton_after("IF 1 < 2 THEN FW 1")
    depth = automaton.finish_command()
    assert automaton.is_between_commands()
    before = list(automaton.states)

    for name in ("SPEAK", "LPAR", "NUMBER"):
        automaton.feed(KIND[name])
    automaton.cut(depth)

    assert automaton.states == before
    automaton.feed(KIND["END_IF"])
    assert automaton.accepts(KIND["$END"])


@pytest.mark.parametrize(
    ("source", "symbols", "expected"),
    [
        ("IF", ("condition", "THEN"), ("command", "ELSE", "END IF")),
        ("REPEAT", ("expression", "TIMES"), ("command", "DO", "END REPEAT")),
        ("FOR", ("beginning", "SEMICOLON", "condition", "SEMICOLON", "step", "DO"), ("command", "END FOR")),
        ("PROCEDURE", ("NAME", "DO"), ("command", "END PROCEDURE")),
    ],
)
def test_the_rest_of_a_head_can_be_taken_as_read(
    source: str, symbols: tuple[str, ...], expected: tuple[str, ...]
) -> None:
    automaton = automaton_after(source)
    automaton.move(symbols)

    assert automaton.expected() == expected

"""Text to tree."""

import sys

import pytest

from devices.ports.robot import Bearing
from language.lexer import lex
from language.parser import kinds_after, parse
from language.syntax import (
    ActionCommand,
    Assign,
    Axis,
    Binary,
    Call,
    ColourSensor,
    Condition,
    Declare,
    Direction,
    DistanceSensor,
    For,
    HelpCommand,
    If,
    Name,
    NamedDistanceSensor,
    Negative,
    NumberLiteral,
    PositionSensor,
    Procedure,
    Program,
    QuitCommand,
    Repeat,
    Span,
    SpeakCommand,
    Statement,
    TextLiteral,
    TurnCommand,
    UnusedSensor,
    WalkCommand,
)
from language.tables import TERMINALS


def read(source: str) -> Program:
    program = parse(source).program
    assert program is not None
    return program


def first(source: str) -> Statement:
    return read(source).body[0]


def shown(source: str) -> str:
    """An expression with all its parentheses."""
    statement = first(f"SPEAK {source}")
    assert isinstance(statement, SpeakCommand)
    return _shown(statement.what)


def _shown(node: object) -> str:
    match node:
        case Binary(operator=operator, left=left, right=right):
            return f"({_shown(left)}{operator}{_shown(right)})"
        case Negative(operand=operand):
            return f"(-{_shown(operand)})"
        case NumberLiteral(value=value):
            return str(value)
        case Name(name=name):
            return name
    raise AssertionError(node)


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("1+2*3", "(1+(2*3))"),
        ("1-2-3", "((1-2)-3)"),
        ("8/4/2*3", "(((8/4)/2)*3)"),
        ("(1+2)*3", "((1+2)*3)"),
        ("-2*3", "((-2)*3)"),
        ("2*-3", "(2*(-3))"),
        ("-a/2", "((-a)/2)"),
        ("- -3", "(-(-3))"),
        ("+3-+2", "(3-2)"),
        ("3\n-1", "(3-1)"),
        ("((((5))))", "5"),
        ("007", "7"),
    ],
)
def test_operators_bind_as_in_arithmetic(source: str, expected: str) -> None:
    assert shown(source) == expected


def test_spans_are_those_of_the_typed_text() -> None:
    source = "  FW (a + 1) * 2 -- why\nTR +x"
    program = read(source)
    walk, turn = program.body
    assert isinstance(walk, WalkCommand)
    assert isinstance(turn, TurnCommand)

    assert walk.span == Span(2, 16, 1, 3)
    assert program.typed(walk.steps.span) == "(a + 1) * 2"
    assert isinstance(walk.steps, Binary)
    assert program.typed(walk.steps.left.span) == "(a + 1)"
    assert turn.span == Span(24, 29, 2, 1)
    assert program.typed(turn.degrees.span) == "+x"


@pytest.mark.parametrize(
    "statement",
    [
        *("VAR a", "VAR a = 3 + 1", "a = -2", "P []", "P [1, (2)]", "SPEAK (1)", 'SPEAK "a"', "SOUND ON"),
        *("FW 1", "PARA TRÁS +1", "TR (1)", "SCAN", "STATE", "HISTORY", "GRIP", "RELEASE", "POS", "DISTANCE"),
        *("DISTANCE F", 'DISTANCE "a"', "POS x", "COLOR red", "WAIT 1 * 2", "BELT OFF", "VIBRATE FL"),
        *("HELP", "HELP END IF", "QUIT", "RUN", "IF 1 < 2 THEN END IF", "IF 1 < 2 THEN ELSE FW 1 END IF"),
        *("FOR VAR i = 0; i < 3; i = i + 1 DO END FOR", "FOR i = 0; i < 3; i = 1 DO FW 1 END FOR"),
        *("REPEAT 2 TIMES DO END REPEAT", "REPEAT 2 TIMES FW 1 END REPEAT", "WHILE 1 < 2 DO END WHILE"),
        *("PROCEDURE P DO END PROCEDURE", "PROCEDURE P: a, b DO FW 1 END PROCEDURE"),
    ],
)
def test_the_span_of_a_statement_is_its_whole_text(statement: str) -> None:
    program = read(f"SCAN\n  {statement}\nFW 2")

    assert program.typed(program.body[1].span) == statement
    assert (program.body[1].span.line, program.body[1].span.column) == (2, 3)
    assert len(program.body) == 3


@pytest.mark.parametrize(
    ("source", "value"),
    [
        ("DISTANCE FL", DistanceSensor(Span(6, 17, 1, 7), Bearing.FRONT_LEFT)),
        ("DISTANCE", DistanceSensor(Span(6, 14, 1, 7), Bearing.FRONT)),
        ('DISTANCE "Left  eye"', NamedDistanceSensor(Span(6, 26, 1, 7), "Left eye")),
        ("DISTANCE te", DistanceSensor(Span(6, 17, 1, 7), Bearing.BACK_LEFT)),
        ("DISTANCE ti", DistanceSensor(Span(6, 17, 1, 7), Bearing.BACK_LEFT)),
        ("POSICIÓN A", PositionSensor(Span(6, 16, 1, 7), Axis.ANGLE)),
        ("COLOR cinza", ColourSensor(Span(6, 17, 1, 7), "gray")),
        ("COR grey", ColourSensor(Span(6, 14, 1, 7), "gray")),
        ('"Não É"', TextLiteral(Span(6, 13, 1, 7), "Não É")),
        ('"a\r\nb\rc\n d"', TextLiteral(Span(6, 17, 1, 7), "a\nb\nc\n d")),
    ],
)
def test_sensors_and_texts(source: str, value: object) -> None:
    statement = first(f"SPEAK {source}")

    assert isinstance(statement, SpeakCommand)
    assert statement.what == value


def test_a_sensor_alone_is_unused_and_pos_alone_is_the_pose() -> None:
    assert isinstance(first("DISTANCE F"), UnusedSensor)
    assert isinstance(first("COLOR red"), UnusedSensor)
    assert isinstance(first("POS x"), UnusedSensor)
    assert first("POS FW 1") == ActionCommand(Span(0, 3, 1, 1), "announce_pose")


def test_blocks_have_their_parts() -> None:
    source = "IF 1 < 2 THEN FW 1 ELSE END IF"
    block = first(source)

    assert isinstance(block, If)
    assert block.condition == Condition(
        Span(3, 8, 1, 4), "<", NumberLiteral(Span(3, 4, 1, 4), 1), NumberLiteral(Span(7, 8, 1, 8), 2)
    )
    assert [type(each) for each in block.then] == [WalkCommand]
    assert block.otherwise == ()
    assert block.span == Span(0, len(source), 1, 1)


def test_an_if_without_else_has_none() -> None:
    block = first("IF 1 < 2 THEN END IF")
    assert isinstance(block, If)
    assert block.otherwise is None


def test_a_for_has_a_start_a_condition_and_a_step() -> None:
    made, given = (
        first("FOR VAR i = 0; i < 3; i = i + 1 DO END FOR"),
        first("PARA j = 0; j < 3; k = 1 FAÇA FW 1 FIM PARA"),
    )

    assert isinstance(made, For)
    assert isinstance(made.start, Declare)
    assert isinstance(given, For)
    assert isinstance(given.start, Assign)
    assert given.step.name.name == "k"
    assert len(given.body) == 1


def test_do_after_times_is_optional() -> None:
    for source in ("REPEAT 2 TIMES FW 1 END REPEAT", "REPEAT 2 TIMES DO FW 1 END REPEAT"):
        block = first(source)
        assert isinstance(block, Repeat)
        assert len(block.body) == 1


def test_procedures_and_calls() -> None:
    program = read("PROCEDURE Pê: Á, b DO FW a END PROCEDURE PROCEDURE q DO END PROCEDURE pe [1, 2] Q []")
    with_names, without, call, empty = program.body

    assert isinstance(with_names, Procedure)
    assert (with_names.name.name, [each.name for each in with_names.parameters]) == ("pe", ["a", "b"])
    assert isinstance(without, Procedure)
    assert without.parameters == ()
    assert isinstance(call, Call)
    assert (call.name.name, len(call.arguments)) == ("pe", 2)
    assert isinstance(empty, Call)
    assert empty.arguments == ()


def test_help_keeps_its_word_as_typed() -> None:
    assert first("HELP  Fim   Se") == HelpCommand(Span(0, 14, 1, 1), "Fim Se")
    assert first("AJUDA") == HelpCommand(Span(0, 5, 1, 1), None)


@pytest.mark.parametrize("word", ["QUIT", "exit", "SAIR", "salir"])
def test_the_program_ends_in_all_languages(word: str) -> None:
    assert isinstance(first(word), QuitCommand)


@pytest.mark.parametrize("source", ["", "\n\n", "-- only this", "\ufeff", ";;;", " ; -- a\n;"])
def test_an_empty_text_is_a_program(source: str) -> None:
    assert read(source).body == ()


def test_semicolons_separate_as_many_as_there_are() -> None:
    assert len(read(";FW 1;; FW 2;").body) == 2


def test_lines_count_from_the_first_line_given() -> None:
    assert read("FW 1").body[0].span.line == 1
    shifted = parse("FW 1\nJUMP", first_line=7)
    assert shifted.diagnostics[0].span.line == 8


def test_directions_of_movement() -> None:
    walks = [each for each in read("RE 1 PT 1 BW 1 AV 1").body if isinstance(each, WalkCommand)]
    assert [each.direction for each in walks] == [Direction.BACKWARD] * 3 + [Direction.FORWARD]


@pytest.mark.skipif(not hasattr(sys, "set_int_max_str_digits"), reason="this Python has no such limit")
def test_long_numbers_are_read_whatever_limit_python_has_for_texts() -> None:
    before = sys.get_int_max_str_digits()
    sys.set_int_max_str_digits(640)
    try:
        walk = first("FW 1" + "0" * 4299)
    finally:
        sys.set_int_max_str_digits(before)

    assert isinstance(walk, WalkCommand)
    assert walk.steps == NumberLiteral(Span(3, 4303, 1, 4), 10**4299)


def test_the_colours_of_the_robot_are_the_only_ones() -> None:
    seen = parse("SPEAK COLOR red SPEAK COR amarelo", colours=frozenset({"red", "blue"}))

    assert seen.program is None
    assert [(each.kind.value, each.span.column) for each in seen.diagnostics] == [("bad-argument", 27)]
    assert seen.diagnostics[0].details["wanted"] == "blue, red"
    assert parse("SPEAK COLOR yellow").program is not None


def words_after(source: str) -> set[str]:
    return {TERMINALS[kind] for kind in kinds_after(lex(source).tokens)}


VALUE = "COLOR DISTANCE LPAR NAME NUMBER POS SIGN"


@pytest.mark.parametrize(
    ("source", "following"),
    [
        ("FW", VALUE),
        ("FW 1", "SCALE SIGN command"),
        ("IF", VALUE),
        ("IF 1", "COMPARATOR SCALE SIGN"),
        ("IF 1 < 2", "SCALE SIGN THEN"),
        ("IF 1 < 2 THEN", "ELSE END_IF command"),
        ("IF 1 < 2 THEN FW 1 ELSE", "END_IF command"),
        ("REPEAT 2", "SCALE SIGN TIMES"),
        ("REPEAT 2 TIMES", "DO END_REPEAT command"),
        ("VAR", "NAME"),
        ("VAR x", "ASSIGN command"),
        ("x", "ASSIGN LSQB"),
        ("P [", f"{VALUE} RSQB"),
        ("P [1", "COMMA RSQB SCALE SIGN"),
        ("FOR", "NAME VAR"),
        ("FOR VAR i = 0", "SCALE SEMICOLON SIGN"),
        ("FOR VAR i = 0; i < 3; i = i + 1", "DO SCALE SIGN"),
        ("PROCEDURE P", "COLON DO"),
        ("PROCEDURE P: a", "COMMA DO"),
        ("SOUND", "SWITCH"),
        ("HELP", "TOPIC command"),
        ("POS", "AXIS command"),
        ("DISTANCE", "DIRECTION STRING command"),
        ("COLOR", "COLOUR"),
        ('SPEAK "a"', "command"),
        # after a mistake
        ("FW )", "command"),
        (") )", "command"),
        ("FW ) REPEAT 2", "SCALE SIGN TIMES"),
        ("REPEAT 2 TIMES FW FW", VALUE),
        ("REPEAT 2 TIMES END IF", "DO END_REPEAT command"),
        ("IF 1 < 2 THEN FW ) ELSE", "END_IF command"),
        ("IF 1 < 2 THEN FW ) END IF", "command"),
        ("END IF", "command"),
        ("x ) y", "ASSIGN LSQB"),
    ],
)
def test_what_may_come_next_is_known_whatever_is_wrong_before(source: str, following: str) -> None:
    commands = words_after("")
    assert {"FW", "NAME", "VAR", "SEMICOLON"} < commands
    assert not {"$END", "NUMBER", "THEN", "END_IF"} & commands

    expected = set(following.split())
    if "command" in expected:
        expected = commands | expected - {"command"}
    assert words_after(source) == expected


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("COLOR red COR roxo", []),
        ("FW 1\nSPEAK COLOR  amarelo", [(2, 14, "amarelo")]),
        ("COLOR red COLOR pink COR azul COR rosa", [(1, 17, "pink"), (1, 35, "rosa")]),
    ],
)
def test_each_colour_that_is_not_seen_is_a_mistake_of_its_own(
    source: str, found: list[tuple[int, int, str]]
) -> None:
    mistakes = [each for each in parse(source, colours=frozenset({"red", "blue"})).diagnostics if each.code]

    assert [(each.span.line, each.span.column, each.found) for each in mistakes] == found
    for each in mistakes:
        assert (each.code, each.expected, each.meant) == ("unseen-colour", ("colour",), "")
        assert each.details == {"word": "COLOR", "wanted": "blue, red"}


def test_a_colour_that_is_none_names_those_of_the_robot() -> None:
    colours = frozenset({"red", "blue"})
    (mistake,) = parse("COLOR roxo", colours=colours).diagnostics
    (without,) = parse("COLOR roxo").diagnostics
    (other,) = parse("POS b", colours=colours).diagnostics

    assert mistake.details == {"word": "COLOR", "wanted": "blue, red"}
    assert (without.details, other.details) == ({"word": "COLOR"}, {"word": "POS"})


@pytest.mark.parametrize("length", [1, 639, 640, 641, 1279, 1280, 1281, 4300])
def test_a_number_of_any_length_has_the_value_of_its_digits(length: int) -> None:
    digits = ("1234567890" * 430)[:length]

    walk = first(f"FW 00{digits}")

    assert isinstance(walk, WalkCommand)
    assert isinstance(walk.steps, NumberLiteral)
    assert str(walk.steps.value) == digits

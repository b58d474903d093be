"""Every mistake has one sentence that names what was typed, and a hint that corrects it."""

import re

import pytest

from donnie_tui.core.events import Error
from donnie_tui.core.transcript import lines_of
from donnie_tui.i18n.mistakes import remark
from donnie_tui.i18n.words import Words
from language.checker import check
from language.diagnostics import Diagnostic, MistakeKind
from language.parser import parse
from language.syntax import Span

RGB = frozenset({"red", "green", "blue"})

TOLD = [
    ("FW 1\nonde", "I do not know onde.", "Type ONDE alone, not in a program."),
    ("n", "I do not know n.", None),
    ("FWD 10", "I do not know FWD.", "Did you mean FW?"),
    ("FW = 3", "FW is a command, not a variable.", "Leave out the equals sign."),
    ("SCAN = 3", "SCAN is a command, not a variable.", "Leave out the equals sign."),
    ("JUMP 3", "I do not know JUMP.", None),
    ("REPEAT 2 FW 1 END REPEAT", "I expected TIMES, not FW.", "Write TIMES before FW."),
    ("SPEAK COLOUR blue", "I do not know COLOUR.", "Did you mean COLOR?"),
    ("IF DISTANSE F > 3 THEN END IF", "I do not know DISTANSE.", "Did you mean DISTANCE?"),
    ("SPEAK DISTANCE LEFT", "DISTANCE does not know LEFT.", "Use F, FR, FL, B, BR or BL."),
    ("x == 3", "Use one equals sign to give a value.", "Did you mean =?"),
    ("VAR a = 3 *", "I need a value at the end.", None),
    ("WALK 3", "I do not know WALK.", "Did you mean FW 3?"),
    ("FW\nTR 90", "FW needs a number, such as FW 2.", None),
    ("SPEAK", 'SPEAK needs a text, such as SPEAK "hello".', None),
    ("IF\nFW 1\nEND IF", "IF needs a comparison, such as IF a > 3 THEN.", None),
    ("IF THEN FW 1 END IF", "IF needs a comparison here.", "Example: IF a > 3 THEN."),
    ("WHILE DO FW 1 END WHILE", "WHILE needs a comparison here.", "Example: WHILE a > 3 DO."),
    ("REPEAT TIMES FW 1 END REPEAT", "REPEAT needs a number here.", "Example: REPEAT 4 TIMES."),
    ("FOR DO FW 1 END FOR", "FOR needs a name here.", "Example: FOR VAR i = 1."),
    ("FOR VAR = 1; i < 3; i = i + 1 DO END FOR", "VAR needs a name here.", "Example: VAR a = 5."),
    ("VAR = 5", "VAR needs a name here.", "Example: VAR a = 5."),
    ("PROCEDURE DO FW 1 END PROCEDURE", "PROCEDURE needs a name here.", "Example: PROCEDURE P DO."),
    (
        "PROCEDURE p: DO FW 1 END PROCEDURE",
        "I expected a name, not DO.",
        "Without values, leave out the colon.",
    ),
    ("VIBRATE", "VIBRATE needs a direction.", "Use F, FR, FL, B, BR or BL."),
    ("SOUND", "SOUND needs ON or OFF.", "Use ON or OFF."),
    ("SPEAK POS", "POS needs X, Y or A.", "Use X, Y or A."),
    ("FW 3 +\nTR 90", "A value is missing after a plus sign.", None),
    ("SPEAK (1+2", "I need a closing parenthesis at the end.", None),
    ("FW 1 $ FW 2", "I can't use a dollar sign here.", None),
    ("FW 2.5", "I can't use a full stop here.", "Numbers are whole, such as 2."),
    ("IF 1 != 2 THEN END IF", "I can't use an exclamation mark here.", "Write <> for different."),
    ("IF 1 = 2 THEN END IF", "Use two equals signs to compare.", "Did you mean ==?"),
    ("# go", "I can't use a hash sign here.", "A comment begins with two hyphens."),
    ("FW 2 // go on", "I can't use // here.", "A comment begins with two hyphens."),
    ("SPEAK 7 % 2", "I can't use a percent sign here.", "The rest of 7 / 2 is 7 - 7 / 2 * 2."),
    ("IF 1 < 2 AND 2 < 3 THEN END IF", "IF takes one comparison.", "Write a second IF inside it."),
    ("IF 1 < 2 or 2 < 3 THEN END IF", "IF takes one comparison.", "Write a second IF after it."),
    ("IF 1 < 2 && 2 < 3 THEN END IF", "I can't use an ampersand here.", "Write a second IF inside it."),
    ("i++", "To change i, write i = i + 1.", None),
    ("i += 2", "To change i, write i = i + 2.", None),
    ("VAR a = RANDOM 5", "I do not know RANDOM 5.", None),
    (
        "IF 1 < 2 THEN\nELSE IF 2 < 3 THEN\nEND IF",
        "IF has no END IF.",
        "ELSE IF needs another END IF.",
    ),
    ('SPEAK "hello', "This text needs a quote at its end.", None),
    ('SPEAK "a" + 1', "I can't calculate with a text.", "Write another SPEAK for the rest."),
    ("VAR 52abc", "52abc can't be a name.", "A name begins with a letter."),
    ("VAR times = 2", "times is a word of GoDonnie.", "Choose another name."),
    ("SPEAK DISTANCE Z", "DISTANCE does not know Z.", "Use F, FR, FL, B, BR or BL."),
    ("SPEAK POS b", "POS does not know b.", "Use X, Y or A."),
    ("SOUND maybe", "SOUND does not know maybe.", "Use ON or OFF."),
    ("SOUND onn", "SOUND does not know onn.", "Did you mean ON? Use ON or OFF."),
    ("SPEAK COLOR yellow", "The robot does not see yellow.", "Use BLUE, GREEN or RED."),
    ("FW 1\nREPEAT 2 TIMES", "REPEAT has no END REPEAT.", "Write END REPEAT where it ends."),
    ("IF 1 == 1 THEN END FOR", "END FOR does not close IF of line 1.", "END IF belongs here."),
    ("FW 1 END IF", "END IF has nothing to close.", None),
    ("ELSE", "ELSE needs an IF before it.", None),
    (f"FW {'1' * 4301}", "This number is too large.", "A number has at most 4300 digits."),
]


def first_mistake(source: str) -> Diagnostic:
    return parse(source, colours=RGB).diagnostics[0]


@pytest.mark.parametrize(("source", "message", "hint"), TOLD, ids=[each[0][:24] for each in TOLD])
def test_a_mistake_of_form_has_a_sentence_and_a_hint(source: str, message: str, hint: str | None) -> None:
    words, found = Words("en"), first_mistake(source)

    assert (words.mistake(found), words.hint(found)) == (message, hint)


@pytest.mark.parametrize(
    ("language", "message", "hint"),
    [
        ("pt", "REPITA não tem FIM REPITA.", "Escreva FIM REPITA onde o bloco acaba."),
        ("es", "REPETIR no tiene FIN REPETIR.", "Escribe FIN REPETIR donde termina."),
    ],
)
def test_words_of_godonnie_are_in_the_learners_language(language: str, message: str, hint: str) -> None:
    words, found = Words(language), first_mistake("REPEAT 2 TIMES FW 1")

    assert (words.mistake(found), words.hint(found)) == (message, hint)


@pytest.mark.parametrize(
    ("language", "message"),
    [
        ("pt", "PF precisa de um número, como PF 2."),
        ("es", "AV necesita un número, como AV 2."),
    ],
)
def test_what_a_command_needs_is_said_with_an_example(language: str, message: str) -> None:
    assert Words(language).mistake(first_mistake("FW\nTR 90")) == message


def test_the_expected_words_are_in_the_learners_language() -> None:
    assert Words("es").mistake(first_mistake("WHILE 1 < 2 FW 1 END WHILE")) == "Esperaba HACER, no FW."


def meaning(kind: MistakeKind, found: str, **details: str | int) -> Diagnostic:
    return Diagnostic(kind, Span(0, 1, 3, 5), found=found, details=details)


MEANT = [
    (meaning(MistakeKind.UNDECLARED_VARIABLE, "q"), "There is no variable q.", "Write VAR q first."),
    (
        meaning(MistakeKind.UNDECLARED_VARIABLE, "q", in_procedure="P"),
        "q is not known in P.",
        "A procedure sees only its own variables.",
    ),
    (
        meaning(MistakeKind.UNDECLARED_PROCEDURE, "P"),
        "There is no procedure P yet.",
        "Write its PROCEDURE before the call.",
    ),
    (
        meaning(MistakeKind.ALREADY_DECLARED, "a", what="variable", first_line=1),
        "a exists already, from line 1.",
        "To change it, leave out VAR.",
    ),
    (
        meaning(MistakeKind.ALREADY_DECLARED, "a", what="parameter"),
        "a exists already.",
        "Choose another name.",
    ),
    (
        meaning(MistakeKind.WRONG_ARGUMENT_COUNT, "P", name="P", wanted=1, given=3),
        "P needs 1 value, not 3.",
        None,
    ),
    (meaning(MistakeKind.DIVISION_BY_ZERO, "1/0"), "I can't divide by zero.", None),
    (
        meaning(MistakeKind.RECURSION_LIMIT, "P", limit=20000),
        "P calls itself too often.",
        "It may call itself 20000 times, no more.",
    ),
    (
        meaning(MistakeKind.NUMBER_TOO_LARGE, "FW a", limit=10**9),
        "This number is too large.",
        "The most is 1000000000.",
    ),
    (
        meaning(MistakeKind.TERMINAL_ONLY, "QUIT"),
        "QUIT works only when you type it.",
        "A file ends by itself.",
    ),
    (meaning(MistakeKind.BELT_OFF, "VIBRATE F"), "The belt is off.", "BELT ON switches it on."),
    (meaning(MistakeKind.ROBOT, "FW 1"), "The robot can't do that.", None),
]


@pytest.mark.parametrize(
    ("found", "message", "hint"), MEANT, ids=[f"{each[0].kind.value}-{each[1][:12]}" for each in MEANT]
)
def test_a_mistake_of_meaning_has_a_sentence_and_a_hint(
    found: Diagnostic, message: str, hint: str | None
) -> None:
    words = Words("en")

    assert (words.mistake(found), words.hint(found)) == (message, hint)


@pytest.mark.parametrize("kind", MistakeKind, ids=lambda kind: kind.value)
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_a_mistake_without_details_has_a_sentence(kind: MistakeKind, language: str) -> None:
    words, bare = Words(language), Diagnostic(kind, Span(0, 0, 1, 1), details={"wanted": 0})

    assert words.mistake(bare).endswith(".")
    assert words.hint(bare) is None or isinstance(words.hint(bare), str)


@pytest.mark.parametrize("found", ["\x1b[2J", "a\tb\nc", "x" * 5000, "\udcff", "\u202e", "{0}{name}", ""])
@pytest.mark.parametrize(
    "kind", [MistakeKind.SYNTAX, MistakeKind.UNKNOWN_COMMAND, MistakeKind.UNKNOWN_CHARACTER]
)
def test_control_characters_of_typed_text_are_removed(found: str, kind: MistakeKind) -> None:
    texts = Words("en").mistake(Diagnostic(kind, Span(0, 1, 1, 1), found=found))

    assert texts.isprintable()
    assert len(texts) <= 80


def test_a_hint_of_the_checker_is_one_line() -> None:
    program = parse("DISTANCE F").program
    assert program is not None

    texts = remark(check(program)[0], Words("en"))

    assert texts == "DISTANCE alone does nothing. Did you mean SPEAK DISTANCE F?"


@pytest.mark.parametrize("language", ["en", "pt", "es"])
@pytest.mark.parametrize("source", [each[0] for each in TOLD], ids=[each[0][:24] for each in TOLD])
def test_an_error_has_three_lines_at_most_and_no_caret(source: str, language: str) -> None:
    words, found = Words(language), first_mistake(source)
    line = source.splitlines()[found.span.line - 1]
    error = Error(
        found.kind.value, found.span.line, found.span.column, words.mistake(found), words.hint(found), line
    )

    lines = lines_of(error, words)

    assert 2 <= len(lines) <= 3
    assert re.fullmatch(
        r"(Error,|Erro na) (line|linha|línea) \d+, (column|coluna|columna) \d+: \S.*\.", lines[0]
    )
    assert re.match(r"(Line|Linha|Línea) \d+: \S", lines[1])
    assert not any("^" in each for each in lines)
    assert max(map(len, lines)) <= 80


def of_kind(kind: MistakeKind, **values: object) -> Diagnostic:
    return Diagnostic(kind, Span(0, 1, 1, 1), **values)  # type: ignore[arg-type] -- its own fields


SYNTAX, CHARACTER, NUMBER = MistakeKind.SYNTAX, MistakeKind.UNKNOWN_CHARACTER, MistakeKind.NUMBER_TOO_LARGE


@pytest.mark.parametrize(
    ("found", "expected", "sentence"),
    [
        ("x", (), "I did not expect x here."),
        ("", (), "The program ends too early."),
        ("", ("THEN",), "I need THEN at the end."),
        ("x", ("THEN", "DO", "TIMES", "ELSE"), "I expected THEN, DO, TIMES or ELSE, not x."),
        ("x", ("THEN", "DO", "TIMES", "ELSE", "VAR"), "I did not expect x here."),
        ("", ("THEN", "DO", "TIMES", "ELSE", "VAR"), "The program ends too early."),
        ("x", ("number", "number"), "I expected a number, not x."),
        ("x", (")", "number"), "I expected a closing parenthesis or a number, not x."),
        ("x" * 24, (), f"I did not expect {'x' * 24} here."),
        ("x" * 25, (), f"I did not expect {'x' * 23}\N{HORIZONTAL ELLIPSIS} here."),
        (" a \n b ", (), "I did not expect a b here."),
        ("+", (), "I did not expect a plus sign here."),
    ],
)
def test_up_to_four_expected_words_are_named_and_a_long_text_is_cut(
    found: str, expected: tuple[str, ...], sentence: str
) -> None:
    assert Words().mistake(of_kind(SYNTAX, found=found, expected=expected)) == sentence


@pytest.mark.parametrize(
    ("found", "sign"),
    [
        ("€uro", "the character €"),
        ("e\u0323\u0301x", "the character ẹ\u0301"),  # with all its accents
        ("\u0301a", "the character U+0301"),
        ("\x07", "the character U+0007"),
        ("\u202e", "the character U+202E"),
        ("@home", "an at sign"),
    ],
)
def test_a_sign_is_named_with_its_accents_or_by_its_number(found: str, sign: str) -> None:
    assert Words().mistake(of_kind(CHARACTER, found=found)) == f"I can't use {sign} here."


@pytest.mark.parametrize(
    ("found", "hint"),
    [
        ("'a'", "Put text between double quotes."),
        ("\u2019a", "Put text between double quotes."),
        ("\u2018a", "Put text between double quotes."),
        ("||", "Write a second IF after it."),
        ("&", "Write a second IF inside it."),
        ("«", "Put text between double quotes."),
        ("%", "The rest of 7 / 2 is 7 - 7 / 2 * 2."),
        (".5", "Numbers are whole, such as 2."),
        ("#", "A comment begins with two hyphens."),
        ("$", None),
        ("", None),
    ],
)
def test_a_sign_of_another_language_gets_the_way_in_which_it_is_written_here(
    found: str, hint: str | None
) -> None:
    assert Words().hint(of_kind(CHARACTER, found=found)) == hint


@pytest.mark.parametrize(
    ("limit", "hint"),
    [
        (99_999, "A number has at most 99999 digits."),
        (100_000, "The most is 100000."),
        ("many", None),
    ],
)
def test_a_small_limit_is_one_of_digits(limit: object, hint: str | None) -> None:
    assert Words().hint(of_kind(NUMBER, details={"limit": limit})) == hint
    assert Words().hint(of_kind(NUMBER)) is None


@pytest.mark.parametrize(("details", "hint"), [({"limit": 7}, "The most is 7."), ({}, None)])
def test_a_program_that_is_too_deep_gets_its_limit(details: dict[str, int], hint: str | None) -> None:
    assert Words().hint(of_kind(MistakeKind.TOO_DEEP, details=details)) == hint


@pytest.mark.parametrize(
    ("details", "sentence"),
    [
        ({"problem": "no-sensor", "bearing": "front right"}, "I have no sensor ahead right."),
        ({"problem": "no-sensor", "bearing": "above"}, "I have no sensor above."),
        ({"problem": "no-eyes"}, "I have no eyes: I see no colors."),
        ({}, "The robot can't do that."),
    ],
)
def test_what_a_robot_can_not_do_names_the_direction(details: dict[str, str], sentence: str) -> None:
    assert Words().mistake(of_kind(MistakeKind.ROBOT, details=details)) == sentence


@pytest.mark.parametrize(
    ("wanted", "hint"), [("red, blue", "Use RED or BLUE."), ("green", "Use GREEN."), ("", None)]
)
def test_the_colours_that_a_robot_sees_are_listed(wanted: str, hint: str | None) -> None:
    unseen = of_kind(MistakeKind.BAD_ARGUMENT, code="unseen-colour", details={"wanted": wanted})

    assert Words().hint(unseen) == hint


def test_a_wrong_end_gets_the_one_that_belongs_there() -> None:
    wrong = of_kind(MistakeKind.WRONG_END, found="END FOR", details={"opener": "IF"})

    assert (Words().hint(wrong), Words("pt").hint(wrong)) == (
        "END IF belongs here.",
        "Aqui o certo é FIM SE.",
    )
    assert Words().hint(of_kind(MistakeKind.WRONG_END, found="END FOR")) is None


@pytest.mark.parametrize(
    ("found", "hint"),
    [
        ("onde", "Type ONDE alone, not in a program."),
        ("Where", "Type WHERE alone, not in a program."),
        ("n", None),
        ("nonsense", None),
    ],
)
def test_a_command_of_any_language_is_typed_alone(found: str, hint: str | None) -> None:
    assert Words().hint(of_kind(MistakeKind.UNKNOWN_COMMAND, found=found)) == hint


def test_what_was_probably_meant_is_offered_unless_the_sentence_says_it() -> None:
    def offered(**values: object) -> str | None:
        return Words().hint(of_kind(SYNTAX, found="x", **values))

    assert offered(meant="FW") == "Did you mean FW?"
    assert offered(meant="--") == "A comment begins with two hyphens."
    for code in ("missing-argument", "number-word", "short-change", "text-quotes", "filler"):
        assert offered(meant="FW", code=code) is None
    assert offered(meant="FW", meant_at=0) is None
    assert offered(meant="FW", code="other-end") is None
    on = of_kind(MistakeKind.BAD_ARGUMENT, found="onn", meant="ON", expected=("on-or-off",))
    assert Words().hint(on) == "Did you mean ON? Use ON or OFF."


def test_an_unknown_variable_may_be_a_number_in_words_or_a_text_without_quotes() -> None:
    unknown, digits = MistakeKind.UNDECLARED_VARIABLE, {"written": "FW 3"}
    number = of_kind(unknown, found="three", code="number-word", meant="3", details=digits)
    text = of_kind(
        unknown, found="hello", code="spoken", meant='"hello"', details={"written": 'SPEAK "hello"'}
    )

    assert (Words().mistake(number), Words().hint(number)) == ("Numbers are written in digits: FW 3.", None)
    assert Words().mistake(text) == "There is no variable hello."
    assert Words().hint(text) == 'A text needs quotes: SPEAK "hello".'


def test_a_name_is_that_of_the_details_where_nothing_was_typed() -> None:
    unknown = of_kind(MistakeKind.UNDECLARED_VARIABLE, details={"name": "a" * 25})

    assert Words().hint(unknown) == f"Write VAR {'a' * 23}\N{HORIZONTAL ELLIPSIS} first."


@pytest.mark.parametrize("kind", MistakeKind, ids=lambda kind: kind.value)
def test_a_mistake_of_which_nothing_is_known_has_a_sentence(kind: MistakeKind) -> None:
    assert Words().mistake(of_kind(kind)).endswith(".")
    assert Words().hint(of_kind(kind)) != ""


LONG, CUT = "n" * 25, f"{'n' * 23}\N{HORIZONTAL ELLIPSIS}"
"""A name, and as a sentence repeats it."""


@pytest.mark.parametrize(
    ("kind", "details", "sentence"),
    [
        (MistakeKind.UNDECLARED_VARIABLE, {"name": LONG}, f"There is no variable {CUT}."),
        (MistakeKind.UNDECLARED_PROCEDURE, {"name": LONG}, f"There is no procedure {CUT} yet."),
        (
            MistakeKind.UNDECLARED_VARIABLE,
            {"name": LONG, "in_procedure": LONG},
            f"{CUT} is not known in {CUT}.",
        ),
        (
            MistakeKind.WRONG_ARGUMENT_COUNT,
            {"name": LONG, "wanted": 1, "given": 0},
            f"{CUT} needs 1 value, not 0.",
        ),
        (MistakeKind.RECURSION_LIMIT, {"name": LONG, "limit": 7}, f"{CUT} calls itself too often."),
    ],
)
def test_a_long_name_is_cut_in_a_sentence(
    kind: MistakeKind, details: dict[str, str | int], sentence: str
) -> None:
    assert Words().mistake(of_kind(kind, found=LONG, details=details)) == sentence


@pytest.mark.parametrize(
    ("expected", "closer"), [(("END FOR",), "END FOR"), (("command", "END FOR"), "END FOR"), ((), "END IF")]
)
def test_an_open_block_gets_the_end_that_is_expected(expected: tuple[str, ...], closer: str) -> None:
    open_block = of_kind(MistakeKind.MISSING_END, expected=expected, details={"opener": "IF"})

    assert Words().hint(open_block) == f"Write {closer} where it ends."


def test_a_remark_without_advice_is_the_sentence_alone() -> None:
    assert remark(of_kind(MistakeKind.DIVISION_BY_ZERO), Words()) == "I can't divide by zero."


def test_a_code_without_a_sentence_of_its_own_has_that_of_its_kind() -> None:
    assert Words().mistake(of_kind(SYNTAX, code="unheard-of", found="x")) == "I did not expect x here."
    assert Words().mistake(of_kind(MistakeKind.DIVISION_BY_ZERO, code="x")) == "I can't divide by zero."


@pytest.mark.parametrize(("details", "code"), [({"word": "POS"}, "-of"), ({}, "")])
def test_a_wrong_argument_names_its_command_if_that_is_known(details: dict[str, str], code: str) -> None:
    sentence = Words()(f"mistake-bad-argument{code}", found="x", word="POS")

    assert Words().mistake(of_kind(MistakeKind.BAD_ARGUMENT, found="x", details=details)) == sentence

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
    ("JUMP 3", "I do not know JUMP.", None),
    ("REPEAT 2 FW 1 END REPEAT", "I expected TIMES, not FW.", "Write TIMES before FW."),
    ("SPEAK COLOUR blue", "I do not know COLOUR.", "Did you mean COLOR?"),
    ("IF DISTANSE F > 3 THEN END IF", "I do not know DISTANSE.", "Did you mean DISTANCE?"),
    ("SPEAK DISTANCE LEFT", "DISTANCE can't take LEFT.", "It takes F, FR, FL, B, BR or BL."),
    ("x == 3", "A value is given with one equals sign.", "Did you mean =?"),
    ("VAR a = 3 *", "Missing at the end: a value.", None),
    ("SPEAK (1+2", "Missing at the end: a closing parenthesis.", None),
    ("FW 1 $ FW 2", "I can't use a dollar sign here.", None),
    ("FW 2.5", "I can't use a full stop here.", "Numbers are whole, such as 2."),
    ("IF 1 != 2 THEN END IF", "I can't use an exclamation mark here.", "Different is written <>."),
    ("IF 1 = 2 THEN END IF", "Here two values are compared.", "Did you mean ==?"),
    ('SPEAK "hello', "This text has no closing quote.", None),
    ('SPEAK "a" + 1', "A text can't be calculated with.", "Write another SPEAK for the rest."),
    ("VAR 52abc", "52abc is no name.", "A name begins with a letter."),
    ("VAR times = 2", "times is a word of GoDonnie.", "Choose another name."),
    ("SPEAK DISTANCE Z", "DISTANCE can't take Z.", "It takes F, FR, FL, B, BR or BL."),
    ("SPEAK POS b", "POS can't take b.", "It takes X, Y or A."),
    ("SOUND maybe", "SOUND can't take maybe.", "It takes ON or OFF."),
    ("SOUND onn", "SOUND can't take onn.", "Did you mean ON? It takes ON or OFF."),
    ("SPEAK COLOR yellow", "The robot does not see yellow.", "It takes BLUE, GREEN or RED."),
    ("FW 1\nREPEAT 2 TIMES", "REPEAT has no END REPEAT.", "Write END REPEAT where it ends."),
    ("IF 1 == 1 THEN END FOR", "END FOR does not close IF of line 1.", "Here belongs END IF."),
    ("FW 1 END IF", "END IF closes nothing.", None),
    ("ELSE", "ELSE belongs to no IF.", None),
    (f"FW {'1' * 4301}", "This number is too large.", "At most 4300 digits."),
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
        ("pt", "REPITA não tem FIM REPITA.", "Escreva FIM REPITA onde ele acaba."),
        ("es", "REPETIR no tiene FIN REPETIR.", "Escribe FIN REPETIR donde acaba."),
    ],
)
def test_words_of_godonnie_are_in_the_learners_language(language: str, message: str, hint: str) -> None:
    words, found = Words(language), first_mistake("REPEAT 2 TIMES FW 1")

    assert (words.mistake(found), words.hint(found)) == (message, hint)


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
        "Its PROCEDURE must come before the call.",
    ),
    (
        meaning(MistakeKind.ALREADY_DECLARED, "a", what="variable", first_line=1),
        "a exists already, from line 1.",
        "To change it, leave out VAR.",
    ),
    (meaning(MistakeKind.ALREADY_DECLARED, "a", what="parameter"), "a exists already.", None),
    (
        meaning(MistakeKind.WRONG_ARGUMENT_COUNT, "P", name="P", wanted=1, given=3),
        "P takes 1 value, not 3.",
        None,
    ),
    (meaning(MistakeKind.DIVISION_BY_ZERO, "1/0"), "I can't divide by zero.", None),
    (
        meaning(MistakeKind.RECURSION_LIMIT, "P", limit=20000),
        "P calls itself too often.",
        "At most 20000 calls in each other.",
    ),
    (
        meaning(MistakeKind.NUMBER_TOO_LARGE, "FW a", limit=10**9),
        "This number is too large.",
        "At most 1000000000.",
    ),
    (
        meaning(MistakeKind.TERMINAL_ONLY, "QUIT"),
        "QUIT works in the terminal only.",
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
        r"(Error|Erro), (line|linha|línea) \d+, (column|coluna|columna) \d+: \S.*\.", lines[0]
    )
    assert re.match(r"(Line|Linha|Línea) \d+: \S", lines[1])
    assert not any("^" in each for each in lines)
    assert max(map(len, lines)) <= 80

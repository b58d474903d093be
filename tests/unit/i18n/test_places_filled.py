"""A call with the code of a sentence gives a value for each of its places."""

import ast
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import pytest

import donnie_tui
from donnie_tui import DETAILS
from language.locales import languages
from tests.unit.i18n.sentences import CODES, text

ROOT = Path(donnie_tui.__file__).parent
SPEAKERS = {
    *("words", "_words", "wording", "_wording", "say", "_say", "answer", "_answer", "answer_of_robot"),
    *("ask_yes", "Answer", "Notice", "BundleError", "well", "amiss"),
}
"""Called with a code: what they are given besides are the values of its sentence."""


def places(code: str) -> set[str]:
    texts = {text(code, language, detail) for language in languages() for detail in DETAILS}
    return {name for text in texts for _, name, _, _ in Formatter().parse(text) if name}


def calls_in(source: str) -> Iterator[tuple[int, str, set[str]]]:
    """Line, code and names of the values of each; where they are not all written there, none."""
    for call in ast.walk(ast.parse(source)):
        if isinstance(call, ast.Call) and called(call) in SPEAKERS:
            given = values(call)
            for code in codes(call) if given is not None else ():
                yield call.lineno, code, given


def called(call: ast.Call) -> str:
    return call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")


def codes(call: ast.Call) -> Iterator[str]:
    for given in call.args:
        for each in (given.body, given.orelse) if isinstance(given, ast.IfExp) else (given,):
            if isinstance(each, ast.Constant) and each.value in CODES:
                yield each.value


def values(call: ast.Call) -> set[str] | None:
    """Named one by one, or in a dictionary; None if that is made elsewhere."""
    names = {each.arg for each in call.keywords}
    if called(call) not in ("Answer", "Notice"):
        return None if None in names else names
    for given in call.args[1:]:
        if not isinstance(given, ast.Dict) or not all(isinstance(key, ast.Constant) for key in given.keys):
            return None
        names |= {key.value for key in given.keys}
    return names


def test_no_value_is_missing_where_a_code_is_used() -> None:
    wanting = [
        f"{path.relative_to(ROOT)}:{line} {code} lacks {sorted(places(code) - given)}"
        for path in sorted(ROOT.rglob("*.py"))
        for line, code, given in calls_in(path.read_text(encoding="utf-8"))
        if places(code) - given
    ]

    assert wanting == []


@pytest.mark.parametrize(
    "source",
    [
        'Answer("answer-no-line", {"line": 3})',
        'words("answer-no-line", line=3)',
        'x.answer("answer-lines" if y else "answer-no-line", line=3)',
    ],
)
def test_a_missing_value_is_found(source: str) -> None:
    assert [places(code) - given for _, code, given in calls_in(source)] == [{"last"}]

"""Every problem that a robot can raise has a sentence, with the direction where it is about one."""

import re

import pytest

from devices.ports.robot import Bearing
from donnie_tui.i18n.words import Words
from language.diagnostics import Diagnostic, MistakeKind
from language.syntax import Span
from tests.conftest import ROOT
from tests.unit.i18n.sentences import CODES

RAISED = re.compile(r'RobotProblem\(\s*"([a-z-]+)"')
RAISED_CODES = sorted(
    {
        code
        for folder in ("sim", "devices", "donnie_tui")
        for file in (ROOT / folder).rglob("*.py")
        for code in RAISED.findall(file.read_text(encoding="utf-8"))
    }
)


def sentence_of(language: str = "en", **details: str | int) -> str:
    span = Span(0, 0, 1, 1)
    return Words(language).mistake(Diagnostic(MistakeKind.ROBOT, span, details=details))


@pytest.mark.parametrize("code", RAISED_CODES)
def test_a_problem_has_a_sentence(code: str) -> None:
    assert f"problem-{code}" in CODES


@pytest.mark.parametrize("bearing", Bearing, ids=lambda each: each.name.lower())
def test_a_missing_sensor_is_named_by_its_direction(bearing: Bearing) -> None:
    sentences = {
        sentence_of(language, problem="no-sensor", bearing=bearing.words) for language in ("en", "pt", "es")
    }

    assert len(sentences) == 3
    assert not any("_" in sentence or "{" in sentence for sentence in sentences)


def test_an_unknown_problem_has_a_general_sentence() -> None:
    assert sentence_of(problem="unheard-of") == "The robot can't do that."

"""The linear mode does every use case, and says how each is said."""

from importlib import import_module

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import USE_CASES
from donnie_tui.i18n.words import Words
from donnie_tui.linear.commands import HANDLED_IN, OF_CONVERSATION, find, listed


def test_everything_that_is_done_is_a_use_case() -> None:
    assert set(HANDLED_IN) | set(OF_CONVERSATION) <= {each.name for each in USE_CASES}


@pytest.mark.parametrize("module", sorted(set(HANDLED_IN.values())))
def test_a_word_is_done_by_the_module_that_is_loaded_for_it(module: str) -> None:
    done = import_module(f"donnie_tui.linear.{module}").HANDLERS

    assert set(done) == {name for name, where in HANDLED_IN.items() if where == module}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("case", listed(), ids=lambda case: case.name)
def test_the_example_of_a_word_is_a_way_to_say_it(case: use_cases.UseCase, language: str) -> None:
    words = Words(language)
    line = use_cases.help_line(case, words)
    found = use_cases.find(line.partition(":")[0])

    assert line.startswith(case.word(language))
    assert found is not None
    assert found[0].name == case.name


@pytest.mark.parametrize("line", ["speed = 3", "LIST [2]", "where=1", "openx", "FW 3", "", "x" * 1000])
def test_a_learner_s_own_name_is_no_word(line: str) -> None:
    assert find(line) is None

"""The linear mode does every use case, and says how each is said."""

import pytest

from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import USE_CASES
from donnie_tui.i18n.sentence import LANGUAGES
from donnie_tui.i18n.words import Words
from donnie_tui.linear.commands import HANDLERS, OF_CONVERSATION, find, listed


def test_everything_that_is_done_is_a_use_case() -> None:
    assert set(HANDLERS) | set(OF_CONVERSATION) <= {each.name for each in USE_CASES}


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

"""Which small mistakes count as noticed, where a module that runs once more misleads the tests."""

from collections.abc import Collection, Sequence
from types import SimpleNamespace
from typing import Any

import pytest

from tests.tools.mutants import Trial
from tests.tools.mutations import Mutation

MISTAKE = Mutation("language/parser.py", 1, 0, 1, "x", "another text")


class Process(Trial):
    """Tests that fail with a mistake: in the process that runs the module once more, and in a new one."""

    def __init__(
        self, fail: Collection[str], fail_without: Collection[str], fail_anew: Collection[str]
    ) -> None:
        self._fail, self._fail_without, self._fail_anew = fail, fail_without, fail_anew
        self._warm: Any = SimpleNamespace(has_no_end=False, names=frozenset("abc"))

    def _first_failure(self, path: str, names: Sequence[str], is_imported: bool) -> str:
        return next((each for each in names if each in self._fail), "")

    def _first_failure_anew(self, names: list[str]) -> tuple[str, list[str]]:
        return next((each for each in names if each in self._fail_anew), ""), names

    def _passes_without(self, path: str, name: str, is_imported: bool = False) -> bool:
        return not (is_imported and name in self._fail_without)


@pytest.mark.parametrize(
    ("fail", "fail_without", "fail_anew", "by"),
    [
        ("", "", "", ""),
        ("b", "", "", "b"),
        ("bc", "b", "", "c"),
        ("b", "b", "", ""),
        ("", "", "a", "a"),
        ("b", "b", "a", "a"),
        ("b", "b", "b", "b"),
        ("abc", "abc", "c", "c"),
    ],
)
def test_new_processes_try_all_tests_where_a_module_that_runs_once_more_shows_nothing(
    fail: str, fail_without: str, fail_anew: str, by: str
) -> None:
    assert Process(fail, fail_without, fail_anew)._noticed(MISTAKE, ["a", "b", "c"], True) == by

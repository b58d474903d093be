"""The size and the shape of the product: few modules, few small ones, one class of each name."""

from __future__ import annotations

from statistics import median

from tests.architecture.house import functions, lines_of, modules, places_of_public_classes, tracked
from tests.conftest import ROOT

MOST_MODULES = 249
MOST_SMALL_MODULES = 29
SMALL = 60
LEAST_MEDIAN, MOST_MEDIAN = 100, 300
MOST_CLASSES_OF_ONE_NAME = 0
MOST_PARAMETERS = 8
MOST_FUNCTIONS_WITH_MORE = 0


def test_there_are_few_modules() -> None:
    assert 0 < len(modules()) <= MOST_MODULES


def test_few_modules_are_small() -> None:
    small = {path: lines for path in modules() if (lines := lines_of(path)) < SMALL}

    assert len(small) <= MOST_SMALL_MODULES, small


def test_the_median_module_has_a_readable_size() -> None:
    assert LEAST_MEDIAN <= median(map(lines_of, modules())) <= MOST_MEDIAN


def test_no_two_public_classes_have_one_name() -> None:
    shared = {name: places for name, places in places_of_public_classes().items() if len(places) > 1}

    assert len(shared) <= MOST_CLASSES_OF_ONE_NAME, shared


def test_no_function_has_more_than_eight_parameters() -> None:
    more = [place for place, parameters in functions() if parameters > MOST_PARAMETERS]

    assert len(more) <= MOST_FUNCTIONS_WITH_MORE, more


def test_only_files_of_tests_mark_tests_as_slow() -> None:
    """The slow check reads only the files that have the word."""
    others = [path for path in tracked("tests/*.py") if not path.rpartition("/")[2].startswith("test_")]

    assert "tests/conftest.py" in others
    assert [path for path in others if ".mark." + "slow" in (ROOT / path).read_text("utf-8")] == []

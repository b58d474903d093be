"""How the linear mode behaves: every choice has its words in three languages; its English one is kept."""

from dataclasses import fields

import pytest

from donnie_tui.linear.habits import (
    SPELLINGS,
    Habits,
    Page,
    Prompt,
    choices,
    find,
    kept_as,
    of_settings,
    read,
    spelled,
)
from donnie_tui.settings.chosen import Settings, resolve
from donnie_tui.settings.readers import LONGEST_PROGRESS

FIELDS = [each.name for each in fields(Habits)]


def test_the_defaults_of_the_settings_are_the_defaults_of_the_habits() -> None:
    assert of_settings(Settings()) == Habits()
    assert list(SPELLINGS) == FIELDS


@pytest.mark.parametrize("field", FIELDS)
def test_every_value_is_read_back_in_every_language_and_from_the_settings(field: str) -> None:
    for value in SPELLINGS[field][1]:
        for at in range(3):
            assert read(field, spelled(field, value, at)) == value
            assert spelled(field, value, at) in choices(field, at)
        settings, notices = resolve({}, {}, {field: kept_as(field, value)})
        assert (getattr(of_settings(settings), field), notices) == (value, ())


@pytest.mark.parametrize("field", FIELDS)
def test_every_name_is_found_in_every_language(field: str) -> None:
    assert {find(name.upper()) for name in SPELLINGS[field][0]} == {field}


@pytest.mark.parametrize(
    ("field", "typed", "value"),
    [
        *(("progress", "0", 0), ("progress", str(LONGEST_PROGRESS), LONGEST_PROGRESS)),
        *(("free", "f", "f"), ("page", "PERGUNTAR", Page.ASK), ("prompt", "respuesta", Prompt.ANSWER)),
    ],
)
def test_numbers_letters_and_words_of_other_languages_are_understood(
    field: str, typed: str, value: object
) -> None:
    assert read(field, typed) == value


@pytest.mark.parametrize(
    ("field", "typed"),
    [("progress", "-1"), ("progress", "99999"), ("free", "ab"), ("free", "5"), ("page", "x"), ("hold", "")],
)
def test_what_is_no_value_is_refused(field: str, typed: str) -> None:
    with pytest.raises(ValueError, match=r".*"):
        read(field, typed)


def test_a_wrong_value_in_the_settings_is_told_and_the_default_counts() -> None:
    settings, notices = resolve({}, {}, {"progress": "often", "free": "~"})

    assert of_settings(settings) == Habits()
    assert {each.values["name"] for each in notices} == {"progress", "free"}

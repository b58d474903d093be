"""The file of words next to a world file: which language is taken, and what can be wrong with it."""

from __future__ import annotations

from pathlib import Path

import pytest

from worlds import words
from worlds.words import About, BadWords, Difficulty, about, about_file, words_file

ENTRY = '[{}]\ntitle = "{} title"\ndescription = """\nOne.\nTwo.\n"""\ntask = "Do it."\n'


def world_with(folder: Path, text: str | bytes) -> str:
    """The path of a world whose file of words has this text."""
    file = folder / "attic.toml"
    file.write_bytes(text.encode() if isinstance(text, str) else text)
    return str(folder / "attic.world")


def entries(*languages: str) -> str:
    return "".join(ENTRY.format(each, each) for each in languages)


def problem_of(world: str, language: str = "en") -> BadWords:
    with pytest.raises(BadWords) as caught:
        about_file(world, language)
    return caught.value


def test_a_world_without_a_file_of_words_has_no_words(tmp_path: Path) -> None:
    world = str(tmp_path / "attic.world")
    (tmp_path / "attic.toml").mkdir()

    assert (words_file(world), about_file(world, "en")) == (None, None)


def test_the_words_are_those_of_the_file_of_the_same_name(tmp_path: Path) -> None:
    world = world_with(tmp_path, 'difficulty = "hard"\n' + entries("en"))
    found = about_file(world, "en")

    assert words_file(world) == str(tmp_path / "attic.toml")
    assert found == About("en title", "One.\nTwo.", "Do it.", Difficulty.HARD)
    assert found.sentences == ("One.", "Two.")


@pytest.mark.parametrize(
    ("written", "language", "taken"),
    [
        (("de", "en", "pt"), "pt", "pt"),
        (("de", "pt", "en"), "es", "en"),
        (("de", "fr"), "es", "de"),
    ],
)
def test_words_are_in_the_language_or_in_english_or_in_the_first_one(
    tmp_path: Path, written: tuple[str, ...], language: str, taken: str
) -> None:
    found = about_file(world_with(tmp_path, 'version = "1"\n' + entries(*written)), language)

    assert found is not None
    assert (found.title, found.difficulty) == (f"{taken} title", Difficulty.UNSTATED)


def test_a_builtin_world_is_described_in_english_where_a_language_is_missing() -> None:
    assert about("first_room", "xx") == about("first_room", "en") != about("first_room", "pt")


@pytest.mark.parametrize(
    ("text", "language", "key"),
    [
        ("", "pt", "pt"),
        ('version = "1"\n', "en", "en"),
        ('en = "words"\n', "en", "en.title"),
        ("[en]\n", "en", "en.title"),
        ('[en]\ntitle = "T"\ntask = "T"\n', "en", "en.description"),
        ('[pt]\ntitle = "T"\ndescription = "D"\n', "en", "pt.task"),
        ('[en]\ntitle = 7\ndescription = "D"\ntask = "T"\n', "en", "en.title"),
        ('difficulty = "very"\n' + entries("en"), "en", "difficulty"),
        ("difficulty = 3\n" + entries("en"), "en", "difficulty"),
    ],
)
def test_what_is_missing_or_no_text_is_named(tmp_path: Path, text: str, language: str, key: str) -> None:
    problem = problem_of(world_with(tmp_path, text), language)

    assert (problem.file, problem.key, problem.line, problem.limit) == (tmp_path / "attic.toml", key, "", 0)
    assert str(problem) == f"{tmp_path / 'attic.toml'}: {key}"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (b"\n\n[en\n", "3"),
        (b"[en]\na" + b".a" * 201 + b" = 1\n", "2"),
        (b"[en]\ntitle = \xff\n", ""),
        (b"a = " + b"[" * 5000, ""),
    ],
)
def test_the_line_that_can_not_be_read_is_named_where_it_is_known(
    tmp_path: Path, text: bytes, line: str
) -> None:
    problem = problem_of(world_with(tmp_path, text))

    assert (problem.key, problem.line, problem.limit) == ("", line, 0)


def test_two_hundred_dots_in_a_line_are_read() -> None:
    assert words.parsed(b"\xef\xbb\xbftitle = '" + b"." * 200 + b"'\r\n") == {"title": "." * 200}
    with pytest.raises(ValueError, match=r"too many dots \(at line 1, column 1\)"):
        words.parsed(b"title = '" + b"." * 201 + b"'\r\n")


@pytest.mark.parametrize("more", [0, 1])
def test_a_file_of_words_has_at_most_a_hundred_thousand_bytes(tmp_path: Path, more: int) -> None:
    text = entries("en")
    world = world_with(tmp_path, text + "#" * (100_000 - len(text) + more))

    if more:
        assert problem_of(world).limit == 100_000
    else:
        assert about_file(world, "en") is not None

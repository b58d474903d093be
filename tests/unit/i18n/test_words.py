"""Sentences are found by code, language and detail, and their places filled as the language wants it."""

import os
from errno import ENOENT

import pytest

from donnie_tui.core.program_files import DocumentError
from donnie_tui.i18n.words import NotAllowed, Sentence, Unusable, Words, as_unusable, filled, find


def test_an_unknown_code_has_no_sentence() -> None:
    words = Words("pt", "brief")
    assert words.knows("sign-star")
    assert not words.knows("no-such-code")
    assert find("no-such-code", "pt") is None
    with pytest.raises(KeyError, match="no-such-code"):
        words("no-such-code")


def test_a_sentence_of_another_detail_is_the_normal_one_unless_there_is_one() -> None:
    assert [Words("en", each)("answer-stopped-at", line=3) for each in ("brief", "normal", "full")] == [
        "Stopped at line 3."
    ] * 3
    assert Words("en", "brief")("problem-not-a-port", port="x") == "x is no port."
    assert Words("en", "normal")("problem-not-a-port", port="x") != "x is no port."
    changed = Words()
    changed.language, changed.detail = "pt", "brief"
    assert changed("sign-star") == Words("pt", "brief")("sign-star")


@pytest.mark.parametrize(
    ("language", "number", "said"),
    [
        ("en", 1, "one"),
        ("en", -1, "one"),
        ("en", 0, "many"),
        ("en", 2, "many"),
        ("en", 1.0, "one"),
        ("en", 1.5, "many"),
        ("en", 0.5, "many"),
        ("en", "1", "many"),
        ("en", True, "one"),
        ("pt", 0, "many"),
        ("no such language", 1, "one"),
        ("no such language", 2, "many"),
    ],
)
def test_a_word_agrees_with_its_number(language: str, number: object, said: str) -> None:
    assert filled(Sentence("{n:one|many}", language), {"n": number}) == said
    assert filled(Sentence("{n:always|}", language), {"n": number}) == ("always" if said == "one" else "")


@pytest.mark.parametrize(
    ("text", "value", "said"),
    [
        ("{n:grouped}", 1234567, "1 234 567"),
        ("{n:grouped}", 999, "999"),
        ("{n:grouped}", "many", "many"),
        ("{n:grouped}", 1234.5, "1234.5"),
        ("{n}", 1234.5, "1234,5"),
        ("{n:.2f}", 0.5, "0,50"),
        ("{n}", "1.5", "1.5"),
        ("{n:capital}", "", ""),
        ("{n:capital}", "éa BC", "Éa BC"),
        ("{n:small}", "ÉA BC", "éA BC"),
        ("{{{n}}}", 3, "{3}"),
        ("}}", 3, "}"),
        ("{{", 3, "{"),
        ("none", 3, "none"),
    ],
)
def test_a_place_has_the_form_that_the_sentence_wants(text: str, value: object, said: str) -> None:
    assert filled(Sentence(text, "pt"), {"n": value, "other": 1}) == said


def test_a_place_without_a_value_is_an_error() -> None:
    with pytest.raises(KeyError, match="n"):
        filled(Sentence("{n}", "en"), {"m": 1})


def test_the_systems_reason_is_translated_for_the_sentence_or_in_general() -> None:
    words, missing = Words("en"), os.strerror(ENOENT)

    assert words("file-unwritable", path="a/b", reason=missing).endswith(": there is no such folder.")
    assert words("file-unreadable", path="a", reason=missing) == f"I can't read a: {words('reason-ENOENT')}."
    assert words("file-unreadable", path="a", reason="odd") == "I can't read a: odd."


def test_what_can_not_be_used_is_said_in_words_in_place_of_an_error() -> None:
    words = Words()
    with pytest.raises(Unusable) as unusable, as_unusable(words):
        raise DocumentError("file-unreadable", "a.gd", "odd")

    assert unusable.value.sentences == ("I can't read a.gd: odd.",)
    assert unusable.value.sentences_after(("run", "a.gd")) == unusable.value.sentences
    assert Unusable("One.", "Two.").sentence == "One. Two."
    assert str(Unusable("One.")) == "One."


def test_a_folder_that_is_not_allowed_is_named_with_the_command_that_allows_it() -> None:
    refused = NotAllowed("It lies outside.", Words(), ("run", "my maze.world"), "/la b\x07")

    command = "donnie run 'my maze.world' --allow '/la b '"
    assert refused.sentences == ("It lies outside.", Words()("world-allow", command=command))
    assert refused.sentences_after(()) == (
        "It lies outside.",
        Words()("world-allow", command="donnie --allow '/la b '"),
    )

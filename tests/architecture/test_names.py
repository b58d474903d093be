"""Names and sentences are the field's: what breaks the rules grows no more."""

from __future__ import annotations

import pytest

from tests.architecture.naming import findings, wrong_sentences, wrong_words

MOST = {
    "donnie_tui": 0,
    "devices": 0,
    "language": 0,
    "sim": 0,
    "worlds": 0,
    "tests": 0,
    "docs": 0,
    "benchmarks": 0,
}
"""Findings that are left. To list them: ``python -m tests.architecture.naming PLACE``."""

DOCUMENTS = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs")


@pytest.mark.parametrize("place", MOST)
def test_names_and_sentences_follow_the_rules(place: str) -> None:
    found = findings(*(DOCUMENTS if place == "docs" else (place,)))

    assert len(found) <= MOST[place], "\n".join(found[:20])


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("told_lines", {"told"}),
        ("TellAgain", {"tell"}),
        ("Desk", {"desk"}),
        ("intellect", set()),
        ("test_a_program_ends", set()),
        ("ends", {"ends"}),
    ],
)
def test_a_forbidden_word_is_found_as_a_part_of_a_name(name: str, words: set[str]) -> None:
    assert wrong_words(name) == words


@pytest.mark.parametrize(
    ("sentence", "is_wrong"),
    [
        ("Whoever types comes through.", True),
        ("The robot is told where to go.", True),
        ("Who would hear why not?", True),
        ("Hears what the hub publishes.", True),
        ("The learner hears a cue.", False),
        ("Publishes each event to the listeners. The thread returns.", False),
        ("Printed once (L25).", True),
        ("The key F8 stops the run.", False),
    ],
)
def test_a_sentence_pattern_is_found(sentence: str, is_wrong: bool) -> None:
    assert bool([*wrong_sentences(sentence, codes=True)]) == is_wrong

"""What the system says of a file or a port is told in the learner's language, whoever tells it."""

import errno
import os

import pytest

from donnie_tui.i18n.words import Words

NUMBERS = ("ENOENT", "EACCES", "ENOSPC", "EISDIR", "EROFS", "ENAMETOOLONG", "ENOTDIR")


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.parametrize("language", ["pt", "es"])
def test_the_usual_reasons_have_words_in_each_language(name: str, language: str) -> None:
    reason = os.strerror(getattr(errno, name))
    told = Words(language)("file-unreadable", path="x", reason=reason)

    assert reason not in told
    assert told.startswith(("Não consigo ler x: ", "No puedo leer x: "))


def test_what_can_not_be_written_for_want_of_it_is_a_folder() -> None:
    reason = os.strerror(errno.ENOENT)
    told = [Words(each)("file-unwritable", path="a/b", reason=reason) for each in ("en", "pt", "es")]

    assert told == [
        "I can't write a/b: there is no such folder.",
        "Não consigo escrever a/b: essa pasta não existe.",
        "No puedo escribir a/b: esa carpeta no existe.",
    ]


def test_a_reason_that_nobody_knows_is_told_as_it_is() -> None:
    assert Words("pt")("file-unreadable", path="x", reason="odd") == "Não consigo ler x: odd."

"""The system's reason why a file or a port can't be used is in the learner's language."""

import errno
import os
import socket

import pytest

from devices.serial_ports import reason_of
from donnie_tui.i18n.words import Words

NUMBERS = (
    *(
        "ENOENT",
        "EEXIST",
        "EACCES",
        "EPERM",
        "ENOSPC",
        "EDQUOT",
        "EFBIG",
        "EISDIR",
        "EROFS",
        "ENAMETOOLONG",
        "ENOTDIR",
    ),
    *("ELOOP", "EINVAL", "EIO", "EBUSY", "EAGAIN", "EMFILE", "ENFILE", "ENOMEM", "ENOTTY", "ENXIO", "ENODEV"),
    *("EADDRINUSE", "EADDRNOTAVAIL", "EAFNOSUPPORT", "ENETUNREACH", "EHOSTUNREACH", "ETIMEDOUT"),
    *("ECONNREFUSED", "ECONNRESET", "EPIPE"),
)


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.parametrize("language", ["pt", "es"])
def test_the_usual_reasons_have_words_in_each_language(name: str, language: str) -> None:
    reason = os.strerror(getattr(errno, name))
    found = Words(language)("file-unreadable", path="x", reason=reason)

    assert reason not in found
    assert found.startswith(("Não consigo ler x: ", "No puedo leer x: "))


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_a_name_that_no_machine_has_is_in_the_language_of_the_learner(language: str) -> None:
    with pytest.raises(socket.gaierror) as caught:
        socket.getaddrinfo("no machine", None, flags=socket.AI_NUMERICHOST)

    assert (
        Words(language)("serve-failed", port=8000, reason=reason_of(caught.value))
        == {
            "en": "Port 8000 can't be used: no machine has that name.",
            "pt": "A porta 8000 não pode ser usada: nenhuma máquina tem esse nome.",
            "es": "El puerto 8000 no se puede usar: ninguna máquina tiene ese nombre.",
        }[language]
    )


def test_without_a_network_names_of_machines_can_not_be_looked_up() -> None:
    reason = "Temporary failure in name resolution"

    assert [Words(each)("problem-port-failed", port="x", reason=reason) for each in ("en", "pt", "es")] == [
        "I can't use x: names of machines can't be looked up now.",
        "Não consigo usar x: agora não dá para procurar nomes de máquinas.",
        "No puedo usar x: ahora no se pueden buscar nombres de máquinas.",
    ]


@pytest.mark.parametrize(
    "reason",
    [
        "Name or service not known",  # glibc
        "No address associated with hostname",
        "nodename nor servname provided, or not known",  # macOS
        "Name does not resolve",  # musl
        "getaddrinfo failed",  # Windows
    ],
)
def test_each_system_says_in_its_own_words_that_no_machine_has_a_name(reason: str) -> None:
    assert (
        Words()("problem-port-failed", port="x", reason=reason) == "I can't use x: no machine has that name."
    )


def test_a_missing_folder_is_named_when_a_file_can_not_be_written() -> None:
    reason = os.strerror(errno.ENOENT)
    found = [Words(each)("file-unwritable", path="a/b", reason=reason) for each in ("en", "pt", "es")]

    assert found == [
        "I can't write a/b: there is no such folder.",
        "Não consigo gravar a/b: essa pasta não existe.",
        "No puedo escribir a/b: esa carpeta no existe.",
    ]


def test_an_unknown_reason_stays_as_it_is() -> None:
    assert Words("pt")("file-unreadable", path="x", reason="odd") == "Não consigo ler x: odd."

"""The settings files: read, with its mistakes reported once, and written a line at a time.

A damaged file never prevents a start: defaults apply, and the file is left as it is. ``parsing`` checks the
values and not msgspec: they are texts as on the command line, and each wrong one is reported by itself.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from donnie_tui.process.confinement import make_folder, open_bytes
from donnie_tui.settings.folders import account_settings_file, settings_file
from donnie_tui.settings.settings import Notice
from language.locales import toml_in

LARGEST = 100_000
"""Bytes; ten settings take two hundred."""


def read_settings(environment: Mapping[str, str]) -> tuple[dict[str, object], tuple[Notice, ...]]:
    """The settings of the account, as ``read_file``."""
    return read_file(account_settings_file(environment))


def read_file(file: str) -> tuple[dict[str, object], tuple[Notice, ...]]:
    """What the file says, and what is wrong with it; both empty where there is none."""
    try:
        with open_bytes(file) as stream:
            data = stream.read(LARGEST + 1)
        if len(data) > LARGEST:
            return {}, (Notice("settings-file-too-large", {"limit": f"{LARGEST:,}".replace(",", " ")}),)
        text = data.decode("utf-8-sig")
    except FileNotFoundError:
        return {}, ()
    except (OSError, ValueError):
        return {}, (Notice("settings-file-unreadable", {}),)
    return _parsed(text)


def _parsed(text: str) -> tuple[dict[str, object], tuple[Notice, ...]]:
    try:
        return toml_in(text), ()
    except (ValueError, RecursionError) as damage:
        line = re.search(r"line (\d+)", str(damage))
        last = str(text.count("\n") + 1)
        return {}, (Notice("settings-file-damaged", {"line": line[1] if line else last}),)


def remember(key: str, value: str | bool | float, environment: Mapping[str, str]) -> None:
    """Put one setting into the file; the others, and comments, stay. Raises ``DocumentError``."""
    from pathlib import Path

    from donnie_tui.core.program_files import DocumentError, write_program  # a start only reads

    path = Path(settings_file(environment))
    try:
        make_folder(path.parent)
        with open_bytes(path) as file:
            text = file.read().decode("utf-8-sig")
    except FileNotFoundError:
        text = ""
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise DocumentError("file-unwritable", str(path), reason) from None
    write_program(path, with_setting(text, key, value))


def with_setting(text: str, key: str, value: str | bool | float) -> str:
    """The text of a settings file in which ``key`` has ``value``."""
    line = f"{key} = {_as_toml(value)}"
    changed, count = re.subn(rf"^[ \t]*{re.escape(key)}[ \t]*=.*$", lambda _: line, text, flags=re.MULTILINE)
    if count:
        return changed
    first_table = re.search(r"^[ \t]*\[", text, flags=re.MULTILINE)
    at = first_table.start() if first_table else len(text)
    before = text[:at] if not text[:at] or text[:at].endswith("\n") else f"{text[:at]}\n"
    return f"{before}{line}\n{text[at:]}"


def _as_toml(value: str | bool | float) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        import json  # few starts write a setting

        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return str(value)

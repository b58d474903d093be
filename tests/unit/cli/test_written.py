"""The files that a session writes as it goes."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

import pytest

from donnie_tui.core import told_log
from donnie_tui.core.events import Spoke
from donnie_tui.core.hub import Hub
from donnie_tui.core.transcript import told_lines
from donnie_tui.i18n.words import Words
from donnie_tui.outlets.written import Written
from donnie_tui.settings.chosen import Settings

FULL = Path("/dev/full")


@pytest.mark.skipif(not FULL.exists(), reason="needs a device that is always full")
def test_a_log_that_takes_no_more_is_told_once_and_counts_as_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(told_log, "next_log", lambda folder: FULL)
    hub, words, told = Hub(lambda: 0.0), Words(), list[str]()
    hub.subscribe(lambda stamped: told.extend(told_lines(stamped, words)))
    with ExitStack() as closing:
        written = Written(Settings(log=True), hub, words, closing)
        written.log()
        hub.publish(Spoke("a"))
        hub.publish(Spoke("b"))

    assert told == ["a", "I can't write /dev/full: No space left on device.", "b"]
    assert written.lost == ["/dev/full"]


@pytest.mark.parametrize("files", [{"record": "a"}, {"events": "a"}, {"sound": "a"}])
def test_a_file_of_this_session_would_be_begun_anew_by_another(files: dict[str, str]) -> None:
    with ExitStack() as closing:
        assert Written(Settings(**files), Hub(lambda: 0.0), Words(), closing).of_this_session == "a"

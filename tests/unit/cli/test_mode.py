"""Linear mode or full screen, and why."""

import pytest

from donnie_tui.cli.front_end import ProcessEnvironment, cause_of_linear
from tests.unit.i18n.sentences import CODES

TTY, PIPE = True, False

CASES = [
    # option, variables, settings file, stdin, stdout, the cause or None for the full screen
    (None, {"TERM": "xterm"}, None, TTY, TTY, None),
    (True, {"TERM": "xterm"}, None, TTY, TTY, "option"),
    (False, {"TERM": "xterm", "DONNIE_LINEAR": "1"}, True, TTY, TTY, None),
    (False, {"TERM": "dumb"}, None, TTY, TTY, None),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "1"}, None, TTY, TTY, "variable"),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "0"}, True, TTY, TTY, None),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "0", "ACCESSIBLE": "1"}, None, TTY, TTY, None),
    (None, {"TERM": "dumb", "DONNIE_LINEAR": "0"}, None, TTY, TTY, None),
    (None, {"TERM": "xterm", "ACCESSIBLE": "1"}, None, TTY, TTY, "variable"),
    (None, {"TERM": "xterm", "ACCESSIBLE": "false"}, None, TTY, TTY, None),
    (None, {"TERM": "xterm", "ACCESSIBLE": "0"}, True, TTY, TTY, "settings"),
    (None, {"TERM": "xterm"}, True, TTY, TTY, "settings"),
    (None, {"TERM": "dumb"}, False, TTY, TTY, None),
    (None, {"TERM": "dumb"}, None, TTY, TTY, "simple-terminal"),
    (None, {"TERM": "xterm"}, None, PIPE, TTY, "no-terminal"),
    (None, {"TERM": "xterm"}, None, TTY, PIPE, "no-terminal"),
    # beyond the table: there is no full screen without a terminal
    (False, {"TERM": "xterm"}, None, TTY, PIPE, "no-terminal"),
    (True, {"TERM": "xterm"}, None, PIPE, PIPE, "option"),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "perhaps", "ACCESSIBLE": ""}, None, TTY, TTY, None),
    (None, {}, None, TTY, TTY, "simple-terminal"),
]


@pytest.mark.parametrize(("option", "variables", "configured", "stdin", "stdout", "cause"), CASES)
def test_the_mode_is_decided_in_order(
    option: bool | None,
    variables: dict[str, str],
    configured: bool | None,
    stdin: bool,
    stdout: bool,
    cause: str | None,
) -> None:
    assert cause_of_linear(option, configured, ProcessEnvironment(stdin, stdout, variables)) == cause


@pytest.mark.parametrize("option", [None, False])
def test_the_full_screen_needs_a_terminal_for_the_errors_too(option: bool | None) -> None:
    around = ProcessEnvironment(TTY, TTY, {"TERM": "xterm"}, stderr_is_terminal=PIPE)

    assert cause_of_linear(option, None, around) == "no-terminal"


def test_every_reason_has_its_first_line() -> None:
    assert {f"linear-cause-{cause}" for *_, cause in CASES if cause} <= set(CODES)

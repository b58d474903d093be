"""A switch between the linear mode and the full screen keeps the program, however often it happens."""

from argparse import Namespace

import pytest

from donnie_tui.cli import front_end
from donnie_tui.cli.options import Invocation, Order
from donnie_tui.cli.streams import Output
from donnie_tui.commands.interaction import SwitchMode
from donnie_tui.i18n.words import Words
from donnie_tui.linear import app as linear
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import full_screen as screen

LIVING = object()
"""Stands for the session that is handed over."""


def order(file: str | None = None, *, option_linear: bool = False) -> Order:
    arguments = Namespace(file=file, linear=option_linear, visual=False, plain=False)
    return Order(Invocation("", {}, arguments), Settings(), Words(), Output(), {"TERM": "xterm"})


@pytest.fixture
def visits(monkeypatch: pytest.MonkeyPatch) -> list[tuple[object, ...]]:
    """What each mode was started with. The first two visits end by changing to the other mode."""
    made: list[tuple[object, ...]] = []

    def visit(*visited: object) -> int:
        made.append(visited)
        if len(made) < 3:
            raise SwitchMode(f"FW {len(made)}", "a.gd" if len(made) == 1 else None, LIVING)
        return 0

    monkeypatch.setattr(
        linear,
        "run_linear",
        lambda settings, file, cause, greeting, text=None, donnie=None: visit(
            "linear", file, cause, text, donnie
        ),
    )
    monkeypatch.setattr(
        screen,
        "run_full_screen",
        lambda settings, file, text=None, donnie=None: visit("screen", file, text, donnie),
    )
    return made


def test_a_switch_keeps_the_program_its_name_and_the_session(visits: list[tuple[object, ...]]) -> None:
    assert front_end.start(order("b.gd", option_linear=True)) == 0
    assert visits == [
        ("linear", "b.gd", "option", None, None),
        ("screen", "a.gd", "FW 1", LIVING),
        ("linear", None, "word", "FW 2", LIVING),
    ]


def test_the_linear_mode_starts_where_there_is_no_terminal(
    visits: list[tuple[object, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Under the tests there is no terminal."""
    front_end.start(order())

    assert visits[0] == ("linear", None, "no-terminal", None, None)

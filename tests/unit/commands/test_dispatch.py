"""Each command has one handler, in the module that its declaration names."""

from importlib import import_module
from inspect import iscoroutinefunction

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.dispatch import HANDLERS, handler_of, handles


@pytest.mark.parametrize("command", COMMANDS, ids=lambda each: each.name)
def test_each_command_has_one_handler_with_its_purpose(command):
    handler = handler_of(command)

    assert handler.__module__ == f"donnie_tui.commands.{command.module}"
    assert iscoroutinefunction(handler)
    assert handler.__doc__


def test_each_handler_is_declared():
    for module in {each.module for each in COMMANDS}:
        import_module(f"donnie_tui.commands.{module}")

    assert set(HANDLERS) == {each.name for each in COMMANDS}


def test_a_second_handler_is_refused():
    with pytest.raises(ValueError, match="where"):
        handles("where")(handler_of(next(each for each in COMMANDS if each.name == "where")))
    with pytest.raises(KeyError):
        handles("nowhere")

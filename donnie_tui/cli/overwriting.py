"""What is written never destroys what is read: programs, recordings, settings, the world and all its files.

Nor what an option can't have written itself, such as a program that is not opened. Looked at before
anything is opened. Two outputs are never the same file either.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product
from pathlib import Path

from donnie_tui.cli.kinds import may_be_replaced
from donnie_tui.cli.order import Order
from donnie_tui.core.documents import is_same_file
from donnie_tui.i18n.words import Unusable
from donnie_tui.settings.folders import settings_file


def refuse_overwriting(order: Order) -> None:
    """Raises ``Unusable`` where an option names a file that the command needs, or that another one names."""
    outputs = tuple((option, Path(name)) for option, name in order.outputs)
    for (option, path), (other, other_path) in combinations(outputs, 2):
        if is_same_file(path, other_path):
            raise Unusable(order.words("output-twice", option=option, other=other, path=path))
    own = (*_programs(order), settings_file(order.environment))
    read = [*map(Path, (*own, *_files_of_world(order, outputs)))]
    for (option, path), source in product(outputs, read):
        if is_same_file(path, source):
            raise Unusable(order.words("output-is-input", option=option, path=path))
    for option, path in outputs:
        if not may_be_replaced(option, path):
            raise Unusable(order.words("output-is-other", option=option, path=path))


def _programs(order: Order) -> Iterator[str]:
    """All that may be meant: ``ROBOT=FILE`` is a file of that name too."""
    arguments = order.invocation.arguments
    named = getattr(arguments, "file", None)
    files = [named] if isinstance(named, str) else named or []
    for each in (*files, *filter(None, [getattr(arguments, "run", None)])):
        yield each
        if "=" in each:
            yield each.partition("=")[2]


def _files_of_world(order: Order, outputs: tuple[tuple[str, Path], ...]) -> tuple[str, ...]:
    """None where no output is there yet, or the world is one of ours."""
    import worlds
    from donnie_tui.world.choice import choose_world, files_of  # slow to load, and few write anything

    settings = order.settings
    name = getattr(order.invocation.arguments, "name", None) or settings.world
    if order.invocation.command == "replay" or name in worlds.names():
        return ()
    if not any(_is_regular(path) for _, path in outputs):
        return ()
    return (name, *files_of(choose_world(name, order.words, settings.world_folders)))


def _is_regular(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False

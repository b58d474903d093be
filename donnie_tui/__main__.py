"""The program. Small: the first lines of the linear mode are printed before anything else is loaded."""

from __future__ import annotations

import os
import sys

from donnie_tui.process import HIGHEST_STANDARD, load_undisturbed
from donnie_tui.process.disconnection import watch_for_hang_up

TYPE_CHECKING = False  # that of typing costs as much as the rest of the first prompt
if TYPE_CHECKING:
    from donnie_tui.linear.greeting import Greeting


def main(*, joins_server: bool = False) -> int:
    """Run ``donnie``. Returns the exit code."""
    try:
        load_undisturbed()
        _open_what_is_closed()
        watch_for_hang_up()
        greeting = _greet_early()
        _load_msgspec()
        from donnie_tui.cli.main import main as command

        return command(sys.argv[1:], greeting, joins_server=joins_server)
    except KeyboardInterrupt:
        return 130


def godonnie() -> int:
    """Run ``donnie`` as the original's client: with the robot of a Player server on this machine."""
    return main(joins_server=True)


def donnie_player() -> int:
    """Run ``donnie player`` with its built-in world; options may follow."""
    from worlds import PLAYER

    sys.argv[1:1] = ["player", PLAYER]
    return main()


def _open_what_is_closed() -> None:
    """Occupy the number of a closed input, else the linear mode would read its own pipe for ever."""
    while (number := os.open(os.devnull, os.O_RDWR)) <= HIGHEST_STANDARD:
        pass
    os.close(number)


def _load_msgspec() -> None:
    """Load msgspec without typing_extensions, which it prefers to typing where both are installed.

    typing_extensions loads inspect, ast and dis: 1.2 MB of each session, a fourteenth of a linear one.
    """
    loaded: dict[str, object] = sys.modules  # type: ignore[assignment]
    if "typing_extensions" in loaded:
        return
    loaded["typing_extensions"] = None  # Python's own way to say that there is none
    import msgspec  # noqa: F401

    del loaded["typing_extensions"]


def _greet_early() -> Greeting | None:
    """Greet before Donnie is loaded, unless a settings file may change the greeting."""
    from donnie_tui.settings.folders import machine_settings_file, settings_file

    files = machine_settings_file(), settings_file(os.environ)
    if any(map(os.path.exists, files)):
        return None
    from donnie_tui.linear.greeting import begin

    return begin(sys.argv[1:], os.environ)


if __name__ == "__main__":
    sys.exit(main())

"""The program. Small: the first lines of the linear mode are printed before anything else is loaded."""

from __future__ import annotations

import os
import sys

from donnie_tui.process import HIGHEST_STANDARD, LazyValue, load_undisturbed, load_with, real_module
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
        _load_libraries()
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


def _load_libraries() -> None:
    """Load libraries without what they load and Donnie does not need: a twelfth of a linear session.

    msgspec prefers typing_extensions to typing, which loads inspect, ast and dis. It looks into types for
    programs that want their schemas. argparse translates its complaints, for which gettext loads the names of
    all locales; ``cli.options`` knows them in English, and complains in sentences of its own.
    """

    def of_schemas(name: str) -> LazyValue:
        return LazyValue(lambda: getattr(real_module(_SCHEMAS), name))

    inspect = LazyValue(lambda: real_module("msgspec.inspect"))
    names = {each: of_schemas(each) for each in ("schema", "schema_components")}
    schemas = LazyValue(lambda: real_module(_SCHEMAS), **names)
    load_with("msgspec", **{"typing_extensions": None, "msgspec.inspect": inspect, _SCHEMAS: schemas})
    untranslated = LazyValue(lambda: real_module("gettext"), gettext=str, ngettext=_as_in_english)
    load_with("argparse", gettext=untranslated)


_SCHEMAS = "msgspec._json_schema"


def _as_in_english(one: str, several: str, number: int) -> str:
    return one if number == 1 else several


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

"""The table of commands: their handlers' modules, when they are possible, their keys, what may follow them.

The words of a command are in ``commands.toml`` of each language. Its purpose is the sentence ``action-NAME``,
an example of its argument the sentence ``help-typed-ARGUMENT``. Words, keys, footer, palette, HELP,
completion and ``docs/commands.md`` come from here. The first frame needs this module: it imports nothing
heavy.
"""

from __future__ import annotations

from enum import Enum

from msgspec import Struct


class When(Enum):
    """When a command is possible, each including the ones before."""

    IDLE = 0
    """While nothing runs."""
    HELD = 1
    """Also while a program is held between two statements."""
    ALWAYS = 2


class Command(Struct, frozen=True, eq=False):
    """One thing that the learner can ask for. Equal to nothing but itself."""

    name: str
    module: str
    """The module of ``donnie_tui.commands`` that has its handler."""
    when: When = When.IDLE
    keys: tuple[str, ...] = ()
    """Its keys in the full screen, as Textual names them; the first one is shown."""
    argument: str = ""
    """What may follow the word, a code of ``help-typed-``; empty if nothing may."""
    required: bool = False
    """Whether the word means nothing without its argument."""
    asked_by_key: bool = False
    """Whether a key for it asks for the argument first."""
    at_cursor: bool = False
    """Whether a key for it gives the line of the cursor as the argument."""
    is_godonnie: bool = False
    """Whether the word is GoDonnie's too and means the same there."""
    is_about_now: bool = False
    """Whether it ends the way back of STEP BACK: it is about the robot's surroundings as they are."""
    is_visual: bool = False
    """Whether it is about the screen alone."""
    in_words: str = ""
    """Of a visual command: the command that says the same in words."""
    needs_name: bool = False
    """Whether the word is a beginner's for the robot where a number follows it: TURN 90."""
    is_live: bool = False
    """Whether the linear mode carries it out at once while a program runs; other lines wait for the end."""
    needs_terminal: bool = False
    """Whether a page in a browser can't do it; it is not offered there."""


_HELD, _ALWAYS = When.HELD, When.ALWAYS


def _asking(
    name: str,
    module: str,
    argument: str,
    *keys: str,
    when: When = _ALWAYS,
    is_about_now: bool = False,
    needs_name: bool = False,
) -> Command:
    """A command that needs its argument, which a key asks for."""
    return Command(
        name,
        module,
        when,
        keys=keys,
        argument=argument,
        required=True,
        asked_by_key=True,
        is_about_now=is_about_now,
        needs_name=needs_name,
    )


COMMANDS = (
    Command("run", "run", _HELD, keys=("f5", "escape"), is_godonnie=True),
    Command("again", "run", keys=("ctrl+k shift+a",)),
    Command("stop", "run", _ALWAYS, keys=("f8",), is_live=True),
    Command("pause", "run", _ALWAYS, keys=("f6",), is_live=True),
    Command("continue_", "run", _ALWAYS, keys=("ctrl+k shift+c",)),
    Command("step", "run", _HELD, keys=("f7",)),
    Command("step_over", "run", _HELD, keys=("f9",)),
    Command("step_back", "run", _HELD, keys=("ctrl+k k",)),
    Command("run_to", "run", _HELD, keys=("f10",), argument="line", at_cursor=True),
    Command("break_", "run", _ALWAYS, keys=("ctrl+b",), argument="line", at_cursor=True),
    Command("watch", "run", _ALWAYS, keys=("ctrl+k shift+w",), argument="variable"),
    Command("slower", "run", _ALWAYS, keys=("f11",), is_live=True),
    Command("faster", "run", _ALWAYS, keys=("f12",), is_live=True),
    Command("speed", "run", _ALWAYS, keys=("ctrl+k f11",), argument="speed", asked_by_key=True, is_live=True),
    Command("reset", "run", keys=("ctrl+r",)),
    Command("open", "files", keys=("ctrl+o", "f3"), argument="file"),
    Command("examples", "files", keys=("ctrl+k 9",), argument="count"),
    Command("save", "files", _ALWAYS, keys=("ctrl+s", "f2"), argument="file"),
    Command("save_as", "files", _ALWAYS, keys=("ctrl+k s",), argument="file"),
    Command("new", "files", keys=("ctrl+n",)),
    Command("recover", "files", keys=("ctrl+k shift+v",)),
    Command("save_log", "files", _ALWAYS, keys=("ctrl+k v",), argument="text-file"),
    _asking("report", "files", "report-file", "ctrl+k percent_sign"),
    Command("list", "program", _ALWAYS, keys=("ctrl+k shift+l",), argument="lines"),
    _asking("change", "program", "line", "ctrl+k shift+x"),
    _asking("insert", "program", "line", "ctrl+k shift+i"),
    Command("delete", "program", _ALWAYS, keys=("ctrl+k shift+d",), argument="lines"),
    _asking("move", "program", "lines-or-thing", "ctrl+k equals_sign"),
    Command("copy", "program", _ALWAYS, keys=("ctrl+k shift+u",), argument="lines"),
    Command("comment", "program", _ALWAYS, keys=("ctrl+k 5",), argument="lines"),
    Command("fix", "program", _ALWAYS, keys=("ctrl+t",)),
    Command("search", "program", _ALWAYS, keys=("ctrl+f",), argument="word"),
    Command("search_again", "program", _ALWAYS, keys=("ctrl+k f3",)),
    Command("replace", "program", _ALWAYS, keys=("ctrl+k r",), argument="word", required=True),
    Command("format", "program", _ALWAYS, keys=("ctrl+k m",)),
    Command("translate", "program", _ALWAYS, keys=("ctrl+k x",), argument="language", required=True),
    Command("undo", "program", _ALWAYS, keys=("ctrl+z",)),
    Command("redo", "program", _ALWAYS, keys=("ctrl+y",)),
    Command("read", "read", _ALWAYS, keys=("ctrl+k space",), argument="line"),
    Command("next", "read", _ALWAYS, keys=("ctrl+k shift+n",)),
    Command("back", "read", _ALWAYS, keys=("ctrl+k shift+b",)),
    Command("first", "read", _ALWAYS, keys=("ctrl+k less_than_sign",)),
    Command("last_line", "read", _ALWAYS, keys=("ctrl+k greater_than_sign",)),
    Command("place", "read", _ALWAYS, keys=("ctrl+k shift+p",)),
    Command("up", "read", _ALWAYS, keys=("ctrl+k u",)),
    Command("down", "read", _ALWAYS, keys=("ctrl+k d",)),
    Command("next_same", "read", _ALWAYS, keys=("ctrl+k right_parenthesis",)),
    Command("back_same", "read", _ALWAYS, keys=("ctrl+k left_parenthesis",)),
    Command("outline", "read", _ALWAYS, keys=("ctrl+l",)),
    Command("error", "read", _ALWAYS, keys=("ctrl+k shift+e",)),
    Command("error_next", "read", _ALWAYS, keys=("ctrl+k right_square_bracket",)),
    Command("error_previous", "read", _ALWAYS, keys=("ctrl+k left_square_bracket",)),
    Command("errors", "read", _ALWAYS, keys=("ctrl+k exclamation_mark",)),
    Command("explain", "read", _ALWAYS, keys=("ctrl+k question_mark",)),
    Command("last", "read", _ALWAYS, keys=("ctrl+k shift+h",), argument="count"),
    Command("last_word", "read", _ALWAYS, keys=("ctrl+k quotation_mark",)),
    Command("spell", "read", _ALWAYS, keys=("ctrl+k shift+z",), argument="count"),
    _asking("find", "read", "word", "ctrl+k shift+f"),
    Command("typed", "read", _ALWAYS, keys=("ctrl+k shift+y",), argument="count"),
    Command("quiet", "sound", _ALWAYS, keys=("ctrl+k shift+q",), is_live=True),
    Command("cues", "sound", _ALWAYS, keys=("ctrl+k asterisk",), argument="cue"),
    Command("where", "world", _ALWAYS, keys=("ctrl+k i",)),
    Command("around", "world", _ALWAYS, keys=("ctrl+k j",), argument="compass", is_about_now=True),
    Command("map", "world", _ALWAYS, keys=("ctrl+k shift+m",), argument="square", is_about_now=True),
    _asking("map_row", "world", "row", "ctrl+k underscore", is_about_now=True),
    _asking("map_column", "world", "row", "ctrl+k colon", is_about_now=True),
    Command("map_picture", "world", _ALWAYS, keys=("ctrl+k number_sign",), is_about_now=True),
    Command("trail", "world", _ALWAYS, keys=("ctrl+k 6",), argument="count"),
    Command("sensors", "world", _ALWAYS, keys=("ctrl+k shift+s",), is_about_now=True),
    Command("robots", "robots", _ALWAYS, keys=("ctrl+k shift+r",), is_live=True),
    Command("robot", "robots", _ALWAYS, keys=("ctrl+k at",), argument="robot", required=True),
    Command("start", "run", keys=("ctrl+k slash",)),
    Command("together", "run", keys=("ctrl+k shift+j",)),
    Command("stop_all", "run", _ALWAYS, keys=("ctrl+k full_stop",), is_live=True),
    Command("connect", "robots", keys=("ctrl+k shift+o",), argument="count"),
    Command("feel", "sound", _ALWAYS, keys=("ctrl+k ampersand",), argument="switch"),
    Command("world", "world", _ALWAYS, keys=("ctrl+k 8",), argument="world"),
    Command("worlds", "world", _ALWAYS, keys=("ctrl+k o",), argument="world"),
    _asking("put", "build", "new-thing", when=When.IDLE),
    _asking("turn", "build", "thing-and-degrees", when=When.IDLE, needs_name=True),
    _asking("remove", "build", "thing"),
    Command("save_world", "build", _ALWAYS, argument="world-file"),
    Command("show_program", "program", _ALWAYS, keys=("ctrl+k 1",)),
    Command("show_map", "world", _ALWAYS, keys=("ctrl+k 2",)),
    Command("show_path", "world", _ALWAYS),
    Command("show_log", "read", _ALWAYS, keys=("ctrl+k 3",)),
    Command("show_variables", "run", _ALWAYS, keys=("f4",)),
    Command("language", "settings", _ALWAYS, keys=("ctrl+k f2",), argument="language"),
    Command("detail", "settings", _ALWAYS, keys=("ctrl+k semicolon",), argument="detail"),
    Command("set", "settings", _ALWAYS, keys=("ctrl+k comma", "ctrl+k dollar_sign"), argument="setting"),
    Command("challenge", "challenges", keys=("ctrl+k 7",), argument="challenge"),
    Command("task", "challenges", _ALWAYS),
    Command("goals", "challenges", _ALWAYS),
    Command("hint", "challenges", _ALWAYS),
    Command("next_challenge", "challenges"),
    Command("questions", "challenges"),
    Command("results", "challenges", _ALWAYS),
    Command("tour", "help", keys=("ctrl+k shift+t",)),
    Command("help", "help", _ALWAYS, keys=("f1",), argument="topic", is_godonnie=True),
    Command("manual", "help", _ALWAYS, keys=("ctrl+k f1",), argument="topic"),
    Command("linear", "help", _ALWAYS, keys=("ctrl+k q",), needs_terminal=True),
    Command("visual", "help", _ALWAYS, keys=("ctrl+k f4",)),
    Command("quit", "help", _ALWAYS, keys=("ctrl+q",), is_godonnie=True),
    Command("zoom_in", "world", _ALWAYS, keys=("ctrl+k plus",), is_visual=True),
    Command("zoom_out", "world", _ALWAYS, keys=("ctrl+k minus",), is_visual=True),
    Command("whole_map", "world", _ALWAYS, keys=("ctrl+k a",), is_visual=True, in_words="map"),
    Command("picture", "world", _ALWAYS, keys=("ctrl+k p",), is_visual=True, in_words="map_picture"),
    Command("names", "world", _ALWAYS, keys=("ctrl+k t",), is_visual=True, in_words="map"),
    Command("coordinates", "world", _ALWAYS, keys=("ctrl+k c",), is_visual=True, in_words="where"),
    Command("legend", "world", _ALWAYS, keys=("ctrl+k l",), is_visual=True, in_words="map_picture"),
    Command("next_thing", "world", _ALWAYS, keys=("ctrl+k n",), is_visual=True, in_words="map"),
    Command("previous_thing", "world", _ALWAYS, keys=("ctrl+k backspace",), is_visual=True, in_words="map"),
    Command("to_robot", "world", _ALWAYS, keys=("ctrl+k h",), is_visual=True, in_words="where"),
    Command("from_here", "world", _ALWAYS, keys=("ctrl+k f",), is_visual=True, in_words="around"),
    Command("to_there", "world", _ALWAYS, keys=("ctrl+k w",), is_visual=True, in_words="map"),
    Command("complete", "program", _ALWAYS, keys=("ctrl+space", "ctrl+@"), is_visual=True),
    Command("go_to", "read", _ALWAYS, keys=("ctrl+g",), argument="line", is_visual=True, in_words="read"),
    Command("filter", "read", _ALWAYS, is_visual=True, in_words="find"),
    Command("recent", "files", keys=("ctrl+k e",), is_visual=True, in_words="open"),
    Command("programs", "files", keys=("ctrl+k b",), is_visual=True, in_words="robot"),
    Command("theme", "settings", _ALWAYS, keys=("ctrl+k y",), argument="theme", is_visual=True),
    Command("plain", "settings", _ALWAYS, keys=("ctrl+k z",), is_visual=True),
    Command("redraw", "settings", _ALWAYS, keys=("ctrl+k f5",), is_visual=True),
    Command("change_keys", "settings", _ALWAYS, keys=("ctrl+k shift+k",), is_visual=True),
    Command("keys_here", "help", _ALWAYS, keys=("ctrl+k 0",), is_visual=True, in_words="help"),
    Command(
        "open_log",
        "read",
        _ALWAYS,
        keys=("ctrl+k g",),
        is_visual=True,
        in_words="show_log",
        needs_terminal=True,
    ),
)

BY_NAME = {each.name: each for each in COMMANDS}

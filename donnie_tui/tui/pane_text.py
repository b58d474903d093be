"""The texts of the status line, inspector, help, tour and palette: values in, sentences out."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence

from devices.ports.robot import Bearing, Pose
from donnie_tui.commands.context import Attempt
from donnie_tui.commands.declarations import BY_NAME, COMMANDS, Command
from donnie_tui.commands.help import first_words
from donnie_tui.commands.interaction import Option
from donnie_tui.commands.keys import MENU, PALETTE, KeyTable, key_label
from donnie_tui.commands.lookup import help_line, word_of
from donnie_tui.commands.preferences import BY_NAME as BY_KEY
from donnie_tui.commands.preferences import PREFERENCES, Preferences, label, setting_word, value_label
from donnie_tui.core.describe import goals_in_words, task_in_words
from donnie_tui.core.events import Read
from donnie_tui.core.run_state import RunState
from donnie_tui.core.wording import Wording, compass_heading, facing, whole_steps
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES, screen_tour_page
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import speed_words
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.screens.pages import TourPage
from language.keywords import canonical
from language.runtime import Frame

# --- the status line and the inspector


def robot_sentence(name: str | None, pose: Pose, words: Wording) -> str:
    """The robot's place; without a name the robot is Donnie.

    Between the points of the compass its heading is a number: the line is short.
    """
    heading = compass_heading(pose)
    is_at_point = heading % 45 == 0
    return words(
        "status-robot",
        robot=name or "Donnie",
        x=whole_steps(pose.x),
        y=whole_steps(pose.y),
        facing=facing(pose, words) if is_at_point else words("status-degrees", degrees=heading),
    )


def state_sentences(state: str, speed: float | None, words: Wording) -> tuple[str, str]:
    """The run state with the speed, and without it for small room.

    ``state`` is the value of a ``RunState``, or "looking-back".
    """
    return (
        words(f"status-{state}-speed", speed=speed_words(speed, words)),
        words(f"status-{state}"),
    )


_BADGE_LOOKS = {
    RunState.READY: "$success",
    RunState.RUNNING: "$accent",
    RunState.PAUSED: "$warning",
    RunState.STOPPING: "$error",
}


def state_badge(
    state: RunState,
    past: tuple[int, int] | None,
    speed: float | None,
    words: Wording,
    *,
    was_stopped: bool = False,
) -> tuple[str, str]:
    """The run state and the speed, or the position of STEP BACK, in capitals; and its colour."""
    if past is not None:
        step, steps = past
        return words("status-past", step=step, steps=steps).rstrip(".").upper(), "$warning"
    if was_stopped and state is RunState.READY:
        return words("status-stopped").rstrip(".").upper(), "$error"
    badge = words(f"status-{state.value}").rstrip(".").upper()
    if state is RunState.RUNNING:
        fast = speed_words(speed, words)
        badge = f"{badge} {fast.upper() if speed is None else f'x{fast}'}"
    return badge, _BADGE_LOOKS[state]


def goal_lines(attempt: Attempt, words: Wording, *, is_seen: bool) -> tuple[str, ...]:
    """The task of a challenge, and each goal in words, with a mark if the learner sees them."""
    judgment = attempt.now
    goals = goals_in_words(judgment, words)
    marks = ("[ ] " if each else "[x] " for each in judgment.of_goals)
    return (
        *task_in_words(attempt.challenge, words),
        words("inspector-goals", **judgment.counts),
        *(f"{mark}{line}" if is_seen else line for mark, line in zip(marks, goals, strict=True)),
    )


class VariableChanges:
    """The values of variables before their last change, and those that the last step changed.

    A scope is a procedure, or the program with an empty name.
    """

    def __init__(self) -> None:
        self._seen: tuple[object, dict[tuple[str, str], int]] = ((), {})
        self.was: dict[tuple[str, str], int] = {}
        self.changed: frozenset[tuple[str, str]] = frozenset()

    def look(self, scopes: Sequence[tuple[str, Sequence[tuple[str, int]]]], lines: Sequence[int]) -> None:
        """Note the variables of each scope, at these lines of the calls."""
        place, before = self._seen
        now = {(scope, name): value for scope, variables in scopes for name, value in variables}
        if (tuple(lines), now) == (place, before):
            return
        self._seen = tuple(lines), now
        is_step = bool(place or lines)  # else the program ended unseen: its last step is not known
        self.changed = frozenset(each for each in now if is_step and before.get(each) != now[each])
        self.was.update({each: before[each] for each in self.changed & before.keys()})

    def forget(self) -> None:
        """A program begins anew."""
        self.__init__()  # type: ignore[misc]


class Histories:
    """The readings and the values of variables in order, for charts."""

    def __init__(self) -> None:
        self._series: dict[str, deque[int]] = {}

    def add(self, name: str, value: int) -> None:
        """Add a reading."""
        self._series.setdefault(name, deque(maxlen=_MOST_MOMENTS)).append(value)

    def look(self, scopes: Sequence[tuple[str, Sequence[tuple[str, int]]]]) -> None:
        """Add the values of variables that have changed."""
        for _scope, variables in scopes:
            for name, value in variables:
                if self._series.get(name, [None])[-1] != value:
                    self.add(name, value)

    def charts(self, columns: int, words: Wording) -> tuple[str, ...]:
        """Charts of some changed values, as letters in that many columns, the highest value above."""
        changing = [
            (name, values)
            for name, values in self._series.items()
            if len(values) >= _LEAST_MOMENTS and len(set(values)) > 1 and max(map(abs, values)) < 10**6
        ]
        return tuple(
            line
            for name, values in changing[:_MOST_CHARTS]
            for line in (words("inspector-over-time", what=name), *_chart(values, columns))
        )

    def forget(self) -> None:
        """A program begins anew."""
        self._series.clear()


_MOST_MOMENTS, _LEAST_MOMENTS, _MOST_CHARTS, _CHART_ROWS = 200, 3, 3, 4


def _chart(values: Iterable[int], columns: int) -> tuple[str, ...]:
    """A chart with a ``*`` for each moment, the newest at the right."""
    shown = list(values)
    labels = str(max(shown)), str(min(shown))
    width = max(map(len, labels))
    shown = shown[-max(1, columns - width - 1) :]
    low, high = min(shown), max(shown)
    labels = str(high), str(low)
    heights = [round((each - low) * (_CHART_ROWS - 1) / max(1, high - low)) for each in shown]
    sides = (labels[0], *[""] * (_CHART_ROWS - 2), labels[1])
    return tuple(
        f"{side:>{width}}|{''.join('*' if height == row else ' ' for height in heights)}".rstrip()
        for side, row in zip(sides, reversed(range(_CHART_ROWS)), strict=True)
    )


def scopes_of(
    frames: Sequence[Frame], variables: Mapping[str, int]
) -> tuple[tuple[str, Sequence[tuple[str, int]]], ...]:
    """The variables in scope: those of the running procedure, and those of the program."""
    if not frames:
        return (("", tuple(variables.items())),)
    inner, outer = frames[0], frames[-1]
    own = ((inner.procedure, inner.variables),) if inner.procedure else ()
    return (*own, ("", outer.variables if not outer.procedure else ()))


def inspector_lines(
    frames: Sequence[Frame],
    variables: Mapping[str, int] | None,
    distances: Mapping[Bearing, int],
    readings: Sequence[Read],
    belt: Sequence[str],
    words: Wording,
    changes: VariableChanges | None = None,
) -> tuple[str, ...]:
    """Variables, calls, the distances and the belt now, and last what the program read of each sensor.

    ``variables``: None if they are not known. The belt is in words, and as two rows of seven. With
    ``changes`` variables are a table and the distances stand around the robot; without, all are sentences.
    """
    scopes = [each for each in scopes_of(frames, variables or {}) if each[1]]
    if not scopes:
        of_variables: Sequence[str] = [
            words(f"inspector-{'unknown' if variables is None else 'no'}-variables")
        ]
    elif changes is not None:
        of_variables = _table(scopes, changes, words)
    else:
        of_variables = _variables(scopes, words)
    return (
        *of_variables,
        *_headed("inspector-calls", (_call(each, words) for each in frames[:20]), words),
        *(_distances(distances, words) if changes is None else _compass(distances, words)),
        *belt,
        *_headed("inspector-readings", (_reading(each, words) for each in readings), words),
    )


def _table(
    scopes: Sequence[tuple[str, Sequence[tuple[str, int]]]], changes: VariableChanges, words: Wording
) -> tuple[str, ...]:
    """Name, value and previous value; ``*`` marks those that the last step changed."""
    head = tuple(words(f"inspector-{column}") for column in ("name", "value", "was"))
    rows: list[tuple[str, tuple[str, str, str]]] = [(" ", (head[0], head[1], head[2]))]
    for number, (scope, variables) in enumerate(scopes):
        if number:
            rows.append(("", (words("inspector-of-program"), "", "")))
        for name, value in variables:
            was = changes.was.get((scope, name))
            mark = "*" if (scope, name) in changes.changed else " "
            rows.append((mark, (name, _short(value), "" if was is None else _short(was))))
    cells = [row for mark, row in rows if mark]
    widths = [max(len(row[column]) for row in cells) for column in range(3)]
    return tuple(
        f"{mark}{name.ljust(widths[0])}  {value.rjust(widths[1])}  {was.rjust(widths[2])}".rstrip()
        if mark
        else name
        for mark, (name, value, was) in rows
    )


def _compass(distances: Mapping[Bearing, int], words: Wording) -> tuple[str, ...]:
    """The distances arranged around the robot, which looks up."""
    if not distances:
        return ()
    sides = words("where-front"), words("where-back")
    width = max(map(len, sides))
    rows = (
        (Bearing.FRONT_LEFT, Bearing.FRONT, Bearing.FRONT_RIGHT),
        (Bearing.BACK_LEFT, Bearing.BACK, Bearing.BACK_RIGHT),
    )
    ahead, behind = (
        side.ljust(width) + "".join(f"{distances.get(bearing, '-'):>6}" for bearing in row)
        for side, row in zip(sides, rows, strict=True)
    )
    middle = f"{words('where-left'):>{width + 10}} ^ {words('where-right')}"
    return words("inspector-distances"), ahead, middle, behind


def _variables(scopes: Sequence[tuple[str, Sequence[tuple[str, int]]]], words: Wording) -> tuple[str, ...]:
    lines = [words("inspector-variables")]
    for number, (_scope, variables) in enumerate(scopes):
        if number:
            lines.append(words("inspector-of-program"))
        lines += [words("inspector-variable", name=name, value=_short(value)) for name, value in variables]
    return tuple(lines)


def _short(value: int) -> str:
    """A number that fits: of a long one the first digits and their count."""
    if abs(value) < 10**18:
        return str(value)
    digits = str(abs(value))
    return f"{'-' if value < 0 else ''}{digits[:6]}... ({len(digits)})"


def working_lines(worked_out: Sequence[Sequence[str]], words: Wording) -> tuple[str, ...]:
    """How the expressions of the next statement are evaluated."""
    rows = (text if not at else f"= {text}" for texts in worked_out for at, text in enumerate(texts))
    return _headed("inspector-worked-out", rows, words)


def _headed(code: str, lines: Iterable[str], words: Wording) -> tuple[str, ...]:
    """Lines below their heading; nothing if there are none."""
    shown = tuple(lines)
    return (words(code), *shown) if shown else ()


def working_in_a_row(worked_out: Sequence[Sequence[str]]) -> tuple[str, ...]:
    """``working_lines`` in one row: choices from the longest to the shortest."""
    if not worked_out:
        return ()
    whole = "; ".join(" = ".join(texts) for texts in worked_out)
    results = "; ".join(f"{texts[0]} = {texts[-1]}" for texts in worked_out)
    return tuple(dict.fromkeys((whole, results, "; ".join(f"= {texts[-1]}" for texts in worked_out))))


def _call(frame: Frame, words: Wording) -> str:
    if not frame.procedure:
        return words("inspector-main", line=frame.line)
    return words("inspector-call", name=frame.procedure, line=frame.line)


def _distances(distances: Mapping[Bearing, int], words: Wording) -> tuple[str, ...]:
    """The distances, clockwise from the front."""
    lines = (
        words("inspector-reading", what=_where(bearing.words, words), value=distances[bearing])
        for bearing in sorted(distances, key=lambda each: each.value)
    )
    return _headed("inspector-distances", lines, words)


def _where(bearing: str, words: Wording) -> str:
    code = f"where-{bearing.replace(' ', '-')}"
    return words(code) if words.knows(code) else bearing


def _reading(read: Read, words: Wording) -> str:
    return words("inspector-reading", what=reading_name(read, words), value=read.value)


def reading_name(read: Read, words: Wording) -> str:
    """The sensor that was read, and its direction or colour."""
    where = read.argument
    if read.sensor == "distance":
        where = _where(read.argument, words)
    elif read.sensor == "colour":
        where = words(f"colour-{read.argument}")
    return words(f"reading-{read.sensor}", where=where)


# --- the help, the tour, the keys and the palette

_MOST_LINES = 9

_NEAR = {
    "program": ("run", "step", "break_", "complete", "fix", "search", "outline", "undo", "save"),
    "map": ("where", "around"),
    "variables": ("show_variables", "feel"),
    "log": ("open_log", "find", "save_log"),
    "command": ("typed", "run"),
}
"""The most useful commands of each pane."""
_EVERYWHERE = ("stop", "keys_here", "help", "quit")


def help_lines(place: MainScreen, words: Words, table: KeyTable) -> tuple[str, ...]:
    """The mistakes of the program, the word of GoDonnie at the cursor, the keys of the focused part, and the
    words of the first lesson.
    """
    is_in_program = place.editor.has_focus
    word = place.editor.word if is_in_program else ""
    about = words.help(word) if word and canonical(word) is not None else ()
    wrong = (words("answer-line", line=each.line, text=each.message) for each in place.editor.mistakes)
    return (
        *(wrong if is_in_program else ()),
        *about,
        *keys_here(place, words, table),
        words("help-further"),
        *first_words(words),
    )


def help_text(words: Wording, table: KeyTable) -> tuple[str, ...]:
    """Every command of the screen, its typed word first, which works everywhere; then GoDonnie's."""
    return (
        words("help-screen-words"),
        *(help_line(each, words, table.labels(each.name, words.language)) for each in _offered(table)),
        words("help-palette"),
        words("help-program-words"),
        *_program_lines(words),
    )


def _program_lines(words: Wording) -> tuple[str, ...]:
    """GoDonnie's commands, except those that the screen has listed."""
    listed = {word_of(each, words.language) for each in COMMANDS}
    return tuple(line for line in words.help(None) if line.partition(":")[0] not in listed)


def tour_pages(words: Words, table: KeyTable) -> tuple[TourPage, ...]:
    """The pages of the tour, with the current key of each command, or its word."""
    language = words.language
    keys = {each.name: table.label(each.name, language) or word_of(each, language) for each in COMMANDS}
    keys |= {"menu": key_label(MENU, language), "palette": key_label(PALETTE, language)}
    return tuple(
        TourPage(
            words("screen-tour-title", page=page, pages=SCREEN_TOUR_PAGES),
            words("screen-tour-keys"),
            screen_tour_page(page, words, keys),
        )
        for page in range(1, SCREEN_TOUR_PAGES + 1)
    )


def keys_here(place: MainScreen, words: Words, table: KeyTable) -> tuple[str, ...]:
    """The keys of the focused part: a heading, then a line each."""
    pane = _focused_part(place)
    codes = (f"here-{pane}-{number}" for number in range(1, _MOST_LINES + 1))
    of_pane = (words(code) for code in codes if words.knows(code))
    names = (*_NEAR[pane], *_EVERYWHERE)
    commands = (
        words("here-key", keys=table.labels(name, words.language), purpose=words(f"action-{name}"))
        for name in names
        if table.of(name)
    )
    return (words(f"here-{pane}"), *of_pane, *commands, words("here-tab"))


def _focused_part(place: MainScreen) -> str:
    """The focused pane, or the program."""
    if place.map.has_focus:
        return "map"
    if place.inspector.has_focus:
        return "variables"
    if place.log_rows.has_focus:
        return "log"
    return "command" if place.command_line.has_focus else "program"


def palette(words: Words, table: KeyTable, preferences: Preferences) -> tuple[Option, ...]:
    """Every command with its keys, also found by its usual names in other programs.

    Then the settings, the looks and the worlds; the value of such an option begins with ``TYPED_LINE``.
    """
    commands = (
        Option(
            each.name,
            _palette_row(each, words, table),
            also=_synonyms(each, words),
            columns=(
                word_of(each, words.language),
                words(f"action-{each.name}"),
                table.label(each.name, words.language),
            ),
        )
        for each in _offered(table)
    )
    return (*commands, *map(_typed_option, _more_lines(words, preferences)))


TYPED_LINE = "> "
"""The prefix of an option's value that types a line."""


def _typed_option(line: tuple[str, str]) -> Option:
    typed, purpose = line
    return Option(f"{TYPED_LINE}{typed}", f"{typed}: {purpose}", columns=(typed, purpose))


def _more_lines(words: Words, preferences: Preferences) -> Iterator[tuple[str, str]]:
    """The lines that change a setting, the theme or the world, each with its purpose."""
    import worlds
    from worlds.words import about

    language = words.language
    set_, theme, world = (word_of(BY_NAME[name], language) for name in ("set", "theme", "world"))
    for each in PREFERENCES:
        if words.knows(f"setting-{each.key}") and each.key not in ("theme", "lang"):
            value = preferences.value_label(each.key, words)
            row = words("setting-row", name=label(each.key, words), value=value)
            yield f"{set_} {setting_word(each.key, words)}", row
    look = BY_KEY["theme"]
    for value in look.values:
        yield f"{theme} {value_label(look, value, words)}", label("theme", words)
    for name in worlds.names():
        yield f"{world} {name}", about(name, language).title


def _synonyms(command: Command, words: Wording) -> str:
    code = f"also-{command.name}"
    return words(code) if words.knows(code) else ""


def _offered(table: KeyTable) -> list[Command]:
    return [each for each in COMMANDS if table.offers(each.name)]


def _palette_row(command: Command, words: Wording, table: KeyTable) -> str:
    label = table.label(command.name, words.language)
    keys = f" ({label})" if label else ""
    return f"{word_of(command, words.language)}{keys}: {words(f'action-{command.name}')}"

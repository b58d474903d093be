"""Shows the session on the main screen: titles, marks, map, inspector, status line, keys, log.

It keeps the last values (pose, distances, readings, belt) and does not know their source.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from devices.ports.robot import Bearing, Pose
from donnie_tui.commands.context import Context
from donnie_tui.commands.keys import PALETTE, KeyTable, key_label
from donnie_tui.core.describe import task_in_words
from donnie_tui.core.events import Outcome, Read, RunEnded
from donnie_tui.core.map_grid import Cell, Kind, floor_size
from donnie_tui.core.map_scene import Line, MapScene
from donnie_tui.core.program_text import LONGEST_CHECKED
from donnie_tui.core.run_state import RunState
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.wording import colour_initials, shown_name
from donnie_tui.settings.settings import speed_words
from donnie_tui.tui.environment import first_steps
from donnie_tui.tui.event_queue import EventBatch
from donnie_tui.tui.pane_text import (
    Histories,
    VariableChanges,
    goal_lines,
    inspector_lines,
    reading_name,
    robot_sentence,
    scopes_of,
    state_badge,
    state_sentences,
    working_in_a_row,
    working_lines,
)
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.widgets.rows import LOOKS, KeyEntry
from language.keywords import spelling
from language.runtime import Frame

LEAST_CHART = 24
"""The least columns of a chart."""

_WORDLESS = ("answer",)
"""Kinds of lines in the log without a name before them."""

_OFFERED = {
    RunState.READY: ("run", "help", "quit", "step", "save", "open", "show_variables"),
    RunState.RUNNING: ("stop", "help", "quit", "pause", "slower", "faster", "show_variables"),
    RunState.PAUSED: (
        "pause",
        "help",
        "quit",
        "stop",
        "step",
        "step_back",
        "step_over",
        "run_to",
        "show_variables",
    ),
    RunState.STOPPING: ("help", "quit"),
}
"""The keys of the bottom line by run state, the most important first."""
_OFFERED_FIRST = ("run", "help", "examples", "challenge", "quit", "open", "show_variables")
"""The keys while the program is empty."""
_OFFERED_PAST = ("run", "help", "quit", "step_back", "step", "show_variables")
"""The keys after STEP BACK in an ended run."""
_OFFERED_WRONG = ("run", "help", "errors", "fix", "quit", "save", "open")
"""The keys while lines are marked as wrong."""


class Display:
    """Updates the main screen."""

    def __init__(self, place: MainScreen, ctx: Context, table: KeyTable) -> None:
        self._place = place
        self._table = table
        self._attempt, self._preferences = ctx.attempt, ctx.preferences
        self._donnie, self._words = ctx.donnie, ctx.words
        self._runs, self._workspace = ctx.runs, ctx.workspace
        self._readings: dict[tuple[str, str], Read] = {}
        self._distances: Mapping[Bearing, int] = {}
        self._offered: tuple[object, ...] = ()
        """The state for which the bottom line was last written; a letter does not change it."""
        self._has_belt = False
        """Whether a belt has shown anything yet."""
        self._changes = VariableChanges()
        self._histories = Histories()
        self._kinds: dict[str, str] = {}
        self._was_stopped = False
        """Whether the latest run was stopped."""
        self._answer = ""
        """The last answer, until the focus or the cursor moves."""
        self._has_acted = False
        """Whether the learner has pressed anything since; a moving cursor alone keeps the sentence."""
        self.show_world()

    def show_world(self) -> None:
        """Show the map of the current robot; the other robots are things on it."""
        self._pose = self._donnie.session.pose
        picture = self._donnie.picture()
        self.scene = MapScene(picture, self._pose, shown_name(self._donnie.session.name))
        if self._attempt is not None:
            self.scene.grid.mark_goals(self._attempt.challenge.rules.goal_places)
        self.scene.hide(self._hidden_marks)
        self._place.map.call_colours(colour_initials(self._words))
        self._place.show_map(self.scene)
        self.entitle_map()
        self._entitle_inspector()

    def show_marks_of_map(self) -> None:
        """Show or hide trail, rays and goals, as the settings say."""
        self._place.map.update_cells(self.scene.hide(self._hidden_marks))

    @property
    def _hidden_marks(self) -> tuple[Kind, ...]:
        settings = self._preferences.settings
        shown = {Kind.TRAIL: settings.trail, Kind.RAY: settings.rays, Kind.GOAL: settings.goals}
        return tuple(kind for kind, is_shown in shown.items() if not is_shown)

    def _entitle_inspector(self) -> None:
        code = "pane-inspector" if self._attempt is None else "pane-goals"
        self._place.inspector_pane.entitle(self._words(code))

    def entitle_map(self) -> None:
        """Entitle the map: the world, its size, the sides with more floor outside, and north above."""
        picture = self.scene.picture
        width, height = floor_size(picture)
        title = self._donnie.world.title(self._words.language)
        where = " ".join(self._words(f"compass-{side}")[:1].upper() for side in self._place.map.hidden)
        values = {"world": title, "width": width, "height": height, "where": where}
        codes = ("pane-map-more", "pane-map-more-short") if where else ("pane-map", "pane-map-short")
        titles = (self._with_robot(self._words(each, **values)) for each in codes)
        north = f"{self._words('compass-north')[:1].upper()} ^"
        self._place.map_pane.entitle(*titles, corner=north)

    def _with_robot(self, title: str) -> str:
        """A title with the name of the robot if there are several."""
        name = self._donnie.session.name
        is_one = name is None or not self._donnie.team.has_several
        return title if is_one else self._words("pane-of-robot", robot=name, title=title)

    # --- the robot

    def begin(self, pose: Pose, *, fresh: bool) -> None:
        """Begin a run with the robot here; a fresh run has no trail and no readings."""
        self._pose, self._was_stopped = pose, False
        if fresh:
            self._place.map.begin(self.scene.begin(pose) | self._show_others())
            self._readings.clear()
            self._changes.forget()
            self._histories.forget()

    def end(self, event: RunEnded) -> None:
        """End the run with the robot here."""
        self._was_stopped = event.outcome is Outcome.STOPPED
        self.move((event.pose,))

    def _show_others(self) -> frozenset[Cell]:
        """Show the other robots, which keep their places when this one starts again."""
        others = (each for each in self._donnie.team.sessions if each is not self._donnie.session)
        return frozenset().union(*(self.scene.move_other(each.name, each.pose) for each in others))

    def move(self, poses: Sequence[Pose]) -> None:
        """Move the robot through these places."""
        if poses:
            self._pose = poses[-1]
            self._place.map.update_cells(frozenset().union(*map(self.scene.move, poses)))

    def receive(self, batch: EventBatch) -> None:
        """Show a batch of events, except its sentences."""
        if batch.things is not None:
            self._place.map.update_cells(self.scene.place_things(batch.things))
        self.move(batch.poses)
        for name, pose in batch.others.items():
            self._place.map.update_cells(self.scene.move_other(name, pose))
        for look in batch.looks:
            self._place.map.update_cells(self.scene.look_along(look))
        for each in batch.measured:
            self._histories.add(reading_name(each, self._words), each.value)
        self._readings.update(batch.readings)
        self._has_belt = self._has_belt or batch.belt is not None
        self._distances = self._distances if batch.distances is None else batch.distances
        if batch.belt is not None or batch.distances is not None:
            self._show_inspector()

    def show_fields(self, lines: Iterable[Line]) -> None:
        """Show the reach of the robot's devices, in its frame, until it moves."""
        self._place.map.update_cells(self.scene.show_fields(lines))

    def show_past(self, timeline: Timeline) -> None:
        """Show the map at that position of the timeline."""
        robot = self._donnie.session.name if self._donnie.team.has_several else None
        at = timeline.at
        timeline.go_to(max(1, at))  # where the robot was at first is known from the beginning of the run
        walked = timeline.trail(robot)
        timeline.go_to(at)
        if walked:
            self.scene.begin(walked[0])
            for pose in walked:
                self.scene.move(pose)
            self._pose = walked[-1]
        self.scene.place_things(timeline.things)
        for other in timeline.robots:
            place = timeline.pose(other)
            if other is not None and other != robot and place is not None:
                self.scene.move_other(other, place)
        self._place.map.restart()
        self.look()

    def show_slider(self) -> None:
        """Show the slider at the step that STEP BACK has reached."""
        self._place.show_slider(self._runs.past_steps)

    # --- the language

    def relabel(self) -> None:
        """Show everything again in another language."""
        self._kinds.clear()
        self._place.map.call_colours(colour_initials(self._words))
        self._place.map.restart()
        self.entitle_map()
        self.entitle_log()
        self._entitle_inspector()
        self.look()

    # --- the log

    def entitle_log(self, found: tuple[str, int] | None = None) -> None:
        """Entitle the log with the kind of lines that it shows, or the word that was ``found`` and how often.

        A reader would speak a changed title, so the plain layout has none of it.
        """
        only, title = self._place.log_rows.only, self._words("pane-log")
        if only:
            title = self._words("pane-log-only", kind=only)
        elif found is not None and not self._place.is_plain:
            title = self._words("pane-log-found", word=found[0], lines=found[1])
        self._place.log_pane.entitle(title)

    def write(self, lines: Iterable[tuple[str, str]]) -> None:
        """Write lines into the log, each with the code of its kind."""
        given = list(lines)
        seen = [each for each in given if each[1] != "typed"] if self._place.is_plain else given
        self._place.log_lines([(text, self._kind_words(kind)) for text, kind in seen])
        self._show_inspector()
        answers = [text for text, kind in given if kind != "typed"]
        if answers:
            self.keep(answers[-1])

    def keep(self, sentence: str) -> None:
        """Show a sentence in the status line until the learner looks elsewhere."""
        self._has_acted = False
        self._answer = sentence if sentence.endswith((".", "!", "?", ":")) else f"{sentence}."
        self.say_status()

    def _kind_words(self, kind: str) -> str:
        """The log's name for a kind, cached since a flood of lines has few kinds."""
        if kind not in self._kinds:
            code = f"kind-{kind}"
            known = self._words(code) if self._words.knows(code) else kind
            words = "" if kind in _WORDLESS else known
            self._kinds[kind] = words
            if kind in LOOKS:
                self._place.log_rows.looks[words] = LOOKS[kind]
        return self._kinds[kind]

    # --- all the rest

    def update(self) -> None:
        """Update everything, the distances too."""
        self.ask_distances()
        self.look()

    def ask_distances(self) -> None:
        """Ask for the distances to be published, if they are shown."""
        if self.shows_distances:
            self._donnie.session.publish_distances()

    def look(self) -> None:
        """Update titles, marks, status line, keys and inspector."""
        self.show_titles()
        self._show_marks()
        self.say_status()
        self._show_inspector()

    def _offer_keys(self) -> None:
        is_beginning = self._runs.state is RunState.READY and not self._place.editor.text
        is_wrong = self._runs.state is RunState.READY and bool(self._place.editor.mistakes)
        names = _OFFERED_FIRST if is_beginning else _OFFERED_WRONG if is_wrong else _OFFERED[self._runs.state]
        if self._runs.past is not None and self._runs.state is RunState.READY:
            names = _OFFERED_PAST
        offered = names, self._runs.state, self._words.language, self._table.all
        if offered == self._offered:
            return
        self._offered = offered
        entries = (self._key_entry(name) for name in names if self._table.of(name))
        everything = KeyEntry(PALETTE, key_label(PALETTE, self._words.language), self._words("key-all"))
        self._place.keys.offer([*entries, everything])

    def _key_entry(self, name: str) -> KeyEntry:
        shown_as = "continue_" if name == "pause" and self._runs.state is RunState.PAUSED else name
        return KeyEntry(name, self._table.label(name, self._words.language), self._words(f"key-{shown_as}"))

    def show_titles(self) -> None:
        """Show the program's name, first steps or the task for an empty one, and the keys that fit."""
        document = self._workspace.document
        name = document.path.name if document.path else self._words("new-program")
        code = "pane-program" if document.is_saved else "pane-program-changed"
        running = self._runs.text_on_its_way
        if running is not None and running != document.text:
            code = "pane-program-old"
        title, steps = first_steps(self._words.language, self._table)
        if self._attempt is not None:
            steps = task_in_words(self._attempt.challenge, self._words)
        is_beginning = self._place.is_small and document.path is None and not self._place.editor.text
        self._place.editor.show_first_steps(steps)
        self._place.program_pane.entitle(
            title if is_beginning else self._with_robot(self._words(code, name=name))
        )
        self._offer_keys()

    def _show_marks(self) -> None:
        lines = [frame.line for frame in self._program_frames()]
        working = working_in_a_row(self._runs.worked_out) if lines else ()
        editor = self._place.editor
        editor.mark(lines[0] if lines else None, frozenset(lines[1:]), working)
        if lines and self._runs.state is RunState.RUNNING and not self._place.is_plain:
            editor.follow(lines[0])

    def _program_frames(self) -> tuple[Frame, ...]:
        """The calls of the editor's program; empty while it is not running."""
        return self._runs.frames if self._runs.is_whole else ()

    @property
    def shows_distances(self) -> bool:
        """False in the plain layout while the robot moves, since readers would speak every distance."""
        return not (self._place.is_plain and self._runs.state is RunState.RUNNING)

    def _show_inspector(self) -> None:
        is_after_run = self._runs.state is RunState.READY and self._runs.past is None
        variables = self._donnie.session.variables if is_after_run else {}
        distances = self._distances if self.shows_distances else {}
        readings = tuple(self._readings.values())
        belt = self._donnie.outlets.belt.rows() if self._has_belt else ()
        is_moving_on = (
            self._runs.state is RunState.RUNNING
        )  # asked first: held, its variables stay as they are
        frames, changes = self._runs.frames, None if self._place.is_plain else self._changes
        is_step = not is_moving_on and self._runs.knows_variables  # no look on the way, or at nothing
        if changes is not None and is_step:
            changes.look(scopes_of(frames, variables), [frame.line for frame in frames])
        if changes is not None and self._runs.past is None:
            self._histories.look(scopes_of(frames, variables))
        known = variables if self._runs.knows_variables else None
        lines = inspector_lines(frames, known, distances, readings, belt, self._words, changes)
        goals = (
            ()
            if self._attempt is None
            else goal_lines(self._attempt, self._words, is_seen=changes is not None)
        )
        columns = max(self._place.inspector.size.width, LEAST_CHART) - 1
        charts = self._histories.charts(columns, self._words) if changes is not None else ()
        working = working_lines(self._runs.worked_out, self._words) if frames else ()
        self._place.inspector.show((*goals, *lines, *working, *charts))

    def say_status(self) -> None:
        """Show the focus, Donnie's place and the program's state.

        In the log only the focus is shown, since the listener has just heard the rest.
        """
        if self._place.is_plain and self._place.log_is_seen:
            self._place.status.say(f" {self.focus_sentence}")
            return
        session = self._donnie.session
        robot = robot_sentence(session.hub.robot, self._pose, self._words)
        past = self._runs.past_steps
        state = "looking-back" if past is not None else self._runs.state.value
        states = state_sentences(state, session.speed, self._words)
        focus, answer = self.focus_sentence, self._answer
        if self._place.is_plain:
            whole = [f"{focus} {robot} {each}" for each in states]
            short = [f"{focus} {states[1]}", *([states[1], ""] if answer else [focus])]
            badge = colour = ""
        else:
            speed = self._words("status-speed", speed=speed_words(session.speed, self._words))
            whole = [f"{focus} {robot} {speed}", f"{focus} {robot}", *([robot] if self._is_in_sight else [])]
            short = [focus, *self._mistake_in_short, *([""] if answer else [])]
            badge, colour = state_badge(
                self._runs.state, past, session.speed, self._words, was_stopped=self._was_stopped
            )
        choices = [f" {answer} {rest}".replace("  ", " ") for rest in (*whole, *short)]
        running = "" if self._place.is_plain else self._running_sentence
        if running:  # the badge has the speed, and the log the answer, where there is a log
            said = [answer, ""] if self._place.log_is_seen or not answer else [answer]
            choices = [f" {each} {running} {robot}".replace("  ", " ") for each in said]
            choices += [f" {said[-1]} {running}".replace("  ", " "), f" {answer or running}"]
        self._place.status.say(*choices, badge=badge, colour=colour)

    def acted(self) -> None:
        """Note that the learner pressed a key or the mouse."""
        self._has_acted = True

    def looked(self) -> None:
        """Drop the last answer, which is read once the focus or the cursor moves."""
        if self._has_acted:
            self._answer = ""
        self.show_titles()
        self.say_status()

    @property
    def focus_sentence(self) -> str:
        place, words = self._place, self._words
        if place.map.has_focus and place.map.pointer is not None and place.map.is_exploring:
            return words("status-map-cell", what=place.map.pointer.words(words))
        if place.map.has_focus:
            return words("status-map")
        if place.log_rows.has_focus:
            return words("status-log", line=place.log_rows.row + 1, lines=place.log_rows.row_count)
        if place.inspector.has_focus:
            return words("status-inspector")
        if place.command_line.has_focus:
            return words("status-command")
        if place.tour is not None and place.tour.has_focus:
            return f"{place.tour.title}."
        line, lines = self._program_line(), place.editor.line_count
        mistake = place.editor.mistake
        if mistake is not None and self._runs.state is RunState.READY:
            key = self._table.label("fix", words.language)
            code = "status-mistake-meant" if mistake.meant and key else "status-mistake"
            return words(code, line=line, lines=lines, message=mistake.message, meant=mistake.meant, key=key)
        return words("status-program", line=line, lines=lines)

    @property
    def _running_sentence(self) -> str:
        """The line that runs, or that STEP BACK has reached, with its innermost block; empty for none."""
        frames = self._program_frames()
        if not frames:
            return ""
        document, words = self._workspace.document, self._words
        line, lines = frames[0].line, self._place.editor.line_count
        is_there = line <= lines and len(document.text) <= LONGEST_CHECKED
        block = next(iter(document.structure.openers(line)), None) if is_there else None
        if block is None:
            return words("status-line", line=line, lines=lines)
        name = block.name or spelling(block.kind, words.language)
        return words("status-line-in", line=line, lines=lines, block=name)

    @property
    def _is_in_sight(self) -> bool:
        """Whether the program pane shows all of it: the line is visible and has no mistake."""
        editor = self._place.editor
        is_wrong = editor.mistake is not None and self._runs.state is RunState.READY
        return editor.has_focus and not is_wrong

    @property
    def _mistake_in_short(self) -> tuple[str, ...]:
        """The mistake of the cursor's line, used if the line number has no room in the status line."""
        mistake, words = self._place.editor.mistake, self._words
        if mistake is None or self._runs.state is not RunState.READY or not self._place.editor.has_focus:
            return ()
        key = self._table.label("fix", words.language)
        meant = words("status-meant", message=mistake.message, key=key, meant=mistake.meant)
        return (*((meant,) if mistake.meant and key else ()), mistake.message)

    def _program_line(self) -> int:
        """The line that runs, or the one of the cursor."""
        frames = self._program_frames()
        return frames[0].line if frames else self._place.editor.line

"""The text of the status line and of the inspector: values in, sentences of the catalogue out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from devices.ports.robot import Bearing, Pose
from donnie_tui.core.events import Read
from donnie_tui.core.run_state import RunState
from donnie_tui.core.wording import Wording, compass_heading, facing, whole_steps
from donnie_tui.settings.settings import speed_words
from language.runtime import Frame


def robot_sentence(name: str | None, pose: Pose, words: Wording) -> str:
    """Where the robot is; without a name of its own it is Donnie.

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


def state_sentences(state: RunState, speed: float | None, words: Wording) -> tuple[str, str]:
    """What the program does, and how fast; and without the speed, where there is no room."""
    return (
        words(f"status-{state.value}-speed", speed=speed_words(speed, words)),
        words(f"status-{state.value}"),
    )


def inspector_lines(
    frames: Sequence[Frame],
    variables: Mapping[str, int],
    distances: Mapping[Bearing, int],
    readings: Sequence[Read],
    belt: Sequence[str],
    words: Wording,
) -> tuple[str, ...]:
    """Variables, calls, the distances and the belt now, and last what the program read of each sensor.

    The belt is in words, and as two rows of seven.
    """
    return (
        *_variables(frames[0].variables if frames else tuple(variables.items()), words),
        *_calls(frames, words),
        *_distances(distances, words),
        *belt,
        *_readings(readings, words),
    )


def _variables(variables: Sequence[tuple[str, int]], words: Wording) -> tuple[str, ...]:
    if not variables:
        return (words("inspector-no-variables"),)
    lines = (words("inspector-variable", name=name, value=_short(value)) for name, value in variables)
    return (words("inspector-variables"), *lines)


def _short(value: int) -> str:
    """A number that fits; of a long one the first digits and how many there are."""
    if abs(value) < 10**18:
        return str(value)
    digits = str(abs(value))
    return f"{'-' if value < 0 else ''}{digits[:6]}... ({len(digits)})"


def _calls(frames: Sequence[Frame], words: Wording) -> tuple[str, ...]:
    if not frames:
        return ()
    return (words("inspector-calls"), *(_call(frame, words) for frame in frames[:20]))


def _call(frame: Frame, words: Wording) -> str:
    if not frame.procedure:
        return words("inspector-main", line=frame.line)
    return words("inspector-call", name=frame.procedure, line=frame.line)


def _distances(distances: Mapping[Bearing, int], words: Wording) -> tuple[str, ...]:
    """From the front to the right and round."""
    if not distances:
        return ()
    lines = (
        words("inspector-reading", what=_where(bearing.words, words), value=distances[bearing])
        for bearing in sorted(distances, key=lambda each: each.value)
    )
    return (words("inspector-distances"), *lines)


def _where(bearing: str, words: Wording) -> str:
    return words(f"where-{bearing.replace(' ', '-')}")


def _readings(readings: Sequence[Read], words: Wording) -> tuple[str, ...]:
    if not readings:
        return ()
    return (words("inspector-readings"), *(_reading(each, words) for each in readings))


def _reading(read: Read, words: Wording) -> str:
    where = read.argument
    if read.sensor == "distance":
        where = _where(read.argument, words)
    elif read.sensor == "colour":
        where = words(f"colour-{read.argument}")
    return words("inspector-reading", what=words(f"reading-{read.sensor}", where=where), value=read.value)

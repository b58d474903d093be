"""Changes the text of a world: models at the top level are added, put elsewhere or taken out.

All else stays as its author wrote it. A model that stands in an included file can't be changed.
"""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from sim.geometry import Placement
from sim.worldfile.entities import MODEL_TYPES, Expander, FileReader
from sim.worldfile.parser import WorldToken, tokens


class WrittenModel(Struct, frozen=True):
    """Where a model at the top level stands in the text of its world. Offsets count characters."""

    begin: int
    end: int
    """After its last bracket."""
    inside: int
    """Before its last bracket."""
    pose: tuple[int, int] | None
    """From the bracket of its pose to after the other one; None where it says none."""


def written_models(text: str, path: Path, allowed: tuple[Path, ...] = ()) -> tuple[WrittenModel | None, ...]:
    """The models at the top level, in the scene's order; None for those of included files.

    Raises ``WorldError`` as ``load_text`` does.
    """
    reader = FileReader(path, allowed)
    entities = Expander(folders=reader.folders).expand(reader.statements(text, path, ()))
    here = _models_of(text, str(path))
    return tuple(
        here.get((each.line, each.column)) if each.file == str(path) else None
        for each in entities
        if each.type in MODEL_TYPES
    )


def _models_of(text: str, file: str) -> dict[tuple[int, int], WrittenModel]:
    """What has a body at the top level, by line and column."""
    starts = [0]
    for line in text.split("\n"):
        starts.append(starts[-1] + len(line) + 1)

    def offset(token: WorldToken) -> int:
        return starts[token.line - 1] + token.column - 1

    found: dict[tuple[int, int], WrittenModel] = {}
    depth, first, pose, opened = 0, None, None, None
    before: WorldToken | None = None
    for token in tokens(text, file):
        match token.kind:
            case "LPAR":
                if depth == 0:
                    first, pose = before, None
                depth += 1
            case "RPAR":
                depth -= 1
                if depth == 0 and first is not None:
                    begin, inside = offset(first), offset(token)
                    found[first.line, first.column] = WrittenModel(begin, inside + 1, inside, pose)
            case "LSQB" if depth == 1 and before is not None and before.text == "pose":
                opened = offset(token)
            case "RSQB" if opened is not None:
                pose, opened = (opened, offset(token) + 1), None
        before = token
    return found


def put_elsewhere(text: str, model: WrittenModel, place: Placement) -> str:
    """With another pose, in metres and degrees."""
    pose = f"[ {place.x:.6g} {place.y:.6g} {place.z:.6g} {place.yaw:.6g} ]"
    if model.pose is not None:
        return text[: model.pose[0]] + pose + text[model.pose[1] :]
    blank = "" if text[model.inside - 1].isspace() else " "
    return f"{text[: model.inside]}{blank}pose {pose} {text[model.inside :]}"


def taken_out(text: str, model: WrittenModel) -> str:
    """Without it; its line too where nothing else is in it."""
    line, rest = text.rfind("\n", 0, model.begin) + 1, text.find("\n", model.end)
    end = len(text) if rest < 0 else rest + 1
    if not text[line : model.begin].strip() and not text[model.end : end].strip():
        return text[:line] + text[end:]
    return text[: model.begin] + text[model.end :]

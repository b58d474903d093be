"""A run as a picture for those who see: walls, things where they ended, and the path of each robot.

As SVG a dot drives along each path at the pace of the run, the title and the description say the path in
words, and letters stand in for colours. As PNG the same picture stands still. Lengths are pixels, places in
the world steps; the northern edge is up.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from io import BytesIO
from itertools import accumulate, pairwise
from math import cos, hypot, radians, sin
from textwrap import wrap
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

from msgspec import Struct

from devices.ports.robot import Pose
from donnie_tui.core.map_grid import PAINTED, path_in_words
from donnie_tui.core.wording import Wording, coloured_thing
from language.source import printable

if TYPE_CHECKING:
    from sim.picture import Drawing

_Point = tuple[float, float]

LARGEST = 900.0
"""Pixels that the map is wide or high."""
MARGIN, LETTER, LINE = 24.0, 14.0, 20.0
"""Pixels: around everything, the height of a letter, from line to line of the legend."""
STEPS_A_SECOND = 10.0
"""How fast the dot drives: ten times the robot's pace."""
_WALL, _OTHER, _INK = "#444444", "#bbbbbb", "#000000"
_PATHS = ("#7b2cbf", "#006d5b", "#9d0208", "#003049")
"""Dark enough on white for lines (at least 4.5 to 1)."""


class DrivenPath(Struct, frozen=True):
    """Where a robot was, its start first; ``robot`` is empty in a world of one."""

    robot: str
    poses: tuple[Pose, ...]

    @property
    def seconds(self) -> float:
        """The time of the moving dot."""
        return max(0.1, sum(_apart(*each) for each in pairwise(self.poses)) / STEPS_A_SECOND)


class RunPicture(Struct, frozen=True):
    """What is drawn, and where: the scale and the edges of the world's part that is shown."""

    title: str
    drawings: tuple[Drawing, ...]
    paths: tuple[DrivenPath, ...]
    west: float
    north: float
    scale: float
    """Pixels for a step."""
    width: float
    height: float
    legend: tuple[str, ...]

    def at(self, x: float, y: float) -> _Point:
        return round(MARGIN + (x - self.west) * self.scale, 1), round(
            2 * MARGIN + (self.north - y) * self.scale, 1
        )


def run_picture(
    title: str, drawings: Sequence[Drawing], paths: Sequence[DrivenPath], wording: Wording
) -> RunPicture:
    """``drawings``: what stands there at the end, without the robots of ``paths``."""
    shown = tuple(each for each in drawings if each.thing is None or not each.thing.is_robot)
    points = [point for each in shown for outline in each.outlines for point in outline]
    points += [(pose.x, pose.y) for path in paths for pose in path.poses] or [(0.0, 0.0)]
    xs, ys = zip(*points, strict=True)
    west, east, south, north = min(xs) - 2, max(xs) + 2, min(ys) - 2, max(ys) + 2
    scale = min(LARGEST / (east - west), LARGEST / (north - south), 24.0)
    width = round(max((east - west) * scale, 320) + 2 * MARGIN)
    letters = int((width - 2 * MARGIN) / (LETTER * 0.55))
    legend = tuple(part for line in _legend(shown, paths, wording) for part in wrap(line, letters))
    return RunPicture(
        printable(title),
        shown,
        tuple(paths),
        west,
        north,
        scale,
        width=width,
        height=round((north - south) * scale + 3 * MARGIN + LINE * len(legend)),
        legend=legend,
    )


def _legend(drawings: Iterable[Drawing], paths: Iterable[DrivenPath], wording: Wording) -> Iterable[str]:
    yield wording("paper-north")
    named: dict[str, list[str]] = {}
    for each in drawings:
        if each.thing is not None:
            named.setdefault(each.thing.letter, []).append(coloured_thing(each.thing, wording))
    for letter, names in sorted(named.items()):
        yield printable(f"{letter}: {'; '.join(dict.fromkeys(names))}")
    for path in paths:
        words = " ".join(path_in_words(path.poses, wording))
        yield printable(f"{path.robot}: {words}" if path.robot else words)


def as_svg(it: RunPicture) -> str:
    """The picture as SVG; the dots drive once and stop at the end."""
    size = f'width="{it.width:g}" height="{it.height:g}" viewBox="0 0 {it.width:g} {it.height:g}"'
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" {size}>',
            f"<title>{escape(it.title)}</title>",
            f"<desc>{escape(' '.join(it.legend))}</desc>",
            f'<rect width="{it.width:g}" height="{it.height:g}" fill="white"/>',
            *(_svg_shape(it, each) for each in it.drawings),
            *(line for number, path in enumerate(it.paths) for line in _svg_path(it, path, number)),
            *(_svg_text(*each) for each in texts(it)),
            "</svg>\n",
        )
    )


def _svg_shape(it: RunPicture, drawing: Drawing) -> str:
    fill = _fill(drawing)
    d = " ".join(
        "M " + " L ".join(f"{x:g} {y:g}" for x, y in (it.at(*point) for point in outline)) + " Z"
        for outline in drawing.outlines
    )
    return f'<path d="{d}" fill="{fill}" stroke="{_INK}" stroke-width="1"/>'


def _svg_path(it: RunPicture, path: DrivenPath, number: int) -> Iterable[str]:
    colour = _PATHS[number % len(_PATHS)]
    places = [it.at(pose.x, pose.y) for pose in path.poses]
    (x, y), radius = places[0], max(3.0, 1.3 * it.scale)
    yield f'<polyline points="{_svg_points(places)}" fill="none" stroke="{colour}" stroke-width="3"/>'
    yield f'<circle cx="{x:g}" cy="{y:g}" r="4" fill="white" stroke="{colour}" stroke-width="2"/>'
    yield f'<polygon points="{_svg_points(arrow(it, path))}" fill="{colour}"/>'
    lengths = [0.0, *accumulate(_apart(*each) for each in pairwise(path.poses))]
    if lengths[-1] > 0:
        times = ";".join(f"{each / lengths[-1]:.4f}" for each in lengths)
        yield f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="none" stroke="{colour}" stroke-width="2">'
        for name, values in (("cx", [x for x, _ in places]), ("cy", [y for _, y in places])):
            yield (
                f'<animate attributeName="{name}" values="{";".join(f"{each:g}" for each in values)}"'
                f' keyTimes="{times}" dur="{path.seconds:.1f}s" fill="freeze"/>'
            )
        yield "</circle>"


def _svg_points(points: Iterable[_Point]) -> str:
    return " ".join(f"{x:g},{y:g}" for x, y in points)


def _svg_text(x: float, y: float, text: str) -> str:
    font = f'font-family="sans-serif" font-size="{LETTER:g}"'
    return f'<text x="{x:g}" y="{y:g}" {font} fill="{_INK}">{escape(text)}</text>'


def as_png(it: RunPicture) -> bytes:
    """The picture as PNG, drawn by Pillow."""
    from PIL import Image, ImageDraw, ImageFont, PngImagePlugin  # slow to load

    image = Image.new("RGB", (round(it.width), round(it.height)), "white")
    draw = ImageDraw.Draw(image)
    font = ImageFont.load_default(LETTER)
    for each in it.drawings:
        for outline in each.outlines:
            draw.polygon([it.at(*point) for point in outline], fill=_fill(each), outline=_INK)
    for number, path in enumerate(it.paths):
        colour = _PATHS[number % len(_PATHS)]
        places = [it.at(pose.x, pose.y) for pose in path.poses]
        if len(places) > 1:
            draw.line(places, fill=colour, width=3, joint="curve")
        x, y = places[0]
        draw.ellipse((x - 4, y - 4, x + 4, y + 4), fill="white", outline=colour, width=2)
        draw.polygon(arrow(it, path), fill=colour)
    for x, y, text in texts(it):
        draw.text((x, y), text, fill=_INK, font=font, anchor="ls")
    out, about = BytesIO(), PngImagePlugin.PngInfo()
    about.add_text("Software", "donnie")  # so that only a picture of Donnie's is replaced
    about.add_text("Description", " ".join(it.legend).encode("latin-1", "replace").decode("latin-1"))
    image.save(out, "PNG", pnginfo=about)
    return out.getvalue()


def texts(it: RunPicture) -> Iterable[tuple[float, float, str]]:
    """The title, a letter on each thing or next to a small one, and the legend.

    Left end and base line of each.
    """
    yield MARGIN, MARGIN, it.title
    for each in it.drawings:
        thing = each.thing
        if thing is None:
            continue
        x, y = it.at(thing.x, thing.y)
        is_inside = min(thing.width, thing.depth) * it.scale >= 1.5 * LETTER
        right = x - LETTER / 3 if is_inside else x + thing.width * it.scale / 2 + 3
        yield right, y + LETTER / 3, thing.letter
    below = it.height - LINE * len(it.legend)
    for number, line in enumerate(it.legend):
        yield MARGIN, below + LINE * number, line


def arrow(it: RunPicture, path: DrivenPath) -> list[_Point]:
    """A triangle where the robot stopped, in its direction."""
    pose = path.poses[-1]
    x, y = it.at(pose.x, pose.y)
    size = max(6.0, 1.3 * it.scale)
    turns = ((0.0, size), (140.0, size), (220.0, size))
    return [
        (
            round(x + length * sin(radians(pose.heading + angle)), 1),
            round(y - length * cos(radians(pose.heading + angle)), 1),
        )
        for angle, length in turns
    ]


def _fill(drawing: Drawing) -> str:
    return _WALL if drawing.thing is None else PAINTED.get(drawing.thing.colour, _OTHER)


def _apart(here: Pose, there: Pose) -> float:
    return hypot(there.x - here.x, there.y - here.y)

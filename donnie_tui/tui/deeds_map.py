"""What the actions about the map do: exploring it in words, and how it is shown."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from donnie_tui.core import map_labels
from donnie_tui.core.pointing import Pointer, legend
from donnie_tui.tui.running import Answer

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost


class MapDeeds:
    """One method an action."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host
        self._map = host.workplace.map

    # --- exploring

    def next_thing(self, _argument: str) -> None:
        self._to_thing(forward=True)

    def previous_thing(self, _argument: str) -> None:
        self._to_thing(forward=False)

    def _to_thing(self, *, forward: bool) -> None:
        pointer = self._map.pointer
        if pointer is None or not pointer.scene.things:
            self._host.talk.tell(Answer("world-bare"))
        else:
            self._explore(lambda pointer: pointer.to_next_thing(forward))

    def to_robot(self, _argument: str) -> None:
        self._explore(Pointer.to_robot)

    def from_here(self, _argument: str) -> None:
        self._explore(Pointer.mark)
        if self._map.pointer is not None:
            x, y = self._map.pointer.scene.place(self._map.pointer.here)
            self._host.talk.tell(Answer("map-marked", {"x": x, "y": y}))

    def to_there(self, _argument: str) -> None:
        if self._map.pointer is not None:
            self._host.talk.tell_sentences(self._map.pointer.way(self._host.words))

    def _explore(self, change: Callable[[Pointer], object]) -> None:
        """With the focus on the map: there the cursor stands on what is told."""
        if not self._map.has_focus:
            self._host.workplace.go_to(self._host.workplace.map_pane)
        self._map.explore(change)

    # --- how it is shown

    def zoom_in(self, _argument: str) -> None:
        self._zoom(self._map.zoom + 1)

    def zoom_out(self, _argument: str) -> None:
        self._zoom(self._map.zoom - 1)

    def _zoom(self, zoom: int) -> None:
        self._map.set_zoom(zoom)
        self._tell_scale()

    def whole_map(self, _argument: str) -> None:
        self._map.show_all(not self._map.shows_all)
        self._tell_scale()

    def _tell_scale(self) -> None:
        scale = self._map.scale
        if scale is not None:
            steps = scale.factor * scale.scene.picture.cell
            code = "map-shows-all" if self._map.shows_all else "map-follows"
            self._host.talk.tell(Answer(code, {"steps": steps}))

    def names(self, _argument: str) -> None:
        placed = None if self._map.has_names else partial(map_labels.labels, wording=self._host.words)
        self._map.show_names(placed)
        self._switched("names", self._map.has_names)

    def coordinates(self, _argument: str) -> None:
        self._map.show_rulers(not self._map.has_rulers)
        self._switched("coordinates", self._map.has_rulers)

    def _switched(self, name: str, on: bool) -> None:
        self._host.talk.tell(Answer(f"screen-{name}-{'on' if on else 'off'}"))

    def legend(self, _argument: str) -> None:
        if self._map.scale is not None:
            lines = legend(self._map.scale.scene, self._host.words)
            self._host.pages.show_lines(self._host.words("legend-title"), lines)

"""The world of a recording, loaded from the recording alone. Nothing of it stays behind."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import worlds
from devices.ports.robot import Bearing
from devices.ports.values import replace
from donnie_tui.core.recording import Header
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.i18n.world_mistakes import world_mistake
from donnie_tui.settings.chosen import Settings
from donnie_tui.world.bundle import BundleError, WorldBundle, from_record, unpack
from donnie_tui.world.choice import ChosenWorld

if TYPE_CHECKING:
    from sim.scene import Scene


@contextmanager
def unpacked(header: Header, words: Words) -> Iterator[ChosenWorld]:
    """The world as it was, in a folder that is gone afterwards. Raises ``Unusable``."""
    with TemporaryDirectory(prefix="donnie-") as folder:
        try:
            bundle = from_record(header.world)
            main, folders = unpack(bundle, Path(folder))
        except BundleError as error:
            raise Unusable(words(error.code, **error.values)) from None
        yield ChosenWorld(bundle.name, str(main), _loaded(bundle, main, folders, words), _ships(bundle))


def _loaded(bundle: WorldBundle, main: Path, folders: tuple[Path, ...], words: Words) -> Scene:
    from sim.worldfile import WorldError, load_world

    try:
        scene = load_world(main, allowed=folders)
    except WorldError as error:
        raise Unusable(world_mistake(error, words)) from None
    offered = tuple(index for index in scene.robots if scene.models[index].spoken_name in bundle.robots)
    if not offered:
        raise Unusable(words("world-without-robot", name=bundle.name))
    return replace(scene, robots=offered)


def _ships(bundle: WorldBundle) -> bool:
    """Whether there are words about it, as long as it is called as one of ours."""
    return bundle.name in worlds.names()


def settings_of(header: Header, settings: Settings, words: Words) -> Settings:
    """What matters of how it was recorded, over the settings of now. Raises ``Unusable``."""
    try:
        strong, medium, weak = (_number(each) for each in _list(header.belt["steps"]))
        columns = {
            Bearing(int(bearing)): tuple(_number(each) for each in _list(those))
            for bearing, those in _columns(header).items()
        }
    except (KeyError, ValueError, TypeError):
        raise Unusable(words("bundle-damaged")) from None
    return replace(
        settings,
        seed=header.seed,
        speed=None,
        belt_steps=(strong, medium, weak),
        belt_columns=columns,
    )


def _columns(header: Header) -> Mapping[str, object]:
    columns = header.belt["columns"]
    if not isinstance(columns, dict):
        raise TypeError
    return columns


def _list(value: object) -> list[object]:
    if not isinstance(value, list):
        raise TypeError
    return value


def _number(value: object) -> int:
    if type(value) is not int:
        raise TypeError
    return value

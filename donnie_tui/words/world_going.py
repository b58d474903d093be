"""Going to another world, for both front ends: which one is meant, whether it can be, and what stays.

Rules: who records stays; a world is only left for one that can be loaded; whatever runs is stopped first and
told so. The front end then makes a session there, with the program and with what was chosen.
"""

from __future__ import annotations

from devices.ports.values import replace
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.events import SoundSwitched
from donnie_tui.core.harmless import printable
from donnie_tui.core.patience import LAST_WORDS
from donnie_tui.core.world_words import arrived, world_meant
from donnie_tui.i18n.words import Unusable
from donnie_tui.settings.chosen import Settings, Source
from donnie_tui.words.team_words import stopped_all
from donnie_tui.world.choice import choose_world


def may_leave_world(donnie: Donnie) -> bool:
    """Whoever records this one stays in it: what was recorded would be lost. That is told."""
    kept = donnie.outlets.written.of_this_session
    if kept is not None:
        donnie.say("world-kept", path=kept)
    return kept is None


def world_to_go_to(donnie: Donnie, typed: str) -> str | None:
    """The name or file of the world that is meant; None where nothing comes of it, which is told."""
    if not may_leave_world(donnie):
        return None
    name = world_meant(typed) or typed
    if name == donnie.world.name and donnie.world.ships:
        donnie.say("world-here-already", name=name)
        return None
    try:
        folders = donnie.outlets.audible.settings.world_folders
        world = choose_world(name, donnie.words, folders, unknown="world-unknown-here")
    except Unusable as unusable:
        donnie.tell(printable(unusable.sentence))
        return None
    if not world.scene.robots:
        donnie.say("world-without-robot", name=world.name)
        return None
    return name


def stop_before_going(donnie: Donnie, name: str) -> None:
    """All that runs is stopped; that, and where it goes, is told."""
    running = donnie.team.running
    code = stopped_all(donnie)
    for session in running:
        if session.run is not None:
            session.run.wait(LAST_WORDS)
    if running:
        donnie.say(code)
    donnie.say("world-going", name=name)


def settings_there(donnie: Donnie, settings: Settings, name: str) -> Settings:
    """``settings`` in that world: with what was chosen by a word meanwhile."""
    words, robot = donnie.words, donnie.connection.robot
    found = replace(
        settings,
        world=name,
        language=words.language,
        verbosity=words.detail,
        speed=donnie.session.speed,
        notices=(),
    )
    if robot == settings.robot:
        return found
    return replace(found, robot=robot, sources={**settings.sources, "robot": Source.OPTION})


def tell_arrival(donnie: Donnie, *, is_silent: bool) -> None:
    """That the other world is there, and what it has; ``is_silent``: after SOUND OFF in the one before."""
    world, words = donnie.world, donnie.words
    if is_silent:
        donnie.session.hub.publish(SoundSwitched(False))
    donnie.tell(*arrived(world.name, world.about(words.language), donnie.picture(), words))

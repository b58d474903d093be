"""Each heavy library is imported by its owner only, also at run time: a static graph can't see deferral.

A fresh interpreter imports one module of ours and tells which heavy libraries came with it.
"""

import pkgutil
import subprocess
import sys

import pytest

from tests.conftest import ROOT

PACKAGES = ("donnie_tui", "language", "sim", "devices", "worlds")

OWNERS = {
    "textual": ("donnie_tui.tui",),
    "rich": ("donnie_tui.tui",),
    "lark": ("sim.", "language.make_tables"),
    "pymunk": ("sim.",),
    "PIL": ("sim.",),
    "serial": (),
    "gpiod": (),
    "pyttsx3": (),
    "miniaudio": (),
    "numpy": (),
}
"""The modules, by prefix, that may load a library when they are imported; others may later, or never."""


def modules() -> list[str]:
    found = pkgutil.walk_packages([str(ROOT)], onerror=lambda name: None)
    return [each.name for each in found if each.name.split(".")[0] in PACKAGES]


@pytest.mark.parametrize("module", modules())
def test_a_module_brings_no_library_that_it_does_not_own(module: str) -> None:
    loaded = libraries_loaded_by(module)

    foreign = {each for each in loaded if not f"{module}.".startswith(OWNERS[each] or ("-",))}
    assert foreign == set()


def libraries_loaded_by(module: str) -> set[str]:
    code = f"import sys, {module}; print(*sorted(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True, timeout=60
    )
    return {name for name in done.stdout.split() if name in OWNERS}


def test_every_module_can_be_imported() -> None:
    """Found as files: a package that can't be imported hides its modules from whoever walks packages."""
    files = [each.relative_to(ROOT) for top in PACKAGES for each in (ROOT / top).rglob("*.py")]
    names = [".".join(each.with_suffix("").parts).removesuffix(".__init__") for each in files]
    wanted = sorted(each for each in names if not each.endswith("__main__"))
    done = subprocess.run(
        [sys.executable, "-c", IMPORT_ALL, *wanted], capture_output=True, text=True, cwd=ROOT, timeout=100
    )

    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


IMPORT_ALL = """
import importlib, sys
for name in sys.argv[1:]:
    try:
        importlib.import_module(name)
    except Exception as error:
        print(name, repr(error))
"""


def test_there_are_modules_to_look_at() -> None:
    assert {"donnie_tui.core.session", "language.parser", "sim.robot", "donnie_tui.tui.app"} <= set(modules())

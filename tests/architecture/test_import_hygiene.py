"""Each heavy library is imported by its owner only, also at run time, which a static graph can't see.

A fresh interpreter imports modules and reports the heavy libraries that they load.
"""

import pkgutil
import subprocess
import sys

import pytest

from tests.conftest import ROOT
from tests.timeouts import TIMEOUT

PACKAGES = ("donnie_tui", "language", "sim", "devices", "worlds")

OWNERS = {
    "textual": ("donnie_tui.tui",),
    "rich": ("donnie_tui.tui",),
    "lark": ("sim.",),
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


def owned_by(module: str) -> frozenset[str]:
    """The libraries that the module may load."""
    return frozenset(name for name, owners in OWNERS.items() if f"{module}.".startswith(owners or ("-",)))


KINDS = sorted({owned_by(each) for each in modules()}, key=sorted)


@pytest.mark.parametrize("owned", KINDS, ids=lambda each: " ".join(sorted(each)) or "none")
def test_no_module_loads_a_library_that_it_does_not_own(owned: frozenset[str]) -> None:
    """Those that may load the same libraries are imported in one process, which names the first offender."""
    names = [each for each in modules() if owned_by(each) == owned]
    foreign = " ".join(OWNERS.keys() - owned)
    done = subprocess.run(
        [sys.executable, "-c", WATCH_IMPORTS, foreign, *names],
        capture_output=True,
        text=True,
        cwd=ROOT,
        timeout=TIMEOUT,
    )

    assert (done.stdout, done.stderr) == ("", "")


WATCH_IMPORTS = """
import importlib, sys
foreign = {*sys.argv[1].split()}
for name in sys.argv[2:]:
    importlib.import_module(name)
    if loaded := foreign & {*sys.modules}:
        sys.exit(f"{name} loads {loaded}")
"""


def test_every_module_can_be_imported() -> None:
    """The modules are found as files: a broken package hides its modules from ``pkgutil``."""
    files = [each.relative_to(ROOT) for top in PACKAGES for each in (ROOT / top).rglob("*.py")]
    names = [".".join(each.with_suffix("").parts).removesuffix(".__init__") for each in files]
    wanted = sorted(each for each in names if not each.endswith("__main__"))
    done = subprocess.run(
        [sys.executable, "-c", IMPORT_ALL, *wanted],
        capture_output=True,
        text=True,
        cwd=ROOT,
        timeout=TIMEOUT,
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


def test_modules_are_found() -> None:
    assert {"donnie_tui.core.session", "language.parser", "sim.robot", "donnie_tui.tui.app"} <= set(modules())

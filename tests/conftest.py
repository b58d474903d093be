"""What every test may ask for."""

import signal
from pathlib import Path

import pytest
from hypothesis import settings

settings.register_profile("donnie", deadline=None)  # a busy machine is no failure
settings.load_profile("donnie")

for number in (signal.SIGINT, signal.SIGQUIT) if hasattr(signal, "SIGQUIT") else (signal.SIGINT,):
    if signal.getsignal(number) is signal.SIG_IGN:  # a shell ignores them for what runs beside it
        signal.signal(number, signal.default_int_handler if number == signal.SIGINT else signal.SIG_DFL)

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def shared() -> Path:
    """The material that is kept beside the project; where it is absent, the test is skipped."""
    folder = ROOT.parent / "shared"
    if not folder.is_dir():
        pytest.skip("needs the shared material beside the project")
    return folder

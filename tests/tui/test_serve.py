"""``donnie serve``: a page on this machine alone, and the full screen behind it."""

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

aiohttp = pytest.importorskip("aiohttp")
pytest.importorskip("textual_serve")

ROOT = Path(__file__).resolve().parents[2]
LIMIT = 30.0


def free_port() -> int:
    with socket.socket() as found:
        found.bind(("localhost", 0))
        return found.getsockname()[1]


@pytest.fixture
def server(tmp_path):
    """The port of one that serves."""
    port = free_port()
    ours = ("DONNIE", "TEXTUAL")
    environment = {key: value for key, value in os.environ.items() if not key.startswith(ours)}
    process = subprocess.Popen(
        [sys.executable, "-m", "donnie_tui", "serve", "--port", str(port), "--speech", "off", "--lang", "en"],
        cwd=ROOT,
        env=environment | {"HOME": str(tmp_path), "DONNIE_TOUR": "off"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    end = time.monotonic() + LIMIT
    while socket.socket().connect_ex(("localhost", port)):
        assert time.monotonic() < end and process.poll() is None, "it does not listen"
        time.sleep(0.05)
    yield port
    process.terminate()
    process.wait(LIMIT)


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_shows_the_full_screen(server):
    address = f"http://localhost:{server}"
    async with aiohttp.ClientSession() as session:
        async with session.get(address) as page:
            assert page.status == 200
            assert "Donnie" in await page.text()
        async with session.ws_connect(f"{address}/ws?width=80&height=24") as terminal:
            seen = b""
            while b"Ready, speed" not in seen:
                message = await terminal.receive(timeout=LIMIT)
                seen += message.data if isinstance(message.data, bytes) else str(message.data).encode()


def run(*arguments: str, **environment: str) -> tuple[int, str]:
    done = subprocess.run(
        [sys.executable, "-m", "donnie_tui", *arguments],
        cwd=ROOT,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        timeout=LIMIT,
        check=False,
    )
    return done.returncode, done.stderr


@pytest.mark.parametrize("port", ["none", "0", "70000", "-1", "1" * 50])
def test_a_port_that_is_none_is_one_sentence(port):
    code, told = run("serve", f"--port={port}", "--lang", "en")

    assert code == 2
    assert "is no port" in told
    assert told.count("\n") == 1

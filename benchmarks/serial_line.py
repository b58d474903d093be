"""The real robot's connection: frames a second through the codec, how soon a stop is on the wire, what it
costs.

It is a pseudo-terminal with a simulated board behind it, which sends as many frames as the real one. Targets:
ten times the frames of a board; a stop within 50 ms; the thread takes less than 5 % of a processor. The board
is a process of its own, so that only the driver is measured. (It is not called serial.py, because pyserial
is.)
"""

from __future__ import annotations

import multiprocessing
import statistics
import sys
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from devices.board_simulator.board import SimulatedBoard
from devices.serial_robot.link import SerialLink
from devices.wire.frames import STOP, Decoder, MotorDrive
from tests.board_on_pty import PtyBoard

FAR = 1e9
SECONDS = 5.0
STOPS = 20


def main() -> None:
    decode()
    talk: tuple[Connection, Connection] = multiprocessing.Pipe()
    board = multiprocessing.get_context("spawn").Process(target=play_board, args=(talk[1],), daemon=True)
    board.start()
    link = SerialLink(talk[0].recv())
    link.connect()
    cost(link)
    stop(link, talk[0])
    link.close()
    board.kill()


def decode() -> None:
    """Decode what a driving board sends in ten seconds, in the chunks in which it is read."""
    board = SimulatedBoard(boot_loader=-0.9)
    board.advance(0.2)
    board.receive(bytes.fromhex("aabb13c03f800000000000000000000040a0000003fdef"))
    board.advance(0.1)
    board.receive(bytes.fromhex("aabb05280f7ff07fcc"))
    chunks = [board.advance(0.01) for _ in range(1000)]
    decoder = Decoder()
    began = time.perf_counter()
    frames = sum(len(decoder.feed(chunk)) for chunk in chunks)
    seconds = time.perf_counter() - began
    print(f"codec: {frames / seconds:,.0f} frames a second ({frames} of a board that drives)")


def cost(link: SerialLink) -> None:
    """Of the thread that reads, while the robot drives."""
    before, began = link.telemetry.frames, time.perf_counter()
    worked = -time.process_time()
    while (passed := time.perf_counter() - began) < SECONDS:
        link.drive(link.permit(), MotorDrive.FORWARD, FAR)
        time.sleep(0.02)
    worked += time.process_time()
    link.stop()
    frames = (link.telemetry.frames - before) / passed
    print(f"thread: {100 * worked / passed:.1f} % of a processor at {frames:.0f} frames a second")


def stop(link: SerialLink, board: Connection) -> None:
    """From the call to the last byte of a stop at the board."""
    took = [one_stop(link, board.recv) for _ in range(STOPS)]
    print(
        f"stop: {1000 * statistics.median(took):.1f} ms in the middle, {1000 * max(took):.1f} ms at the most"
    )


def one_stop(link: SerialLink, received_at: Callable[[], float]) -> float:
    for _ in range(25):
        link.drive(link.permit(), MotorDrive.FORWARD, FAR)
        time.sleep(0.02)
    asked = time.monotonic()
    link.stop()
    while (at := received_at()) < asked:
        pass
    time.sleep(0.5)
    return at - asked


def play_board(talk: Connection) -> None:
    """Send its path, and then the time of each stop that the board receives."""
    with PtyBoard(SimulatedBoard(boot_loader=-0.9)) as double:
        talk.send(double.path)
        looked_to = 0
        while True:
            found = double.received.find(STOP, looked_to)
            if found >= 0:
                looked_to = found + len(STOP)
                talk.send(time.monotonic())
            time.sleep(0.0005)


if __name__ == "__main__":
    main()

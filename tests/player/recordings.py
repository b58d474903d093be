"""Sessions of real clients with the real server, where the shared material is there."""

import json
from collections import defaultdict
from contextlib import suppress
from pathlib import Path

from msgspec import Struct

from devices.player.codec import BANNER_SIZE, LONGEST_REPLY, MessageReader, PlayerMessage, TooLong

NAMES = (
    "drive",
    "every-interface",
    "garbage",
    "godonnie",
    "gripper",
    "playerprint",
    "playerv",
    "push-and-rules",
    "refused",
    "stage-simple",
    "two-ports",
)


class Side(Struct, frozen=True):
    """What one end of a connection sent."""

    connection: int
    sender: str
    data: bytes

    def messages(self) -> list[PlayerMessage]:
        """All that are whole, up to the first that can't be read."""
        found: list[PlayerMessage] = []
        data = self.data[BANNER_SIZE:] if self.sender == "server" else self.data
        with suppress(TooLong):
            found.extend(MessageReader(LONGEST_REPLY).feed(data))
        return found


def sides(shared: Path, name: str) -> list[Side]:
    joined: dict[tuple[int, str], bytearray] = defaultdict(bytearray)
    for line in (shared / "devices" / "player" / f"{name}.jsonl").read_text(encoding="utf-8").splitlines():
        chunk = json.loads(line)
        joined[chunk["connection"], chunk["from"]] += bytes.fromhex(chunk["hex"])
    return [Side(*key, bytes(data)) for key, data in joined.items()]

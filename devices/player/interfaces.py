"""The interfaces of Player as tables: their codes, and the form of the body of each message."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from devices.player.codec import BadBody, MessageType, PlayerMessage, decode, encode


class Interface(IntEnum):
    """Kinds of devices, by the code that the header has. The name in a configuration file is the same."""

    PLAYER = 1
    POWER = 2
    GRIPPER = 3
    POSITION2D = 4
    SONAR = 5
    LASER = 6
    BLOBFINDER = 7
    FIDUCIAL = 10
    SPEECH = 12
    BUMPER = 14
    DIO = 20
    AIO = 21
    SIMULATION = 31
    CAMERA = 40
    GRAPHICS2D = 55
    RANGER = 62
    SOUND = 66


class Access(IntEnum):
    """How a client opens a device."""

    OPEN = 1
    CLOSE = 2
    ERROR = 3


class DataMode(IntEnum):
    PUSH = 1
    """Data go out when they are there."""
    PULL = 2
    """Data go out when the client asks for a round."""


CAN_YOU = 255
"""The subtype of a request, of any interface: is this type and subtype known?"""

ADDRESS = "IIII"
POSE2D, POSE3D = "ddd", "dddddd"
BOX2D, BOX3D = "dd", "ddd"

DATA, COMMAND, REQUEST, ACK = (
    MessageType.DATA,
    MessageType.COMMAND,
    MessageType.REQUEST,
    MessageType.ACK,
)

FORMS: dict[tuple[int, int, int], str] = {
    (Interface.PLAYER, REQUEST, 1): "",  # device list
    (Interface.PLAYER, ACK, 1): f"[{ADDRESS}]",
    (Interface.PLAYER, REQUEST, 2): f"{ADDRESS} t",  # driver
    (Interface.PLAYER, ACK, 2): f"{ADDRESS} t",
    (Interface.PLAYER, REQUEST, 3): f"{ADDRESS} I t",  # open, close
    (Interface.PLAYER, ACK, 3): f"{ADDRESS} I t",
    (Interface.PLAYER, MessageType.NACK, 3): f"{ADDRESS} I t",
    (Interface.PLAYER, REQUEST, 4): "",  # a round of data
    (Interface.PLAYER, REQUEST, 5): "I",  # data mode
    (Interface.PLAYER, REQUEST, 10): "iiiii",  # replace rule
    (Interface.PLAYER, MessageType.SYNCH, 1): "",
    (Interface.PLAYER, MessageType.SYNCH, 2): "I",
    (Interface.POWER, DATA, 1): "I ffff i",
    (Interface.GRIPPER, DATA, 1): "I I I",
    (Interface.GRIPPER, COMMAND, 1): "",  # open
    (Interface.GRIPPER, COMMAND, 2): "",  # close
    (Interface.GRIPPER, COMMAND, 3): "",  # stop
    (Interface.GRIPPER, COMMAND, 4): "",  # store
    (Interface.GRIPPER, COMMAND, 5): "",  # retrieve
    (Interface.GRIPPER, REQUEST, 1): "",  # geometry
    (Interface.GRIPPER, ACK, 1): f"{POSE3D} {BOX3D} {BOX3D} I I",
    (Interface.POSITION2D, DATA, 1): f"{POSE2D} {POSE2D} I",
    (Interface.POSITION2D, COMMAND, 1): f"{POSE2D} I",  # velocity
    (Interface.POSITION2D, COMMAND, 2): f"{POSE2D} {POSE2D} I",  # position
    (Interface.POSITION2D, COMMAND, 3): "dd",  # velocity and angle, as a car
    (Interface.POSITION2D, COMMAND, 4): "dd",  # velocity and heading
    (Interface.POSITION2D, REQUEST, 1): "",  # geometry
    (Interface.POSITION2D, ACK, 1): f"{POSE3D} {BOX3D}",
    (Interface.POSITION2D, REQUEST, 2): "I",  # motor power
    (Interface.POSITION2D, REQUEST, 3): "I",  # velocity mode
    (Interface.POSITION2D, REQUEST, 4): "I",  # position mode
    (Interface.POSITION2D, REQUEST, 5): POSE2D,  # set odometry
    (Interface.POSITION2D, REQUEST, 6): "",  # reset odometry
    (Interface.BLOBFINDER, DATA, 1): "I I [IIIIIIIIIf]",
    (Interface.FIDUCIAL, DATA, 1): f"[i{POSE3D}{POSE3D}]",
    (Interface.FIDUCIAL, REQUEST, 1): "",  # geometry
    (Interface.FIDUCIAL, ACK, 1): f"{POSE3D} {BOX3D} {BOX2D}",
    (Interface.FIDUCIAL, REQUEST, 7): "",  # get the mark of its own model
    (Interface.FIDUCIAL, ACK, 7): "I",
    (Interface.FIDUCIAL, REQUEST, 8): "I",  # set it
    (Interface.FIDUCIAL, ACK, 8): "I",
    (Interface.SPEECH, COMMAND, 1): "t",
    (Interface.BUMPER, DATA, 1): "b",
    (Interface.BUMPER, REQUEST, 1): "",  # geometry
    (Interface.BUMPER, ACK, 1): f"[{POSE3D}ff]",
    (Interface.DIO, DATA, 1): "I I",
    (Interface.DIO, COMMAND, 1): "I I",
    (Interface.SIMULATION, COMMAND, 1): "",  # pause, resume
    (Interface.SIMULATION, COMMAND, 2): "",  # reset
    (Interface.SIMULATION, COMMAND, 3): "",  # save
    (Interface.SIMULATION, REQUEST, 1): f"t {POSE2D}",  # get
    (Interface.SIMULATION, ACK, 1): f"t {POSE2D}",
    (Interface.SIMULATION, REQUEST, 2): f"t {POSE2D}",  # set
    (Interface.SIMULATION, REQUEST, 3): f"t {POSE3D} d",  # get
    (Interface.SIMULATION, ACK, 3): f"t {POSE3D} d",
    (Interface.SIMULATION, REQUEST, 4): f"t {POSE3D} d",  # set
    (Interface.SIMULATION, REQUEST, 5): "t t I b",  # get a property
    (Interface.SIMULATION, ACK, 5): "t t I b",
    (Interface.SIMULATION, REQUEST, 6): "t t I b",  # set it
    (Interface.RANGER, DATA, 1): "[d]",
    (Interface.RANGER, DATA, 3): "[d]",  # intensities
    (Interface.RANGER, REQUEST, 1): "",  # geometry
    (Interface.RANGER, ACK, 1): f"{POSE3D} {BOX3D} [{POSE3D}] [{BOX3D}]",
    (Interface.RANGER, REQUEST, 5): "",  # configuration
    (Interface.RANGER, ACK, 5): "ddddddd",
    (Interface.SOUND, COMMAND, 1): "64s",
}
"""By interface, type and subtype, of what is served. A reply that isn't here has no body."""


def form_of(message: PlayerMessage) -> str | None:
    """The form of its body; None if nothing is known of such a message."""
    form = FORMS.get((message.interface, message.type, message.subtype))
    if form is not None:
        return form
    if message.type in (ACK, MessageType.NACK):
        return ""
    return "II" if message.type == REQUEST and message.subtype == CAN_YOU else None


def values_of(message: PlayerMessage) -> tuple[Any, ...]:
    """What is in its body. Raises ``BadBody``, also for a message of which nothing is known."""
    form = form_of(message)
    if form is None:
        raise BadBody(f"no form for {message.interface}, {message.type}, {message.subtype}")
    return decode(form, message.body)


def body_of(interface: int, type_: int, subtype: int, *values: object) -> bytes:
    """The body of such a message; empty if it has no form."""
    form = FORMS.get((interface, type_, subtype))
    return encode(form, values) if form else b""

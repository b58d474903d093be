"""What a robot senses: distances, coloured things, marks, touches. Computed when read, from exact geometry.

Sensors tell centimetres, as the real sonars do; they are cut to steps for the learner.
"""

from sim.sensors.eyes import Eyes, Found, MarkFinder, Seen, View
from sim.sensors.rangers import CENTIMETRES_A_STEP, Bar, Beams, Cone, Fan, Ranger
from sim.sensors.senses import Senses, senses_of
from sim.sensors.sight import Around

__all__ = [
    "CENTIMETRES_A_STEP",
    "Around",
    "Bar",
    "Beams",
    "Cone",
    "Eyes",
    "Fan",
    "Found",
    "MarkFinder",
    "Ranger",
    "Seen",
    "Senses",
    "View",
    "senses_of",
]

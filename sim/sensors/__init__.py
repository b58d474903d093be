"""What a robot senses: distances, coloured things, marks, touches. Computed when read, from exact geometry.

Sensors tell centimetres, as the real sonars do; they are cut to steps for the learner.
"""

from sim.sensors.eyes import Eyes, Seen, View
from sim.sensors.fiducials import Found, MarkFinder
from sim.sensors.rangers import CENTIMETRES_A_STEP, Cone, Fan, Ranger
from sim.sensors.senses import Senses, senses_of
from sim.sensors.sight import Around
from sim.sensors.spot import Spot
from sim.sensors.touch import Bar, Beams

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
    "Spot",
    "View",
    "senses_of",
]

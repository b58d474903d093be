"""Replaces an audio worker: it starts a player, and then reads nothing any more."""

import signal
import subprocess

subprocess.Popen(["sleep", "600"])
while True:
    signal.pause()

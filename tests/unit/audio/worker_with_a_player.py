"""In the place of an audio worker: one that started a player, and then hears nothing any more."""

import signal
import subprocess

subprocess.Popen(["sleep", "600"])
while True:
    signal.pause()
